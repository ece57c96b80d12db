//! A share of the parts, for an array of processes.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

/// One of several equal shares of the parts of a sweep: the parts whose number leaves the
/// remainder `index` when it is divided by `count`. Its text is `index/count`.
///
/// # Example
/// ```
/// use towermodes_sweep::Shard;
///
/// let shard: Shard = "3/16".parse()?;
/// assert_eq!((shard.index(), shard.count()), (3, 16));
/// assert!(shard.has(19) && !shard.has(20));
/// assert!("16/16".parse::<Shard>().is_err());
/// # Ok::<(), towermodes_sweep::ShardError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    index: u64,
    count: u64,
}

/// Why a text or two numbers are not a share.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ShardError {
    /// Not two whole numbers.
    #[error("`{text}` is not a shard; write INDEX/COUNT with the index from 0, as 0/16 to 15/16")]
    Text {
        /// The text.
        text: String,
    },
    /// An index that is not below the count.
    #[error("shard {index}/{count} does not exist; {}", existing(*count))]
    Index {
        /// The index.
        index: u64,
        /// The count.
        count: u64,
    },
}

fn existing(count: u64) -> String {
    match count.checked_sub(1) {
        None => "the count must be at least 1".to_owned(),
        Some(last) => format!("the index is from 0, so the last of {count} is {last}/{count}"),
    }
}

impl Shard {
    /// All parts.
    pub const ALL: Self = Self { index: 0, count: 1 };

    /// The share with an index, from 0, of a number of shares.
    ///
    /// # Errors
    /// [`ShardError::Index`] if the index is not below the count.
    pub fn new(index: u64, count: u64) -> Result<Self, ShardError> {
        match index < count {
            true => Ok(Self { index, count }),
            false => Err(ShardError::Index { index, count }),
        }
    }

    /// Its index, from 0.
    pub fn index(self) -> u64 {
        self.index
    }

    /// The number of shares.
    pub fn count(self) -> u64 {
        self.count
    }

    /// Whether a part, from 0, belongs to it.
    pub fn has(self, part: u64) -> bool {
        part % self.count == self.index
    }
}

impl Default for Shard {
    fn default() -> Self {
        Self::ALL
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.count)
    }
}

impl FromStr for Shard {
    type Err = ShardError;

    fn from_str(text: &str) -> Result<Self, ShardError> {
        let wrong = || ShardError::Text {
            text: text.chars().take(40).collect(),
        };
        let (index, count) = text.split_once('/').ok_or_else(wrong)?;
        let number = |digits: &str| digits.trim().parse::<u64>().map_err(|_| wrong());
        Self::new(number(index)?, number(count)?)
    }
}
