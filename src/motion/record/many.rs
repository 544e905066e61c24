//! Many bodies under one record, in vector lanes and on all threads.

use super::answers::RecordAnswer;
use super::body::Body;
use super::lanes;
use super::load::Record;
use super::quiet::Followed;
use crate::batch::{Level, Loops};
use crate::machine::error::Error;
use core::ops::ControlFlow;

/// Bodies side by side: a multiple of the lanes of every instruction set, few enough for the first-level cache.
const LANES: usize = 16;

/// Follows bodies from rest at x = 0 under one record, on all threads of the current rayon pool with the feature
/// `rayon`. Answers and errors are those of [`Body::follow`], to the last bit.
pub fn follow_each(bodies: &[Body<f64>], record: &Record<f64>) -> Vec<Result<RecordAnswer<f64>, Error>> {
    follow_each_while(bodies, record, &|| ControlFlow::Continue(()))
}

/// Follows bodies as [`follow_each`] does, as long as `keep_going` returns [`ControlFlow::Continue`].
///
/// # Errors
/// [`Error::Interrupted`] where `keep_going` ends the work, and as for [`follow_each`].
pub fn follow_each_while(
    bodies: &[Body<f64>],
    record: &Record<f64>,
    keep_going: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Vec<Result<RecordAnswer<f64>, Error>> {
    #[cfg(feature = "rayon")]
    {
        use rayon::prelude::*;
        bodies.par_chunks(LANES).flat_map_iter(|chunk| side_by_side(chunk, record, keep_going)).collect()
    }
    #[cfg(not(feature = "rayon"))]
    bodies.chunks(LANES).flat_map(|chunk| side_by_side(chunk, record, keep_going)).collect()
}

/// Follows at most [`LANES`] bodies.
fn side_by_side(
    bodies: &[Body<f64>],
    record: &Record<f64>,
    keep_going: &dyn Fn() -> ControlFlow<()>,
) -> Vec<Result<RecordAnswer<f64>, Error>> {
    let (mut followed, mut errors) = (Vec::with_capacity(LANES), Vec::with_capacity(LANES));
    for body in bodies {
        match body.followed(record, 0.0, 0.0) {
            Ok(one) => {
                followed.push(one);
                errors.push(None);
            }
            Err(error) => errors.push(Some(error)),
        }
    }
    Level::best().run(Lanes { bodies: &mut followed, record, keep_going });
    let mut followed = followed.into_iter();
    let answers =
        bodies.iter().zip(errors).map(|(body, error)| match (error, followed.as_slice().is_empty()) {
            (None, false) => followed
                .next()
                .map_or(Err(Error::Interrupted), |followed| body.settled(record, [0.0; 2], followed)),
            (error, _) => Err(error.unwrap_or(Error::Interrupted)),
        });
    answers.collect()
}

/// The bodies of all lanes.
struct Lanes<'a> {
    bodies: &'a mut [Followed<f64>],
    record: &'a Record<f64>,
    keep_going: &'a dyn Fn() -> ControlFlow<()>,
}

impl Loops for Lanes<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        lanes::follow::<f64, LANES>(self.bodies, self.record, self.keep_going);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::excitation::Excitation;
    use core::sync::atomic::{AtomicU32, Ordering};

    #[test]
    fn a_body_that_leaves_the_range_fails_once_beside_others() {
        let samples = [0.0, 0.0, 1e200, -1e200, 0.0].repeat(10);
        let record = Record::new(Excitation::Force, 0.01, samples).unwrap();
        let body = |mass: f64| Body::new(mass, 0.1 * mass).unwrap().with_stiffness(4.0 * mass).unwrap();
        let bodies = [1e200, 1e-120, 3e200, 1e-100, 1e-140].map(body);
        let together = follow_each(&bodies, &record);
        assert!(together.iter().any(Result::is_err) && together.iter().any(Result::is_ok), "{together:?}");
        for (body, together) in bodies.iter().zip(together) {
            assert_eq!(format!("{:?}", body.follow(&record)), format!("{together:?}"));
        }
    }

    /// Rests last whole steps of several lengths, some of which follow each other, with changes of the load at once.
    #[test]
    fn a_body_has_its_bits_under_steps_of_several_lengths() {
        let lengths =
            [0.125, 0.125, 0.125, 0.0625, 0.125, 0.0, 0.125, 0.0625, 0.0625, 0.0625, 0.0, 0.0625, 0.25];
        let mut time = 0.0;
        let times: Vec<f64> = (0..400)
            .map(|i| {
                let now = time;
                time += lengths[i % lengths.len()];
                now
            })
            .collect();
        let samples = times.iter().enumerate().map(|(i, t)| (1.7 * t).sin() + (i as f64 * 2.3).sin() * 0.3);
        let record = Record::at_times(Excitation::Force, times.clone(), samples.collect()).unwrap();
        let body = |k: i32| {
            let body = Body::new(1.0, 0.05 * f64::from(k)).unwrap().with_stiffness(4.0).unwrap();
            body.with_damping(0.1 * f64::from(k % 3)).unwrap()
        };
        let bodies: Vec<_> = (0..24).map(body).collect();
        let together = follow_each(&bodies, &record);
        assert!(together.iter().filter(|answer| answer.as_ref().unwrap().stick_time > 1.0).count() > 5);
        for (body, together) in bodies.iter().zip(together) {
            assert_eq!(format!("{:?}", body.follow(&record)), format!("{together:?}"));
        }
    }

    #[test]
    fn a_long_record_is_left_before_its_end() {
        let record = Record::new(Excitation::SurfaceAcceleration, 0.01, vec![1.0; 20_000]).unwrap();
        let body = Body::new(1.0, 0.1).unwrap().with_stiffness(4.0).unwrap();
        let looks = AtomicU32::new(0);
        let twice = || {
            let is_over = looks.fetch_add(1, Ordering::Relaxed) >= 2;
            if is_over { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let found = follow_each_while(&[body; 3], &record, &twice);
        assert!(found.iter().all(|answer| matches!(answer, Err(Error::Interrupted))), "{found:?}");
        assert_eq!((found.len(), looks.into_inner()), (3, 3));
    }
}
