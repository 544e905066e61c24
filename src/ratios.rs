//! The two dimensionless numbers that decide everything (eq. 8, 9).

use crate::error::{Error, Quantity};
use crate::float::Float;

/// Frequency ratio Ω = ω_d/ω_n (eq. 9) and force ratio α = p₀/r_y (eq. 8), validated.
///
/// | ratio | domain |
/// |---|---|
/// | Ω | `2⁻ᵉ ≤ Ω ≤ 2ᵉ`, e = [`Float::RATIO_EXPONENT`] (250 for `f64`, 30 for `f32`) |
/// | α | `0 < α ≤ 2ᵉ` |
///
/// Inside that domain no closed form over- or underflows; outside, construction says so.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ratios<F> {
    omega: F,
    alpha: F,
}

impl<F: Float> Ratios<F> {
    /// The pair (Ω, α).
    ///
    /// # Errors
    /// [`Error`] with the value and the inequality it breaks.
    #[inline]
    pub fn new(omega: F, alpha: F) -> Result<Self, Error> {
        Ok(Self { omega: frequency_ratio(omega)?, alpha: force_ratio(alpha)? })
    }

    /// Ratios that are known to be in the domain.
    #[cfg(feature = "dual")]
    pub(crate) const fn of_valid(omega: F, alpha: F) -> Self {
        Self { omega, alpha }
    }

    /// Frequency ratio Ω = ω_d/ω_n (eq. 9).
    pub const fn omega(&self) -> F {
        self.omega
    }

    /// Force ratio α = p₀/r_y (eq. 8).
    pub const fn alpha(&self) -> F {
        self.alpha
    }

    /// Both ratios in another number type, which has to hold them.
    pub(crate) fn map<G: Float>(self, to: impl Fn(F) -> G) -> Ratios<G> {
        Ratios { omega: to(self.omega), alpha: to(self.alpha) }
    }

    /// Amplitude of the frictionless response in units of B: `A/B = α/(1 − Ω²)` (eq. 5, 6). Negative
    /// above the natural frequency; infinite at Ω = 1.
    pub fn forced_amplitude(&self) -> F {
        self.alpha / ((F::int(1) - self.omega) * (F::int(1) + self.omega))
    }
}

/// `x`, where it is finite.
pub(crate) fn finite<F: Float>(quantity: Quantity, x: F) -> Result<F, Error> {
    if x.is_finite() { Ok(x) } else { Err(Error::NotFinite { quantity, value: x.to_string() }) }
}

/// `x`, where it is finite and above zero.
pub(crate) fn positive<F: Float>(quantity: Quantity, x: F) -> Result<F, Error> {
    if x > F::int(0) && x.is_finite() { Ok(x) } else { Err(not_positive(quantity, x)) }
}

/// `x`, where it is within `[least, greatest]`, `least` > 0.
#[inline]
pub(crate) fn within<F: Float>(quantity: Quantity, x: F, least: F, greatest: F) -> Result<F, Error> {
    if x >= least && x <= greatest { Ok(x) } else { Err(outside(quantity, x, least, greatest)) }
}

/// Why `x` is not a finite number above zero.
#[cold]
fn not_positive<F: Float>(quantity: Quantity, x: F) -> Error {
    let value = x.to_string();
    if x.is_finite() { Error::NotPositive { quantity, value } } else { Error::NotFinite { quantity, value } }
}

/// Why `x` is not within `[least, greatest]`: of several reasons the plainest.
#[cold]
fn outside<F: Float>(quantity: Quantity, x: F, least: F, greatest: F) -> Error {
    positive(quantity, x).err().unwrap_or_else(|| Error::OutOfRange {
        quantity,
        value: x.to_string(),
        least: least.to_string(),
        greatest: greatest.to_string(),
    })
}

/// Ω, where `2⁻ᵉ ≤ Ω ≤ 2ᵉ`.
#[inline]
pub(crate) fn frequency_ratio<F: Float>(omega: F) -> Result<F, Error> {
    let e = F::RATIO_EXPONENT;
    within(Quantity::FrequencyRatio, omega, F::exp2i(-e), F::exp2i(e))
}

/// α, where `0 < α ≤ 2ᵉ`. Any smaller α is at rest, so that there is no lower bound to respect.
#[inline]
fn force_ratio<F: Float>(alpha: F) -> Result<F, Error> {
    let greatest = F::exp2i(F::RATIO_EXPONENT);
    if alpha > F::int(0) && alpha <= greatest {
        Ok(alpha)
    } else {
        Err(outside(Quantity::ForceRatio, alpha, F::int(0), greatest))
    }
}

#[cfg(test)]
mod tests {
    use super::Ratios;
    use crate::error::{Error, Quantity};

    #[test]
    fn the_domain_is_what_the_table_says() {
        let edge = 2f64.powi(250);
        assert!(Ratios::new(edge, edge).is_ok());
        assert!(Ratios::new(1.0 / edge, f64::from_bits(1)).is_ok());
        for (omega, alpha, quantity) in [
            (edge.next_up(), 2.0, Quantity::FrequencyRatio),
            ((1.0 / edge).next_down(), 2.0, Quantity::FrequencyRatio),
            (f64::from_bits(1), 2.0, Quantity::FrequencyRatio),
            (1.5, edge.next_up(), Quantity::ForceRatio),
        ] {
            match Ratios::new(omega, alpha) {
                Err(Error::OutOfRange { quantity: named, .. }) => assert_eq!(named, quantity),
                other => panic!("({omega}, {alpha}): {other:?}"),
            }
        }
    }

    #[test]
    fn the_message_names_value_and_inequality() {
        let message = |omega, alpha| Ratios::new(omega, alpha).map(|_| ()).unwrap_err().to_string();
        assert_eq!(message(0.0, 2.0), "frequency ratio Ω = 0 must be > 0");
        assert_eq!(message(-1.5, 2.0), "frequency ratio Ω = -1.5 must be > 0");
        assert_eq!(message(1.5, -0.0), "force ratio α = -0 must be > 0");
        assert_eq!(message(f64::NAN, 2.0), "frequency ratio Ω = NaN must be finite");
        assert_eq!(message(1.5, f64::INFINITY), "force ratio α = inf must be finite");
    }

    #[test]
    fn forced_amplitude_changes_sign_at_the_natural_frequency() {
        let amplitude = |omega| Ratios::new(omega, 3.0).map(|r| r.forced_amplitude());
        assert_eq!(amplitude(0.5), Ok(4.0));
        assert_eq!(amplitude(2.0), Ok(-1.0));
        assert_eq!(amplitude(1.0), Ok(f64::INFINITY));
    }
}
