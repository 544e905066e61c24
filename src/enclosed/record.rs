//! The motion under a record, enclosed: every answer with a bound of its error, and every stop proved.

use super::widen::{InBalls, with_more_bits};
use super::{Ball, Enclosure, valid};
use crate::float::ball::Radius;
use crate::float::mp::Mp;
use crate::machine::error::{Error, written};
use crate::motion::record::{Body, Record, RecordAnswer, follow_in_balls};

/// The motion under a record from the displacement x and the velocity v, enclosed: the exact motion of every body, record
/// and start within 64 units in the last place of the numbers given, so that decimal numbers that were read and converted
/// are among them. Equal samples side by side are one number, and a static friction of exactly the kinetic one stays so. Damping that
/// is critical within those units is taken as critical.
///
/// Signs are certain: no stop, release or extreme was missed, whatever the rounding. The widths grow with the time
/// in units of 1/ω, by some 1.4 bits each, so that the computation takes as many bits as it needs, up to 4160. The
/// greatest displacement and the greatest velocity are as sharp as `bits`, unless the numbers given or those
/// bits do not suffice; then the radii say so.
///
/// # Errors
/// As [`Body::follow_from`], and [`Error::UncertainEvent`] where a sign stays uncertain at the same time with twice the bits, or at the most: the load is at
/// the bound of friction, or the velocity grazes zero.
///
/// ```
/// use stickslip::float::Mp;
/// use stickslip::motion::record::{Body, Record};
/// use stickslip::{Excitation, enclosed};
/// let number = |text: &str| text.parse::<Mp<4>>();
/// // Newmark's sliding block: µ g = 1 and a pulse of 3 for 1 s. It slides by a(a − r)t²/(2r) = 3.
/// let body = Body::new(number("2")?, number("2")?)?;
/// let pulse = Record::new(Excitation::SurfaceAcceleration, number("1")?, vec![number("-3")?, number("-3")?])?;
/// let found = enclosed::follow(&body, &pulse, number("0")?, number("0")?, 64)?;
/// let residual = found.residual_displacement.unwrap();
/// assert!(residual.contains(&number("3")?.into()) && residual.rad < 1e-18);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn follow<const N: usize>(
    body: &Body<Mp<N>>,
    record: &Record<Mp<N>>,
    x: Mp<N>,
    v: Mp<N>,
    bits: u32,
) -> Result<RecordAnswer<Enclosure>, Error> {
    let bits = valid(bits)?;
    body.check_start(x, v)?;
    let mut last = Err(Error::UncertainEvent { time: written(record.time(0)) });
    let motion = AskedRecord { body, record, start: [x, v], bits };
    let found = with_more_bits(&PRECISIONS, bits, &motion, |words, found| {
        match found {
            Ok((true, Ok(found))) => return Some(Ok(found)),
            Ok((_, found)) => last = found,
            // More bits do not help where the motion is exactly on a bound: they end at the same time.
            Err(error) if words >= DECIDED && last.as_ref().err() == Some(&error) => return Some(Err(error)),
            Err(error) if last.is_err() => last = Err(error),
            // Fewer bits were enough.
            Err(_) => {}
        }
        None
    });
    found.unwrap_or(last)
}

/// A motion under a record, to so many bits.
struct AskedRecord<'a, const N: usize> {
    body: &'a Body<Mp<N>>,
    record: &'a Record<Mp<N>>,
    start: [Mp<N>; 2],
    bits: u32,
}

impl<const N: usize> InBalls for AskedRecord<'_, N> {
    /// The answers, and whether they have so many bits.
    type Found = Result<(bool, Result<RecordAnswer<Enclosure>, Error>), Error>;

    fn run<const W: usize>(&self) -> Self::Found {
        let found = follow_in_balls::<N, W>(self.body, self.record, self.start)?;
        Ok((is_sharp(&found, self.bits), answer(&found, self.bits)))
    }
}

/// The precision from which on a sign that is uncertain at the same time as with half the bits is taken to stay so, in
/// words of 64 bits: a slide of 500 time constants has signs of e^−500, which need 720 bits.
const DECIDED: u32 = 33;
/// The precisions tried, in words of 64 bits.
const PRECISIONS: [u32; 6] = [3, 5, 9, 17, 33, 65];

/// Whether the greatest displacement and the greatest velocity have so many bits.
fn is_sharp<const W: usize>(found: &RecordAnswer<Ball<W>>, bits: u32) -> bool {
    let pairs =
        [(&found.max_displacement, &found.min_displacement), (&found.max_velocity, &found.min_velocity)];
    pairs.into_iter().all(|(most, least)| {
        let size = |ball: &Ball<W>| Radius::below(ball.mid()).exponent();
        let radius = most.rad().max(least.rad());
        radius.is_zero() || size(most).max(size(least)) - radius.exponent() >= i64::from(bits) + 2
    })
}

fn answer<const W: usize>(
    found: &RecordAnswer<Ball<W>>,
    bits: u32,
) -> Result<RecordAnswer<Enclosure>, Error> {
    let of = |ball: &Ball<W>| Enclosure::of(ball).map(|found| found.rounded(bits));
    let answer = found.map(of);
    let time = found.max_displacement_time.or(found.max_velocity_time);
    answer.ok_or_else(|| Error::UncertainEvent { time: written(time.map_or(Mp::ZERO, |time| time.mid())) })
}
