//! Wrong answers and wrong formulae with damping, one at a time: some ball must exclude 0.

use super::super::proved::{DAMPED, against};
use super::{Found, claims, places, residues};
use crate::float::ball::Ball;
use crate::float::{Field, Real};
use crate::nonsticking::damped::half_period::HalfPeriod;
use crate::output::Output;

const W: usize = 5;
type B = Ball<W>;
type F = Found<W>;

/// A statement that a ball without 0 refutes at some point.
fn refuted(alter: impl Fn(F) -> F, each: usize) -> Option<&'static str> {
    places().iter().step_by(each).find_map(|place| {
        let claims = claims::<W>();
        let by_form = residues(place, &alter)?.into_iter().zip(claims.iter().map(|claim| claim.statement));
        let excludes = |found: Option<super::Residue>| found.is_some_and(|residue| !residue.has_zero);
        let by_form =
            by_form.filter(|(residue, _)| excludes(*residue)).map(|(_, statement)| statement).next();
        by_form.or_else(|| {
            let answered = Found::at(place).map(&alter).map(|found| found.answered());
            let mut found = against(place, 160, answered).into_iter().zip(DAMPED);
            found.find(|(residue, _)| excludes(*residue)).map(|(_, (_, statement))| statement)
        })
    })
}

/// A number increased by one part in 10⁴⁰.
fn off(x: B) -> B {
    x + (0..40).fold(x, |x, _| x / B::int(10))
}

fn with(mut found: F, output: Output, change: impl Fn(B) -> B) -> F {
    for (name, value) in &mut found.values {
        if *name == output {
            *value = change(*value);
        }
    }
    found
}

/// a = Δ₀/B + G.
fn amplitude(found: &F) -> B {
    found.get(Output::MaxDisplacement) + found.half.shift
}

/// α_min computed from another S, with the phase unchanged.
fn border(found: F, s: B) -> F {
    let half = found.half;
    let found = with(found, Output::MinForceRatio, |_| half.stiffness * s.hypot(half.h));
    with(found, Output::LeastDisplacement, |_| s - half.shift)
}

/// All outputs that have a statement of their own.
const OUTPUTS: [Output; 14] = [
    Output::MinForceRatio,
    Output::TurningPointForceRatio,
    Output::LeastDisplacement,
    Output::TouchingPhase,
    Output::BestForceRatio,
    Output::BestLoopSize,
    Output::MaxDisplacement,
    Output::DisplacementPhase,
    Output::MaxVelocity,
    Output::VelocityPhase,
    Output::Deviation,
    Output::LoopSizeStiffness,
    Output::LoopSizeInertia,
    Output::Contraction,
];

/// A part of the half period.
type Part = fn(&mut HalfPeriod<B>) -> &mut B;
const PARTS: [(&str, Part); 8] = [
    ("G", |half| &mut half.shift),
    ("H", |half| &mut half.h),
    ("K", |half| &mut half.k),
    ("q", |half| &mut half.stiffness),
    ("2ζΩ", |half| &mut half.lag.0),
    ("e^{−ζT}", |half| &mut half.decay),
    ("e^{−ζT} cos dT", |half| &mut half.cosine),
    ("e^{−ζT} sin(dT)/d", |half| &mut half.sine),
];

type Wrong = (&'static str, fn(F) -> F);
const WRONG: [Wrong; 22] = [
    ("Δ₀ without G", |f| {
        let a = amplitude(&f);
        with(f, Output::MaxDisplacement, |_| a)
    }),
    ("Δ₀ with +G", |f| {
        let shift = f.half.shift;
        with(f, Output::MaxDisplacement, |x| x + B::int(2) * shift)
    }),
    ("G with the other sign", |mut f| {
        f.half.shift = -f.half.shift;
        f
    }),
    ("H with the other sign", |mut f| {
        f.half.h = -f.half.h;
        f
    }),
    ("|1 − Ω²| for q", |mut f| {
        f.half.stiffness = f.half.lag.1.abs();
        f
    }),
    ("t₂ without the lag", |f| {
        let at = amplitude(&f).atan2(f.half.h);
        with(f, Output::DisplacementPhase, |_| at)
    }),
    ("t₂ with the lag subtracted", |f| {
        let lag = f.half.phase_lag();
        with(f, Output::DisplacementPhase, |at| at - lag - lag)
    }),
    ("cos(ω_d t₂ − δ) = −K/α", |f| {
        let at = f.half.phase_lag() + amplitude(&f).atan2(-f.half.h);
        with(f, Output::DisplacementPhase, |_| at)
    }),
    ("V₀ over ω_n", |f| {
        let omega = f.half.omega;
        with(f, Output::MaxVelocity, |v| v * omega)
    }),
    ("V₀ of the drive alone", |f| {
        let driven = f.alpha / f.half.stiffness;
        with(f, Output::MaxVelocity, |_| driven)
    }),
    ("t₁ half a turn off", |f| with(f, Output::VelocityPhase, |at| at + B::pi())),
    ("Δ₁ without the damper's force", |f| {
        let held = f.alpha * f.get(Output::VelocityPhase).sin() - B::int(1);
        with(f, Output::Deviation, |_| held)
    }),
    ("A₁ by a for Δ₀", |f| {
        let size = B::int(8) * amplitude(&f) / f.alpha.square();
        with(f, Output::LoopSizeStiffness, |_| size)
    }),
    ("A₂ = Ω A₁", |f| {
        let omega = f.half.omega;
        with(f, Output::LoopSizeInertia, |size| size / omega)
    }),
    ("α* of ζ = 0", |f| {
        let k = f.half.k.abs();
        with(f, Output::BestForceRatio, |_| B::int(2).sqrt() * k)
    }),
    ("A₁max of ζ = 0", |f| {
        let (k, q) = (f.half.k.abs(), f.half.stiffness);
        with(f, Output::BestLoopSize, |_| B::int(4) / (k * q))
    }),
    ("S = 1/Ω²", |f| {
        let s = B::int(1) / f.half.omega.square();
        border(f, s)
    }),
    ("S without G", |f| {
        let s = (B::int(1) + f.half.lag.0 * f.half.h) / f.half.omega.square();
        border(f, s)
    }),
    ("S without 2ζΩH", |f| {
        let s = (B::int(1) + f.half.shift) / f.half.omega.square();
        border(f, s)
    }),
    ("the turning point alone", |f| {
        let s = f.half.holding() / f.half.omega.square();
        border(f, s)
    }),
    ("the mirror image of τ*", |f| with(f, Output::TouchingPhase, |at| B::pi() - at)),
    ("the contraction of a whole cycle", |f| with(f, Output::Contraction, |c| c.square())),
];

#[test]
fn every_wrong_answer_with_damping_is_excluded_by_a_ball() {
    assert_eq!(refuted(|found| found, 7), None);
    let mut passing = Vec::new();
    for output in OUTPUTS {
        if refuted(|found| with(found, output, off), 1).is_none() {
            passing.push(output.name());
        }
    }
    for (name, part) in PARTS {
        let alter = |mut found: F| {
            let part = part(&mut found.half);
            *part = off(*part);
            found
        };
        if refuted(alter, 1).is_none() {
            passing.push(name);
        }
    }
    for (what, alter) in WRONG {
        if refuted(alter, 1).is_none() {
            passing.push(what);
        }
    }
    assert!(passing.is_empty(), "{passing:#?}");
}
