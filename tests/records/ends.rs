//! What the body does at an instant, at a touch, and after the record: cases with answers from integration in time and from
//! closed forms.

use std::f64::consts::{PI, TAU};
use stickslip::motion::record::{After, Body, Record, RecordAnswer};
use stickslip::{Error, Excitation};

fn body(mass: f64, stiffness: f64, damping: f64, friction: f64) -> Body<f64> {
    let body = Body::new(mass, friction).unwrap();
    body.with_stiffness(stiffness).unwrap().with_damping(damping).unwrap()
}

fn force(times: &[f64], samples: &[f64]) -> Record<f64> {
    Record::at_times(Excitation::Force, times.to_vec(), samples.to_vec()).unwrap()
}

fn close(name: &str, found: f64, expected: f64, digits: f64) {
    assert!(
        (found - expected).abs() <= digits * expected.abs().max(1e-3),
        "{name}: {found} against {expected}"
    );
}

/// A force that turns within the step in which it leaves one bound and passes the other: the body slides at once, back and
/// forth, and transmits no more than friction.
#[test]
fn a_force_through_both_bounds_moves_the_body_both_ways() {
    for sign in [1.0, -1.0] {
        let record = force(&[0.0, 1.0], &[-3.0 * sign, 3.0 * sign]);
        let found = body(1.0, 0.0, 0.0, 1.0).follow(&record).unwrap();
        // By integration of ∓3 ± 6t ± 1 from 0 to 2/3 s, back from there, and braked by friction alone.
        let (most, least) = (found.max_displacement * sign, found.min_displacement * sign);
        close("extreme", most.min(least), -4.0 / 27.0, 1e-14);
        close("residual", found.residual_displacement.unwrap() * sign, -1.0 / 18.0, 1e-14);
        close("path", found.path, 13.0 / 54.0, 1e-14);
        close("force", found.max_transmitted_force, 1.0, 1e-14);
        close("acceleration", found.max_absolute_acceleration, 2.0, 1e-14);
        assert_eq!((found.slides, found.stops, found.reversals, found.stick_time), (2, 1, 1, 0.0));
    }
}

/// At an instant between two slides the force on the support is that of neither a rest.
#[test]
fn a_reversal_transmits_no_more_than_friction() {
    let samples = vec![0.0, 3.0, 0.0, -3.0, 0.0];
    let record = Record::new(Excitation::SurfaceAcceleration, 1.0, samples).unwrap();
    let found = body(1.0, 0.0, 0.0, 1.0).follow(&record).unwrap();
    close("force", found.max_transmitted_force, 1.0, 1e-14);
    close("acceleration", found.max_absolute_acceleration, 1.0, 1e-14);
    assert_eq!((found.slides, found.stops, found.reversals), (2, 1, 1));
}

/// A body without friction and a damper under a load is nowhere at rest, and its force is that of the spring.
#[test]
fn without_friction_the_body_does_not_rest() {
    let samples: Vec<f64> =
        (0..200).map(|i| (0.37 * f64::from(i)).sin() - (1.9 * f64::from(i)).cos()).collect();
    let record = Record::new(Excitation::Force, 0.1, samples).unwrap();
    let found = body(2.0, 7.0, 0.0, 0.0).follow(&record).unwrap();
    assert_eq!((found.stick_time, found.stops), (0.0, 0), "{found:?}");
    let spring = 7.0 * found.max_displacement.max(-found.min_displacement);
    close("force", found.max_transmitted_force, spring, 1e-12);
}

/// Released by a straight ramp without a damper, v = (ṗ/k)(1 − cos ωt) touches zero once a period and goes on, however
/// the ramp is sampled and in all units: x = (ṗ/k)(t − sin ωt/ω).
#[test]
fn a_velocity_that_touches_zero_goes_on() {
    let (k, rate): (f64, f64) = (99.0, 10.0);
    let omega = k.sqrt();
    let (t, start) = (10.0 - 1.0 / rate, 1.0 / rate);
    let x = rate / k * (t - (omega * t).sin() / omega);
    let v = rate / k * (1.0 - (omega * t).cos());
    for parts in [1u32, 2, 7, 100, 1000] {
        for (length, mass) in
            [(1.0, 1.0), (1000.0, 0.001), (1000.0, 1.0), (39.370_078_740_157_48, 0.005_710_147_154_733)]
        {
            let samples = (0..=parts).map(|i| 100.0 * f64::from(i) / f64::from(parts) * length * mass);
            let record = Record::new(Excitation::Force, 10.0 / f64::from(parts), samples.collect()).unwrap();
            let found = body(mass, k * mass, 0.0, length * mass).follow(&record).unwrap();
            let case = format!("{parts} {length}: {found:?}");
            close(&case, found.end_displacement / length, x, 1e-12);
            close(&case, found.end_velocity / length, v, 1e-11);
            close(&case, found.stick_time, start, 1e-12);
            // One slide through the ramp, and fifty half turns of the decay after it.
            assert_eq!((found.slides, found.stops, found.reversals), (51, 1, 50), "{case}");
        }
    }
}

/// Overdamped slides after the record, which never stop, by integration in time.
#[test]
fn a_slide_that_creeps_for_ever_is_followed() {
    let of = body(1.0, 4.0, 5.0, 1.0);
    let found = of.follow(&force(&[0.0, 1.0, 1.25], &[0.0, 8.0, 8.0])).unwrap();
    close("velocity", found.min_velocity, -0.264_849_748_333_786_7, 1e-12);
    close("its time", found.min_velocity_time.unwrap(), 1.882_759_5, 1e-7);
    let still = force(&[0.0, 0.0625], &[0.0, 0.0]);
    let found = of.follow_from(&still, -2.0, 0.0).unwrap();
    close("velocity", found.max_velocity, 1.102_430_918_66, 1e-10);
    close("residual", found.residual_displacement.unwrap(), -0.25, 1e-14);
    assert_eq!((found.max_displacement, found.max_displacement_time), (-0.25, None));
    let found = of.follow(&force(&[0.0, 0.0625], &[-5.0, -5.0])).unwrap();
    // The load begins with 5 against the friction of 1.
    close("acceleration", found.max_absolute_acceleration, 4.0, 1e-14);
}

/// Without friction a damped body swings for ever; its path is that of all swings.
#[test]
fn a_decay_without_friction_has_its_whole_path() {
    let of = body(1.0, 1.0, 0.04, 0.0);
    let found = of.follow_from(&force(&[0.0, 0.0625], &[0.0, 0.0]), 1.0, 0.1).unwrap();
    let least = found.min_velocity.min(-found.max_velocity);
    assert!(least < -0.9, "{found:?}");
    close("velocity", found.max_velocity, 0.914_932_946_75, 1e-10);
    // The turning points are a geometric series with the ratio q, and the first is at tan dt = v₀d/(βv₀ + ω²x₀).
    let (beta, d) = (0.02f64, (1.0 - 0.0004f64).sqrt());
    let t = (0.1 * d / (beta * 0.1 + 1.0)).atan() / d;
    let x = (-beta * t).exp() * ((d * t).cos() + (0.1 + beta) / d * (d * t).sin());
    let q = (-PI * beta / d).exp();
    close("path", found.path, x - 1.0 + x * (1.0 + q) / (1.0 - q), 1e-11);
    assert_eq!((found.residual_displacement, found.cut_time), (Some(0.0), None));
    assert_eq!((found.slides, found.stops, found.reversals), (1, 0, 0));
}

/// Without friction and a damper the motion is cut after a period, which has all its extremes.
#[test]
fn an_endless_vibration_is_followed_for_a_period() {
    let found = body(2.0, 8.0, 0.0, 0.0).follow_from(&force(&[0.0, 0.1], &[0.0, 0.0]), 0.3, 0.8).unwrap();
    let amplitude = 0.3f64.hypot(0.4);
    close("displacement", found.max_displacement, amplitude, 1e-14);
    close("displacement", found.min_displacement, -amplitude, 1e-14);
    close("velocity", found.max_velocity, 2.0 * amplitude, 1e-14);
    close("velocity", found.min_velocity, -2.0 * amplitude, 1e-14);
    close("acceleration", found.max_absolute_acceleration, 4.0 * amplitude, 1e-14);
    close("cut", found.cut_time.unwrap(), 0.1 + PI, 1e-14);
    assert_eq!(found.residual_displacement, None);
    // On a slope steeper than friction the slide after the record has no end, and the answers are those of the record.
    let block = body(1.0, 0.0, 0.5, 1.0).with_mean_force(2.0).unwrap();
    let found = block.follow(&force(&[0.0, 1.0], &[0.0, 0.0])).unwrap();
    close("cut", found.cut_time.unwrap(), 1.0, 1e-14);
    close("velocity", found.max_velocity, 2.0 * (1.0 - (-0.5f64).exp()), 1e-13);
    assert_eq!(found.residual_displacement, None);
}

/// A support stays where its record ends, so that the body comes to rest beside it; and the damper on it takes ∫ c(v − u′)².
#[test]
fn a_foot_stays_where_it_ends() {
    for excitation in [Excitation::FootMotion, Excitation::DampedFootMotion] {
        let record = Record::new(excitation, 1.0, vec![0.0, 1.0]).unwrap();
        let found = body(1.0, 100.0, 3.0, 1.0).follow(&record).unwrap();
        let rest = found.residual_displacement.unwrap();
        assert!((rest - 1.0).abs() <= 0.01 + 1e-12, "{found:?}");
    }
    let times = vec![0.0, 1.0, 2.0];
    let record = Record::at_times(Excitation::DampedFootMotion, times, vec![0.0, 1.0, 0.0]).unwrap();
    let found = body(1.0, 4.0, 1.5, 1.0).follow(&record).unwrap();
    close("work", found.damper_work, 2.760_650_658_077_4, 1e-12);
}

/// What follows a record: the load ends, stays, or lets go. Each has the motion of a record that goes on as it says.
#[test]
fn what_follows_a_record_is_that_of_a_record_that_goes_on() {
    for (excitation, size) in [
        (Excitation::Force, 9.0),
        (Excitation::FootMotion, 0.4),
        (Excitation::DampedFootMotion, 0.4),
        (Excitation::SurfaceAcceleration, 4.5),
    ] {
        let of = body(2.0, 40.0, 1.5, 1.0);
        let samples = vec![0.0, 1.0, -0.7, 0.9].into_iter().map(|x| x * size).collect::<Vec<_>>();
        let times = vec![0.0, 0.3, 0.55, 1.0];
        let record = Record::at_times(excitation, times.clone(), samples.clone()).unwrap();
        let ended = |after| of.follow(&record.clone().followed_by(after)).unwrap();
        // A long record that says the same.
        let long = |last: f64| {
            let (mut times, mut samples) = (times.clone(), samples.clone());
            if last != 0.9 * size {
                times.push(1.0);
                samples.push(last);
            }
            times.push(60.0);
            samples.push(last);
            let record = Record::at_times(excitation, times, samples)?;
            of.follow(&record.followed_by(After::Hold))
        };
        let same = |name: &str, found: &RecordAnswer<f64>, long: &RecordAnswer<f64>| {
            for (what, found, other) in [
                ("greatest", found.max_displacement, long.max_displacement),
                ("least", found.min_displacement, long.min_displacement),
                ("fastest", found.max_velocity, long.max_velocity),
                ("acceleration", found.max_absolute_acceleration, long.max_absolute_acceleration),
                ("force", found.max_transmitted_force, long.max_transmitted_force),
                ("path", found.path, long.path),
                ("friction work", found.friction_work, long.friction_work),
                ("damper work", found.damper_work, long.damper_work),
                ("load work", found.load_work, long.load_work),
                ("rest", found.residual_displacement.unwrap(), long.end_displacement),
            ] {
                close(&format!("{excitation:?} {name} {what}"), found, other, 1e-11);
            }
            assert_eq!(found.slides, long.slides);
        };
        same("hold", &ended(After::Hold), &long(0.9 * size).unwrap());
        same("zero", &ended(After::Zero), &long(0.0).unwrap());
        let moves_foot = matches!(excitation, Excitation::FootMotion | Excitation::DampedFootMotion);
        let by_default = if moves_foot { After::Hold } else { After::Zero };
        assert_eq!(record.after(), by_default);
        assert_eq!(of.follow(&record).unwrap(), ended(by_default));
        if !moves_foot {
            assert_eq!(ended(After::Free), ended(After::Zero));
            continue;
        }
        // A support that has let go: a block without a spring, with the damper where that stands on the ground.
        let held = ended(After::Hold);
        let damping = if excitation == Excitation::DampedFootMotion { 0.0 } else { 1.5 };
        let block = body(2.0, 0.0, damping, 1.0);
        let still = force(&[0.0, 1.0], &[0.0, 0.0]);
        let slide = block.follow_from(&still, held.end_displacement, held.end_velocity).unwrap();
        let free = ended(After::Free);
        let rest = slide.residual_displacement.unwrap();
        close("rest", free.residual_displacement.unwrap(), rest, 1e-13);
        // The works of the record are those of a support that stays, less those of the way to rest beside it.
        let (x, last) = (held.end_displacement, 0.9 * size);
        let settled = of.follow_from(&still, x - last, held.end_velocity).unwrap();
        let damper = held.damper_work - settled.damper_work;
        close("damper work", free.damper_work - slide.damper_work, damper, 1e-11);
        let load = held.load_work - 40.0 * last * (held.residual_displacement.unwrap() - x);
        close("load work", free.load_work, load, 1e-11);
        close("path", free.path - slide.path, held.path - settled.path, 1e-11);
        assert!(free.damper_work > 0.0 && slide.friction_work > 0.0, "{free:?} {slide:?}");
    }
    // Pulled by a force that stays, a block without a spring never stops.
    let pull = force(&[0.0, 1.0], &[0.0, 3.0]);
    let found = body(1.0, 0.0, 0.0, 1.0).follow(&pull.followed_by(After::Hold)).unwrap();
    assert_eq!((found.residual_displacement, found.cut_time), (None, Some(1.0)));
}

/// Many periods in a step cost no more than a few, and many stops are refused.
#[test]
fn a_step_of_many_periods_is_followed_or_refused() {
    // A ramp of 1e7 periods: the body follows it.
    let omega = TAU;
    let record = Record::new(Excitation::SurfaceAcceleration, 1e7, vec![0.0, -9.8]).unwrap();
    let found = body(1.0, omega * omega, 0.1 * omega, 0.5).follow(&record).unwrap();
    close("end", found.end_displacement, (9.8 - 0.5) / (omega * omega), 1e-6);
    assert_eq!((found.slides, found.stops > 0), (found.stops + found.reversals, true));
    let record = Record::new(Excitation::Force, 1.0, (0..4000).map(|i| f64::from(i % 7)).collect()).unwrap();
    let found: Result<RecordAnswer<f64>, Error> = body(1.0, 1.8e19, 0.0, 0.0).follow(&record);
    assert!(matches!(found, Err(Error::TooManyEvents { .. })), "{found:?}");
}

/// Works and forces that leave the range of the type are an error where the motion itself is within it.
#[test]
fn sums_beyond_the_range_are_refused() {
    let of = |mass: f32, force: f32| {
        let body = Body::new(mass, 0.1 * mass).unwrap().with_stiffness(4.0 * mass).unwrap();
        body.with_damping(0.2 * mass)
            .unwrap()
            .follow(&Record::new(Excitation::Force, 0.1, vec![0.0, force, -force, 0.5 * force, 0.0]).unwrap())
    };
    let found = of(1.0, 3.0).unwrap();
    assert!([found.load_work, found.damper_work, found.friction_work].iter().all(|work| work.is_finite()));
    for scale in [1e30f32, 1e37] {
        // The displacements are those of a mass of 1, and energies are beyond 3.4e38.
        match of(scale, 3.0 * scale) {
            Ok(answer) => assert!(
                [answer.load_work, answer.damper_work, answer.friction_work, answer.max_transmitted_force]
                    .iter()
                    .all(|value| value.is_finite()),
                "{answer:?}"
            ),
            Err(error) => assert!(matches!(error, Error::BeyondRange { .. }), "{error}"),
        }
    }
    // Displacements of 1e15 under a mass of 1e20: energies of 1e50.
    let far = of(1e20, 1e35);
    assert!(matches!(far, Err(Error::BeyondRange { .. })), "{far:?}");
}

/// A support that jumps by Δu gives the body the impulse c Δu of the damper on it: without a spring the body slides from
/// rest to (m/c)v − (mr/c²)ln(1 + cv/r), v = cΔu/m.
#[test]
fn a_damper_on_a_support_that_jumps_strikes_the_body() {
    let (m, c, r, du) = (2.0, 20.0, 1.0, 0.1);
    let of = body(m, 0.0, c, r);
    let v: f64 = c * du / m;
    let way = m / c * v - m * r / (c * c) * (1.0 + c * v / r).ln();
    for sign in [1.0, -1.0] {
        let samples = [0.0, 0.0, du, du].map(|u| sign * u).to_vec();
        let record = |after| {
            let record =
                Record::at_times(Excitation::DampedFootMotion, vec![0.0, 1.0, 1.0, 1.5], samples.clone());
            record.unwrap().followed_by(after)
        };
        let found = of.follow(&record(After::Hold)).unwrap();
        close("way", found.residual_displacement.unwrap(), sign * way, 1e-13);
        close("speed", found.max_velocity.max(-found.min_velocity), v, 1e-15);
        close("load work", found.load_work, m * v * v / 2.0, 1e-13);
        close("works", found.friction_work + found.damper_work, found.load_work, 1e-13);
        assert_eq!((found.slides, found.stops, found.reversals), (1, 1, 0));
        let motion = of.motion(&record(After::Hold), 0.0, 0.0, 0.1).unwrap();
        close("path", motion.answer.path, found.path, 1e-14);
        assert!(motion.states.iter().any(|state| state.time == 1.0 && state.velocity == sign * v));
        // A body that moves one way is held against the other.
        let held = of.one_way().follow(&record(After::Hold)).unwrap();
        assert_eq!(
            held.residual_displacement.unwrap(),
            if sign > 0.0 { found.residual_displacement.unwrap() } else { 0.0 }
        );
        #[cfg(feature = "batch")]
        assert_eq!(
            stickslip::motion::record::follow_each(&[of], &record(After::Zero))[0],
            of.follow(&record(After::Zero))
        );
    }
}

/// With a spring, and within a slide, a jump is the limit of ever faster ramps: twice the answer to a ramp less that to one of
/// twice its time.
#[test]
fn a_jump_of_a_support_is_the_limit_of_fast_ramps() {
    let damped = |times: &[f64], samples: &[f64]| {
        Record::at_times(Excitation::DampedFootMotion, times.to_vec(), samples.to_vec()).unwrap()
    };
    for (m, k, c, r) in [(2.0, 100.0, 20.0, 1.0), (1.0, 300.0, 2.0, 4.0), (3.0, 50.0, 40.0, 0.2)] {
        let of = body(m, k, c, r);
        for (low, high) in [(0.3, -0.2), (0.1, 0.4), (0.2, 0.0)] {
            let found = of.follow(&damped(&[0.0, 0.7, 0.7, 1.1, 4.0], &[0.0, low, high, high, 0.0])).unwrap();
            let ramp = |t: f64| {
                of.follow(&damped(&[0.0, 0.7, 0.7 + t, 1.1, 4.0], &[0.0, low, high, high, 0.0])).unwrap()
            };
            let (one, two) = (ramp(1e-5), ramp(2e-5));
            for (name, of) in [
                ("rest", (|a| a.residual_displacement.unwrap_or_default()) as fn(&RecordAnswer<f64>) -> f64),
                ("end", |a| a.end_displacement),
                ("fastest", |a| a.max_velocity),
                ("slowest", |a| a.min_velocity),
                ("path", |a| a.path),
                ("stick time", |a| a.stick_time),
                ("load work", |a| a.load_work),
            ] {
                // What is left is of the square of the ramp's time, in units of c/m.
                let limit = 2.0 * of(&one) - of(&two);
                assert!(
                    (of(&found) - limit).abs() < 1e-6 * (1.0 + of(&found).abs()),
                    "{name} {m} {low}: {found:?} {limit}"
                );
            }
            let loads =
                of.follow(&damped(&[0.0, 0.7, 4.0], &[0.0, low, low]).followed_by(After::Zero)).unwrap();
            let jump = of.follow(&damped(&[0.0, 0.7, 4.0, 4.0, 40.0], &[0.0, low, low, 0.0, 0.0])).unwrap();
            close("after", loads.residual_displacement.unwrap(), jump.end_displacement, 1e-12);
        }
    }
}

/// A damper so weak that its work is below the rounding of the other works, by ∫ v² dt of the motion without it: half a period
/// of ω = 2 at the amplitude X = 1 − r/k has c ω π X²/2.
#[test]
fn a_weak_damper_has_its_own_work() {
    let (k, r, c) = (4.0, 0.8, 1e-13);
    let still = force(&[0.0, 10.0], &[0.0, 0.0]);
    let found = body(1.0, k, c, r).follow_from(&still, 0.38, 0.0).unwrap();
    let amplitude: f64 = 0.38 - r / k;
    assert_eq!((found.slides, found.stops), (1, 1));
    close("damper work", found.damper_work / c, 2.0 * PI * amplitude * amplitude / 2.0, 1e-11);
    // With friction that differs in nothing but the damper, each work of a strong one is what the balance leaves.
    let strong = body(1.0, k, 0.3, r).follow_from(&still, 0.38, 0.0).unwrap();
    let stored = k / 2.0 * (0.38 * 0.38 - strong.residual_displacement.unwrap().powi(2));
    close("balance", strong.damper_work + strong.friction_work, stored, 1e-13);
}
