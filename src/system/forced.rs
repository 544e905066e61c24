//! The motion that a start leads to under loads: the periods are followed, and a fixed point of the period map is taken for the limit where
//! the motion goes to it.

use super::assembly::Assembly;
use super::branch::Branch;
use super::error::Error;
use super::few::is_large;
use super::first_passage::integer;
use super::fixed_point::{Fixed, newton};
use super::follow::Follower;
use super::following::{End, Following, MOST_MULTIPLE};
use super::steady::Steady;
use crate::float::Float;
use alloc::string::ToString;
use alloc::vec::Vec;

/// The most periods that are followed where the change of the motion does not fall.
const MOST_PERIODS: usize = 2048;
/// The most steps of a period of the loads.
const MOST_STEPS: usize = 250_000;

/// A measure of a motion at a number of periods: the greatest displacements and velocities since the mark before, and how nearly it
/// repeats itself.
struct Mark<F> {
    followed: usize,
    sizes: [F; 3],
    change: F,
}

/// Whether displacements or velocities have grown by more than a half from each of the last marks to the next.
fn grows<F: Float>(marks: &[Mark<F>]) -> bool {
    let grown = |a: F, b: F| a > F::int(0) && b * F::int(2) > a * F::int(3);
    let by = |part: fn(&[F; 3]) -> F| matches!(marks, [.., a, b, c] if grown(part(&a.sizes), part(&b.sizes)) && grown(part(&b.sizes), part(&c.sizes)));
    by(|sizes| sizes[0]) || by(|sizes| sizes[1])
}

/// The motion that a start leads to.
pub(crate) fn steady<'a, F: Float>(
    system: &'a Assembly<F>,
    period: F,
    slowest: impl FnOnce() -> Option<F>,
    follower: Follower<'a, F>,
) -> Result<Steady<F>, Error> {
    let step = follower.branch().map_or(period, Branch::longest);
    if !step.is_finite() || period > step * integer(MOST_STEPS) {
        return Err(Error::Unsupported {
            name: "period of the loads".to_string(),
            condition: "must have at most 250000 steps of the system's fastest rate",
        });
    }
    let mut following = Following::new(system, follower, period);
    let mut marks: Vec<Mark<F>> = Vec::new();
    let (mut next, mut refused, mut looked) = (4, false, 0);
    while following.advance()?.is_some() {
        let followed = following.followed;
        let settled = following.back(1) <= F::epsilon() * F::int(2);
        // Where events come no more, the derivative is that of a branch alone, and the limit may be proved at once.
        let is_quiet = followed > 4 && following.has_become_quiet() && 8 * followed > 9 * looked;
        if followed >= next || (settled && !refused) || is_quiet {
            looked = followed;
            // Of a large system a derivative takes as long as many periods.
            let later = if is_large(system) { 4 } else { 2 };
            next = next.max(followed.saturating_mul(later));
            if let Some(found) = look(&mut following)? {
                return Ok(found);
            }
            refused = settled;
        }
        let followed = following.followed;
        if followed >= marks.last().map_or(MOST_PERIODS / 8, |mark| 2 * mark.followed) {
            let (sizes, change) = (following.take_greatest(), following.recurrence());
            marks.push(Mark { followed, sizes, change });
            let falls =
                matches!(marks.as_slice(), [.., a, b] if b.change * F::int(33) <= a.change * F::int(32));
            if followed >= MOST_PERIODS && (!falls || grows(&marks)) {
                break;
            }
        }
    }
    let decay = match marks.as_slice() {
        [.., a, b] if b.change < a.change => {
            let periods = integer::<F>(b.followed - a.followed);
            F::from_f64(((b.change / a.change).to_f64().ln() / periods.to_f64()).exp())
        }
        _ => F::int(1),
    };
    // Within a part of an own vibration a beginning looks like growth.
    let is_long = slowest().is_none_or(|longest| period * integer(following.followed) > longest * F::int(8));
    let grows = following.end == Some(End::Unbounded) || (is_long && grows(&marks));
    let change = following.back(1);
    following.unsettled(grows, change, decay)
}

/// The steady motion that the motion goes to now, if there is one.
fn look<F: Float>(following: &mut Following<'_, F>) -> Result<Option<Steady<F>>, Error> {
    let settled = following.back(1) <= F::epsilon() * F::int(2);
    let known = following.states.len().saturating_sub(1);
    for multiple in 1..=MOST_MULTIPLE.min(if settled { 1 } else { (known / 4).max(1) }) {
        // A motion of several periods comes back to its state, and not after one.
        if multiple > 1 && following.back(multiple) * F::int(2) > following.back(1) {
            continue;
        }
        // Motions of many periods are looked for where the followed one almost repeats itself.
        let few = if is_large(following.map.system) { 1 } else { 8 };
        if multiple > few && following.back(multiple) > F::ratio(1, 1000) {
            continue;
        }
        let (from, before) = (following.now(), following.map.follower.saved());
        let found = newton(&mut following.map, &from, multiple)?;
        let Some(mut fixed) = found else {
            following.map.follower.resume(&before);
            continue;
        };
        // It may be one of fewer periods, which divide these.
        let mut least = multiple;
        for fewer in (1..multiple).filter(|&fewer| multiple.is_multiple_of(fewer)) {
            let x = fixed.x.clone();
            let part = newton(&mut following.map, &x, fewer)?;
            let near = |part: &Fixed<F>| {
                following.map.distance(&part.x, &x, &part.mapped.sizes) <= F::epsilon().sqrt() / F::int(64)
            };
            if let Some(part) = part.filter(near) {
                (least, fixed) = (fewer, part);
                break;
            }
        }
        following.map.follower.resume(&before);
        if following.approaches(&fixed, least, 0)? {
            return following.answer(fixed, least, true).map(Some);
        }
    }
    Ok(None)
}

/// The common period of loads with these frequencies.
pub(crate) fn common_period<F: Float>(frequencies: &[F]) -> Result<F, Error> {
    let unsupported = |condition| Error::Unsupported { name: "loads".to_string(), condition };
    let least = frequencies
        .iter()
        .copied()
        .reduce(|a, b| if b < a { b } else { a })
        .ok_or_else(|| unsupported("must have an entry: a steady motion has the period of a load"))?;
    // Rounded multiples of a common frequency differ from it by a few units.
    let doubt = F::epsilon() * F::int(64);
    for multiple in 1..=1000 {
        let whole = |f: &F| {
            let ratio = *f / least * F::int(multiple);
            (ratio - ratio.round()).abs() <= doubt * ratio
        };
        if frequencies.iter().all(whole) {
            return Ok(F::int(2) * F::pi() * F::int(multiple) / least);
        }
    }
    Err(unsupported("must have a common period of at most 1000 periods of the slowest"))
}
