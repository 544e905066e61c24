//! The border, its touching phase, cycles as functions of the phase and families, beside dense samples: in ratios.

use crate::compared::Origin::DenseSamples;
use crate::compared::{agreed, compared, near};
use crate::random::Random;
use crate::sampled::{Cycle as Sampled, Harmonic, Limit, Load, Machine, Of};
use std::f64::consts::TAU;
use stickslip::cycle::SixReversals;
use stickslip::uncertainty::{Interval, ParameterBox, Range};
use stickslip::{Border, Cycle, Output, PhaseFunction, Ratios, Verdict};

fn harmonic([omega, alpha, zeta, eta]: [f64; 4]) -> Harmonic {
    let machine = Machine::new([1.0, 1.0, 2.0 * zeta], [1.0, 0.0, eta], 0.0);
    Harmonic { machine, load: Load::Force, amplitude: alpha, frequency: omega }
}

fn ratios([omega, alpha, zeta, eta]: [f64; 4]) -> Ratios<f64> {
    let ratios = Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
    ratios.with_static_friction_ratio(eta).unwrap()
}

fn sampled(at: [f64; 4], start: [f64; 2]) -> Option<Sampled> {
    match harmonic(at).limit(start, 0.0, 4000) {
        Limit::Periodic(cycle) => Some(*cycle),
        Limit::Rest(_) | Limit::Unsettled => None,
    }
}

/// On the border: the displacement, and the phase after its maximum at which the velocity touches zero; with static
/// friction the force at the turning point is what holds the body.
#[test]
fn the_motion_on_the_border_touches_zero_where_it_is_said() {
    let mut random = Random(51);
    let (mut touched, mut turned) = (0, 0);
    for i in 0..60 {
        let zeta = if i % 2 == 0 { 0.0 } else { random.scale(1e-2, 0.5) };
        let eta = if i % 4 == 3 { random.between(1.1, 2.0) } else { 1.0 };
        let omega = random.scale(0.15, 2.0);
        let border = Border::of(&ratios([omega, 1.0, zeta, eta]));
        let alpha = border.min_force_ratio * (1.0 + 1e-7);
        // With static friction the cycle is the limit of its neighbourhood: the samples start on it.
        let Ok(cycle) = Cycle::new(ratios([omega, alpha, zeta, eta])) else { panic!("{omega} {zeta} {eta}") };
        let phase = cycle.displacement_phase;
        let at = [omega, alpha, zeta, eta];
        let start = [cycle.max_displacement, 0.0];
        let Limit::Periodic(found) = harmonic(at).limit(start, phase, 3000) else { continue };
        let most = found.found.most(Of::Displacement);
        // The displacement changes with the force as 1/|1 − Ω²|.
        let room = 1e-5 / (1.0 - omega * omega).abs().min(1.0);
        near("border least_displacement", border.least_displacement, most.value, DenseSamples, room);
        let tau = border.border_phase;
        if tau == 0.0 {
            // The force left over at the turning point is that of the static bound.
            turned += 1;
            let left = (alpha * (omega * most.time).sin() - most.value).abs();
            compared("border border_phase", left, eta, DenseSamples, 1e-4 * (1.0 + alpha));
        } else {
            touched += 1;
            let speeds = harmonic(at).states(&found, omega * most.time + tau);
            let fastest = found.found.most(Of::Velocity).value;
            compared("border border_phase", speeds[0][1], 0.0, DenseSamples, 1e-3 * fastest);
        }
    }
    assert!(touched > 8 && turned > 12, "{touched} {turned}");
}

/// The border's minima and the bands in which eq. 61 falls short, beside other frequencies by the samples; its slope
/// beside differences.
#[test]
fn minima_slopes_and_shortfalls_of_the_border_are_those_of_the_samples() {
    let is_free = |omega: f64, alpha: f64| {
        let cycle = sampled([omega, alpha, 0.0, 1.0], [0.0, 0.0]);
        cycle.is_some_and(|cycle| cycle.found.rests == 0 && cycle.found.ends == 2)
    };
    for lobe in 0..2 {
        let minimum = Border::<f64>::minimum(lobe);
        let is_reached = is_free(minimum.omega, minimum.force_ratio * (1.0 + 1e-5));
        let beside = [0.97, 0.99, 1.01, 1.03]
            .map(|by| is_free(minimum.omega * by, minimum.force_ratio * (1.0 - 1e-9)));
        agreed("fn Border::minimum", (is_reached, beside), (true, [false; 4]), DenseSamples);
        assert!(!minimum.is_corner);
    }
    let short = Border::<f64>::shortfall(1).unwrap();
    assert!((short.pole - 1.0 / 3.0).abs() < 1e-15 && (short.high - 0.5).abs() < 1e-15);
    for omega in [0.97 * short.low, 1.02 * short.low, 0.45, 0.52] {
        let printed = Border::new(omega).unwrap().min_force_ratio_turning_point;
        let is_short = omega > short.low && omega < short.high;
        for of in ["response", "border"] {
            let output = format!("{of} min_force_ratio_turning_point by Border::new, Border::shortfall");
            agreed(&output, is_free(omega, printed * (1.0 + 1e-6)), !is_short, DenseSamples);
        }
    }
    for omega in [0.27, 0.41, 0.7, 0.9, 1.4, 2.3] {
        let slope: f64 = Border::slope(&PhaseFunction::new(omega).unwrap());
        let border = Border::new(omega).unwrap().min_force_ratio;
        // Along its tangent the samples leave the border by the square of the way: closer than a slope that is off by 1 %.
        let (way, room) = (1e-3, 1e-5 * (1.0 + slope.abs()));
        let found = [-1.0, 1.0].map(|side| {
            let on = border + slope * side * way * omega;
            [on - room, on + room].map(|alpha| is_free(omega * (1.0 + side * way), alpha))
        });
        agreed("fn Border::slope", found, [[false, true]; 2], DenseSamples);
        let at = |by: f64| Border::new(omega * (1.0 + by)).unwrap().min_force_ratio;
        let difference = (at(1e-5) - at(-1e-5)) / (2e-5 * omega);
        assert!((slope - difference).abs() < 1e-6 * (1.0 + slope.abs()), "{omega}: {slope} {difference}");
    }
}

/// Displacement and velocity over the phase, of cycles of two and of six reversals; and K, which is the cosine of the
/// phase of the maximum displacement times α.
#[test]
fn cycles_over_the_phase_are_those_of_the_samples() {
    let mut random = Random(52);
    let mut count = 0;
    for i in 0..30 {
        let zeta = if i % 2 == 0 { 0.0 } else { random.scale(1e-2, 1.5) };
        let omega = random.scale(0.3, 2.5);
        let least = Border::of(&ratios([omega, 1.0, zeta, 1.0])).min_force_ratio;
        let at = [omega, least * random.scale(1.01, 6.0), zeta, 1.0];
        let Some(found) = sampled(at, [0.0, 0.0]) else { continue };
        let cycle = Cycle::new(ratios(at)).unwrap();
        count += 1;
        let size = cycle.max_displacement;
        for j in 0..8 {
            let phase = TAU * (f64::from(j) + 0.37) / 8.0;
            let [x, v] = harmonic(at).states(&found, phase)[0];
            let fastest = cycle.max_velocity;
            compared("fn Cycle::displacement_at", cycle.displacement_at(phase), x, DenseSamples, 1e-9 * size);
            compared(
                "fn Cycle::velocity_at",
                cycle.velocity_at(phase),
                v / omega,
                DenseSamples,
                1e-8 * fastest,
            );
        }
        if zeta == 0.0 {
            let k = PhaseFunction::new(omega).unwrap().value();
            let of_samples = at[1] * (omega * found.found.most(Of::Displacement).time).cos();
            for function in ["new", "value"] {
                compared(&format!("fn PhaseFunction::{function}"), k, of_samples, DenseSamples, 1e-6 * at[1]);
            }
            #[cfg(feature = "matching")]
            {
                use stickslip::cycle::Solvable;
                let most = f64::solve(ratios(at)).unwrap().unknowns.max_displacement;
                let due = found.found.most(Of::Displacement).value;
                compared("fn cycle::Solvable::*", most, due, DenseSamples, 1e-9 * size);
            }
        }
        let multipliers = cycle.multipliers().cycle;
        let [(a, b), (c, d)] = multipliers;
        let [sum, product] = found.multipliers;
        compared("fn Cycle::multipliers", a + c, sum, DenseSamples, 2e-6);
        compared("fn Cycle::multipliers", a * c - b * d, product, DenseSamples, 2e-6);
        let most = found.found.most(Of::Displacement).value;
        compared("fn Cycle::new", size, most, DenseSamples, 1e-9 * most);
        // After this many cycles of the samples a disturbance is below the tolerance.
        let cycles = cycle.multipliers().cycles_to_settle(1e-3).unwrap();
        let after = harmonic(at).after([0.0, 0.0], 0.0, 2 * cycles as u32 + 2);
        let there = harmonic(at).states(&found, 0.0)[0];
        let off = (after[0] - there[0]).hypot(after[1] - there[1]);
        let size = 2.0 * (there[0].hypot(there[1]) + cycle.max_displacement);
        compared("fn cycle::Multipliers::*", off, 0.0, DenseSamples, 1e-3 * size);
    }
    assert!(count > 20, "{count}");
    let at = [0.331, 61.6, 0.0, 1.0];
    let found = sampled(at, [0.0, 0.0]).unwrap();
    let cycle = SixReversals::new(ratios(at)).unwrap();
    assert_eq!((found.found.rests, found.found.ends), (0, 6));
    for phase in [0.2, 1.3, 2.9, 4.4] {
        let [x, v] = harmonic(at).states(&found, phase)[0];
        let of = "fn cycle::SixReversals::*";
        compared(of, cycle.displacement_at(phase), x, DenseSamples, 1e-8 * x.abs().max(1.0));
        compared(of, cycle.velocity_at(phase), v / at[0], DenseSamples, 1e-7 * v.abs().max(1.0));
    }
    for (phase, force) in cycle.reversal_phases().into_iter().zip(cycle.forces()) {
        let [x, _] = harmonic(at).states(&found, phase)[0];
        let near = found.found.stops.iter().map(|[t, _]| (t * at[0] - phase).rem_euclid(TAU));
        let near = near.map(|off| off.min(TAU - off)).fold(f64::INFINITY, f64::min);
        let of = "fn cycle::SixReversals::*";
        compared(of, near, 0.0, DenseSamples, 1e-6);
        compared(of, force, (at[1] * phase.sin() - x).abs(), DenseSamples, 1e-6);
    }
}

/// At Ω = 1/2n the samples of each start are a member of the family, shifted by no more than its bound.
#[test]
fn members_of_a_family_are_those_of_the_samples() {
    for (omega, alpha) in [(0.5, 4.0), (0.25, 17.0)] {
        let Verdict::Degenerate(family) = Verdict::new(ratios([omega, alpha, 0.0, 1.0])) else { panic!() };
        for start in [[0.0, 0.0], [1.5, 0.3], [-2.0, 1.0]] {
            // At the edge of the family the shift settles as 1/turns: within 3/200 after 200 of them.
            let harmonic = harmonic([omega, alpha, 0.0, 1.0]);
            let mut follower = harmonic.follower(start, 0.0);
            for _ in 0..200 * harmonic.steps() {
                follower.advance(&mut None);
            }
            let mut found = follower.watched();
            for _ in 0..harmonic.steps() {
                follower.advance(&mut found);
            }
            let found = found.unwrap();
            assert_eq!(found.ends, 2, "{omega} {start:?}");
            let (most, least) = (found.most(Of::Displacement).value, found.least(Of::Displacement).value);
            let shift = (most + least) / 2.0;
            assert!(shift.abs() <= family.max_shift + 0.015, "{omega} {start:?}: {shift} {family:?}");
            let (high, low) = family.extremes(shift.clamp(-family.max_shift, family.max_shift)).unwrap();
            compared("fn Family::extremes", high, most, DenseSamples, 0.015);
            compared("fn Family::extremes", low, least, DenseSamples, 0.015);
        }
    }
}

/// Guaranteed ranges over boxes of Ω and α: samples within the box are within the range, and reach over half of it.
#[test]
fn ranges_over_a_box_hold_the_samples_in_it() {
    let mut random = Random(54);
    for _ in 0..12 {
        let omega = random.scale(1.2, 2.0);
        let alpha = 1.5 * Border::of(&ratios([omega, 1.0, 0.0, 1.0])).min_force_ratio;
        let [omegas, alphas] = [omega, alpha].map(|x| Interval::relative(x, 0.02));
        let whole =
            ParameterBox::Ratios { omega: omegas, alpha: alphas, damping_ratio: Interval::exactly(0.0) };
        let found: Vec<_> = [omegas.low, omega, omegas.high]
            .into_iter()
            .flat_map(|omega| [alphas.low, alpha, alphas.high].map(|alpha| [omega, alpha, 0.0, 1.0]))
            .map(|at| sampled(at, [0.0, 0.0]).unwrap().found)
            .collect();
        let range = whole.range(Output::MaxDisplacement, 40).unwrap().filter(Range::is_guaranteed).unwrap();
        let values: Vec<f64> = found.iter().map(|one| one.most(Of::Displacement).value).collect();
        let (least, most) = values.iter().fold((f64::INFINITY, 0.0f64), |(a, b), x| (a.min(*x), b.max(*x)));
        let room = 1e-9 * most;
        let holds = (range.low <= least + room, most - room <= range.high);
        let is_tight = most - least > 0.5 * (range.high - range.low);
        for of in ["ParameterBox::*", "Range::is_guaranteed"] {
            agreed(&format!("fn uncertainty::{of}"), (holds, is_tight), ((true, true), true), DenseSamples);
        }
    }
}

/// With static friction: from the force ratio on that suffices for every start, starts of the samples do not stop.
#[test]
fn above_the_bound_no_start_stops() {
    let mut random = Random(53);
    for _ in 0..6 {
        let [omega, zeta, eta] = [random.scale(0.7, 2.0), random.scale(0.1, 0.5), random.between(1.1, 2.0)];
        let forces = stickslip::NoStop::of(&ratios([omega, 1.0, zeta, eta]));
        let bound = forces.every_start.unwrap();
        for start in [[0.0, 0.0], [5.0, 0.0], [-9.0, 4.0]] {
            let found = sampled([omega, bound, zeta, eta], start).unwrap().found;
            agreed("fn NoStop::*", (found.rests, found.ends), (0, 2), DenseSamples);
        }
    }
}
