//! The section for shooting: a point in the middle of a slide, found from a start or from a closed form.

use super::shooting::Guess;
use crate::cycle::{Cycle, SixReversals};
use crate::float::Float;
use crate::motion::broken::{Broken, Budget};
use crate::motion::drive_phase::DrivePhase;
use crate::motion::slide::Slide;
use crate::motion::slide::equation::Equation;
use crate::motion::state::{PhasePoint, State};
use crate::motion::trajectory::{Body, Trajectory};

/// Follows the motion for two half turns, and takes the middle of its longest slide as the section, with the
/// natural time to its first velocity zero.
///
/// # Errors
/// [`crate::Error::SearchBound`], [`crate::Error::Interrupted`].
pub(crate) fn settle_in<F: Float>(
    equation: Equation<F>,
    start: State<F>,
    budget: &mut Budget<'_>,
) -> Result<(PhasePoint<F>, F), Broken> {
    let mut longest: Option<(Slide<F>, F)> = None;
    let begin = start.phase;
    let turn = F::pi();
    for phase in Trajectory::of(equation, start) {
        let phase = phase?;
        budget.ask()?;
        let Body::Slide(slide, end) = &phase.body else { continue };
        let longer = longest.as_ref().is_none_or(|(_, length)| end.phi >= *length);
        let after = end.phase.since(begin);
        if longer || after < turn {
            longest = Some((*slide, end.phi));
        }
        if after >= F::int(2) * turn {
            break;
        }
    }
    budget.spend(2);
    let here = PhasePoint { phase: begin, ..PhasePoint::of(&start, equation.omega) };
    let Some((slide, length)) = longest else { return Ok((here, turn / equation.omega)) };
    let half = length / F::int(2);
    Ok((slide.point(half), half))
}

/// A cycle without stops and without damping as a second start of the shooting method. Below Ω = 2/3 the cycle is
/// known to be the limit if Δ₀ is not large compared with the force.
pub(crate) fn cycle_guess<F: Float>(equation: Equation<F>, cycle: &Cycle<F>) -> Guess<F> {
    let (at, hint) = fastest_point(equation, cycle);
    Guess { at, hint, is_limit: equation.omega * F::int(3) < F::int(2) }
}

/// The fastest point of a non-sticking cycle, (Δ₁, V₀) at ω_d t₁, and the natural time from there to the
/// maximum displacement.
pub(crate) fn fastest_point<F: Float>(equation: Equation<F>, cycle: &Cycle<F>) -> (PhasePoint<F>, F) {
    let lag = cycle.displacement_phase - cycle.velocity_phase;
    let lag = if lag < F::int(0) { lag + F::int(2) * F::pi() } else { lag };
    let phase = DrivePhase::of_half_turn(0, F::int(0)).advanced(cycle.velocity_phase);
    let point = PhasePoint { phase, x: cycle.deviation(), w: cycle.max_velocity * equation.omega };
    (point, lag / equation.omega)
}

/// A point of the six-reversal cycle half way from its third reversal to the next, and the natural time to
/// the next reversal.
pub(crate) fn on_six_reversals<F: Float>(
    equation: Equation<F>,
    cycle: &SixReversals<F>,
) -> (PhasePoint<F>, F) {
    let [first, _, third] = cycle.reversal_phases();
    let next = first + F::pi();
    let theta = (third + next) / F::int(2);
    let phase = DrivePhase::of_half_turn(0, F::int(0)).advanced(theta);
    let (x, w) = (cycle.displacement_at(theta), cycle.velocity_at(theta) * equation.omega);
    (PhasePoint { phase, x, w }, (next - theta) / equation.omega)
}

#[cfg(test)]
mod tests {
    use super::fastest_point;
    use crate::Ratios;
    use crate::cycle::Cycle;
    use crate::motion::slide::equation::Equation;
    use crate::motion::slide::{Direction, Slide};

    /// The body reaches its maximum displacement from the fastest point of a cycle in the stated time.
    #[test]
    fn from_the_fastest_point_to_the_farthest() {
        for (omega, alpha) in
            [(0.3f64, 13.0f64), (0.4, 9.0), (0.7, 2.0), (1.0 + 1e-6, 2.0), (1.3, 3.0), (5.0, 2.0)]
        {
            let ratios = Ratios::new(omega, alpha).unwrap();
            let (equation, cycle) = (Equation::new(ratios), Cycle::new(ratios).unwrap());
            let (point, time) = fastest_point(equation, &cycle);
            let slide = Slide::new(equation, point.phase, point.x, point.w, Direction::Forward);
            let at = slide.motion(time);
            let size = cycle.max_displacement;
            assert!(
                time > 0.0 && at.w.abs() < 1e-12 * size && (at.x - size).abs() < 1e-12 * size,
                "{omega}: {at:?}"
            );
        }
    }
}
