use super::*;
use crate::machine::excitation::Excitation;
use crate::motion::record::{Body, Record};
use crate::random::Random;

/// A turn has the bits of the follower, which takes the same step by its events.
#[test]
fn turns_are_those_of_the_follower() {
    let mut random = Random(11);
    let samples: Vec<f64> = (0..600).map(|_| random.between(-0.5, 0.5)).collect();
    let (mut turns, mut stops, mut rests) = (0, 0, 0);
    for excitation in [Excitation::SurfaceAcceleration, Excitation::DampedFootMotion] {
        let record = Record::new(excitation, 0.01, samples.clone()).unwrap();
        for k in 0..60u32 {
            let omega = core::f64::consts::TAU / (0.05 + 0.07 * f64::from(k));
            let body = Body::new(1.0, [0.0, 0.05, 0.15, 0.3][(k % 4) as usize])
                .and_then(|body| body.with_stiffness(omega * omega))
                .and_then(|body| body.with_damping([0.0, 0.1, 2.5][(k % 3) as usize] * omega))
                .and_then(|body| body.with_static_friction_ratio([1.0, 1.3][(k / 4 % 2) as usize]))
                .unwrap();
            let body = if k % 7 == 3 { body.one_way() } else { body };
            let [mut quick, mut slow] = [0; 2].map(|_| body.followed(&record, 0.0, 0.0).unwrap());
            let whole = quick.follower.whole_step(0.01);
            let (whole, step) = (whole.as_ref(), Step::new(0.01));
            for (index, pair) in record.samples().windows(2).enumerate() {
                let (samples, time) = ([pair[0], pair[1]], record.time(index));
                let (quiet, limits) = (Quiet::of(&quick, whole, &step), Limits::of(&quick));
                let state = [quick.follower.x, quick.follower.v];
                let turn = Turning::of(&quick, whole, &step).alone(
                    &quick.follower.linear,
                    &quiet,
                    state,
                    &limits,
                    samples,
                    &step,
                );
                match turn {
                    Some(turn) => {
                        turns += 1;
                        stops += i32::from(turn.stops != 0.0);
                        rests += i32::from(turn.wait > 0.0);
                        assert!(quick.turn(&turn, samples, time, &step, whole));
                    }
                    None => assert!(quick.take(samples, time, &step, whole)),
                }
                assert!(slow.take(samples, time, &step, whole));
                let [quick, slow] = [&quick, &slow]
                    .map(|one| format!("{:?} {:?} {:?}", one.follower.x, one.follower.v, one.totals));
                assert_eq!(quick, slow, "{body:?}, step {index}: {turn:?}");
            }
        }
    }
    assert!(turns > 20_000 && stops > 5_000 && rests > 5_000, "{turns} {stops} {rests}");
}
