//! The friction whose greatest amplitude over a band of frequencies is least.
//!
//! `F(r) = max Q(ω_d; r)` over the band, Q being the amplitude of the steady motion with the friction r, stops
//! included. With little friction F is a resonance, with much the body moves with its support, or rests: in between is
//! the classical compromise of an isolator, in which two frequencies balance.
//!
//! **Where rest is best the answer is proved**: at rest a displacement is 0, and no friction makes it less. That is
//! the trivial case of a displacement under any drive, and of an acceleration unless the surface moves.
//!
//! **Everything else is searched**: Q on a mesh of frequencies, finer towards Ω = 1, 1/3, 1/5, 1/7 and the damped
//! resonance, with each of its maxima located by a golden section; F on a mesh of frictions down to 10⁻⁶ of those that
//! hold the body, which is refined three times where it is best, and around the best minima by a golden section. The
//! answer is then looked at on a mesh of 1024 frequencies: those at which it is worse than on the first mesh join it, and
//! the search begins anew. A peak of Q that is much narrower than 2⁻¹² of its frequency could be missed. A friction with
//! which a motion of the band does not settle, or is irregular, is no candidate.
//!
//! With static friction above the kinetic one Q is the amplitude of the motion from rest. Every friction and frequency may
//! have a limit of its own: the mesh of frictions has a uniform part, more minima are refined, and the frequencies of
//! release belong to the mesh.
//!
//! A friction that is worse than the best one known by a quarter is left at the first frequency that shows it. All motions
//! together have a number of steps, after which the best checked answer is given, or the search is refused.

mod band;
mod steps;

use crate::float::Float;
use crate::greatest::highest;
use crate::machine::error::{Error, Quantity};
use crate::machine::oscillator::{Drive, Oscillator};
use crate::machine::ratios::finite;
use crate::named::named;
use alloc::vec::Vec;
use band::Band;
use core::cmp::Ordering;
use core::ops::RangeInclusive;
pub use steps::Aim;
use steps::{LOG_STEPS, SEARCH_STEPS, by_place, geometric, infinite};

named! {
    /// The kind of a best friction over a band.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
    #[non_exhaustive]
    pub enum BandFrictionKind [name] {
        /// Between none and rest.
        Interior = "interior",
        /// The less friction the better: the answer is the least friction that was tried, 10⁻⁶ of the one that holds the
        /// body.
        None = "none",
        /// The body rests in the whole band, and no motion is better.
        Rest = "rest",
    }
}

/// The friction whose greatest amplitude over a band is least.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct BandFriction<F> {
    /// The friction force r_y, the least of those whose greatest amplitude is within 10⁻¹⁰ of the least.
    pub friction: F,
    /// The greatest amplitude over the band.
    pub greatest: F,
    /// The angular frequencies at which the amplitude is that great, to a relative 10⁻⁶, each as a range of which both
    /// ends are the same where it is a single frequency. Two that balance are the classical compromise; a range is one
    /// where the body moves with its support at the crest.
    pub at: Vec<(F, F)>,
    /// The greatest friction up to which every one is as good, where these are more than 1/1000 of `friction` apart: the
    /// optimum is flat. Where it is `rest` or more, every greater friction is as good, too.
    pub up_to: Option<F>,
    /// The kind.
    pub kind: BandFrictionKind,
    /// The friction from which on the body rests in the whole band.
    pub rest: F,
}

/// The friction with which the greatest amplitude `aim` of the body over the angular frequencies `[low, high]` is
/// least. No friction that was tried, that of rest among them, is better. Where the crest is a motion with the support, many
/// frictions may be equally good: the answer is the least of them, and the greatest up to which all on a mesh are.
///
/// Mass, spring, damper and the ratio of static friction are those of `body`; its own friction plays no part. The
/// amplitude of the drive is the same at every frequency, its frequency is not used. Where the motion depends on its
/// start, as with static friction above the kinetic one, the amplitude is that of the motion from rest.
///
/// Unit of force; the greatest amplitude in a unit of length, force or acceleration, accurate to a relative 10⁻⁹. The
/// friction has a relative error of some 10⁻¹⁰ where two frequencies balance, and of 10⁻⁵ at a smooth minimum. With
/// static friction above the kinetic one it lies 10⁻⁶ inside the frictions that are as good. The
/// documentation of `src/design/over_band.rs` says which answers are proved and which are searched.
///
/// ```
/// use stickslip::design::{Aim, BandFrictionKind, best_friction_over_band};
/// use stickslip::{Drive, Excitation, Oscillator};
/// // 800 kg with a natural period of 2.2 s on a base that moves 50 mm, from half the natural frequency to four times it.
/// let natural = std::f64::consts::TAU / 2.2;
/// let body = Oscillator::new(800.0, 800.0 * natural * natural, 1.0)?;
/// let drive = Drive::new(Excitation::SurfaceMotion, 0.05, 1.0)?;
/// let best =
///     best_friction_over_band(&body, &drive, natural / 2.0..=natural * 4.0, Aim::AbsoluteDisplacement)?;
/// assert_eq!(best.kind, BandFrictionKind::Interior);
/// assert!(best.greatest > 0.05 && best.at.len() >= 2);
/// # Ok::<(), stickslip::Error>(())
/// ```
///
/// # Errors
/// Where `low ≥ high`, a ratio of the band is outside the domain of [`crate::Ratios`], or
/// [`Aim::AbsoluteDisplacement`] is asked of a surface at rest; [`Error::BandTooCostly`] where the motions of the band
/// take more steps than the search may have; and those of [`Amplitude::of`](crate::motion::Amplitude::of) but
/// [`Error::NotSettled`].
pub fn best_friction_over_band<F: Float>(
    body: &Oscillator<F>,
    drive: &Drive<F>,
    band: RangeInclusive<F>,
    aim: Aim,
) -> Result<BandFriction<F>, Error> {
    let (low, high) = band.into_inner();
    let mut band = Band::new(body, drive, low, high, aim)?;
    let rest = band.rest()?;
    if band.is_best_at_rest() {
        return Ok(BandFriction {
            friction: rest,
            greatest: F::int(0),
            at: Vec::new(),
            up_to: Some(rest),
            kind: BandFrictionKind::Rest,
            rest,
        });
    }
    let least = rest * F::exp2i(-LOG_RANGE);
    // With a jump beyond it, rest is to be the motion of a friction typed with seven digits, too.
    let held = if band.is_rough() { rest * (F::int(1) + F::exp2i(-SAFE)) } else { rest };
    let mut best = (held, band.value(held, infinite())?);
    let mut steps = SEARCH_STEPS;
    for round in 0..CHECKS {
        if round >= GUESSES {
            band.doubt_all();
        }
        let found = checked(&band, least, rest, &mut steps);
        let (friction, greatest, missed) = match found {
            Err(Error::BandTooCostly { .. }) if round > 0 => break,
            found => found?,
        };
        // Of those as good the least friction.
        if greatest <= best.1 * (F::int(1) + F::exp2i(-32)) {
            best = (if friction < rest { friction } else { held }, greatest);
        }
        if missed.is_empty() {
            break;
        }
        band.add(&missed);
    }
    band.allow(CHECK_STEPS);
    let friction = best.0;
    let (greatest, at) = band.greatest(friction)?;
    let greatest = finite(Quantity::MaxDisplacement, greatest)?;
    let kind = if friction <= least * F::ratio(33, 32) {
        BandFrictionKind::None
    } else if friction >= rest {
        BandFrictionKind::Rest
    } else {
        BandFrictionKind::Interior
    };
    let up_to = if friction < rest { flat_up_to(&band, (friction, greatest), rest)? } else { Some(friction) };
    Ok(BandFriction { friction, greatest, at, up_to, kind, rest })
}

/// The end of the frictions that are as good as the best one, if they are more than a point.
fn flat_up_to<F: Float>(
    band: &Band<'_, F>,
    (friction, greatest): (F, F),
    rest: F,
) -> Result<Option<F>, Error> {
    band.allow(CHECK_STEPS);
    let is_rough = band.is_rough();
    let enough = greatest * (F::int(1) + F::exp2i(if is_rough { -16 } else { -32 }));
    // With the steps at an end, what was not looked at is not said to be as good.
    let is_as_good = |friction| match band.value(friction, enough) {
        Err(Error::BandTooCostly { .. }) => Ok(false),
        value => value.map(|value| value <= enough),
    };
    let (mut inside, mut outside) = (friction, None);
    for next in geometric(friction, rest, LOG_STEPS).into_iter().skip(1) {
        if !is_as_good(next)? {
            outside = Some(next);
            break;
        }
        inside = next;
    }
    if let Some(mut outside) = outside {
        while outside - inside > inside * F::exp2i(if is_rough { -SAFE } else { -36 }) {
            let middle = inside + (outside - inside) / F::int(2);
            if is_as_good(middle)? { inside = middle } else { outside = middle }
        }
        if is_rough {
            inside = inside * (F::int(1) - F::exp2i(-SAFE));
        }
    }
    Ok(Some(inside).filter(|&end| end > friction * F::ratio(1001, 1000)))
}

/// A friction, its greatest amplitude on the mesh and on the finer one, and the frequencies that the mesh missed.
type Checked<F> = (F, F, Vec<(F, F)>);

/// The best friction on the mesh of frequencies, found with the steps that are left, and looked at on a finer one.
fn checked<F: Float>(band: &Band<'_, F>, least: F, rest: F, steps: &mut u64) -> Result<Checked<F>, Error> {
    let search = FrictionSearch { band, rest, tried: Vec::new(), much_worse: F::ratio(5, 4) };
    band.allow(*steps);
    let (friction, greatest) = search.best(least)?;
    *steps = band.allow(CHECK_STEPS);
    let missed = band.missed(friction, greatest)?;
    Ok((friction, missed.first().map_or(greatest, |worst| greatest.or_larger(worst.1)), missed))
}

/// The frictions tried, in their order, with the greatest amplitude of each; of one that is much worse than the best, with
/// an amplitude that shows it.
struct FrictionSearch<'a, 'b, F> {
    band: &'a Band<'b, F>,
    rest: F,
    tried: Vec<(F, F)>,
    /// The part of the least amplitude above which a friction is not looked at closely.
    much_worse: F,
}

impl<F: Float> FrictionSearch<'_, '_, F> {
    /// The best friction, and its greatest amplitude; with the steps at an end, the best one tried.
    fn best(mut self, least: F) -> Result<(F, F), Error> {
        let mut frictions = geometric(least, self.rest, LOG_STEPS);
        if self.band.is_rough() {
            frictions.extend(self.uniform(UNIFORM));
        }
        // From rest on downwards: what is much worse is seen by one motion.
        frictions.sort_by(|a, b| b.partial_cmp(a).unwrap_or(Ordering::Equal));
        self.add(frictions)?;
        match self.refined() {
            Err(Error::BandTooCostly { .. }) => {
                self.tried.sort_by(by_place);
                let (enough, first) = as_good_as_any(&self.tried);
                Ok((self.tried.get(first).map_or(self.rest, |place| place.0), enough))
            }
            found => found,
        }
    }

    /// Steps of the same size up to rest.
    fn uniform(&self, steps: i32) -> Vec<F> {
        (1..steps).map(|k| self.rest * F::ratio(k, steps)).collect()
    }

    fn refined(&mut self) -> Result<(F, F), Error> {
        let (band, rest) = (self.band, self.rest);
        let is_rough = band.is_rough();
        if is_rough {
            // From here on only better ones count; on a piece of equal ones one motion shows that they are not.
            self.much_worse = F::int(1) - F::exp2i(-33);
            self.add(self.uniform(FINE))?;
            let places = minima(&self.tried, ROUGH_MINIMA);
            let ranges: Vec<(F, F)> = places.into_iter().map(|place| self.beside(place)).collect();
            for (from, to) in ranges {
                self.add(geometric(from, to, LOG_STEPS).into_iter().step_by(2))?;
            }
            self.much_worse = F::ratio(17, 16);
        } else {
            self.much_worse = F::ratio(17, 16);
            // Where the body moves with its support the amplitude hardly depends on the friction, and less of it may be a
            // little better still: the mesh is refined around the least friction that is as good as any.
            for _ in 0..REFINEMENTS {
                let (from, to) = around(&self.tried);
                self.add(geometric(from, to, LOG_STEPS).into_iter().step_by(4))?;
            }
        }
        let share = F::epsilon() * F::exp2i(if is_rough { 28 } else { 18 });
        for place in minima(&self.tried, MINIMA) {
            if is_rough && self.is_flat(place) {
                continue;
            }
            let (from, to) = self.beside(place);
            let friction = highest(from, to, share, |friction| self.value(friction).map(|value| -value))?;
            let value = self.value(friction)?;
            self.tried.push((friction, value));
        }
        self.tried.sort_by(by_place);
        let (enough, first) = as_good_as_any(&self.tried);
        let at = |j: usize| self.tried.get(j).map_or(rest, |place| place.0);
        let (mut outside, mut inside) = (at(first.saturating_sub(1)), at(first));
        let (sharp, within) = (inside * F::exp2i(-36), inside * F::exp2i(-SAFE));
        let last = if is_rough { within } else { sharp };
        while inside - outside > last {
            let middle = outside + (inside - outside) / F::int(2);
            if band.value(middle, enough)? > enough { outside = middle } else { inside = middle }
        }
        if !is_rough {
            return Ok((inside, enough));
        }
        // A limit may begin or end there: a friction typed with seven digits is to be on the same side of it.
        let enough = enough * (F::int(1) + F::exp2i(-16));
        let is_good = |friction| Ok::<_, Error>(band.value(friction, enough)? <= enough);
        let friction = match (is_good(inside - within)?, is_good(inside + within)?) {
            (true, false) => inside - within,
            (false, true) => inside + within,
            _ => inside,
        };
        Ok((friction, band.value(friction, enough)?))
    }

    /// The greatest amplitude; of a friction that is much worse than the best one an amplitude that shows it.
    fn value(&self, friction: F) -> Result<F, Error> {
        let least = self
            .tried
            .iter()
            .fold(infinite(), |least: F, place| if place.1 < least { place.1 } else { least });
        let limit = least * self.much_worse;
        let value = self.band.value(friction, limit)?;
        Ok(if value > limit { value.or_larger(least * (F::int(1) + F::exp2i(-20))) } else { value })
    }

    fn add(&mut self, frictions: impl IntoIterator<Item = F>) -> Result<(), Error> {
        for friction in frictions {
            let value = self.value(friction)?;
            self.tried.push((friction, value));
        }
        self.tried.sort_by(by_place);
        self.tried.dedup_by(|a, b| a.0 == b.0);
        Ok(())
    }

    /// Whether a neighbour of a place is as good.
    fn is_flat(&self, place: usize) -> bool {
        let value = |i: usize| self.tried.get(i).map(|place| place.1);
        let Some(here) = value(place) else { return true };
        let as_good = here * (F::int(1) + F::exp2i(-16));
        let beside = [place.checked_sub(1), place.checked_add(1)];
        beside.into_iter().flatten().filter_map(value).any(|value| value <= as_good)
    }

    /// The neighbours of a place.
    fn beside(&self, place: usize) -> (F, F) {
        let at = |j: usize| self.tried.get(j).map_or(self.rest, |place| place.0);
        (at(place.saturating_sub(1)), at(place.saturating_add(1)))
    }
}

/// The least greatest amplitude but for 2⁻³³, and the first friction that is as good.
fn as_good_as_any<F: Float>(tried: &[(F, F)]) -> (F, usize) {
    let least =
        tried.iter().fold(infinite(), |least: F, place| if place.1 < least { place.1 } else { least });
    let enough = least * (F::int(1) + F::exp2i(-33));
    (enough, tried.iter().position(|place| place.1 <= enough).unwrap_or(0))
}

/// The neighbours of the least friction that is as good as any.
fn around<F: Float>(tried: &[(F, F)]) -> (F, F) {
    let (_, first) = as_good_as_any(tried);
    let at = |i: usize| tried.get(i).or(tried.last()).map_or(F::int(1), |place| place.0);
    (at(first.saturating_sub(1)), at(first.saturating_add(1)))
}

/// The places of the best minima of a mesh.
fn minima<F: Float>(tried: &[(F, F)], count: usize) -> Vec<usize> {
    let value = |i: Option<usize>| i.and_then(|i| tried.get(i)).map(|place| place.1);
    let mut found: Vec<usize> = (0..tried.len())
        .filter(|&i| {
            let (before, here, after) = (value(i.checked_sub(1)), value(Some(i)), value(i.checked_add(1)));
            here.is_some_and(|here| before.is_none_or(|b| here <= b) && after.is_none_or(|a| here <= a))
        })
        .collect();
    found.sort_by(|&a, &b| value(Some(a)).partial_cmp(&value(Some(b))).unwrap_or(Ordering::Equal));
    found.truncate(count);
    found
}

/// The binary logarithm of the range of frictions: 10⁶.
const LOG_RANGE: i32 = 20;
/// The part of a friction by which it is inside of those as good, 10⁻⁶, as a power of 1/2.
const SAFE: i32 = 20;
/// Refinements of the mesh of frictions.
const REFINEMENTS: usize = 3;
/// Minima of the mesh around which a golden section searches.
const MINIMA: usize = 3;
/// Minima of a mesh with static friction above the kinetic one.
const ROUGH_MINIMA: usize = 5;
/// The uniform steps of the frictions up to rest, with static friction above the kinetic one.
const UNIFORM: i32 = 32;
/// The uniform steps of a mesh whose frictions are left as soon as they are worse than the best one.
const FINE: i32 = 600;
/// The steps of a check.
const CHECK_STEPS: u64 = 2_000_000;
/// The meshes of frequencies.
const CHECKS: u32 = 5;
/// Those on which the cycle in closed form is tried for the motion from rest.
const GUESSES: u32 = 3;

#[cfg(test)]
mod tests;
