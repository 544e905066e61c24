//! Friction and damping from a measured load and the motion under it.
//!
//! The motion of a body with the friction r and the damping ratio ζ under the load is exact ([`crate::motion::record`]), so
//! that measured less computed displacements have no error of a method. Their squares are least at the estimates of r, ζ, the
//! displacement at which the spring is relaxed, the start, and the stiffness where it is not known. The fit does not know that r and ζ are not negative: beyond 0
//! the motion goes on in a straight line, x(−r) = 2 x(0) − x(r).

mod between;
mod rough;

use self::between::Between;
use super::free_decay::fit::{Ends, Fit};
use crate::machine::error::{Error, Quantity, written};
use crate::machine::oscillator::critical_damping;
use crate::machine::ratios::{finite, positive};
use crate::motion::record::{Body, Record};
use crate::uncertainty::Estimate;
use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;
use core::cell::Cell;
use core::f64::consts::PI;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// Friction and damping estimated from a load and the motion under it.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
#[must_use]
pub struct MotionIdentified {
    /// The friction r_y.
    pub friction: Estimate,
    /// The damping ratio ζ.
    pub damping_ratio: Estimate,
    /// The damping constant c = 2ζ√(km).
    pub damping: Estimate,
    /// The friction as a displacement r_y/k.
    pub friction_displacement: Estimate,
    /// The stiffness k of the spring where it was not known.
    pub stiffness: Option<Estimate>,
    /// The displacement, as it was measured, at which the spring is relaxed under no load.
    pub offset: Estimate,
    /// The displacement at the start, as it would have been measured without noise.
    pub start_displacement: Estimate,
    /// The velocity at the start; `None` where the body starts at rest.
    pub start_velocity: Option<Estimate>,
    /// The standard error of one displacement, estimated from the residuals.
    pub noise: f64,
    /// Measured minus computed, of each displacement.
    pub residuals: Vec<f64>,
}

/// The places of the parameters.
const FRICTION: usize = 0;
const ZETA: usize = 1;
const OFFSET: usize = 2;
const PLACE: usize = 3;
/// The first of those that a fit may leave out: the stiffness where it is not known, then a velocity at the start.
const FURTHER: usize = 4;

/// The least number of samples.
const LEAST: usize = 20;
/// The frictions of the starts, as parts of the greatest force on the body.
const FRICTIONS: [f64; 5] = [0.02, 0.08, 0.2, 0.4, 0.7];
/// The damping ratios of the starts.
const DAMPINGS: [f64; 3] = [0.003, 0.03, 0.15];
/// The greatest damping ratio of a start beside a fit.
const MOST_DAMPING: f64 = 0.9;
/// The starts from which the descent begins.
const STARTS: usize = 3;
/// The stiffnesses of the starts, in that of the linear least squares.
const STIFFNESSES: [f64; 5] = [0.6, 0.85, 1.0, 1.2, 1.7];
/// The number of stiffnesses where the linear least squares have none, from a cycle in the record to two samples a cycle.
const LADDER: u32 = 24;
/// The frictions on either side of a fit at which other valleys are searched: their number, the distance of the first as a part of the
/// fit's, and the factor from one distance to the next.
const VALLEY: (i32, f64, f64) = (39, 2e-3, 1.2);
/// The directions of the search, as parts of the change of all else along the valley of the fit. With another number of half cycles a valley
/// has another direction.
const DIRECTIONS: [f64; 4] = [1.0, 1.15, 0.85, 0.7];
/// The valleys from which one search descends, and the searches one after the other.
const VALLEYS: usize = 2;
const SEARCHES: usize = 4;
/// The gain of a step, as a part of the sum of squares, below which the descent ends.
const TOLERANCE: f64 = 1e-12;
/// The rise of the sum of squares, over its standard error, with which a start at rest is not refused.
const CHANCE: f64 = 12.0;
/// The half cycles of the natural period, for each sample, above which samples do not show the motion.
const MOST_HALF_CYCLES: f64 = 8.0;
/// The greatest number of samples and half cycles that a search follows, of some 0.05 µs each.
const MOST_FOLLOWED: f64 = 1e8;
/// The noise over the spread of the displacements at which a start at rest explains everything.
const ROUNDING: f64 = 1e-7;
/// The noise over the spread of the displacements above which the model explains nothing.
const MOST_NOISE: f64 = 0.5;

/// The friction and the damping ratio of a body of this mass on a spring of this stiffness, from a measured load and the
/// displacements at the times of its samples; with `None` the stiffness, too.
///
/// Friction is one, static and kinetic. The displacements may be from any zero, and a constant error of the load is a part of
/// this offset. Errors of the displacements count as independent and normal; where neighbouring residuals are alike, the
/// intervals are wider accordingly. The samples of the load count as exact. Between them it is a harmonic, where they are those
/// of one but for a scatter of up to 2 % of it. Otherwise it is as smooth as their differences say, and the intervals include
/// what that leaves open. Straight lines count where they explain the displacements better.
///
/// # Errors
/// Where the mass or the stiffness is not > 0, the displacements are not as many as the samples, fewer than 20, or not finite;
/// [`Error::OutOfRange`] where a sample has more than eight half cycles of the natural period, which it does not show;
/// [`Error::MotionNotIdentified`] where friction and damping do not follow from them, as from a body at rest;
/// [`Error::MotionUnexplained`] where no friction and damping explain them.
pub fn identify_motion(
    mass: f64,
    stiffness: Option<f64>,
    load: &Record<f64>,
    displacements: &[f64],
) -> Result<MotionIdentified, Error> {
    let stiffness = stiffness.map(|stiffness| positive(Quantity::Stiffness, stiffness)).transpose()?;
    let mass = positive(Quantity::Mass, mass)?;
    let (found, expected) = (displacements.len(), load.samples().len());
    if found != expected {
        return Err(Error::LengthMismatch { name: "displacements", found, expected });
    }
    if found < LEAST {
        return Err(Error::TooFewSamples { count: found });
    }
    for (index, &x) in displacements.iter().enumerate() {
        finite(Quantity::Displacement, x)
            .map_err(|error| Error::InMeasurement { index, error: Box::new(error) })?;
    }
    // A fit of the stiffness, too, has several times as many starts.
    let most = if stiffness.is_some() { MOST_FOLLOWED } else { 2.0 * MOST_FOLLOWED };
    let known = KnownBody { mass, stiffness, load, left: Cell::new(most) };
    // The likely load first: straight lines only where they explain the displacements better.
    let curved = Between::harmonic(load).or_else(|| Between::smooth(load));
    let loads: Vec<Between> = curved.into_iter().chain(core::iter::once(Between::straight(load))).collect();
    if let Some(natural) = stiffness.map(|k| (k / mass).sqrt()).filter(|natural| *natural > known.fastest()) {
        let (quantity, value, least) = (Quantity::NaturalFrequency, written(natural), written(0.0));
        return Err(Error::OutOfRange { quantity, value, least, greatest: written(known.fastest()) });
    }
    let mean = displacements.iter().sum::<f64>() / found as f64;
    let spread = (displacements.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / found as f64).sqrt();
    if !(spread > 0.0 && spread.is_finite()) {
        return Err(Error::MotionNotIdentified);
    }
    let springs = stiffness.map_or_else(|| known.stiffnesses(displacements), |stiffness| vec![stiffness]);
    let scale = springs.get(springs.len() / 2).copied().unwrap_or(f64::NAN);
    let force = known.greatest_force(scale, spread);
    let speed = spread * (scale / mass).sqrt();
    let mut scales = vec![force, 1.0, spread, spread];
    scales.extend(stiffness.is_none().then_some(scale));
    scales.push(speed);
    let first = displacements.first().copied().unwrap_or_default();
    let rough = known.rough_velocity(displacements);
    let hopeless = (MOST_NOISE * spread).powi(2) * found as f64;
    let ends = Ends { tolerance: TOLERANCE, hopeless };
    let from_starts = |drive: &Record<f64>, moves: bool| {
        let count = scales.len().saturating_sub(usize::from(!moves));
        let mut starts = Vec::new();
        for (&spring, friction) in springs.iter().flat_map(|spring| FRICTIONS.map(|part| (spring, part))) {
            for (zeta, offset) in DAMPINGS.iter().flat_map(|zeta| [(*zeta, 0.0), (*zeta, mean)]) {
                let mut at = vec![friction * known.greatest_force(spring, spread), zeta, offset, first];
                at.extend(stiffness.is_none().then_some(spring));
                at.push(rough);
                at.truncate(count);
                let model = known.model(drive, &at);
                let sum: f64 = model.iter().zip(displacements).map(|(c, m)| (m - c) * (m - c)).sum();
                if sum.is_finite() {
                    starts.push((sum, at));
                }
            }
        }
        starts.sort_by(|a, b| a.0.total_cmp(&b.0));
        let most = if stiffness.is_some() { STARTS } else { STARTS.saturating_mul(2) };
        starts.into_iter().take(most).map(|(_, at)| at).collect::<Vec<_>>()
    };
    let fit = |drive: &Record<f64>, starts: &[Vec<f64>]| {
        let scales = starts.first().and_then(|start| scales.get(..start.len())).unwrap_or_default();
        Fit::all(displacements, &|at: &[f64]| known.model(drive, at), starts, scales, ends)
    };
    // Whether a fit is as good as another but for chance.
    let is_alike = |one: &Fit, other: &Fit| {
        let is_exact = one.noise() <= ROUNDING * spread;
        is_exact || one.sum <= other.sum * (1.0 + CHANCE / other.degrees_of_freedom())
    };
    let likely = loads.first().ok_or(Error::MotionNotIdentified)?;
    // Where the body stops on the other side, or moves half a cycle more, the sum of squares has another minimum.
    let fits = |moves: bool| {
        let mut all = fit(&likely.load, &from_starts(&likely.load, moves));
        for _ in 0..SEARCHES {
            // A long record keeps what an answer needs.
            if known.left.get() < most / 2.0 {
                break;
            }
            let Some(best) = all.first().map(|best| best.sum * (1.0 - TOLERANCE)) else { break };
            let starts = all.first().map(|best| known.valleys(&likely.load, best, displacements));
            all.extend(fit(&likely.load, &starts.unwrap_or_default()));
            all.sort_by(|a, b| a.sum.total_cmp(&b.sum));
            if all.first().is_none_or(|next| next.sum >= best) {
                break;
            }
        }
        all
    };
    let mut both: Vec<Vec<Fit>> = [false, true].map(fits).into_iter().filter(|all| !all.is_empty()).collect();
    // Each other load from the end of the search under the likely one.
    let mut best: Option<(&Between, Vec<Fit>)> = None;
    let is_as_good = |one: &[Fit], other: &[Fit]| match (one, other) {
        ([one, ..], [other, ..]) => is_alike(one, other),
        _ => !one.is_empty(),
    };
    for between in &loads {
        if !core::ptr::eq(between, likely) {
            let ends = both.iter().filter_map(|all| all.first());
            both = ends.map(|found| fit(&between.load, core::slice::from_ref(&found.at))).collect();
            both.retain(|all| !all.is_empty());
        }
        // A start at rest before one that moves.
        let chosen = both.iter().fold(None, |best: Option<&Vec<Fit>>, next| match best {
            Some(best) if is_as_good(best, next) => Some(best),
            _ => Some(next),
        });
        best = match (best, chosen) {
            (Some(best), Some(next)) if !is_as_good(&best.1, next) => Some((between, next.clone())),
            (None, Some(next)) => Some((between, next.clone())),
            (best, _) => best,
        };
    }
    let (between, mut alike) = best.ok_or(Error::MotionNotIdentified)?;
    let enough = alike.first().map_or(f64::NAN, Fit::chance);
    alike.retain(|fit| fit.sum <= enough);
    let found = alike.first().ok_or(Error::MotionNotIdentified)?;
    let noise = found.noise();
    if noise > MOST_NOISE * spread {
        return Err(Error::MotionUnexplained { noise: written(noise / spread) });
    }
    // A search that was cut may be far from its end.
    if known.left.get() <= 0.0 {
        return Err(Error::MotionNotIdentified);
    }
    let correlation = found.correlation().min(0.98);
    let wider = ((1.0 + correlation) / (1.0 - correlation)).sqrt();
    // What the next term of the load between its samples would move.
    let moved = between.rest.as_ref().map(|rest| {
        let [with, without] = [rest, &between.load].map(|load| known.model(load, &found.at));
        found.moved_by(&with.iter().zip(without).map(|(a, b)| a - b).collect::<Vec<_>>())
    });
    let error = |gradient: &[f64]| {
        let shift = moved.as_ref().map_or(0.0, |moved| moved.iter().zip(gradient).map(|(a, b)| a * b).sum());
        // The interval covers that of each fit that is as good but for chance.
        let along = |fit: &Fit| fit.at.iter().zip(gradient).map(|(a, b)| a * b).sum::<f64>();
        let off = |fit: &Fit| (along(fit) - along(found)).abs() / 2.0 + fit.error_along(gradient);
        (wider * alike.iter().map(off).fold(0.0, f64::max)).hypot(shift)
    };
    let estimate = |value: f64, error: f64, least: f64| Estimate {
        value: value.max(least),
        standard_error: error,
        degrees_of_freedom: found.degrees_of_freedom(),
        range: (least, f64::INFINITY),
        alike: None,
    };
    let at = |place: usize| found.at.get(place).copied();
    let unit =
        |place: usize| (0..found.at.len()).map(|i| f64::from(u8::from(i == place))).collect::<Vec<_>>();
    let any = |place: usize| Some(estimate(at(place)?, error(&unit(place)), f64::NEG_INFINITY));
    let not_negative = |place: usize| Some(estimate(at(place)?, error(&unit(place)), 0.0));
    let all = || {
        let (friction, zeta) = (at(FRICTION)?, at(ZETA)?);
        let (k, is_fitted) = (known.spring(&found.at), stiffness.is_none());
        let critical = critical_damping(mass, k);
        // c = 2ζ√(km) and r/k, and their slopes by the parameters.
        let along = |place: usize, slope: f64, by_stiffness: f64| {
            let mut gradient = vec![0.0; found.at.len()];
            gradient.get_mut(place).map(|own| *own = slope)?;
            if is_fitted {
                gradient.get_mut(FURTHER).map(|own| *own = by_stiffness)?;
            }
            Some(error(&gradient))
        };
        let velocity = FURTHER.saturating_add(usize::from(is_fitted));
        Some(MotionIdentified {
            friction: not_negative(FRICTION)?,
            damping_ratio: not_negative(ZETA)?,
            damping: estimate(zeta * critical, along(ZETA, critical, zeta * critical / (2.0 * k))?, 0.0),
            friction_displacement: estimate(
                friction / k,
                along(FRICTION, 1.0 / k, -friction / (k * k))?,
                0.0,
            ),
            stiffness: if is_fitted { Some(not_negative(FURTHER)?) } else { None },
            offset: any(OFFSET)?,
            start_displacement: any(PLACE)?,
            start_velocity: any(velocity),
            noise,
            residuals: found.residuals.clone(),
        })
    };
    let is_known = |found: &MotionIdentified| {
        let errors = [Some(found.friction), found.stiffness].map(|e| e.map_or(0.0, |e| e.standard_error));
        errors.iter().all(|error| error.is_finite())
    };
    all().filter(is_known).ok_or(Error::MotionNotIdentified)
}

/// What is known of the body, and its load.
struct KnownBody<'a> {
    mass: f64,
    stiffness: Option<f64>,
    load: &'a Record<f64>,
    /// The samples and half cycles that the search may still follow.
    left: Cell<f64>,
}

impl KnownBody<'_> {
    /// The stiffness, which is a parameter where it is not known.
    fn spring(&self, at: &[f64]) -> f64 {
        self.stiffness.or_else(|| at.get(FURTHER).copied()).unwrap_or(f64::NAN)
    }

    /// The greatest natural angular frequency that the samples show.
    fn fastest(&self) -> f64 {
        MOST_HALF_CYCLES * PI * self.load.samples().len() as f64 / (self.load.end() - self.load.time(0))
    }

    /// Stiffnesses to begin with, in order.
    fn stiffnesses(&self, displacements: &[f64]) -> Vec<f64> {
        if let Some(rough) = rough::stiffness(self.mass, self.load, displacements) {
            return STIFFNESSES.iter().map(|part| part * rough).collect();
        }
        let (length, count) = (self.load.end() - self.load.time(0), displacements.len() as f64);
        let slowest = 2.0 * PI / length;
        (0..LADDER)
            .map(|i| slowest * (count / 2.0).powf(f64::from(i) / f64::from(LADDER)))
            .map(|natural| self.mass * natural * natural)
            .collect()
    }

    /// The greatest force on the body, of the load or of the spring over the spread of the displacements.
    fn greatest_force(&self, stiffness: f64, spread: f64) -> f64 {
        let excitation = self.load.excitation();
        let force = if excitation.carries_surface() { self.mass } else { 1.0 };
        let force = if excitation.moves_foot() { stiffness } else { force };
        self.load.samples().iter().fold(stiffness * spread, |most, sample| most.max((force * sample).abs()))
    }

    /// The computed displacements at the times of the load, which moves the body as `drive`; not numbers where there is no motion.
    fn model(&self, drive: &Record<f64>, at: &[f64]) -> Vec<f64> {
        // Beyond 0 in a straight line: the part of each size, with its sign.
        let value = |place: usize| at.get(place).copied().unwrap_or(0.0);
        let (friction, zeta) = (value(FRICTION), value(ZETA));
        let mut parts = vec![(1.0, friction.abs(), zeta.abs())];
        if friction < 0.0 {
            parts = vec![(2.0, 0.0, zeta.abs()), (-1.0, -friction, zeta.abs())];
        }
        if zeta < 0.0 {
            let mirrored = parts.iter().flat_map(|&(part, r, z)| [(2.0 * part, r, 0.0), (-part, r, z)]);
            parts = mirrored.collect();
        }
        let mut sum = vec![0.0; self.load.samples().len()];
        for (part, r, z) in parts {
            let velocity = value(FURTHER.saturating_add(usize::from(self.stiffness.is_none())));
            let found =
                self.displacements(drive, (r, self.spring(at), z), value(OFFSET), [value(PLACE), velocity]);
            for (i, total) in sum.iter_mut().enumerate() {
                *total += part * found.as_ref().and_then(|found| found.get(i)).copied().unwrap_or(f64::NAN);
            }
        }
        sum
    }

    /// Where the sum of squares has other minima as friction changes, and all else with it in nearly the way that raises the sum least;
    /// the lowest of them.
    fn valleys(&self, drive: &Record<f64>, found: &Fit, displacements: &[f64]) -> Vec<Vec<f64>> {
        let (Some(valley), Some(&friction)) = (found.valley(FRICTION), found.at.get(FRICTION)) else {
            return Vec::new();
        };
        let (count, first, factor) = VALLEY;
        let mut low: Vec<(f64, Vec<f64>)> = Vec::new();
        for (part, side) in DIRECTIONS.iter().flat_map(|part| [(part, 1.0), (part, -1.0)]) {
            let at = |power: i32| {
                let by = side * friction.abs() * first * factor.powi(power);
                let mut at = found.at.clone();
                for (place, (x, slope)) in at.iter_mut().zip(&valley).enumerate() {
                    *x += by * slope * if place == FRICTION { 1.0 } else { *part };
                }
                if let Some(zeta) = at.get_mut(ZETA) {
                    *zeta = zeta.clamp(0.0, MOST_DAMPING);
                }
                at
            };
            let all = (0..count).map(at).take_while(|at| at.first().is_some_and(|friction| *friction >= 0.0));
            let all: Vec<(f64, Vec<f64>)> = all
                .map(|at| {
                    let model = self.model(drive, &at);
                    (model.iter().zip(displacements).map(|(c, m)| (m - c) * (m - c)).sum(), at)
                })
                .collect();
            low.extend(all.windows(3).filter_map(|three| match three {
                [(before, _), (sum, at), (after, _)] if sum < before && sum <= after => {
                    Some((*sum, at.clone()))
                }
                _ => None,
            }));
        }
        low.sort_by(|a, b| a.0.total_cmp(&b.0));
        low.into_iter().take(VALLEYS).map(|(_, at)| at).collect()
    }

    fn displacements(
        &self,
        drive: &Record<f64>,
        (friction, stiffness, zeta): (f64, f64, f64),
        offset: f64,
        [x, v]: [f64; 2],
    ) -> Option<Vec<f64>> {
        let length = self.load.end() - self.load.time(0);
        let natural = (stiffness / self.mass).sqrt();
        self.left.set(self.left.get() - drive.samples().len() as f64 - length * natural / PI);
        if self.left.get() <= 0.0 || natural > self.fastest() {
            return None;
        }
        let body = Body::new(self.mass, friction).ok()?.with_stiffness(stiffness).ok()?;
        let body = body.with_damping_ratio(zeta).ok()?.with_mean_force(stiffness * offset).ok()?;
        let motion = body.motion(drive, x, v, length).ok()?;
        let mut states = motion.states.iter().peekable();
        let (mut found, mut last) = (Vec::new(), (self.load.time(0), x));
        for index in 0..self.load.samples().len() {
            let time = self.load.time(index);
            while let Some(state) = states.next_if(|state| state.time <= time) {
                last = (state.time, state.displacement);
            }
            found.push(if last.0 < time && time >= self.load.end() {
                motion.answer.end_displacement
            } else {
                last.1
            });
        }
        Some(found)
    }

    /// The slope of the first samples.
    fn rough_velocity(&self, displacements: &[f64]) -> f64 {
        let count = (displacements.len() / 50).clamp(3, 10);
        let places: Vec<_> = (0..count).map(|i| self.load.time(i)).zip(displacements).collect();
        let n = places.len() as f64;
        let (t, x) = places.iter().fold((0.0, 0.0), |(t, x), (a, b)| (t + a / n, x + **b / n));
        let (over, under) = places.iter().fold((0.0, 0.0), |(over, under), (a, b)| {
            (over + (a - t) * (**b - x), under + (a - t) * (a - t))
        });
        if under > 0.0 { over / under } else { 0.0 }
    }
}

#[cfg(test)]
mod tests;
