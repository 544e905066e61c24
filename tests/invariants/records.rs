//! Promises of the motion under a record, for any body and record.

use stickslip::generators::Shaken;
use stickslip::motion::record::{Body, Record, RecordMotion};
use stickslip::{Error, Excitation, Float};

const EXCITATIONS: [Excitation; 4] = [
    Excitation::Force,
    Excitation::SurfaceAcceleration,
    Excitation::FootMotion,
    Excitation::DampedFootMotion,
];

/// The body and the record of an input.
pub(crate) fn built<F: Float + From<f64>>(shaken: &Shaken) -> Result<(Body<F>, Record<F>), Error> {
    let [forward, backward] = shaken.friction.map(F::from);
    let mut body = Body::new(shaken.mass.into(), forward)?
        .with_stiffness(shaken.stiffness.into())?
        .with_damping(shaken.damping.into())?
        .with_static_friction_ratio(shaken.static_friction_ratio.into())?
        .with_directional_friction(forward, backward)?;
    if shaken.is_one_way {
        body = body.one_way();
    }
    let excitation = EXCITATIONS[usize::from(shaken.excitation) % 4];
    let samples = shaken.samples.iter().copied().map(F::from).collect();
    let record = if let [step] = shaken.steps[..] {
        Record::new(excitation, step.into(), samples)?
    } else {
        let mut times = vec![F::int(1)];
        times.extend(shaken.steps.iter().scan(1.0, |time, step| {
            *time += step;
            Some(F::from(*time))
        }));
        Record::at_times(excitation, times, samples)?
    };
    Ok((body, record))
}

/// No stop and no release is missed, friction keeps its bound at rest, and the work of the load is dissipated or
/// stored.
///
/// # Panics
/// If a promise is broken.
pub(crate) fn followed(shaken: &Shaken) {
    let Ok((body, record)) = built::<f64>(shaken) else { return };
    let [x, v] = shaken.start;
    let shortest = shaken.steps.iter().fold(f64::INFINITY, |least, step| least.min(*step));
    let longest = shaken.steps.iter().fold(0.0f64, |most, step| most.max(*step));
    let answer = body.follow_from(&record, x, v);
    let motion = match body.motion(&record, x, v, shortest / 16.0) {
        Ok(motion) => motion,
        Err(error) => {
            assert!(
                matches!(error, Error::BeyondRange { .. } | Error::TooManyEvents { .. }),
                "{error} of {shaken:?}"
            );
            return;
        }
    };
    let answer = answer.unwrap_or_else(|error| panic!("{error} of {shaken:?}"));
    let other = motion.answer;
    // A slide of rounding alone has no digits.
    let load = answer.max_transmitted_force.max(body.friction()) / body.mass();
    let length = answer.max_displacement.abs().max(answer.min_displacement.abs()).max(answer.path);
    let speed = answer.max_velocity.abs().max(answer.min_velocity.abs());
    checked(shaken, &body, &record, &motion);
    // A slide that creeps to within rounding of its limit stops or does not, as rounding has it: under loads to come the
    // two are different motions.
    let critical = 2.0 * (body.stiffness() * body.mass()).sqrt();
    if body.damping() > 0.9 * critical && body.damping() > 0.0 {
        return;
    }
    let (step, load) = (longest, load * longest);
    for (one, two, size, time) in [
        (answer.path, other.path, length, step),
        (answer.max_displacement, other.max_displacement, length, step),
        (answer.min_displacement, other.min_displacement, length, step),
        (answer.max_velocity, other.max_velocity, speed, 1.0),
        (answer.min_velocity, other.min_velocity, speed, 1.0),
    ] {
        assert!((one - two).abs() <= 1e-7 * size + 1e-13 * load * time, "{one} {two} of {shaken:?}");
    }
}

/// The states and events of a motion.
fn checked(shaken: &Shaken, body: &Body<f64>, record: &Record<f64>, motion: &RecordMotion<f64>) {
    let answer = motion.answer;
    let speed = answer.max_velocity.abs().max(answer.min_velocity.abs());
    let length = answer.max_displacement.abs().max(answer.min_displacement.abs());
    let tiny = 1e-9;
    for state in &motion.states {
        let sign = f64::from(state.direction);
        assert!(sign * state.velocity >= -tiny * speed, "{state:?} of {shaken:?}");
        assert!(state.direction != 0 || state.velocity == 0.0, "{state:?} of {shaken:?}");
        assert!(state.direction >= 0 || !shaken.is_one_way, "{state:?} of {shaken:?}");
        assert!(state.displacement <= answer.max_displacement + tiny * length, "{state:?} of {shaken:?}");
        assert!(state.displacement >= answer.min_displacement - tiny * length, "{state:?} of {shaken:?}");
        if state.time <= record.end() {
            assert!(state.velocity <= answer.max_velocity + tiny * speed, "{state:?} of {shaken:?}");
            assert!(state.velocity >= answer.min_velocity - tiny * speed, "{state:?} of {shaken:?}");
        }
    }
    for pair in motion.events.windows(2) {
        let [one, two] = pair else { continue };
        assert!(two.time >= one.time - 4.0 * f64::EPSILON * one.time.abs(), "{pair:?} of {shaken:?}");
        assert!((one.direction == 0) != (two.direction == 0), "{pair:?} of {shaken:?}");
        // A slide from one to the next goes in its direction, and a rest stays where it is.
        let moved = (two.displacement - one.displacement) * f64::from(one.direction);
        assert!(moved >= -tiny * length, "{pair:?} of {shaken:?}");
        assert!(one.direction != 0 || one.displacement == two.displacement, "{pair:?} of {shaken:?}");
    }
    // A vibration without friction that decays for ever has its events counted to the end of the record only.
    let is_endless =
        body.friction() == 0.0 && motion.events.last().is_some_and(|event| event.time > record.end());
    let slides = motion.events.iter().filter(|event| event.direction != 0).count();
    if !is_endless {
        assert_eq!(u64::try_from(slides), Ok(answer.slides), "{shaken:?}");
        let ends = motion.events.len() - slides;
        assert_eq!(u64::try_from(ends), Ok(answer.stops + answer.reversals), "{shaken:?}");
    }
    assert!(answer.friction_work >= -tiny * answer.load_work.abs(), "{answer:?} of {shaken:?}");
}
