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
use crate::machine::ratios::Ratios;
use crate::output::Output;

/// A value and its derivatives with respect to N parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
#[must_use]
pub struct Sensitivity<const N: usize> {
    /// The value.
    pub value: f64,
    /// The derivatives, in the unit of the value over that of the parameter.
    pub by: [f64; N],
    /// The parameters.
    pub at: [f64; N],
}

/// A parameter of a machine under a drive, in the order of [`Sensitivities::by_parameters`].
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
    fn of([mass, stiffness, friction_bound, amplitude, angular_frequency]: [f64; 5], parameter: Self) -> f64 {
        match parameter {
            Self::Mass => mass,
            Self::Stiffness => stiffness,
            Self::FrictionBound => friction_bound,
            Self::Amplitude => amplitude,
            Self::AngularFrequency => angular_frequency,
        }
    }
}

impl Sensitivity<5> {
    /// The derivative by a parameter.
    #[must_use]
    pub fn by(&self, parameter: Parameter) -> f64 {
        Parameter::of(self.by, parameter)
    }

    /// The relative sensitivity to a parameter, of [`Sensitivity::elasticities`].
    #[must_use]
    pub fn elasticity(&self, parameter: Parameter) -> f64 {
        Parameter::of(self.elasticities(), parameter)
    }
}

impl<const N: usize> Sensitivity<N> {
    /// Relative sensitivities `(p/y) ∂y/∂p`: percent of change per percent of each parameter.
    #[must_use]
    pub fn elasticities(&self) -> [f64; N] {
        let mut found = self.by;
        for (slope, parameter) in found.iter_mut().zip(self.at) {
            *slope = *slope * parameter / self.value;
        }
        found
    }

    /// The standard deviation of the value to first order, for independent parameters with these standard
    /// deviations: `√Σ(σᵢ ∂y/∂pᵢ)²`.
    #[must_use]
    pub fn deviation(&self, deviations: [f64; N]) -> f64 {
        self.by
            .iter()
            .zip(deviations)
            .map(|(slope, sigma)| slope * sigma)
            .fold(0.0, crate::float::Field::hypot)
    }
}

/// All outputs with their derivatives with respect to N parameters.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Sensitivities<const N: usize> {
    /// The regime of the steady motion.
    pub regime: Regime,
    /// All outputs that exist.
    pub outputs: Vec<(Output, Sensitivity<N>)>,
}

impl Sensitivities<2> {
    /// The dimensionless outputs and their derivatives with respect to Ω and α, in this order.
    ///
    /// The units are B = r_y/k, Bω_d and radians, which are held constant, as is ζ. Away from the corners
    /// named above, the accuracy is that of the outputs: a few units in the last place of the larger of p
    /// ∂y/∂p and y. Compared with differences at 512 bits, the error is at most 5e-14 of that. It is larger
    /// for the contraction near Ω = 1, ε/|1 − Ω|, and for τ* near 1/(2n), 1e-11.
    #[must_use]
    pub fn by_ratios(ratios: Ratios<f64>) -> Self {
        let [omega, alpha] = Dual::parameters([ratios.omega(), ratios.alpha()]);
        let (zeta, eta) = (Dual::of(ratios.damping_ratio()), Dual::of(ratios.static_friction_ratio()));
        // The ratios were valid before.
        let dual = Ratios::of_valid(omega, alpha, zeta, eta).under(ratios.excitation());
        let at = [ratios.omega(), ratios.alpha()];
        Self::of_response(&Response::new(dual), at, |_| Dual::of(1.0))
    }
}

impl Sensitivities<5> {
    /// The outputs in physical units ([`Output::unit`]) and their derivatives with respect to m, k, r_y, the
    /// amplitude and ω_d, in this order.
    ///
    /// All other parameters are constant, including the damping constant c and the static friction ratio η. If the spring's support moves, a
    /// change of stiffness also changes the force. Both loop sizes are the energy of a cycle, `4 r_y Δ₀`,
    /// computed in two ways.
    ///
    /// # Errors
    /// Where a ratio leaves the domain of [`Ratios`], or a scale overflows or underflows.
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
        Ok(Self::of_response(&Response::new(drive.ratios(&body)?), at, |output| output.unit(&scales)))
    }
}

impl<const N: usize> Sensitivities<N> {
    fn of_response(response: &Response<Dual<N>>, at: [f64; N], unit: impl Fn(Output) -> Dual<N>) -> Self {
        let outputs = Output::ALL.into_iter().filter_map(|output| {
            let found = output.of(response)? * unit(output);
            Some((output, Sensitivity { value: found.value(), by: found.derivatives(), at }))
        });
        Self { regime: response.regime, outputs: outputs.collect() }
    }

    /// One output; `None` where it does not exist.
    #[must_use]
    pub fn of(&self, output: Output) -> Option<Sensitivity<N>> {
        self.outputs.iter().find(|(name, _)| *name == output).map(|(_, found)| *found)
    }
}

#[cfg(test)]
mod tests {
    use super::{Parameter, Sensitivities, Sensitivity};
    use crate::{Border, Cycle, Drive, Oscillator, Output, Ratios, Regime};

    #[test]
    fn percents_and_deviations() {
        let s = Sensitivity { value: 8.0, by: [2.0, -3.0], at: [10.0, 4.0] };
        assert_eq!(s.elasticities(), [2.5, -1.5]);
        // Legs 6 and 2.5 of a right triangle.
        assert_eq!(s.deviation([3.0, -2.5 / 3.0]), 6.5);
    }

    #[test]
    fn by_ratios_is_the_slope_of_a_short_way() {
        let at = |omega, alpha| Cycle::new(Ratios::new(omega, alpha).unwrap()).unwrap().max_displacement;
        let found = Sensitivities::by_ratios(Ratios::new(0.7, 2.0).unwrap());
        let delta = found.of(Output::MaxDisplacement).unwrap();
        assert_eq!((delta.value, found.regime), (at(0.7, 2.0), Regime::NonSticking));
        let h = 1e-6;
        let by_omega = (at(0.7 + h, 2.0) - at(0.7 - h, 2.0)) / (2.0 * h);
        let by_alpha = (at(0.7, 2.0 + h) - at(0.7, 2.0 - h)) / (2.0 * h);
        assert!((delta.by[0] / by_omega - 1.0).abs() < 1e-8 && (delta.by[1] / by_alpha - 1.0).abs() < 1e-8);
        let border = found.of(Output::MinForceRatio).unwrap();
        assert_eq!(border.value, Border::new(0.7).unwrap().min_force_ratio);
        let all = found.outputs.clone();
        assert!(all.len() > 10 && all.contains(&(Output::MaxDisplacement, delta)));
        let sticking = Sensitivities::by_ratios(Ratios::new(0.7, 1.1).unwrap());
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
        let more = based.of(Output::MaxDisplacement).unwrap().by[1] - delta.by[1];
        assert!((more / (delta.by[3] * 9.0 / 8.0) - 1.0).abs() < 1e-12, "{more}");
    }
}
