//! Derivatives of every output with respect to every parameter, by dual numbers ([`crate::float::Dual`]).
//!
//! The formulae themselves are differentiated, term by term, and at roots by the implicit function theorem.
//! There is no step size and no cancellation of differences. Near a pole of the border, a double multiplier
//! or the border itself, the derivatives are large because the outputs are steep there. Where an output has a
//! corner (the border next to a pole, the contraction where gσ = 1), the derivatives are those of the side on
//! which the point lies.
//!
//! ```
//! use stickslip::sensitivity::{Parameter, Sensitivities};
//! use stickslip::{Drive, Oscillator, Output};
//! let body = Oscillator::new(50.0, 1000.0, 5.0)?;
//! let drive = Drive::force(12.0, std::f64::consts::TAU)?;
//! let answer = Sensitivities::by_parameters(&body, &drive)?;
//! let stroke = answer.of(Output::MaxDisplacement).unwrap();
//! // One percent more mass gives 2.08 percent less displacement.
//! assert!((stroke.elasticity(Parameter::Mass) + 2.084325).abs() < 1e-6);
//! # Ok::<(), stickslip::Error>(())
//! ```

use crate::cycle::regime::Regime;
use crate::cycle::response::Response;
use crate::float::dual::Dual;
use crate::machine::error::Error;
use crate::machine::oscillator::{Drive, Oscillator, Scales};
use crate::output::Output;

/// A value and its derivatives with respect to each [`Parameter`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct Sensitivity {
    /// The value.
    pub value: f64,
    /// The derivatives, in the order of [`Parameter`].
    pub(crate) by: [f64; 5],
    /// The parameters.
    at: [f64; 5],
}

/// A parameter of a machine under a drive.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Parameter {
    /// Mass m.
    Mass,
    /// Stiffness k.
    Stiffness,
    /// Friction bound r_y.
    FrictionBound,
    /// Amplitude of the drive.
    Amplitude,
    /// Angular frequency ω_d.
    AngularFrequency,
}

impl Parameter {
    /// The entry of this parameter.
    const fn of(self, [mass, stiffness, friction_bound, amplitude, angular_frequency]: [f64; 5]) -> f64 {
        match self {
            Self::Mass => mass,
            Self::Stiffness => stiffness,
            Self::FrictionBound => friction_bound,
            Self::Amplitude => amplitude,
            Self::AngularFrequency => angular_frequency,
        }
    }
}

impl Sensitivity {
    /// The derivative `∂y/∂p` by a parameter, in the unit of the value over that of the parameter.
    #[must_use]
    pub const fn by(&self, parameter: Parameter) -> f64 {
        parameter.of(self.by)
    }

    /// The relative sensitivity `(p/y) ∂y/∂p` to a parameter: percent of change per percent of it.
    #[must_use]
    pub fn elasticity(&self, parameter: Parameter) -> f64 {
        self.by(parameter) * parameter.of(self.at) / self.value
    }

    /// The standard deviation of the value to first order, `√Σ(σᵢ ∂y/∂pᵢ)²`, for independent parameters with these
    /// standard deviations σᵢ; the others are known exactly.
    #[must_use]
    pub fn deviation(&self, deviations: &[(Parameter, f64)]) -> f64 {
        deviations
            .iter()
            .map(|&(parameter, sigma)| self.by(parameter) * sigma)
            .fold(0.0, crate::float::Field::hypot)
    }
}

/// All outputs of a machine with their derivatives with respect to each [`Parameter`].
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Sensitivities {
    /// The regime of the steady motion.
    pub regime: Regime,
    /// All outputs that exist.
    pub outputs: Vec<(Output, Sensitivity)>,
}

impl Sensitivities {
    /// The outputs in physical units ([`Output::unit`]) and their derivatives with respect to m, k, r_y, the
    /// amplitude and ω_d.
    ///
    /// Compared with differences at 512 bits, the error at f64 is at most 1e-11 of the larger of p ∂y/∂p and y, away
    /// from the corners named above and from Ω = 1/n, where the rounding of Ω counts. For derivatives with respect to
    /// Ω and α, compute a [`Response`] of [`Dual`] numbers.
    ///
    /// All other parameters are constant, including the damping constant c and the static friction ratio η. If the spring's support moves, a
    /// change of stiffness also changes the force. Both loop sizes are the energy of a cycle, `4 r_y Δ₀`,
    /// computed in two ways.
    ///
    /// # Errors
    /// Where a ratio leaves the domain of [`crate::Ratios`], or a scale overflows or underflows.
    pub fn by_parameters(body: &Oscillator<f64>, drive: &Drive<f64>) -> Result<Self, Error> {
        let amplitude = drive.amplitude();
        let frequency = drive.angular_frequency();
        let at = [body.mass(), body.stiffness(), body.friction_bound(), amplitude, frequency];
        let [m, k, r, a, w] = Dual::parameters(at);
        let eta = Dual::of(body.static_friction_ratio());
        let body = Oscillator::new(m, k, r)?.with_damping(Dual::of(body.damping()))?;
        let body = body.with_static_friction_ratio(eta)?;
        let drive = Drive::new(drive.excitation(), a, w)?;
        let scales = Scales::new(&body, &drive)?;
        let response = Response::new(drive.ratios(&body)?);
        let outputs = Output::ALL.into_iter().filter_map(|output| {
            let found = output.of(&response)? * output.unit(&scales);
            Some((output, Sensitivity { value: found.value(), by: found.derivatives(), at }))
        });
        Ok(Self { regime: response.regime, outputs: outputs.collect() })
    }

    /// One output; `None` where it does not exist.
    #[must_use]
    pub fn of(&self, output: Output) -> Option<Sensitivity> {
        self.outputs.iter().find(|(name, _)| *name == output).map(|(_, found)| *found)
    }
}

/// An output that does not exist.
const MISSING: Sensitivity = Sensitivity { value: f64::NAN, by: [f64::NAN; 5], at: [f64::NAN; 5] };

/// One output with its derivatives; where it does not exist, all of them are NaN.
///
/// ```
/// use stickslip::sensitivity::{Parameter, Sensitivities};
/// use stickslip::{Drive, Oscillator, Output};
/// let body = Oscillator::new(50.0, 1000.0, 5.0)?;
/// let found = Sensitivities::by_parameters(&body, &Drive::force(12.0, 6.0)?)?;
/// assert!((found[Output::MaxDisplacement].value - 0.012_136_68).abs() < 1e-8);
/// assert!(found[Output::MaxDisplacement].by(Parameter::FrictionBound) < 0.0);
/// # Ok::<(), stickslip::Error>(())
/// ```
impl core::ops::Index<Output> for Sensitivities {
    type Output = Sensitivity;

    fn index(&self, output: Output) -> &Sensitivity {
        self.outputs.iter().find(|(name, _)| *name == output).map_or(&MISSING, |(_, found)| found)
    }
}

#[cfg(test)]
mod tests {
    use super::{Parameter, Sensitivities, Sensitivity};
    use crate::{Border, Cycle, Drive, Oscillator, Output, Ratios, Regime};

    #[test]
    fn percents_and_deviations() {
        let s = Sensitivity { value: 8.0, by: [2.0, -3.0, 0.0, 1.0, 7.0], at: [10.0, 4.0, 1.0, 24.0, 1.0] };
        assert_eq!(
            [Parameter::Mass, Parameter::Stiffness, Parameter::Amplitude].map(|p| s.elasticity(p)),
            [2.5, -1.5, 3.0]
        );
        // Legs 6 and 2.5 of a right triangle, in any order.
        assert_eq!(s.deviation(&[(Parameter::Mass, 3.0), (Parameter::Stiffness, -2.5 / 3.0)]), 6.5);
        assert_eq!(s.deviation(&[(Parameter::Stiffness, -2.5 / 3.0), (Parameter::Mass, 3.0)]), 6.5);
        assert_eq!((s.deviation(&[(Parameter::AngularFrequency, 2.0)]), s.deviation(&[])), (14.0, 0.0));
    }

    #[test]
    fn by_parameters_is_the_slope_of_a_short_way() {
        let at = |omega, alpha| Cycle::new(Ratios::new(omega, alpha).unwrap()).unwrap().max_displacement;
        // m = k = r_y = 1: ω_d is Ω, the force is α, and lengths are in B.
        let machine = |alpha| {
            let body = Oscillator::new(1.0, 1.0, 1.0).unwrap();
            Sensitivities::by_parameters(&body, &Drive::force(alpha, 0.7).unwrap()).unwrap()
        };
        let found = machine(2.0);
        let delta = found.of(Output::MaxDisplacement).unwrap();
        assert_eq!((delta.value, found.regime), (at(0.7, 2.0), Regime::NonSticking));
        let h = 1e-6;
        let by_omega = (at(0.7 + h, 2.0) - at(0.7 - h, 2.0)) / (2.0 * h);
        let by_alpha = (at(0.7, 2.0 + h) - at(0.7, 2.0 - h)) / (2.0 * h);
        assert!((delta.by(Parameter::AngularFrequency) / by_omega - 1.0).abs() < 1e-8);
        assert!((delta.by(Parameter::Amplitude) / by_alpha - 1.0).abs() < 1e-8);
        let border = found.of(Output::MinForceRatio).unwrap();
        assert_eq!(border.value, Border::new(0.7).unwrap().min_force_ratio);
        let all = found.outputs.clone();
        assert!(all.len() > 10 && all.contains(&(Output::MaxDisplacement, delta)));
        assert_eq!(found[Output::MaxDisplacement], delta);
        let sticking = machine(1.1);
        let missing = sticking[Output::MaxDisplacement];
        assert!(missing.value.is_nan() && missing.by(Parameter::Mass).is_nan());
        assert!(sticking.of(Output::MaxDisplacement).is_none() && sticking.outputs.len() < all.len());
    }

    /// If the force and the friction force grow by the same share, so do the lengths.
    #[test]
    fn by_parameters_is_in_their_units() {
        let body = Oscillator::new(2.0, 8.0, 3.0).unwrap();
        let found = Sensitivities::by_parameters(&body, &Drive::force(9.0, 1.5).unwrap()).unwrap();
        let delta = found.of(Output::MaxDisplacement).unwrap();
        let cycle = Cycle::new(Ratios::new(0.75, 3.0).unwrap()).unwrap();
        assert!((delta.value / (cycle.max_displacement * 3.0 / 8.0) - 1.0).abs() < 1e-14);
        let grown = delta.elasticity(Parameter::FrictionBound) + delta.elasticity(Parameter::Amplitude);
        assert!((grown - 1.0).abs() < 1e-13, "{grown}");
        // If the spring's support moves, a stiffer spring means a larger force.
        let based = Sensitivities::by_parameters(
            &body,
            &Drive::new(crate::Excitation::FootMotion, 9.0 / 8.0, 1.5).unwrap(),
        )
        .unwrap();
        let more = based.of(Output::MaxDisplacement).unwrap().by(Parameter::Stiffness)
            - delta.by(Parameter::Stiffness);
        assert!((more / (delta.by(Parameter::Amplitude) * 9.0 / 8.0) - 1.0).abs() < 1e-12, "{more}");
    }
}
