//! The ratios of one question, each as it is known.

use super::{AskedRatios, Known, Response, Steady, Unproved};
use crate::float::ParseError;
use crate::machine::error::{Error, Number, Quantity};
use rug::Rational;

/// The frequency ratio Ω as it is known, and the other ratios where they are given: by default there is no damper, and
/// one friction.
///
/// ```
/// use stickslip::Output;
/// use stickslip::enclosed::KnownRatios;
/// let ratios = KnownRatios::parsed("0.695..0.705", "2")?;
/// let response = ratios.response(128)?;
/// assert!(response.get(Output::MaxDisplacement).is_some());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
#[must_use]
pub struct KnownRatios {
    pub(super) omega: Known,
    pub(super) alpha: Option<Known>,
    pub(super) damping_ratio: Known,
    pub(super) static_friction_ratio: Known,
}

impl KnownRatios {
    /// The frequency ratio Ω.
    pub fn new(omega: &Known) -> Self {
        let exactly = |n: i32| Known::rational(Rational::from(n));
        Self {
            omega: omega.clone(),
            alpha: None,
            damping_ratio: exactly(0),
            static_friction_ratio: exactly(1),
        }
    }

    /// The frequency ratio Ω and the force ratio α from text: a decimal number, a fraction such as `2/7`, or a range such as `0.695..0.705`.
    ///
    /// # Errors
    /// Names the text that is none of these.
    pub fn parsed(omega: &str, alpha: &str) -> Result<Self, ParseError> {
        Ok(Self::new(&omega.parse()?).with_force_ratio(&alpha.parse()?))
    }

    /// With the force ratio α.
    pub fn with_force_ratio(self, alpha: &Known) -> Self {
        Self { alpha: Some(alpha.clone()), ..self }
    }

    /// With the damping ratio ζ.
    pub fn with_damping_ratio(self, damping_ratio: &Known) -> Self {
        Self { damping_ratio: damping_ratio.clone(), ..self }
    }

    /// With a static friction of η times the kinetic one.
    pub fn with_static_friction_ratio(self, static_friction_ratio: &Known) -> Self {
        Self { static_friction_ratio: static_friction_ratio.clone(), ..self }
    }

    /// The closed forms at these ratios, enclosed: to `bits` bits where the ratios are exact.
    ///
    /// Without a force ratio these are the outputs of the border, without a regime:
    /// [`Output::MinForceRatio`](crate::Output::MinForceRatio),
    /// [`Output::MinForceRatioTurningPoint`](crate::Output::MinForceRatioTurningPoint),
    /// [`Output::LeastDisplacement`](crate::Output::LeastDisplacement),
    /// [`Output::BorderPhase`](crate::Output::BorderPhase), [`Output::BestForceRatio`](crate::Output::BestForceRatio)
    /// and [`Output::BestLoopSize`](crate::Output::BestLoopSize).
    ///
    /// With η > 1 the outputs are those of the motion of two reversals a cycle without a stop, and the regime says
    /// whether every start is known to lead to it.
    ///
    /// # Errors
    /// Where a ratio or `bits` is outside its domain ([`crate::Ratios`]; at most 8192 bits).
    pub fn response(&self, bits: u32) -> Result<Response, Error> {
        AskedRatios::new(self)?.answered(bits)
    }

    /// The steady motion from rest at these ratios, enclosed to `bits` bits; or the reason why it is not proved.
    ///
    /// With η > 1 other starts may lead to other motions.
    ///
    /// # Errors
    /// Where there is no force ratio, and where a ratio or `bits` is outside its domain
    /// ([`crate::motion::Trajectory::new`] for Ω).
    pub fn steady(&self, bits: u32) -> Result<Result<Steady, Unproved>, Error> {
        let absent =
            || Error::NotFinite { quantity: Quantity::ForceRatio, value: Number::spelled(f64::NAN, "NaN") };
        let alpha = self.alpha.as_ref().ok_or_else(absent)?;
        super::motion::steady(&self.omega, alpha, &self.damping_ratio, &self.static_friction_ratio, bits)
    }
}
