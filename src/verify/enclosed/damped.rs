//! The cycle with damping in balls, checked against the matching conditions and against motions that are
//! proved to exist.
//!
//! The matching conditions ([`System`]) use the equation of motion and no closed form. The points have ζ
//! below, at and above 1.

#[cfg(test)]
mod mutants;

use super::Residue;
use super::answered::Answered;
use super::point::Place;
use crate::enclosed::Known;
use crate::enclosed::angle::Angle;
use crate::enclosed::damped::{at_border, displacement, half_period, moment, outputs, waves};
use crate::float::ball::Ball;
use crate::float::mp::Mp;
use crate::float::{Field, Real};
use crate::nonsticking::damped::half_period::HalfPeriod;
use crate::nonsticking::damped::rising::Rising;
use crate::nonsticking::matching::Unknowns;
use crate::nonsticking::matching::damped::System;
use crate::nonsticking::max_displacement;
use crate::output::Output;
use crate::verify::damped::{OMEGA, OVER, ZETA};
use rug::Rational;

/// The damped points of [`crate::verify`], with exact ratios.
pub(super) fn places() -> Vec<Place> {
    let pairs = OMEGA.iter().flat_map(|omega| ZETA.iter().map(move |zeta| (*omega, *zeta)));
    let of = |(i, ((omega, zeta), over)): (usize, ((i32, i32), &i32))| {
        let (omega, zeta) = (Rational::from((omega, 100)), Rational::from((zeta, 1000)));
        let (omega, zeta) = (Known::rational(omega), Known::rational(zeta));
        let one = Known::rational(Rational::from(1));
        let (border, _) = at_border(&half_period(&Angle::<5>::new(&omega), &zeta, &one));
        let alpha =
            Mp::<1>::rounded((border.min_force_ratio * Ball::ratio(*over, 100)).mid()).to_rational()?;
        Some(Place { omega, alpha: Known::rational(alpha), zeta, with_motion: true, with_border: i % 5 == 0 })
    };
    pairs.zip(OVER.iter().cycle()).enumerate().filter_map(of).collect()
}

/// The outputs about which there is no statement here.
const PEAKS: [Output; 4] = [
    Output::TransmittedForce,
    Output::Transmissibility,
    Output::MaxAcceleration,
    Output::MaxAbsoluteDisplacement,
];

/// A point and its answers by name, those of the border included.
#[derive(Clone)]
pub(super) struct Found<const W: usize> {
    pub(super) half: HalfPeriod<Ball<W>>,
    alpha: Ball<W>,
    pub(super) values: Vec<(Output, Ball<W>)>,
}

impl<const W: usize> Found<W> {
    pub(super) fn at(place: &Place) -> Option<Self> {
        let angle = Angle::<W>::new(&place.omega);
        let half = half_period(&angle, &place.zeta, &Known::rational(Rational::from(1)));
        let (border, best) = at_border(&half);
        let alpha = place.alpha.ball();
        let mut values = vec![
            (Output::MinForceRatio, border.min_force_ratio),
            (Output::TurningPointForceRatio, border.turning_point),
            (Output::LeastDisplacement, border.least_displacement),
            (Output::TouchingPhase, border.phase?),
            (Output::BestForceRatio, best.0),
            (Output::BestLoopSize, best.1),
        ];
        for (output, value) in outputs(&angle, half, alpha, |output| !PEAKS.contains(&output))? {
            values.push((output, value?));
        }
        Some(Self { half, alpha, values })
    }

    pub(super) fn get(&self, output: Output) -> Ball<W> {
        let found = self.values.iter().find(|(name, _)| *name == output);
        found.map_or_else(Ball::entire, |(_, value)| *value)
    }

    /// The amplitude of the whole motion, in units of B.
    fn scale(&self) -> Ball<W> {
        let half = &self.half;
        let free = Ball::int(1) + half.shift.abs() + half.omega * half.h.abs();
        self.alpha / half.stiffness + free + self.get(Output::MaxDisplacement)
    }

    /// The matching conditions at α.
    fn system(&self, alpha: Ball<W>) -> System<Ball<W>> {
        System::new(self.half.omega, self.half.free.zeta, Ball::int(1) / alpha)
    }

    /// The unknowns of eq. 21–25, lengths in units of p₀/k, with t₂ − π/ω_d < t₁ < t₂.
    fn unknowns(&self) -> Unknowns<Ball<W>> {
        let (first, last) = (self.get(Output::VelocityPhase), self.get(Output::DisplacementPhase));
        let turn = Ball::int(2) * Ball::pi();
        Unknowns {
            velocity_phase: if last.is_below(&first) { first - turn } else { first },
            displacement_phase: last,
            max_velocity: self.get(Output::MaxVelocity) * self.half.omega / self.alpha,
            max_displacement: self.get(Output::MaxDisplacement) / self.alpha,
            deviation: self.get(Output::Deviation) / self.alpha,
        }
    }

    /// The residual of the equation with this number among eq. 21–25, in units of B.
    fn matched(&self, number: usize) -> Option<Ball<W>> {
        let (residuals, _) = self.system(self.alpha).equations_by(&self.unknowns(), waves);
        residuals.get(number).map(|residual| *residual * self.alpha)
    }

    /// x/B and x′/(Bω_n) on the border at the phase after the maximum displacement, by the matching
    /// conditions.
    fn on_border(&self, turn: Ball<W>) -> (Ball<W>, Ball<W>) {
        let (alpha, unknowns) = self.border_unknowns();
        let (x, w) = self.system(alpha).falling_by(&unknowns, turn, waves);
        (x * alpha, w * alpha)
    }

    /// α_min and the known unknowns at the border; the others are zero.
    fn border_unknowns(&self) -> (Ball<W>, Unknowns<Ball<W>>) {
        let (half, zero) = (&self.half, Ball::int(0));
        let (alpha, least) = (self.get(Output::MinForceRatio), self.get(Output::LeastDisplacement));
        let unknowns = Unknowns {
            velocity_phase: zero,
            displacement_phase: half.phase_lag() + (least + half.shift).atan2(half.h),
            max_velocity: zero,
            max_displacement: least / alpha,
            deviation: zero,
        };
        (alpha, unknowns)
    }

    /// Δ₀/B at any α, and the amplitude a = Δ₀/B + G.
    fn displacement_at(&self, alpha: Ball<W>) -> (Ball<W>, Ball<W>) {
        let amplitude = max_displacement(self.half.k, alpha, self.half.stiffness);
        (amplitude - self.half.shift, amplitude)
    }

    /// The answers for comparison with proved motions.
    pub(super) fn answered(&self) -> Answered<W> {
        let (half, get) = (&self.half, |output| self.get(output));
        // λ₁ + λ₂ = −(M₁₁ + sM₂₂), λ₁λ₂ = s e^{−2ζT}, s = (R − 1)/(R + 1)
        let one = Ball::int(1);
        let amplitude = get(Output::MaxDisplacement) + half.shift;
        let r = Rising::new(*half, amplitude).deceleration();
        let s = (r - one) / (r + one);
        let turned = half.free.zeta * half.sine;
        Answered {
            scale: self.scale(),
            max_displacement: get(Output::MaxDisplacement),
            displacement_phase: get(Output::DisplacementPhase),
            max_velocity: get(Output::MaxVelocity),
            sum: -((half.cosine + turned) + s * (half.cosine - turned)),
            product: s * half.decay.square(),
            contraction: get(Output::Contraction),
            min_force_ratio: get(Output::MinForceRatio),
        }
    }
}

/// One statement: the left side minus the right side is zero.
pub(super) struct Claim<const W: usize> {
    pub(super) equation: &'static str,
    pub(super) statement: &'static str,
    residual: fn(&Found<W>) -> Option<Ball<W>>,
}

/// The statements with damping.
pub(super) fn claims<const W: usize>() -> Vec<Claim<W>> {
    let row = |equation, statement, residual| Claim { equation, statement, residual };
    vec![
        row("21, ζ", "matching with damping: x₁′(t₂) = 0", |f| f.matched(0)),
        row("22, ζ", "matching with damping: x₂′(t₃) = −V₀", |f| f.matched(1)),
        row("23, ζ", "matching with damping: x₁(t₂) = Δ₀", |f| f.matched(2)),
        row("24, ζ", "matching with damping: x₂(t₃) = −Δ₁", |f| f.matched(3)),
        row("25, ζ", "matching with damping: x″(t₁) = 0", |f| f.matched(4)),
        row("16, ζ", "with damping the waveform and its velocity are the matched branch", |f| {
            let turn = Ball::pi() / Ball::int(3);
            let (x, w) = f.system(f.alpha).falling_by(&f.unknowns(), turn, waves);
            // The rising half is the falling half with the opposite sign, with a = Δ₀/B + G.
            let rising = Rising::new(f.half, f.get(Output::MaxDisplacement) + f.half.shift);
            let at = moment(&f.half, turn / f.half.omega);
            let [velocity, ..] = rising.velocity(&at);
            Some((displacement(&rising, &at) + x * f.alpha).abs() + (velocity + w * f.alpha).abs())
        }),
        row(
            "62, ζ",
            "on the damped border the body is at −Δ₀, at rest, half a period after Δ₀ = S − G",
            |f| {
                let (x, w) = f.on_border(Ball::pi());
                Some((x + f.get(Output::LeastDisplacement)).abs() + w.abs())
            },
        ),
        row("62, ζ", "on the damped border velocity and acceleration are zero at τ*", |f| {
            let tau = f.get(Output::TouchingPhase);
            let (x, w) = f.on_border(tau);
            let (alpha, unknowns) = f.border_unknowns();
            let sine = (unknowns.displacement_phase + tau).sin();
            let damper = Ball::int(2) * f.half.free.zeta * w;
            Some(w.abs() + (alpha * sine - x - damper + Ball::int(1)).abs())
        }),
        row("61, ζ", "the turning point's border is not above the border", |f| {
            let excess = f.get(Output::MinForceRatio) - f.get(Output::TurningPointForceRatio);
            Some(excess.abs() - excess)
        }),
        row("64, ζ", "with damping A₁ is 4 r_y Δ₀ over p₀²/2k", |f| {
            let work = f.get(Output::LoopSizeStiffness) * f.alpha.square() / Ball::int(2);
            Some(work - Ball::int(4) * f.get(Output::MaxDisplacement))
        }),
        row("67, ζ", "with damping A₂ is Ω² A₁", |f| {
            let inertia = f.get(Output::LoopSizeInertia);
            Some(inertia - f.get(Output::LoopSizeStiffness) * f.half.omega.square())
        }),
        row("65, ζ", "with damping A₁ is stationary at α*", |f| {
            // d(Δ₀/α²)/dα = 0 is equivalent to α² = 2 q² a Δ₀.
            let best = f.get(Output::BestForceRatio);
            let (delta, amplitude) = f.displacement_at(best);
            let two = Ball::int(2);
            Some((best.square() - two * f.half.stiffness.square() * amplitude * delta) / best)
        }),
        row("66, ζ", "with damping A₁ at α* is A₁max", |f| {
            let best = f.get(Output::BestForceRatio);
            let (delta, _) = f.displacement_at(best);
            Some(Ball::int(8) * delta / best.square() - f.get(Output::BestLoopSize))
        }),
    ]
}

/// The residual of every statement at a point; `None` where this precision does not find the answers.
pub(super) fn residues<const W: usize>(
    place: &Place,
    alter: impl Fn(Found<W>) -> Found<W>,
) -> Option<Vec<Option<Residue>>> {
    let found = alter(Found::at(place)?);
    let scale = found.scale();
    Some(claims().iter().map(|claim| (claim.residual)(&found).map(|r| Residue::of(r, scale))).collect())
}
