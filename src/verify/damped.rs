//! The cycle with viscous damping, checked against the same three references: the matching conditions, the
//! exact motion, and Newton's method.
//!
//! The matching conditions ([`System`]) use the equation of motion and no closed form. The identities of the
//! damped cycle are not in the paper: each carries the number of the equation that it becomes at ζ = 0,
//! followed by "ζ".

mod formulae;
mod identities;
#[cfg(test)]
mod mutants;

use super::edge::{loop_size, stops_beside};
use super::followed::Motion;
use super::solved::points as points_of_a_half_cycle;
use super::{Digits, Solvable, Standing, Tally, Verdict};
use crate::float::Float;
use crate::nonsticking::Cycle;
use crate::nonsticking::damped::half_period;
use crate::nonsticking::matching::Unknowns;
use crate::nonsticking::matching::damped::System;
use crate::nonsticking::matching::newton::Solution;
use crate::ratios::Ratios;
use core::ops::ControlFlow;
use formulae::{Answers, Edge};
pub(super) use formulae::{Formulae, Library};
use identities::identities;

/// One identity with damping.
struct Identity<F> {
    equation: &'static str,
    statement: &'static str,
    digits: Digits,
    residual: fn(&Case<'_, F>) -> Option<F>,
}

/// A cycle with all quantities that the identities use.
struct Case<'a, F> {
    formulae: &'a dyn Formulae<F>,
    cycle: Cycle<F>,
    answers: Answers<F>,
    unknowns: Unknowns<F>,
    system: System<F>,
    /// The amplitude of the whole motion, in units of B.
    scale: F,
    motion: Option<Motion<F>>,
    solved: Option<Solution<F>>,
    /// The border, with eq. 21–25 solved there and the stops of the exact motion below and above.
    border: Option<OnBorder<F>>,
}

/// The results on the border.
struct OnBorder<F> {
    edge: Edge<F>,
    system: System<F>,
    solved: Solution<F>,
    stops: Option<(u32, u32)>,
    /// A₁ by the exact motion at the best force ratio, and its relative slope there.
    best: Option<(F, F)>,
}

/// The frequency ratios in hundredths, and the damping ratios in thousandths: below, at and above ζ = 1.
pub(super) const OMEGA: [i32; 12] = [18, 24, 29, 34, 41, 47, 70, 95, 100, 105, 150, 400];
pub(super) const ZETA: [i32; 6] = [10, 50, 200, 700, 1000, 1600];
/// α over the border in hundredths, used in turn.
pub(super) const OVER: [i32; 3] = [101, 150, 400];

/// The number of points.
pub(super) const POINTS: usize = OMEGA.len() * ZETA.len();

/// Checks the identities with damping for the cycles at a set of points. `step` receives the number of points
/// done, before each point and after the last.
pub(super) fn verify_by<F: Solvable, B>(
    formulae: &dyn Formulae<F>,
    mut step: impl FnMut(usize) -> ControlFlow<B>,
) -> ControlFlow<B, Vec<Verdict>> {
    let identities = identities::<F>();
    let mut tallies = vec![Tally { points: 0, worst: None }; identities.len()];
    let places = OMEGA.iter().flat_map(|omega| ZETA.iter().map(move |zeta| (*omega, *zeta)));
    for (done, (omega, zeta)) in places.enumerate() {
        step(done)?;
        let over = OVER.iter().cycle().nth(done).map_or(F::int(2), |&over| F::ratio(over, 100));
        let Some(cycle) = above_border(F::ratio(omega, 100), F::ratio(zeta, 1000), over) else { continue };
        // Beyond 512 bits only every third motion is computed.
        let with_motion = F::PRECISION <= 512 || done.is_multiple_of(3);
        let case = Case::at(formulae, cycle, with_motion);
        for (identity, tally) in identities.iter().zip(&mut tallies) {
            let unit = match identity.digits {
                Digits::All => F::int(1),
                Digits::Half => F::epsilon().sqrt(),
            };
            if let Some(residual) = (identity.residual)(&case) {
                tally.add(Standing::Holds, residual.abs() / case.scale * unit, &cycle);
            }
        }
        step(done.saturating_add(1))?;
    }
    ControlFlow::Continue(
        identities
            .iter()
            .zip(tallies)
            .map(|(identity, tally)| tally.verdict(identity.equation, identity.statement, Standing::Holds))
            .collect(),
    )
}

/// The cycle at α `times` the exact border.
fn above_border<F: Float>(omega: F, zeta: F, times: F) -> Option<Cycle<F>> {
    let least = crate::Border::with_damping(omega, zeta).ok()?.min_force_ratio;
    Ratios::new(omega, least * times).and_then(|r| r.with_damping_ratio(zeta)).and_then(Cycle::new).ok()
}

impl<'a, F: Solvable> Case<'a, F> {
    fn at(formulae: &'a dyn Formulae<F>, cycle: Cycle<F>, with_motion: bool) -> Self {
        let (ratios, answers) = (cycle.ratios, formulae.answers(&cycle));
        let half = half_period(&ratios);
        let (one, two, alpha) = (F::int(1), F::int(2), ratios.alpha());
        let early = answers.velocity_phase > answers.displacement_phase;
        let turn = if early { two * F::pi() } else { F::int(0) };
        let unknowns = Unknowns {
            velocity_phase: answers.velocity_phase - turn,
            displacement_phase: answers.displacement_phase,
            max_velocity: answers.max_velocity * ratios.omega() / alpha,
            max_displacement: answers.max_displacement / alpha,
            deviation: answers.deviation / alpha,
        };
        let free = one + half.shift.abs() + half.omega * half.h.abs();
        Self {
            formulae,
            cycle,
            answers,
            unknowns,
            system: System::new(ratios.omega(), ratios.damping_ratio(), one / alpha),
            scale: alpha / half.stiffness + free + cycle.max_displacement,
            motion: if with_motion { Motion::at(ratios) } else { None },
            solved: F::solve(ratios).ok(),
            border: if with_motion { OnBorder::at(formulae, &ratios) } else { None },
        }
    }
}

impl<F: Float> Case<'_, F> {
    fn omega(&self) -> F {
        self.cycle.ratios.omega()
    }

    fn alpha(&self) -> F {
        self.cycle.ratios.alpha()
    }

    /// The residual of `found = expected`, where `doubt` is the difference that causes other than rounding
    /// may produce.
    fn within(&self, residual: F, size: F, doubt: F) -> F {
        residual / (F::epsilon() * size + doubt) * F::epsilon() * self.scale
    }

    /// A difference of two numbers of this `size`, relative to the accuracy of the solution of eq. 21–25.
    fn in_good_digits(&self, solution: &Solution<F>, difference: F, size: F) -> F {
        let lost = F::exp2i((solution.lost_bits as i32).min(F::RATIO_EXPONENT));
        difference / (size * lost) * self.scale
    }
}

impl<F: Solvable> OnBorder<F> {
    fn at(formulae: &dyn Formulae<F>, ratios: &Ratios<F>) -> Option<Self> {
        let edge = formulae.edge(ratios);
        let at = |alpha: F| {
            let ratios =
                Ratios::new(ratios.omega(), alpha).and_then(|r| r.with_damping_ratio(ratios.damping_ratio()));
            ratios.ok()
        };
        let solved = F::solve(at(edge.min_force_ratio)?).ok()?;
        let (best, _) = formulae.best(ratios);
        Some(Self {
            system: System::new(ratios.omega(), ratios.damping_ratio(), F::int(1) / edge.min_force_ratio),
            stops: stops_beside(ratios.omega(), edge.min_force_ratio, at),
            best: slope_of_loop_size(best, edge.min_force_ratio, at),
            edge,
            solved,
        })
    }
}

/// A₁ of the exact motion at α, and `(α/A₁) dA₁/dα` there by central differences; `None` where the body stops
/// at α or slightly below.
fn slope_of_loop_size<F: Float>(alpha: F, least: F, at: impl Fn(F) -> Option<Ratios<F>>) -> Option<(F, F)> {
    let (one, h) = (F::int(1), super::followed::third_of_digits::<F>());
    if alpha < least * F::ratio(101, 100) {
        return None;
    }
    let size = |alpha: F| loop_size(at(alpha)?);
    let (here, ahead, back) = (size(alpha)?, size(alpha * (one + h))?, size(alpha * (one - h))?);
    Some((here, (ahead - back) / (F::int(2) * h * here)))
}
