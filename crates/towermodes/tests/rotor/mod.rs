//! Rotors of equal blades as their hub feels them: rigid ones by hand, and Coleman's.

mod coleman;
mod rigid;

#[track_caller]
pub fn assert_near(computed: &[f64], exact: &[f64], tolerance: f64) {
    assert_eq!(computed.len(), exact.len(), "{computed:?} and {exact:?}");
    for (computed, exact) in computed.iter().zip(exact) {
        let difference = (computed / exact - 1.0).abs();
        assert!(difference < tolerance, "{computed} and {exact}");
    }
}
