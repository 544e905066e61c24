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
//! hold the body, which is refined three times where it is best, and around the best three of its minima by a golden
//! section. A peak of Q that is much narrower than 2⁻¹² of its frequency could be missed away from these places. A
//! friction with which a motion of the band does not settle is no candidate.

use crate::float::Float;
use crate::greatest::highest;
use crate::machine::error::{Error, Quantity, written};
use crate::machine::oscillator::{Drive, Oscillator, Scales};
use crate::machine::ratios::{Ratios, positive};
use crate::motion::Amplitude;
use crate::named::named;
use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;

named! {
    /// The amplitude that is to be small.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "kebab-case"))]
    #[non_exhaustive]
    pub enum Aim [
        /// Its name in the command and in Python.
    ] {
        /// The displacement x; on a base that carries the surface in relation to the base.
        Displacement = "displacement",
        /// The displacement in space, on a base that carries the surface.
        AbsoluteDisplacement = "absolute-displacement",
        /// The force on the support.
        TransmittedForce = "transmitted-force",
        /// The acceleration in space.
        Acceleration = "acceleration",
    }
}

impl Aim {
    /// Every aim.
    pub const ALL: [Self; 4] =
        [Self::Displacement, Self::AbsoluteDisplacement, Self::TransmittedForce, Self::Acceleration];
}

named! {
    /// The kind of a best friction over a band.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize))]
    #[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
    #[non_exhaustive]
    pub enum BandFrictionKind [
        /// Its name in the command and in Python.
    ] {
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
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct BandFriction<F> {
    /// The friction bound r_y, the least of those whose greatest amplitude is within 10⁻¹⁰ of the least.
    pub friction: F,
    /// The greatest amplitude over the band.
    pub greatest: F,
    /// The angular frequencies at which the amplitude is that great, to a relative 10⁻⁶, each as a range of which both
    /// ends are the same where it is a single frequency. Two that balance are the classical compromise; a range is one
    /// where the body moves with its support at the crest.
    pub at: Vec<(F, F)>,
    /// The kind.
    pub kind: BandFrictionKind,
    /// The friction from which on the body rests in the whole band.
    pub rest: F,
}

/// The friction with which the greatest amplitude `aim` of the body over the angular frequencies `[low, high]` is
/// least.
///
/// Mass, spring, damper and the ratio of static friction are those of `body`; its own friction plays no part. The
/// amplitude of the drive is the same at every frequency, its frequency is not used. Where the motion depends on its
/// start, the amplitude is that of [`Amplitude::of`].
///
/// Unit of force; the greatest amplitude in a unit of length, force or acceleration, accurate to a relative 10⁻⁹. The
/// friction has a relative error of some 10⁻¹⁰ where two frequencies balance, and of 10⁻⁵ at a smooth minimum. The
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
///     best_friction_over_band(&body, &drive, natural / 2.0, natural * 4.0, Aim::AbsoluteDisplacement)?;
/// assert_eq!(best.kind, BandFrictionKind::Interior);
/// assert!(best.greatest > 0.05 && best.at.len() >= 2);
/// # Ok::<(), stickslip::Error>(())
/// ```
///
/// # Errors
/// Where `low ≥ high`, a ratio of the band is outside the domain of [`crate::Ratios`], or
/// [`Aim::AbsoluteDisplacement`] is asked of a surface at rest; and those of [`Amplitude::of`] but
/// [`Error::NotSettled`].
pub fn best_friction_over_band<F: Float>(
    body: &Oscillator<F>,
    drive: &Drive<F>,
    low: F,
    high: F,
    aim: Aim,
) -> Result<BandFriction<F>, Error> {
    let band = Band::new(body, drive, low, high, aim)?;
    let rest = band.rest()?;
    if band.is_best_at_rest() {
        return Ok(BandFriction {
            friction: rest,
            greatest: F::int(0),
            at: Vec::new(),
            kind: BandFrictionKind::Rest,
            rest,
        });
    }
    let least = rest * F::exp2i(-LOG_RANGE);
    let mut tried = Vec::new();
    for friction in geometric(least, rest) {
        tried.push((friction, band.greatest(friction)?.0));
    }
    // Where the body moves with its support the amplitude hardly depends on the friction, and less of it may be a little
    // better still: the mesh is refined around the least friction that is as good as any.
    for _ in 0..REFINEMENTS {
        let (from, to) = around(&tried);
        let inner = geometric(from, to);
        for friction in inner.into_iter().step_by(4) {
            tried.push((friction, band.greatest(friction)?.0));
        }
        tried.sort_by(by_place);
        tried.dedup_by(|a, b| a.0 == b.0);
    }
    for place in minima(&tried) {
        let at = |j: usize| tried.get(j).map_or(rest, |place| place.0);
        let (from, to) = (at(place.saturating_sub(1)), at(place.saturating_add(1)));
        let friction = highest(from, to, F::epsilon() * F::int(1 << 18), |friction| {
            band.greatest(friction).map(|(value, _)| -value)
        })?;
        tried.push((friction, band.greatest(friction)?.0));
    }
    tried.sort_by(by_place);
    let (enough, first) = as_good_as_any(&tried);
    let at = |j: usize| tried.get(j).map_or(rest, |place| place.0);
    let (mut outside, mut inside) = (at(first.saturating_sub(1)), at(first));
    while inside - outside > inside * F::exp2i(-36) {
        let middle = outside + (inside - outside) / F::int(2);
        if band.greatest(middle)?.0 > enough { outside = middle } else { inside = middle }
    }
    let best = inside;
    let (greatest, at) = band.greatest(best)?;
    let kind = if best <= least * F::ratio(33, 32) {
        BandFrictionKind::None
    } else if best >= rest {
        BandFrictionKind::Rest
    } else {
        BandFrictionKind::Interior
    };
    Ok(BandFriction { friction: best, greatest, at, kind, rest })
}

/// The order of frictions, or of frequencies, with their values.
fn by_place<F: Float>(a: &(F, F), b: &(F, F)) -> Ordering {
    a.0.partial_cmp(&b.0).unwrap_or(Ordering::Equal)
}

/// The least greatest amplitude but for 2⁻³³, and the first friction that is as good.
fn as_good_as_any<F: Float>(tried: &[(F, F)]) -> (F, usize) {
    let infinite = F::int(1) / F::int(0);
    let least = tried.iter().fold(infinite, |least, place| if place.1 < least { place.1 } else { least });
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
fn minima<F: Float>(tried: &[(F, F)]) -> Vec<usize> {
    let value = |i: Option<usize>| i.and_then(|i| tried.get(i)).map(|place| place.1);
    let mut found: Vec<usize> = (0..tried.len())
        .filter(|&i| {
            let (before, here, after) = (value(i.checked_sub(1)), value(Some(i)), value(i.checked_add(1)));
            here.is_some_and(|here| before.is_none_or(|b| here <= b) && after.is_none_or(|a| here <= a))
        })
        .collect();
    found.sort_by(|&a, &b| value(Some(a)).partial_cmp(&value(Some(b))).unwrap_or(Ordering::Equal));
    found.truncate(MINIMA);
    found
}

/// The binary logarithm of the range of frictions: 10⁶.
const LOG_RANGE: i32 = 20;
/// Refinements of the mesh of frictions.
const REFINEMENTS: usize = 3;
/// Minima of the mesh around which a golden section searches.
const MINIMA: usize = 3;
/// The binary logarithm of the number of steps of a mesh.
const LOG_STEPS: u32 = 6;

/// 2⁶ steps of one ratio from `low` to `high`.
fn geometric<F: Float>(low: F, high: F) -> Vec<F> {
    let mut ratio = high / low;
    for _ in 0..LOG_STEPS {
        ratio = ratio.sqrt();
    }
    let mut place = low;
    let mut places = Vec::new();
    for _ in 0..1u32 << LOG_STEPS {
        places.push(place);
        place = place * ratio;
    }
    places.push(high);
    places
}

/// A body under a drive over a band.
struct Band<'a, F> {
    body: &'a Oscillator<F>,
    drive: &'a Drive<F>,
    aim: Aim,
    /// The mesh of angular frequencies.
    mesh: Vec<F>,
}

impl<'a, F: Float> Band<'a, F> {
    fn new(body: &'a Oscillator<F>, drive: &'a Drive<F>, low: F, high: F, aim: Aim) -> Result<Self, Error> {
        let low = positive(Quantity::AngularFrequency, low)?;
        let high = positive(Quantity::AngularFrequency, high)?;
        if low >= high {
            let quantity = Quantity::AngularFrequency;
            return Err(Error::EmptyRange { quantity, low: written(low), high: written(high) });
        }
        if aim == Aim::AbsoluteDisplacement && !drive.excitation().carries_surface() {
            return Err(Error::SurfaceAtRest { drive: drive.excitation().name() });
        }
        let natural = body.natural_frequency();
        let mut mesh = geometric(low, high);
        let zeta = body.damping_ratio();
        let shift = F::int(1) - F::int(2) * zeta.square();
        let damped = if shift > F::int(0) { vec![natural * shift.sqrt()] } else { Vec::new() };
        for centre in damped.into_iter().chain([1, 3, 5, 7].map(|n| natural / F::int(n))) {
            mesh.push(centre);
            for k in -12..=-2 {
                let off = centre * F::exp2i(k);
                mesh.extend([centre - off, centre + off]);
            }
        }
        mesh.retain(|&omega| omega >= low && omega <= high);
        mesh.sort_by(|a, b| a.partial_cmp(b).unwrap_or(Ordering::Equal));
        mesh.dedup();
        Ok(Self { body, drive, aim, mesh })
    }

    /// The friction that holds the body at rest in the whole band.
    fn rest(&self) -> Result<F, Error> {
        let mut most = F::int(0);
        for &omega in [self.mesh.first(), self.mesh.last()].into_iter().flatten() {
            most = most.or_larger(self.drive.at_frequency(omega)?.force_amplitude(self.body));
        }
        positive(Quantity::FrictionBound, most / self.body.static_friction_ratio())
    }

    /// Whether the amplitude is 0 at rest.
    fn is_best_at_rest(&self) -> bool {
        match self.aim {
            Aim::Displacement => true,
            Aim::Acceleration => !self.drive.excitation().carries_surface(),
            Aim::TransmittedForce => self.drive.excitation().moves_foot(),
            Aim::AbsoluteDisplacement => false,
        }
    }

    /// The amplitude at one frequency; infinite where the motion is unbounded or does not settle.
    fn at(&self, friction: F, omega: F) -> Result<F, Error> {
        let own = self.body;
        let body = Oscillator::new(own.mass(), own.stiffness(), friction)?
            .with_damping(own.damping())?
            .with_static_friction_ratio(own.static_friction_ratio())?;
        let drive = self.drive.at_frequency(omega)?;
        let one = F::int(1);
        let (amplitude, mass) = match self.aim {
            Aim::Displacement => (Amplitude::Displacement, one),
            Aim::AbsoluteDisplacement => (Amplitude::AbsoluteDisplacement, one),
            Aim::TransmittedForce => (Amplitude::TransmittedForce, one),
            // Nothing else acts on a body over a moving surface.
            Aim::Acceleration if drive.excitation().carries_surface() => {
                (Amplitude::TransmittedForce, body.mass())
            }
            Aim::Acceleration => (Amplitude::Acceleration, one),
        };
        let ratios = drive.ratios(&body)?;
        // A force barely above the one that releases the body moves it by as little, and settles as slowly: its
        // amplitude is that of a body at rest but for 2⁻³³.
        let (eta, zeta) = (ratios.static_friction_ratio(), ratios.damping_ratio());
        let is_barely_released =
            ratios.moves_from_rest() && ratios.alpha() <= eta * (F::int(1) + F::exp2i(-33));
        let ratios =
            if is_barely_released { Ratios::of_valid(ratios.omega(), eta, zeta, eta) } else { ratios };
        let found = match amplitude.of(ratios, drive.excitation()) {
            Err(Error::NotSettled { .. }) => return Ok(F::int(1) / F::int(0)),
            found => found?,
        };
        let unit = amplitude.unit(&Scales::new(&body, &drive)?) / mass;
        Ok(found.value.map_or(F::int(1) / F::int(0), |value| value * unit))
    }

    /// The greatest amplitude, and the frequencies that have it to a relative 10⁻⁶, as ranges.
    fn greatest(&self, friction: F) -> Result<(F, Vec<(F, F)>), Error> {
        let mut values = Vec::with_capacity(self.mesh.len());
        for &omega in &self.mesh {
            values.push((omega, self.at(friction, omega)?));
        }
        let most = values.iter().fold(F::int(0), |most, place| most.or_larger(place.1));
        if !most.is_finite() {
            return Ok((most, Vec::new()));
        }
        // Maxima between places, where the neighbours of a place are not above it.
        let mut peaks = Vec::new();
        for (i, &(omega, value)) in values.iter().enumerate() {
            let beside = |j: Option<usize>| j.and_then(|j| values.get(j)).copied();
            let (before, after) = (beside(i.checked_sub(1)), beside(i.checked_add(1)));
            let mut neighbours = [before, after].into_iter().flatten();
            // A flat piece has no maximum inside.
            let is_flat = neighbours.clone().any(|place| place.1 >= value * (F::int(1) - F::exp2i(-40)));
            if is_flat || !neighbours.all(|place| place.1 < value) || value * F::int(2) < most {
                continue;
            }
            let place = |found: Option<(F, F)>| found.map_or(omega, |place| place.0);
            let at = highest(place(before), place(after), F::epsilon() * F::int(1 << 20), |omega| {
                self.at(friction, omega)
            })?;
            let found = (at, self.at(friction, at)?);
            if found.1 > value {
                peaks.push(found);
            }
        }
        let most = peaks.iter().fold(most, |most, place| most.or_larger(place.1));
        let nearly = most * (F::int(1) - F::ratio(1, 1_000_000));
        values.extend(peaks);
        values.sort_by(by_place);
        let mut at: Vec<(F, F)> = Vec::new();
        let mut is_run = false;
        for (omega, value) in values {
            let is_there = value >= nearly;
            match at.last_mut() {
                Some(last) if is_there && is_run => last.1 = omega,
                _ if is_there => at.push((omega, omega)),
                _ => {}
            }
            is_run = is_there;
        }
        // Two places beside one maximum are one frequency.
        for range in &mut at {
            if range.1 - range.0 <= range.1 * F::ratio(1, 1000) {
                range.1 = range.0;
            }
        }
        Ok((most, at))
    }
}

#[cfg(test)]
mod tests {
    use super::{Aim, Band, BandFrictionKind, best_friction_over_band};
    use crate::machine::error::Error;
    use crate::{Drive, Excitation, Oscillator};

    /// A body of 2 kg with ω_n = 3.
    fn body(zeta: f64, eta: f64) -> Oscillator<f64> {
        let body = Oscillator::new(2.0, 18.0, 1.0).unwrap().with_damping_ratio(zeta).unwrap();
        body.with_static_friction_ratio(eta).unwrap()
    }

    /// The greatest amplitude by a dense mesh of its own, with the neighbourhood of its greatest places once more.
    fn dense(band: &Band<'_, f64>, friction: f64, low: f64, high: f64) -> f64 {
        let at = |omega: f64| band.at(friction, omega).unwrap();
        let place = |i: u32, n: u32, low: f64, high: f64| low + (high - low) * f64::from(i) / f64::from(n);
        let mut places: Vec<(f64, f64)> =
            (0..=500).map(|i| place(i, 500, low, high)).map(|w| (w, at(w))).collect();
        places.sort_by(|a, b| b.1.total_cmp(&a.1));
        let mut apart: Vec<(f64, f64)> = Vec::new();
        for place in places {
            if apart.len() < 3 && apart.iter().all(|other| (other.0 - place.0).abs() > 0.02 * high) {
                apart.push(place);
            }
        }
        for most in &mut apart {
            for step in [3e-3, 1e-4, 5e-6, 2e-7] {
                let (from, to) = ((most.0 - step * high).max(low), (most.0 + step * high).min(high));
                for omega in (0..=50).map(|i| place(i, 50, from, to)) {
                    if at(omega) > most.1 {
                        *most = (omega, at(omega));
                    }
                }
            }
        }
        apart.into_iter().map(|most| most.1).fold(0.0, f64::max)
    }

    /// No friction of a mesh of its own is better by more than 10⁻⁹.
    #[test]
    fn no_other_friction_is_better() {
        let cases = [
            (Excitation::SurfaceMotion, Aim::AbsoluteDisplacement, 0.5, 4.0),
            (Excitation::SurfaceMotion, Aim::TransmittedForce, 0.3, 2.0),
            (Excitation::SurfaceAcceleration, Aim::Acceleration, 0.8, 3.0),
            (Excitation::SurfaceVelocity, Aim::AbsoluteDisplacement, 0.4, 5.0),
            (Excitation::Unbalance, Aim::TransmittedForce, 0.7, 6.0),
            (Excitation::Force, Aim::TransmittedForce, 0.6, 1.8),
        ];
        for (i, (excitation, aim, low, high)) in cases.into_iter().enumerate() {
            for zeta in if i % 2 == 0 { [0.07] } else { [0.0] } {
                let (body, drive) = (body(zeta, 1.0), Drive::new(excitation, 0.7, 1.0).unwrap());
                let (low, high) = (3.0 * low, 3.0 * high);
                let best = best_friction_over_band(&body, &drive, low, high, aim).unwrap();
                let band = Band::new(&body, &drive, low, high, aim).unwrap();
                let own = dense(&band, best.friction, low, high);
                assert!(own <= best.greatest * (1.0 + 1e-9), "{i} {zeta}: {own} {best:?}");
                let spread = (0..16).map(|k| best.rest * 0.4f64.powi(k));
                let near = (-4..=4).map(|k| best.friction * (1.0 + 3e-3 * f64::from(k)));
                for friction in spread.chain(near).filter(|&friction| friction <= best.rest) {
                    let other = dense(&band, friction, low, high);
                    assert!(other >= best.greatest * (1.0 - 1e-9), "{i} {zeta}: {friction} {other} {best:?}");
                }
            }
        }
    }

    /// The classical isolator: where the body moves with its base at the crest, and the peak beyond, balance.
    #[test]
    fn two_frequencies_balance() {
        let drive = Drive::new(Excitation::SurfaceMotion, 0.05, 1.0).unwrap();
        let body = body(0.0, 1.0);
        let best = best_friction_over_band(&body, &drive, 1.5, 12.0, Aim::AbsoluteDisplacement).unwrap();
        assert_eq!((best.kind, best.at.len()), (BandFrictionKind::Interior, 2));
        assert!((best.greatest / 0.05 - 1.0).abs() < 1e-9, "{best:?}");
        assert!(best.at[0].0 == 1.5 && best.at[0].1 > 3.0 && best.at[1].0 == best.at[1].1, "{best:?}");
        let band = Band::new(&body, &drive, 1.5, 12.0, Aim::AbsoluteDisplacement).unwrap();
        assert!(band.greatest(best.friction * 0.999).unwrap().0 > 0.05 * 1.000_1);
    }

    #[test]
    fn a_displacement_is_least_at_rest() {
        let drive = Drive::force(7.0, 1.0).unwrap();
        for aim in [Aim::Displacement, Aim::Acceleration] {
            let best = best_friction_over_band(&body(0.1, 1.4), &drive, 1.0, 2.0, aim).unwrap();
            assert_eq!((best.kind, best.greatest), (BandFrictionKind::Rest, 0.0));
            assert!((best.friction - 5.0).abs() < 1e-14);
        }
        let best = best_friction_over_band(&body(0.0, 1.0), &drive, 6.0, 9.0, Aim::TransmittedForce).unwrap();
        assert_eq!(best.kind, BandFrictionKind::None);
    }

    #[test]
    fn wrong_bands_are_refused() {
        let (body, drive) = (body(0.0, 1.0), Drive::force(7.0, 1.0).unwrap());
        let of = |low, high, aim| best_friction_over_band(&body, &drive, low, high, aim);
        assert!(matches!(of(2.0, 2.0, Aim::Displacement), Err(Error::EmptyRange { .. })));
        assert!(matches!(of(-1.0, 2.0, Aim::Displacement), Err(Error::NotPositive { .. })));
        assert!(of(1.0, f64::NAN, Aim::Displacement).is_err());
        assert!(matches!(of(1.0, 2.0, Aim::AbsoluteDisplacement), Err(Error::SurfaceAtRest { .. })));
    }
}
