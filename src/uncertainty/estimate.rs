//! Estimates from measurements or draws.

/// An estimate with its standard error.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
#[must_use]
pub struct Estimate {
    /// The estimate.
    pub value: f64,
    /// Its standard error.
    pub standard_error: f64,
    /// Degrees of freedom of the standard error; infinite where it is not estimated from a spread.
    #[cfg_attr(feature = "serde", serde(with = "crate::serialized::infinite"))]
    pub(crate) degrees_of_freedom: f64,
    /// The least and the greatest value that the quantity can have.
    #[cfg_attr(feature = "serde", serde(with = "crate::serialized::unbounded"))]
    pub(crate) range: (f64, f64),
    /// The least and the greatest value that a search found to be no worse than the ends of the interval.
    pub(crate) alike: Option<(f64, f64)>,
}

impl Estimate {
    /// The interval that contains the true value in 95 % of such measurements or runs, if their errors are
    /// independent and normal. It is limited to the range of the quantity: a friction, a damping ratio or a
    /// probability is not negative. Values that a search found to be no worse belong to it, as those of a second valley of
    /// a sum of squares.
    ///
    /// The quantile of Student's distribution is computed by its expansion in the degrees of freedom,
    /// accurate to 1 % from 3 degrees on, and is exact for 1 and 2.
    #[must_use]
    pub fn interval(&self) -> (f64, f64) {
        let half = student_95(self.degrees_of_freedom) * self.standard_error;
        let (least, greatest) = self.range;
        let (low, high) = self.alike.unwrap_or((self.value, self.value));
        ((self.value - half).min(low).max(least), (self.value + half).max(high).min(greatest))
    }
}

/// The 97.5 % quantile of Student's distribution.
pub(crate) fn student_95(degrees_of_freedom: f64) -> f64 {
    match degrees_of_freedom {
        1.0 => STUDENT_95[0],
        2.0 => STUDENT_95[1],
        n => student(Z_95, n),
    }
}

/// The 97.5 % quantile of the normal distribution.
const Z_95: f64 = 1.959_963_984_540_054;

/// The 97.5 % quantiles of Student's distribution with 1 and 2 degrees of freedom: cot(π/40), and 0.95/√(2 · 0.975 · 0.025).
const STUDENT_95: [f64; 2] = [12.706_204_736_174_71, 4.302_652_729_749_464];

/// The quantile of Student's distribution with n degrees of freedom, from the quantile z of the normal
/// distribution (Abramowitz and Stegun, 26.7.5).
pub(crate) fn student(z: f64, n: f64) -> f64 {
    let square = z * z;
    let first = z * (square + 1.0) / 4.0;
    let second = z * ((5.0 * square + 16.0) * square + 3.0) / 96.0;
    let third = z * (((3.0 * square + 19.0) * square + 17.0) * square - 15.0) / 384.0;
    z + first / n + second / (n * n) + third / (n * n * n)
}

#[cfg(test)]
mod tests {
    use super::{Estimate, Z_95, student};

    #[test]
    fn the_quantiles_of_students_distribution() {
        // Tabulated quantiles.
        let table =
            [(3.0, 3.182_446), (5.0, 2.570_582), (10.0, 2.228_139), (28.0, 2.048_407), (100.0, 1.983_972)];
        for (n, expected) in table {
            assert!((student(Z_95, n) / expected - 1.0).abs() < 0.01, "{n}: {}", student(Z_95, n));
        }
        assert!((student(Z_95, 28.0) - 2.048_407).abs() < 1e-5);
        let estimate = |value| Estimate {
            value,
            standard_error: 0.5,
            degrees_of_freedom: f64::INFINITY,
            range: (0.0, f64::INFINITY),
            alike: None,
        };
        let (low, high) = estimate(1.0).interval();
        assert!((high - 1.979_982).abs() < 1e-6 && (low - 0.020_018).abs() < 1e-6);
        assert_eq!(estimate(0.5).interval().0, 0.0);
        let wider = Estimate { alike: Some((0.5, 2.5)), ..estimate(1.0) };
        assert_eq!(wider.interval(), (low, 2.5));
    }
}
