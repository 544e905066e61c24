//! Motions from a start, and the limits of many starts, beside dense samples: in ratios, m = k = r_y = 1.

use crate::compared::Origin::{ByHand, DenseSamples};
use crate::compared::{agreed, compared};
use crate::random::Random;
use crate::sampled::{Harmonic, Limit, Load, Machine, Of, record};
use std::f64::consts::{PI, TAU};
use stickslip::internal::stops_per_cycle;
use stickslip::motion::{
    DEFAULT_BUDGET, DrivePhase, FreeDecay, Kind, LongRun, Starts, State, Trajectory, attractors,
    errors_after, periodic_motions, symmetry_breaks,
};
use stickslip::{NoStop, Ratios, Verdict};

/// The machine of ratios: displacements in B, times in 1/ω_n.
fn harmonic([omega, alpha, zeta, eta]: [f64; 4]) -> Harmonic {
    let machine = Machine::new([1.0, 1.0, 2.0 * zeta], [1.0, 0.0, eta], 0.0);
    Harmonic { machine, load: Load::Force, amplitude: alpha, frequency: omega }
}

fn ratios([omega, alpha, zeta, eta]: [f64; 4]) -> Ratios<f64> {
    let ratios = Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
    ratios.with_static_friction_ratio(eta).unwrap()
}

fn close(found: f64, sampled: f64, room: f64, what: &dyn std::fmt::Debug) {
    assert!((found - sampled).abs() <= room, "{found} of the library, {sampled} of the samples: {what:?}");
}

/// The same of an output, which is recorded.
fn held(output: &str, found: f64, sampled: f64, room: f64, what: &dyn std::fmt::Debug) {
    close(found, sampled, room, what);
    compared(output, found, sampled, DenseSamples, room);
}

/// Free vibration: turning points, their times, the place and the time of rest, and the count of half cycles.
#[test]
fn a_free_vibration_turns_and_rests_where_the_samples_do() {
    let mut random = Random(31);
    let (mut turned, mut crept) = (0, 0);
    for i in 0..120 {
        let zeta = [0.0, random.scale(1e-3, 0.6), random.between(1.0, 3.0)][i % 3];
        let eta = if random.next() < 0.5 { 1.0 } else { random.between(1.0, 2.0) };
        let start = [random.between(-12.0, 12.0), if i % 2 == 0 { 0.0 } else { random.between(-9.0, 9.0) }];
        let case = (start, zeta, eta);
        let decay = FreeDecay::new(start[0], start[1], zeta, eta).unwrap();
        let machine = Machine::new([1.0, 1.0, 2.0 * zeta], [1.0, 0.0, eta], 0.0);
        let found = record(machine, Load::Force, &[0.0, 0.1], &[0.0, 0.0], start, 128.0);
        assert!(found.is_over, "{case:?}");
        let size = start[0].abs() + start[1].abs() + 1.0;
        held("decay rest_position", decay.rest_position, found.last, 1e-10 * size, &case);
        // At the start a body without a velocity is at a turning point.
        let mut turns = found.found.stops.clone();
        if start[1] == 0.0 {
            turns.insert(0, [0.0, start[0]]);
        }
        let creeps = decay.rest_time.is_infinite();
        if creeps {
            crept += 1;
            assert!(zeta >= 1.0 && decay.half_cycles == found.found.ends + 1, "{case:?} {decay:?}");
            // The samples end near the limit, which the body never reaches.
            let path = found.found.path[0] + found.found.path[1];
            held("decay path by motion::FreeDecay::*", decay.path(), path, 1e-9 * size, &case);
            continue;
        }
        agreed("decay half_cycles", decay.half_cycles, found.found.ends, DenseSamples);
        held("decay path", decay.path(), found.found.path[0] + found.found.path[1], 1e-9 * size, &case);
        for (n, [t, x]) in turns.iter().enumerate() {
            let Some((time, place)) = decay.turning_point(n as u64) else { panic!("{n} of {case:?}") };
            held("decay displacement by motion::FreeDecay::*", place, *x, 1e-10 * size, &case);
            held("decay time", time, *t, 1e-8 * (1.0 + t), &case);
            turned += 1;
        }
        assert_eq!(decay.turning_point(turns.len() as u64), None, "{case:?}");
        let [t, x] = turns.last().copied().unwrap_or([0.0, start[0]]);
        held("decay rest_time", decay.rest_time, t, 1e-8 * (1.0 + t), &case);
        close(x, found.last, 0.0, &case);
        held("decay first_turn", decay.first_turn, turns[0][1], 1e-10 * size, &case);
    }
    assert!(turned > 150 && crept > 10, "{turned} {crept}");
}

/// Segments: states, accelerations and friction at their starts, in their middles and at their ends, stops included.
#[test]
fn segments_and_samples_are_those_of_the_samples() {
    let mut random = Random(32);
    let (mut slides, mut stops) = (0, 0);
    for i in 0..40 {
        let zeta = if i % 2 == 0 { 0.0 } else { random.scale(1e-2, 2.0) };
        let eta = if i % 3 == 0 { random.between(1.0, 2.0) } else { 1.0 };
        let at = [random.scale(0.2, 2.5), random.scale(1.2, 9.0) * eta, zeta, eta];
        let theta = random.between(0.0, TAU);
        let start = [random.between(-5.0, 5.0), if i % 4 == 0 { 0.0 } else { random.between(-5.0, 5.0) }];
        let case = (at, theta, start);
        let begin = State::new(theta, start[0], start[1]).unwrap();
        let harmonic = harmonic(at);
        let size = 1.0 + start[0].abs() + at[1] + start[1].abs();
        let mut follower = harmonic.follower([start[0], start[1] * at[0]], theta);
        let of = |phase: DrivePhase<f64>| TAU * phase.cycles() as f64 + phase.reduced();
        let segments = Trajectory::new(ratios(at), begin).unwrap().take(10);
        for segment in segments {
            let segment = segment.unwrap();
            let is_stick = segment.kind == Kind::Stick;
            (slides, stops) = (slides + u32::from(!is_stick), stops + u32::from(is_stick));
            let Some(end) = segment.end() else { break };
            let (first, last) = (of(segment.start().phase), of(end.phase));
            close(segment.duration().unwrap(), last - first, 1e-12 * (1.0 + last), &case);
            if last - first < 1e-6 {
                break;
            }
            for part in [0.3, 0.7] {
                let phase = first + part * (last - first);
                let time = phase / at[0] - follower.time;
                let count = (time * at[0] * 40.0).ceil().max(1.0);
                follower.set_step(time / count);
                for _ in 0..count as u64 {
                    follower.advance(&mut None);
                }
                let instant = segment.at(DrivePhase::new(0, phase).unwrap());
                let (state, sign) = (follower.state, follower.sign);
                assert_eq!(is_stick, sign == 0, "{case:?} {segment:?}");
                held("fn motion::Segment::*", instant.state.x, state[0], 1e-9 * size, &case);
                held("fn motion::Segment::*", instant.state.v * at[0], state[1], 1e-9 * size, &case);
                let friction = if sign == 0 { state[2] - state[0] } else { f64::from(sign) };
                let pull = state[2] - 2.0 * zeta * state[1] - state[0] - friction;
                held("fn motion::Segment::*", instant.friction, friction, 1e-9 * size, &case);
                held("fn motion::Segment::*", instant.acceleration * at[0] * at[0], pull, 1e-9 * size, &case);
            }
        }
        // The samples of the library are those instants.
        let of_library = Trajectory::new(ratios(at), begin).unwrap().samples(7).unwrap().take(12);
        let mut follower = harmonic.follower([start[0], start[1] * at[0]], theta);
        for instant in of_library {
            let instant = instant.unwrap();
            let time = of(instant.state.phase) / at[0] - follower.time;
            if time > 0.0 {
                let count = (time * at[0].max(1.0) * (1.0 + zeta) * 40.0).ceil().max(1.0);
                follower.set_step(time / count);
                for _ in 0..count as u64 {
                    follower.advance(&mut None);
                }
            }
            held(
                "simulate --samples x by motion::Trajectory::*",
                instant.state.x,
                follower.state[0],
                1e-9 * size,
                &case,
            );
            held("simulate --samples v", instant.state.v * at[0], follower.state[1], 1e-9 * size, &case);
        }
    }
    assert!(slides > 150 && stops > 30, "{slides} {stops}");
}

/// α ≤ 1: the place of rest, the slides and the periods to it.
#[test]
fn a_body_comes_to_rest_where_the_samples_do() {
    let mut random = Random(33);
    let (mut rested, mut crept) = (0, 0);
    for i in 0..60 {
        let eta = if i % 2 == 0 { 1.0 } else { random.between(1.0, 1.6) };
        let zeta = if i % 3 == 0 { 0.0 } else { random.scale(1e-2, 0.8) };
        let at = [random.scale(0.2, 2.5), random.between(0.2, 0.95), zeta, eta];
        let theta = random.between(0.0, TAU);
        let start = [random.between(-9.0, 9.0), random.between(-5.0, 5.0)];
        let case = (at, theta, start);
        let limit = LongRun::from_start(ratios(at), State::new(theta, start[0], start[1]).unwrap()).unwrap();
        let LongRun::Rest(rest) = limit else { panic!("{limit:?} of {case:?}") };
        let harmonic = harmonic(at);
        let follower = harmonic.follower([start[0], start[1] * at[0]], theta);
        let mut found = follower.watched();
        let mut follower = follower;
        for _ in 0..harmonic.steps() * 300 {
            follower.advance(&mut found);
        }
        let found = found.unwrap();
        let Some(slides) = rest.slides else {
            // It creeps to the edge of the places of rest, and is close to it after 300 turns.
            crept += 1;
            let off = follower.state[0] - rest.position;
            assert!(off * rest.position.signum() >= -1e-9 && off.abs() < 0.05, "{off} {case:?}");
            continue;
        };
        rested += 1;
        assert_eq!(slides, found.slides, "{case:?}");
        held("steady rest_position", rest.position, follower.state[0], 1e-9 * (1.0 + start[0].abs()), &case);
        let turns = (found.stops.last().unwrap()[0] * at[0] - theta) / TAU;
        held("steady periods by motion::LongRun::periods", rest.periods, turns, 1e-8 * (1.0 + turns), &case);
    }
    assert!(rested > 30 && crept > 2, "{rested} {crept}");
}

/// The counts of stops and velocity zeros, and the verdict, at points away from every border.
#[test]
fn stops_and_verdicts_are_those_of_the_samples() {
    let mut random = Random(34);
    let mut compared = 0;
    while compared < 60 {
        let zeta = if compared % 2 == 0 { 0.0 } else { random.scale(1e-2, 1.0) };
        let at = [random.scale(0.12, 2.5), random.scale(1.1, 30.0), zeta, 1.0];
        let Limit::Periodic(cycle) = harmonic(at).limit([0.0, 0.0], 0.0, 600) else { continue };
        let Ok(stops) = stops_per_cycle(ratios(at)) else { continue };
        compared += 1;
        let stops = stops.unwrap();
        let found = &cycle.found;
        assert_eq!((stops.sticks.into(), stops.velocity_zeros.into()), (found.rests, found.ends), "{at:?}");
        let verdict = Verdict::new(ratios(at));
        let expected = match (found.rests, found.ends) {
            (0, 2) => Verdict::NonSticking,
            (0, _) => Verdict::SixReversals,
            _ => Verdict::Sticking,
        };
        agreed("fn Verdict::*", verdict, expected, DenseSamples);
        agreed("fn Verdict::*", verdict.sticks(), Some(found.rests > 0), DenseSamples);
    }
}

/// Near a pole the forces of six reversals without a stop: within them, and below and above, by the samples.
#[test]
fn six_reversals_are_those_of_the_samples() {
    let mut compared = 0;
    for (omega, zeta) in [(0.331, 0.0), (0.3325, 0.0), (0.1995, 0.0), (0.3325, 1e-4)] {
        let forces = NoStop::of(&Ratios::new(omega, 1.0).unwrap().with_damping_ratio(zeta).unwrap());
        let Some((low, high)) = forces.six_reversals else { continue };
        assert_eq!(forces.min(), low);
        let counts = |alpha: f64| match harmonic([omega, alpha, zeta, 1.0]).limit([0.0, 0.0], 0.0, 3000) {
            Limit::Periodic(cycle) => (cycle.found.rests == 0, cycle.found.ends),
            limit => panic!("{omega} {alpha}: {limit:?}"),
        };
        let inside = counts((low * high).sqrt());
        let below = counts(low * (1.0 - 1e-3)).0;
        let above = counts(high * (1.0 + 1e-3)) == (true, 6);
        agreed(
            "border no_stop_force_ratios by NoStop::*",
            (inside, below, above),
            ((true, 6), false, false),
            DenseSamples,
        );
        let intervals: Vec<_> = forces.intervals().collect();
        assert_eq!(intervals[0].0, low, "{intervals:?}");
        compared += 1;
    }
    assert!(compared > 1, "{compared}");
}

/// At Ω = 1 above the border the amplitude grows by πα − 4 in a cycle.
#[test]
fn an_unbounded_motion_grows_as_the_samples_do() {
    for alpha in [1.5, 2.0, 5.0] {
        let limit = LongRun::from_start(ratios([1.0, alpha, 0.0, 1.0]), State::default()).unwrap();
        let LongRun::Unbounded { growth } = limit else { panic!("{limit:?}") };
        let harmonic = harmonic([1.0, alpha, 0.0, 1.0]);
        let mut follower = harmonic.follower([0.0, 0.0], 0.0);
        let mut last = [0.0; 2];
        for turn in 0..900 {
            let mut found = follower.watched();
            for _ in 0..harmonic.steps() {
                follower.advance(&mut found);
            }
            if turn >= 898 {
                last[turn - 898] = found.unwrap().most(Of::Displacement).value;
            }
        }
        // What is left of the way to the limit is of the order of 1/turns.
        close(growth, last[1] - last[0], 3.0 / 900.0, &alpha);
        close(growth, PI * alpha - 4.0, 1e-14 * growth, &alpha);
    }
}

/// Each start leads to its limit: the counts of an attractor, its extremes and its mirror image by brute force.
#[test]
fn starts_lead_where_the_samples_do() {
    let mut several = 0;
    for at in [[0.5, 4.0, 0.02, 1.3], [0.573, 3.92, 0.05, 1.87], [0.8, 1.4, 0.05, 1.6], [1.3, 2.0, 0.1, 2.5]]
    {
        let all = Starts::around(&ratios(at));
        let starts: Vec<_> = (0..40).map(|number| all.get(number)).collect();
        assert!(starts.iter().all(|start| start.x.abs() <= all.reach() && start.v.abs() <= all.reach()));
        let found = attractors(ratios(at), &starts, DEFAULT_BUDGET).unwrap();
        several += usize::from(found.limits.len() > 1);
        agreed("attractors unsettled by motion::attractors", found.unsettled(), 0, DenseSamples);
        let mut counts = vec![0; found.limits.len()];
        let mut ranges = vec![(f64::INFINITY, f64::NEG_INFINITY); found.limits.len()];
        for (number, start) in starts.iter().enumerate() {
            let harmonic = harmonic(at);
            let place = found.of_start[number].unwrap();
            let attractor = &found.limits[place];
            counts[place] += 1;
            match (harmonic.limit([start.x, start.v * at[0]], 0.0, 2000), &attractor.limit) {
                (Limit::Periodic(cycle), LongRun::Periodic(steady)) => {
                    let (most, least) =
                        (cycle.found.most(Of::Displacement), cycle.found.least(Of::Displacement));
                    let of = |name: &str| format!("attractors[] {name}");
                    let (highest, lowest) = (steady.max_displacement.value, steady.min_displacement.value);
                    held(&of("max_displacement"), highest, most.value, 1e-8, &(at, number));
                    held(&of("min_displacement"), lowest, least.value, 1e-8, &(at, number));
                    let sticks = u64::from(steady.sticks_per_cycle);
                    agreed(&of("sticks_per_cycle"), sticks, cycle.found.rests, DenseSamples);
                    agreed(&of("turns_per_cycle"), steady.turns_per_cycle, cycle.turns, DenseSamples);
                    if let Some(mirror) = attractor.mirror {
                        let LongRun::Periodic(other) = &found.limits[mirror].limit else { panic!("{at:?}") };
                        let highest = other.max_displacement.value;
                        held("attractors[] mirror", highest, -least.value, 1e-8, &(at, number));
                    }
                }
                (Limit::Rest(x), LongRun::Rest(_)) => {
                    let range = &mut ranges[place];
                    *range = (range.0.min(x), range.1.max(x));
                }
                (sampled, limit) => panic!("{at:?} {number}: {sampled:?} {limit:?}"),
            }
        }
        for (attractor, (count, range)) in found.limits.iter().zip(counts.iter().zip(&ranges)) {
            agreed(
                "attractors[] starts by motion::attractors, motion::Starts::*",
                attractor.starts,
                *count,
                DenseSamples,
            );
            if let Some((low, high)) = attractor.range {
                held("attractors[] rest_from", low, range.0, 1e-9, &at);
                held("attractors[] rest_to", high, range.1, 1e-9, &at);
            }
        }
    }
    assert!(several > 1, "{several}");
}

/// Periodic motions that no start leads to, too: by the samples each repeats itself, with the same multipliers.
#[test]
fn periodic_motions_repeat_by_the_samples() {
    let mut unstable = 0;
    for at in [[0.5, 3.6, 0.02, 1.3], [0.573, 3.92, 0.005, 1.87], [0.5, 4.0, 0.02, 1.3]] {
        let all = Starts::around(&ratios(at));
        let starts: Vec<_> = (0..20).map(|number| all.get(number)).collect();
        for motion in periodic_motions(ratios(at), &starts, 2).unwrap() {
            let steady = motion.steady_state;
            let harmonic = harmonic(at);
            let phase = steady.state.phase.reduced();
            let start = [steady.state.x, steady.state.v * at[0]];
            unstable += u32::from(!steady.is_stable());
            let size = 1.0 + steady.max_displacement.value.abs();
            let after = harmonic.after(start, phase, steady.turns_per_cycle);
            let growth = 1.0 + steady.contraction();
            held("fn motion::periodic_motions", start[0], after[0], 1e-9 * size * growth, &(at, steady));
            held("fn motion::periodic_motions", start[1], after[1], 1e-9 * size * growth, &(at, steady));
            // The derivative at a point within a slide, reached by a part of a turn.
            let [sum, product] = harmonic.multipliers(start, phase, steady.turns_per_cycle);
            let [(a, b), (c, d)] = steady.multipliers;
            let case = &(at, steady.multipliers);
            // The greater root of the characteristic equation of the samples, where none is a double one.
            let root = sum * sum / 4.0 - product;
            let greatest = if root < 0.0 { product.sqrt() } else { sum.abs() / 2.0 + root.sqrt() };
            held("fn motion::SteadyState::contraction", steady.contraction(), greatest, 1e-3 * growth, case);
            agreed("fn motion::SteadyState::is_stable", steady.is_stable(), greatest < 1.0, DenseSamples);
            for of in ["steady multipliers", "attractors[] multipliers"] {
                held(of, a + c, sum, 1e-4 * growth, case);
                held(of, a * c - b * d, product, 1e-4 * growth * growth, case);
            }
        }
    }
    assert!(unstable > 0);
}

/// Where a symmetric motion is lost by a multiplier of 1, the samples have that multiplier, and on one side a stable
/// motion.
#[test]
fn symmetry_is_lost_where_a_multiplier_of_the_samples_is_one() {
    let at = [0.5, 1.0, 0.02, 1.3];
    let found = symmetry_breaks(ratios(at), 3.0..=3.8, 10).unwrap();
    assert_eq!(found.len(), 1);
    let [omega, _, zeta, eta] = at;
    for lost in &found {
        let harmonic = harmonic([omega, lost.alpha, zeta, eta]);
        let state = lost.motion.state;
        let start = [state.x, state.v * omega];
        let [sum, product] = harmonic.multipliers(start, state.phase.reduced(), 1);
        held("fn motion::symmetry_breaks", 1.0 - sum + product, 0.0, 1e-4, lost);
        let is_symmetric = |by: f64| match self::harmonic([omega, lost.alpha * by, zeta, eta]).limit(
            [0.1, 0.0],
            0.0,
            9000,
        ) {
            Limit::Periodic(cycle) => cycle.is_symmetric,
            limit => panic!("{limit:?}"),
        };
        assert_eq!([is_symmetric(0.99), is_symmetric(1.01)], [!lost.is_stable_above, lost.is_stable_above]);
    }
}

/// The error measures of a motion that has not settled, from the extremes of its samples.
#[test]
fn the_asymmetry_of_a_transient_is_that_of_the_samples() {
    let mut random = Random(35);
    for _ in 0..30 {
        let at = [random.scale(0.3, 2.0), random.scale(2.0, 8.0), random.scale(0.01, 0.3), 1.0];
        let start = [random.between(-3.0, 3.0), random.between(-3.0, 3.0)];
        let cycles = 2;
        let begin = State::new(0.0, start[0], start[1]).unwrap();
        let errors = errors_after(ratios(at), begin, cycles).unwrap();
        let harmonic = harmonic(at);
        let mut follower = harmonic.follower([start[0], start[1] * at[0]], 0.0);
        for _ in 0..harmonic.steps() * cycles {
            follower.advance(&mut None);
        }
        let mut found = follower.watched();
        for _ in 0..harmonic.steps() {
            follower.advance(&mut found);
        }
        let found = found.unwrap();
        for (size, shift, of) in [
            (errors.error_1, errors.error_2, Of::Displacement),
            (errors.error_3, errors.error_4, Of::Velocity),
        ] {
            let (most, least) = (found.most(of), found.least(of));
            let due = (most.value + least.value).abs() / most.value;
            held("fn motion::errors_after", size, due, 1e-8, &(at, start));
            let apart = (most.time - least.time).abs() * at[0];
            held("fn motion::errors_after", shift, (apart - PI) / TAU, 1e-6, &(at, start));
        }
    }
}

/// The Lyapunov exponent of an irregular motion, by two neighbours of the samples, within its standard error and theirs.
#[test]
fn neighbours_of_an_irregular_motion_part_as_the_exponent_says() {
    let at = [0.45, 8.5, 0.02, 3.0];
    let limit = LongRun::from_start(ratios(at), State::default()).unwrap();
    let LongRun::Irregular(motion) = limit else { panic!("{limit:?}") };
    let harmonic = harmonic(at);
    let size = 1e-7;
    let mut one = harmonic.follower([motion.state.x, motion.state.v * at[0]], motion.state.phase.reduced());
    let phase = motion.state.phase.reduced();
    let mut two = one.clone();
    two.state[0] += size;
    let mut rates = Vec::new();
    for _ in 0..1500 {
        for _ in 0..harmonic.steps() {
            one.advance(&mut None);
            two.advance(&mut None);
        }
        let load = [at[1] * phase.sin(), at[1] * phase.cos()];
        one.set_load(load);
        two.set_load(load);
        let apart = [two.state[0] - one.state[0], two.state[1] - one.state[1]];
        let distance = apart[0].hypot(apart[1] / at[0]);
        if distance > 0.0 {
            rates.push((distance / size).ln());
        }
        let shrink = if distance > 0.0 { size / distance } else { 0.0 };
        two = one.clone();
        if distance > 0.0 {
            two.state[0] += apart[0] * shrink;
            two.state[1] += apart[1] * shrink;
        }
    }
    let mean = rates.iter().sum::<f64>() / rates.len() as f64;
    let error = motion.lyapunov_exponent_error.max(0.02);
    // The spread of the means of 30 parts, whose own standard error is a part of 1/√58: four times that.
    let parts: Vec<f64> =
        rates.chunks(rates.len() / 30).map(|of| of.iter().sum::<f64>() / of.len() as f64).collect();
    let square = parts.iter().map(|part| (part - mean) * (part - mean)).sum::<f64>() / 29.0;
    let spread = (square / 30.0 * 1500.0 / motion.turns as f64).sqrt();
    let from_starts = attractors(ratios(at), &[State::default()], DEFAULT_BUDGET).unwrap();
    let LongRun::Irregular(same) = &from_starts.limits[0].limit else { panic!("{from_starts:?}") };
    // The standard error falls with the root of the turns: those observed, by the spread of the parts of 1500 turns.
    let implied = 1500.0 * square / 30.0 / motion.lyapunov_exponent_error.powi(2);
    let (found, due) = ((motion.turns as f64).sqrt(), implied.sqrt());
    compared("steady turns_observed", found, due, DenseSamples, 0.525 * due);
    agreed("fn motion::Irregular::is_chaotic", motion.is_chaotic(), mean > 4.0 * spread, DenseSamples);
    for (of, motion) in [("steady", &motion), ("attractors[]", same)] {
        let output = format!("{of} lyapunov_exponent");
        compared(&output, motion.lyapunov_exponent, mean, DenseSamples, 5.0 * error);
        let output = format!("{of} lyapunov_exponent_error");
        compared(&output, motion.lyapunov_exponent_error, spread, DenseSamples, 0.525 * spread);
    }
}

/// A body pulled through its spring at a constant speed: its slips and sticks, and the speed of smooth sliding.
#[test]
fn a_pulled_body_slips_and_sticks_as_the_samples_do() {
    use crate::sampled::{Equation, Follower};
    let mut random = Random(36);
    let mut smooth = 0;
    for _ in 0..40 {
        let (mass, natural) = (random.scale(0.1, 10.0), random.scale(1.0, 30.0));
        let (zeta, eta) = (random.scale(0.01, 0.4), random.between(1.05, 2.0));
        let (stiffness, friction) = (mass * natural * natural, random.scale(0.5, 20.0));
        let damping = 2.0 * zeta * mass * natural;
        let body = stickslip::Oscillator::new(mass, stiffness, friction).unwrap();
        let body = body.with_damping(damping).unwrap().with_static_friction_ratio(eta).unwrap();
        let machine = Machine::new([mass, stiffness, damping], [friction, 0.0, eta], 0.0);
        // The motion from rest over so many natural periods, watched over the last ones from a release on.
        let follow = |speed: f64| {
            let law = [[0.0, 1.0], [0.0, 0.0]];
            let equation = Equation { machine, load: Load::Foot, law, surface: 0.0 };
            let step = TAU / natural / 256.0;
            let begin = friction * eta / stiffness;
            let mut follower = Follower::new(equation, [0.0, 0.0], [begin * 0.999, speed], 0.0, step);
            let mut releases: Vec<[f64; 2]> = Vec::new();
            let mut found = follower.watched();
            let mut last = follower.sign;
            let mut slips: Vec<(f64, f64, f64)> = Vec::new();
            for _ in 0..200_000 {
                let count = found.as_ref().unwrap().stops.len();
                follower.advance(&mut found);
                let stops = &found.as_ref().unwrap().stops;
                if stops.len() > count {
                    let [time, x] = stops[stops.len() - 1];
                    let [from, at] = releases[releases.len() - 1];
                    slips.push((from, time - from, x - at));
                    if slips.len() == 4 {
                        break;
                    }
                }
                if last == 0 && follower.sign != 0 {
                    // Within the step: at rest the spring stretches until it overcomes static friction.
                    let x = releases
                        .last()
                        .map_or(0.0, |_| slips[slips.len() - 1].2 + releases[releases.len() - 1][1]);
                    let stretch = eta * friction / stiffness;
                    releases.push([(x + stretch - begin * 0.999) / speed, x]);
                }
                last = follower.sign;
            }
            (slips, found.unwrap().most(Of::Velocity).value)
        };
        let least = stickslip::motion::Pull::new(&body, 1e-3).unwrap().smooth_above.unwrap();
        let case = (zeta, eta, least);
        // From rest the first slip is the steady one, or there is none.
        let slips = [0.99, 1.01].map(|by| follow(by * least).0.len());
        agreed("pull smooth_above", slips, [4, 0], DenseSamples);
        let speed = least * random.scale(0.02, 0.95);
        let pull = stickslip::motion::Pull::new(&body, speed).unwrap();
        let (slips, fastest) = follow(speed);
        let (first, last) = (slips[slips.len() - 2], slips[slips.len() - 1]);
        let period = last.0 - first.0;
        held("pull period by motion::Pull::*", pull.period.unwrap(), period, 1e-8 * period, &case);
        held("pull slip_time", pull.slip_time.unwrap(), last.1, 1e-8 * period, &case);
        held("pull stick_time", pull.stick_time.unwrap(), period - last.1, 1e-8 * period, &case);
        held("pull slip_distance", pull.slip_distance.unwrap(), last.2, 1e-8 * last.2, &case);
        held("pull max_velocity", pull.max_velocity, fastest, 1e-9 * fastest, &case);
        let above = stickslip::motion::Pull::new(&body, 1.5 * least).unwrap();
        smooth += u32::from(above.period.is_none());
        compared("pull max_velocity", above.max_velocity, 1.5 * least, ByHand, 1e-15 * least);
    }
    assert_eq!(smooth, 40);
}
