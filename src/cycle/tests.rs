use super::phase_function::PhaseFunction;
use super::{Cycle, den_hartog, matching};
use crate::float::Float;
use crate::{Error, Ratios};
use std::f64::consts::TAU;

fn cycle(omega: f64, alpha: f64) -> Result<Cycle<f64>, Error> {
    Ratios::new(omega, alpha).and_then(Cycle::new)
}

#[test]
fn the_equations_that_know_no_damping_have_no_number_for_it() {
    let damped = Ratios::new(0.7, 3.0).unwrap().with_damping_ratio(0.05).unwrap();
    let amplitude: f64 = Cycle::new(damped).unwrap().given().amplitude;
    assert!(amplitude.is_nan());
}

#[test]
fn below_the_border_there_is_no_cycle() {
    assert!(matches!(cycle(0.4, 6.0), Err(Error::Sticks { .. })));
    assert!(cycle(0.4, 7.0).is_ok());
    assert!(matches!(cycle(1.0, 1.2), Err(Error::Sticks { .. })));
    assert!(matches!(cycle(1.0, 1.3), Err(Error::Unbounded { .. })));
}

#[test]
fn the_waveform_passes_through_its_named_points() {
    for (omega, alpha) in [(0.3, 14.0), (0.4, 9.0), (0.7, 2.0), (1.0 + 1e-9, 1.5), (1.5, 2.5), (3.0, 4.0)] {
        let c = cycle(omega, alpha).unwrap();
        let scale = 1e-13 * c.max_displacement;
        let close = |a: f64, b: f64| assert!((a - b).abs() < scale, "{omega} {alpha}: {a} {b}");
        for turn in [-TAU, 0.0, TAU] {
            close(c.displacement_at(c.displacement_phase + turn), c.max_displacement);
            close(c.displacement_at(c.velocity_phase + turn), c.deviation());
            close(c.velocity_at(c.velocity_phase + turn), c.max_velocity);
            close(c.velocity_at(c.displacement_phase + turn), 0.0);
        }
        // x(t + π/ω_d) = −x(t)
        for i in 0..40 {
            let phase = f64::from(i) * TAU / 40.0;
            close(c.displacement_at(phase + TAU / 2.0), -c.displacement_at(phase));
            close(c.velocity_at(phase + TAU / 2.0), -c.velocity_at(phase));
        }
    }
}

#[test]
fn single_precision_runs_the_same_code() {
    let c = Ratios::new(0.7f32, 2.0).and_then(Cycle::new).unwrap();
    assert!((c.max_displacement - 3.488_508).abs() < 2e-6);
    assert!((c.max_velocity - 3.761_24).abs() < 2e-6);
}

/// Near Ω = 1 with and without damping, where √(α² − K²) on the border has no accurate digit.
#[test]
fn on_the_border_a_cycle_is_no_smaller_than_its_turning_points_ask_for() {
    for zeta in [0.0, 8.67e-19, 1e-15, 1e-12] {
        let at =
            |alpha| Ratios::new(1.000_000_000_116_415_3, alpha).unwrap().with_damping_ratio(zeta).unwrap();
        let cycle = Cycle::new(at(crate::cycle::Border::of(&at(2.0)).min_force_ratio)).unwrap();
        let (far, fast) = (cycle.max_displacement, cycle.max_velocity);
        assert!(far > 0.99 && fast > 0.99, "{zeta}: {far} {fast}");
    }
}

/// With static friction, the cycle begins at its own, higher border and is the same as with one friction; at
/// Ω = 1 there is none.
#[test]
fn with_static_friction_the_cycle_begins_at_its_own_border() {
    for omega in [0.28, 0.4, 0.7, 1.0, 1.6, 3.0] {
        let ratios =
            |alpha: f64, eta| Ratios::new(omega, alpha).unwrap().with_static_friction_ratio(eta).unwrap();
        let least = crate::Border::of(&ratios(2.0, 1.5)).min_force_ratio;
        assert!(least >= crate::Border::new(omega).unwrap().min_force_ratio);
        for alpha in [least, least * 1.3, least * 40.0] {
            let found = Cycle::new(ratios(alpha, 1.5));
            assert_eq!(Cycle::find(ratios(alpha, 1.5)), found.clone().ok(), "{omega} {alpha}");
            if omega == 1.0 {
                assert!(matches!(found, Err(Error::Unbounded { .. })), "{alpha}: {found:?}");
                continue;
            }
            let (found, one) = (found.unwrap(), Cycle::new(ratios(alpha, 1.0)).unwrap());
            let of = |c: &Cycle<f64>| {
                [c.max_displacement, c.displacement_phase, c.max_velocity, c.velocity_phase, c.deviation()]
            };
            assert_eq!(of(&found), of(&one), "{omega} {alpha}");
        }
        for alpha in [least.next_down(), 0.9 * least] {
            let found = Cycle::new(ratios(alpha, 1.5));
            assert!(matches!(found, Err(Error::Sticks { .. })), "{omega} {alpha}: {found:?}");
        }
    }
}

/// The cycle as the matching problem and as Den Hartog's half cycle: both are equations without damping.
impl<F: Float> Cycle<F> {
    /// The given quantities of the paper's matching problem: A/B, B/B = 1 and Ω. Its equations have no
    /// damping: with damping A is NaN.
    pub(crate) fn given(&self) -> matching::Given<F> {
        matching::Given {
            amplitude: self.undamped_amplitude(),
            friction_displacement: F::int(1),
            omega: self.ratios.omega(),
        }
    }

    /// The solution of the matching problem (eq. 21–25), lengths in units of B, with ω_d t₁ taken so that
    /// t₂ − π/ω_d < t₁ < t₂.
    pub(crate) fn unknowns(&self) -> matching::Unknowns<F> {
        let early = self.velocity_phase > self.displacement_phase;
        let turn = if early { F::int(2) * F::pi() } else { F::int(0) };
        matching::Unknowns {
            velocity_phase: self.velocity_phase - turn,
            displacement_phase: self.displacement_phase,
            max_velocity: self.max_velocity * self.ratios.omega(),
            max_displacement: self.max_displacement,
            deviation: self.deviation(),
        }
    }

    /// Den Hartog's half cycle of the same motion (eq. 54), in units of B. NaN with damping.
    pub(crate) fn den_hartog(&self) -> den_hartog::FallingHalf<F> {
        let one = F::int(1);
        den_hartog::FallingHalf {
            amplitude: self.undamped_amplitude(),
            friction_displacement: one,
            omega: self.ratios.omega(),
            phase_lag: den_hartog::phase_lag(self.displacement_phase),
            c1: den_hartog::sine_coefficient(one, PhaseFunction::of_valid(self.ratios.omega()).tangent()),
            c2: den_hartog::cosine_coefficient(one),
        }
    }

    /// The forced amplitude A/B of the equations without damping; NaN with damping.
    fn undamped_amplitude(&self) -> F {
        if self.ratios.is_damped() { F::int(0) / F::int(0) } else { self.ratios.forced_amplitude() }
    }
}
