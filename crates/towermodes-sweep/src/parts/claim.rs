//! A folder belongs to the sweep whose plan it has.

use std::fs;
use std::io::ErrorKind;

use super::check::State;
use super::names::{PLAN, SUCCESS, is_like_a_part, is_of_results, part_number};
use super::write::write_new;
use super::{Parts, PartsError};

impl Parts<'_> {
    /// Writes the plan unless there is one, and compares the one that is there with the own.
    pub(super) fn claim(&self) -> Result<(), PartsError> {
        let path = self.folder().join(PLAN);
        if !path.exists() {
            self.check_without_plan()?;
            // It is read even if it is new: another run may have been faster.
            write_new(self.folder(), PLAN, self.plan.text().as_bytes())?;
        }
        let text = fs::read_to_string(&path).map_err(PartsError::io(&path))?;
        let differences = self.plan.differences(&text);
        let differences = differences.map_err(|detail| PartsError::Plan { path, detail })?;
        match differences.is_empty() {
            true => Ok(()),
            false => Err(PartsError::OtherSweep {
                folder: self.folder().to_path_buf(),
                differences,
            }),
        }
    }

    /// Refuses a folder whose plan another run has removed or replaced since
    /// [`claim`](Self::claim).
    pub(super) fn check_claim(&self) -> Result<(), PartsError> {
        let path = self.folder().join(PLAN);
        match fs::read_to_string(&path) {
            Ok(text)
                if self
                    .plan
                    .differences(&text)
                    .is_ok_and(|list| list.is_empty()) =>
            {
                Ok(())
            }
            Err(error) if error.kind() != ErrorKind::NotFound => {
                Err(PartsError::Io { path, error })
            }
            _ => Err(PartsError::Replaced { path }),
        }
    }

    /// A folder without a plan must have no parts but those of this sweep.
    fn check_without_plan(&self) -> Result<(), PartsError> {
        for name in self.names()? {
            if !is_like_a_part(&name) {
                continue;
            }
            let number = part_number(&name).filter(|part| self.name(*part) == name);
            let foreign = |reason: &str| PartsError::Foreign {
                path: self.folder().join(&name),
                reason: reason.to_owned(),
            };
            let state = match number.filter(|part| *part < self.count()) {
                Some(part) => self.state(part)?,
                None => return Err(foreign("the sweep has no part with this name")),
            };
            if state != State::Done {
                return Err(foreign("it has no key, or that of another sweep"));
            }
        }
        Ok(())
    }

    /// Removes the files of results, and no others.
    ///
    /// A file of another program that would be read as a part is refused before anything is
    /// removed.
    /// In a folder without a plan this is any part that has no key of a sweep.
    pub(super) fn remove_results(&self) -> Result<(), PartsError> {
        let mut names = self.names()?;
        let has_plan = names.iter().any(|name| name == PLAN);
        for name in names.iter().filter(|name| is_like_a_part(name)) {
            let is_own = is_of_results(name) && (has_plan || self.key_of(name)?.is_some());
            if !is_own {
                let path = self.folder().join(name);
                return Err(PartsError::NotResults { path });
            }
        }
        names.retain(|name| is_of_results(name));
        // The mark of success is the first: it must not be there while parts are missing. The plan
        // is the last: if this is interrupted, the parts that are left still have their plan.
        names.sort_by_key(|name| (name != SUCCESS, name == PLAN));
        names.iter().try_for_each(|name| self.remove(name))
    }

    /// Removes a file if it is there.
    pub(super) fn remove(&self, name: &str) -> Result<(), PartsError> {
        let path = self.folder().join(name);
        match fs::remove_file(&path) {
            Err(error) if error.kind() != ErrorKind::NotFound => {
                Err(PartsError::Io { path, error })
            }
            _ => Ok(()),
        }
    }
}
