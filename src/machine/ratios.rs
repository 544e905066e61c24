//! The dimensionless parameters of the problem: Ω, α (eq. 8, 9), the damping ratio ζ and the static friction
//! ratio η.

use crate::float::Float;
use crate::machine::error::{Error, Quantity, written};
use crate::machine::excitation::Excitation;

/// Frequency ratio Ω = ω_d/ω_n (eq. 9), force ratio α = p₀/r_y (eq. 8), damping ratio ζ = c/(2√(k m)) and
/// static friction ratio η = r_s/r_y, validated.
///
/// | ratio | domain |
/// |---|---|
/// | Ω | `2⁻ᵉ ≤ Ω ≤ 2ᵉ`, e = [`Float::RATIO_EXPONENT`] (250 for `f64`, 30 for `f32`) |
/// | α | `0 < α ≤ 2ᵉ` |
/// | ζ | 0, or `2⁻ᵉ ≤ ζ ≤ 2ᵉ`; 0 unless it is given |
/// | η | `1 ≤ η ≤ 2ᵉ`; 1 unless it is given |
///
/// Inside that domain no closed form overflows or underflows; outside it, construction is an error.
///
/// The ratios of a machine under a drive ([`crate::Drive::ratios`]) carry its [`Excitation`], which decides the force on
/// the support and the absolute displacement. Ratios alone have none, until [`Ratios::with_excitation`] gives one.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(
        try_from = "crate::serialized::RatiosFields<F>",
        bound(deserialize = "F: Float + serde::Deserialize<'de>")
    )
)]
pub struct Ratios<F> {
    omega: F,
    alpha: F,
    damping_ratio: F,
    static_friction_ratio: F,
    excitation: Option<Excitation>,
}

/// Displays the ratios that are given: `Ω = 0.7, α = 2, ζ = 0.05`.
impl<F: Float> core::fmt::Display for Ratios<F> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "Ω = {}, α = {}", self.omega, self.alpha)?;
        if self.is_damped() {
            write!(f, ", ζ = {}", self.damping_ratio)?;
        }
        if self.has_higher_static_friction() {
            write!(f, ", η = {}", self.static_friction_ratio)?;
        }
        self.excitation.map_or(Ok(()), |excitation| write!(f, ", {excitation}"))
    }
}

impl<F: Float> Ratios<F> {
    /// The ratios Ω and α, without damping and with η = 1.
    ///
    /// # Errors
    /// [`Error`] with the value and the condition that it violates.
    #[inline]
    pub fn new(omega: F, alpha: F) -> Result<Self, Error> {
        Ok(Self {
            omega: frequency_ratio(omega)?,
            alpha: force_ratio(alpha)?,
            damping_ratio: F::int(0),
            static_friction_ratio: F::int(1),
            excitation: None,
        })
    }

    /// Ω and ζ at α = 1, for answers in which the force plays no part, or is sought.
    pub(crate) fn of_machine(omega: F, damping_ratio: F) -> Result<Self, Error> {
        Self::new(omega, F::int(1))?.with_damping_ratio(damping_ratio)
    }

    /// These ratios with another force ratio α.
    pub(crate) fn with_force_ratio(self, alpha: F) -> Result<Self, Error> {
        Ok(Self { alpha: force_ratio(alpha)?, ..self })
    }

    /// These ratios with a viscous damper of damping ratio ζ.
    ///
    /// # Errors
    /// Where ζ is outside its domain.
    pub fn with_damping_ratio(self, damping_ratio: F) -> Result<Self, Error> {
        Ok(Self { damping_ratio: valid_damping_ratio(damping_ratio)?, ..self })
    }

    /// These ratios with a static friction of η times the kinetic one: a body at rest stays at rest until the
    /// force on it exceeds η r_y.
    ///
    /// # Errors
    /// Where η is outside its domain.
    pub fn with_static_friction_ratio(self, static_friction_ratio: F) -> Result<Self, Error> {
        Ok(Self { static_friction_ratio: valid_static_friction_ratio(static_friction_ratio)?, ..self })
    }

    /// These ratios under an excitation of this kind.
    ///
    /// The motion does not depend on it, as phases are those of the force. The transmitted force, the
    /// transmissibility, the absolute displacement and the works of a damped support do.
    #[must_use]
    pub const fn with_excitation(self, excitation: Excitation) -> Self {
        self.under(Some(excitation))
    }

    /// These ratios under an excitation, if there is one.
    pub(crate) const fn under(self, excitation: Option<Excitation>) -> Self {
        Self { excitation, ..self }
    }

    /// Ratios that are known to be in the domain, without an excitation.
    pub(crate) const fn of_valid(omega: F, alpha: F, damping_ratio: F, static_friction_ratio: F) -> Self {
        Self { omega, alpha, damping_ratio, static_friction_ratio, excitation: None }
    }

    /// Frequency ratio Ω = ω_d/ω_n (eq. 9).
    pub const fn omega(&self) -> F {
        self.omega
    }

    /// Force ratio α = p₀/r_y (eq. 8).
    pub const fn alpha(&self) -> F {
        self.alpha
    }

    /// Damping ratio ζ = c/(2√(k m)): 0 without a damper, 1 where free vibration ceases.
    pub const fn damping_ratio(&self) -> F {
        self.damping_ratio
    }

    /// Static friction ratio η = r_s/r_y; 1 if static and kinetic friction are equal.
    pub const fn static_friction_ratio(&self) -> F {
        self.static_friction_ratio
    }

    /// The kind of excitation; `None` for ratios without a drive.
    pub const fn excitation(&self) -> Option<Excitation> {
        self.excitation
    }

    /// Whether Ω = 1 without a damper, where no cycle without a stop has a finite size above the border.
    #[inline]
    pub(crate) fn is_at_resonance(&self) -> bool {
        self.omega == F::int(1) && !self.is_damped()
    }

    /// Whether a body at rest is released at any position, α > η. For α ≤ η it stays at rest for ever where
    /// `|α sin θ − x| ≤ η` for all θ, that is for `|x| ≤ η − α`, also at x = 0.
    #[inline]
    #[must_use]
    pub fn moves_from_rest(&self) -> bool {
        self.alpha > self.static_friction_ratio
    }

    /// These ratios, if the static friction equals the kinetic one, for calculations that require it.
    pub(crate) fn with_one_friction(self) -> Result<Self, Error> {
        one_friction(self.static_friction_ratio).map(|()| self)
    }

    /// The ratios in another number type, which must be able to represent them.
    pub(crate) fn map<G: Float>(self, to: impl Fn(F) -> G) -> Ratios<G> {
        Ratios {
            omega: to(self.omega),
            alpha: to(self.alpha),
            damping_ratio: to(self.damping_ratio),
            static_friction_ratio: to(self.static_friction_ratio),
            excitation: self.excitation,
        }
    }

    /// Amplitude of the frictionless response in units of B. Without damping it is `A/B = α/(1 − Ω²)` (eq. 5,
    /// 6), negative above the natural frequency and infinite at Ω = 1. With damping it is `α/q`, `q = √((1 −
    /// Ω²)² + 4ζ²Ω²)`, and lags behind the force by a phase in (0, π).
    pub(crate) fn forced_amplitude(&self) -> F {
        if self.is_damped() {
            let damper = F::int(2) * self.damping_ratio * self.omega;
            return self.alpha / damper.hypot((F::int(1) - self.omega) * (F::int(1) + self.omega));
        }
        self.alpha / ((F::int(1) - self.omega) * (F::int(1) + self.omega))
    }
}

// For the programs of this repository.
#[doc(hidden)]
impl<F: Float> Ratios<F> {
    /// Whether there is a damper, ζ > 0.
    #[inline]
    pub fn is_damped(&self) -> bool {
        self.damping_ratio > F::int(0)
    }

    /// Whether the static friction is above the kinetic one, η > 1: the steady motion can then depend on the
    /// start.
    #[inline]
    pub fn has_higher_static_friction(&self) -> bool {
        self.static_friction_ratio > F::int(1)
    }
}

/// `x`, if it is finite.
pub(crate) fn finite<F: Float>(quantity: Quantity, x: F) -> Result<F, Error> {
    if x.is_finite() { Ok(x) } else { Err(Error::NotFinite { quantity, value: written(x) }) }
}

/// `x`, if it is finite and positive.
pub fn positive<F: Float>(quantity: Quantity, x: F) -> Result<F, Error> {
    if x > F::int(0) && x.is_finite() { Ok(x) } else { Err(not_positive(quantity, x)) }
}

/// `x`, if it is finite and not negative.
pub fn non_negative<F: Float>(quantity: Quantity, x: F) -> Result<F, Error> {
    if x < F::int(0) { Err(Error::Negative { quantity, value: written(x) }) } else { finite(quantity, x) }
}

/// Refuses a static friction above the kinetic one, for calculations that do not include it.
pub(crate) fn one_friction<F: Float>(static_friction_ratio: F) -> Result<(), Error> {
    if static_friction_ratio == F::int(1) {
        Ok(())
    } else {
        Err(Error::StaticFriction { static_friction_ratio: written(static_friction_ratio) })
    }
}

/// η, if `1 ≤ η ≤ 2ᵉ`.
pub(crate) fn valid_static_friction_ratio<F: Float>(static_friction_ratio: F) -> Result<F, Error> {
    let eta = finite(Quantity::StaticFrictionRatio, static_friction_ratio)?;
    let (least, greatest) = (F::int(1), F::exp2i(F::RATIO_EXPONENT));
    if eta < least {
        return Err(Error::BelowKineticFriction { static_friction_ratio: written(eta) });
    }
    within(Quantity::StaticFrictionRatio, eta, least, greatest)
}

/// ζ, if it is 0 or `2⁻ᵉ ≤ ζ ≤ 2ᵉ`.
pub(crate) fn valid_damping_ratio<F: Float>(damping_ratio: F) -> Result<F, Error> {
    let zeta = non_negative(Quantity::DampingRatio, damping_ratio)?;
    if zeta == F::int(0) {
        return Ok(zeta);
    }
    within(Quantity::DampingRatio, zeta, F::least_ratio(), F::exp2i(F::RATIO_EXPONENT))
}

/// `x`, if it is within `[least, greatest]`, `least` > 0.
#[inline]
pub(crate) fn within<F: Float>(quantity: Quantity, x: F, least: F, greatest: F) -> Result<F, Error> {
    if x >= least && x <= greatest { Ok(x) } else { Err(outside(quantity, x, least, greatest)) }
}

/// The error for an `x` that is not finite and positive.
#[cold]
fn not_positive<F: Float>(quantity: Quantity, x: F) -> Error {
    let value = written(x);
    if x.is_finite() { Error::NotPositive { quantity, value } } else { Error::NotFinite { quantity, value } }
}

/// The error for an `x` outside `[least, greatest]`: the simplest of several reasons.
#[cold]
fn outside<F: Float>(quantity: Quantity, x: F, least: F, greatest: F) -> Error {
    positive(quantity, x).err().unwrap_or_else(|| Error::OutOfRange {
        quantity,
        value: written(x),
        least: written(least),
        greatest: written(greatest),
    })
}

/// The frequency ratio at which the spring of a body cannot be seen: `Ω⁻² ≤ ε/16`, 2²⁸ at f64.
///
/// A body without a spring has this Ω. Its motions and its cycle are limits for Ω → ∞ at one ω_d: the force k x is Ω⁻² of
/// the inertia m ω_d² x, and so are the differences of all answers in units of r_y/(m ω_d²), ω_d and r_y.
pub(crate) fn springless<F: Float>() -> F {
    F::exp2i(springless_exponent::<F>())
}

/// The binary logarithm of `springless`.
pub fn springless_exponent<F: Float>() -> i32 {
    (F::precision() / 2).saturating_add(2).cast_signed()
}

/// Ω, if `2⁻ᵉ ≤ Ω ≤ 2ᵉ`.
#[inline]
pub(crate) fn frequency_ratio<F: Float>(omega: F) -> Result<F, Error> {
    within(Quantity::FrequencyRatio, omega, F::least_ratio(), F::exp2i(F::RATIO_EXPONENT))
}

/// α, if `0 < α ≤ 2ᵉ`. There is no other lower bound, because the body is at rest for any small α.
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
    use crate::machine::error::{Error, Quantity};

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

    /// The amplitude without friction: (1 − Ω²)² = 1.5625 and (2ζΩ)² = 0.81 at Ω = 1.5, ζ = 0.3.
    #[test]
    fn the_forced_amplitude_is_that_of_the_linear_oscillator() {
        let plain = Ratios::new(1.5f64, 2.0).unwrap();
        assert!((plain.forced_amplitude() + 1.6).abs() < 1e-15);
        let damped = plain.with_damping_ratio(0.3).unwrap();
        let exact = 2.0 / 2.3725f64.sqrt();
        assert!((damped.forced_amplitude() - exact).abs() < 1e-15, "{}", damped.forced_amplitude());
    }

    #[test]
    fn damping_is_zero_or_of_ordinary_size() {
        let with = |zeta| Ratios::new(1.5, 2.0).unwrap().with_damping_ratio(zeta);
        assert_eq!(Ratios::new(1.5, 2.0).unwrap().damping_ratio(), 0.0);
        assert!(with(0.05).unwrap().is_damped() && !with(0.0).unwrap().is_damped());
        let message = |zeta| with(zeta).unwrap_err().to_string();
        assert_eq!(message(-0.5), "damping ratio ζ = -0.5 must be ≥ 0");
        assert_eq!(message(f64::NAN), "damping ratio ζ = NaN must be finite");
        assert!(matches!(with(1e-80), Err(Error::OutOfRange { quantity: Quantity::DampingRatio, .. })));
    }

    #[test]
    fn static_friction_is_not_below_the_kinetic_one() {
        let with = |eta| Ratios::new(1.5, 2.0).unwrap().with_static_friction_ratio(eta);
        assert_eq!(Ratios::new(1.5, 2.0).unwrap().static_friction_ratio(), 1.0);
        assert!(with(1.3).unwrap().has_higher_static_friction());
        assert!(!with(1.0).unwrap().has_higher_static_friction());
        let message = |eta| with(eta).unwrap_err().to_string();
        assert_eq!(
            message(0.5),
            "static friction ratio η = 0.5 must be ≥ 1: static friction is not below the kinetic one"
        );
        assert_eq!(message(f64::NAN), "static friction ratio η = NaN must be finite");
        assert!(matches!(with(1e80), Err(Error::OutOfRange { quantity: Quantity::StaticFrictionRatio, .. })));
        assert!(matches!(with(1.3).unwrap().with_one_friction(), Err(Error::StaticFriction { .. })));
        assert!(with(1.0).unwrap().with_one_friction().is_ok());
    }

    #[test]
    fn forced_amplitude_changes_sign_at_the_natural_frequency() {
        let amplitude = |omega| Ratios::new(omega, 3.0).map(|r| r.forced_amplitude());
        assert_eq!(amplitude(0.5), Ok(4.0));
        assert_eq!(amplitude(2.0), Ok(-1.0));
        assert_eq!(amplitude(1.0), Ok(f64::INFINITY));
    }
}
