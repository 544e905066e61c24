//! A point of the closed forms.

use super::points::{force_ratio, frequency_ratio};
use arbitrary::{Arbitrary, Result, Unstructured};

/// A frequency ratio and a force ratio.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Frequency ratio Ω.
    pub omega: f64,
    /// Force ratio α.
    pub alpha: f64,
}

impl<'a> Arbitrary<'a> for Point {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        let omega = frequency_ratio(u)?;
        Ok(Self { omega, alpha: force_ratio(u, omega)? })
    }
}
