//! The greatest amplitude of a body with one friction over a band of frequencies.

use super::{Aim, LOG_STEPS, SEARCH_STEPS, by_place, geometric, infinite};
use crate::float::Float;
use crate::greatest::highest;
use crate::machine::error::{Error, Quantity, written};
use crate::machine::oscillator::{Drive, Oscillator, Scales};
use crate::machine::ratios::{Ratios, positive};
use crate::motion::{Amplitude, Trust};
use alloc::vec;
use alloc::vec::Vec;
use core::cell::{Cell, RefCell};
use core::cmp::Ordering;
use core::ops::ControlFlow;

/// The steps for which an amplitude in closed form counts.
const STEPS_OF_A_FORMULA: u64 = 2;
/// The binary logarithm of the number of frequencies that check an answer.
const LOG_CHECKS: u32 = 10;
/// The frequencies that are added at once to the mesh.
const MISSED: usize = 16;
/// The last frequencies of a greatest amplitude, which are tried before others.
const WORST: usize = 8;

/// A body under a drive over a band.
pub(super) struct Band<'a, F> {
    body: &'a Oscillator<F>,
    drive: &'a Drive<F>,
    aim: Aim,
    /// The mesh of angular frequencies.
    mesh: Vec<F>,
    /// The steps that are left.
    steps: Cell<u64>,
    /// The frequencies at which the last frictions were worst, the latest last.
    worst: RefCell<Vec<F>>,
    /// Frequencies near which the cycle in closed form is not always the motion from rest.
    doubtful: Vec<F>,
    /// Whether that is so everywhere.
    doubts_all: bool,
}

impl<'a, F: Float> Band<'a, F> {
    pub(super) fn new(
        body: &'a Oscillator<F>,
        drive: &'a Drive<F>,
        low: F,
        high: F,
        aim: Aim,
    ) -> Result<Self, Error> {
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
        let mut mesh = geometric(low, high, LOG_STEPS);
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
        Ok(Self {
            body,
            drive,
            aim,
            mesh,
            steps: Cell::new(SEARCH_STEPS),
            worst: RefCell::default(),
            doubtful: Vec::new(),
            doubts_all: false,
        })
    }

    /// The friction that holds the body at rest in the whole band, to the last digit.
    pub(super) fn rest(&self) -> Result<F, Error> {
        let ends: Vec<F> = [self.mesh.first(), self.mesh.last()].into_iter().flatten().copied().collect();
        let mut most = F::int(0);
        for &omega in &ends {
            most = most.or_larger(self.drive.at(omega)?.force_amplitude(self.body));
        }
        let mut rest = positive(Quantity::FrictionBound, most / self.body.static_friction_ratio())?;
        for _ in 0..8 {
            let mut is_held = true;
            for &omega in &ends {
                is_held &= !self.drive.at(omega)?.ratios(&self.with(rest)?)?.moves_from_rest();
            }
            if is_held {
                break;
            }
            rest = rest * (F::int(1) + F::epsilon());
        }
        Ok(rest)
    }

    /// The body with a friction.
    fn with(&self, friction: F) -> Result<Oscillator<F>, Error> {
        let own = self.body;
        Oscillator::new(own.mass(), own.stiffness(), friction)?
            .with_damping(own.damping())?
            .with_static_friction_ratio(own.static_friction_ratio())
    }

    /// Whether the motion of a friction and a frequency need not be near that of their neighbours.
    pub(super) fn is_rough(&self) -> bool {
        self.body.static_friction_ratio() > F::int(1)
    }

    /// Counts steps.
    fn spend(&self, steps: u64) -> ControlFlow<()> {
        self.steps.set(self.steps.get().saturating_sub(steps));
        if self.steps.get() == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    /// Sets the steps that are left, and gives those that were.
    pub(super) fn allow(&self, steps: u64) -> u64 {
        self.steps.replace(steps)
    }

    /// Whether the amplitude is 0 at rest.
    pub(super) fn is_best_at_rest(&self) -> bool {
        match self.aim {
            Aim::Displacement => true,
            Aim::Acceleration => !self.drive.excitation().carries_surface(),
            Aim::TransmittedForce => self.drive.excitation().moves_foot(),
            Aim::AbsoluteDisplacement => false,
        }
    }

    /// The amplitude at one frequency; infinite where the motion is unbounded or does not settle.
    pub(super) fn at(&self, friction: F, omega: F) -> Result<F, Error> {
        self.amplitude(friction, omega, Trust::FarAbove)
    }

    /// The amplitude at one frequency, or one that is above `limit`. With a higher static friction an amplitude below the
    /// limit may be that of the cycle in closed form where the motion from rest has another limit.
    fn near(&self, friction: F, omega: F, limit: F) -> Result<F, Error> {
        let is_doubtful = |other: &F| (*other - omega).abs() < omega * F::exp2i(-6);
        if limit.is_finite() && self.is_rough() && !self.doubts_all && !self.doubtful.iter().any(is_doubtful)
        {
            let value = self.amplitude(friction, omega, Trust::AboveRelease)?;
            if value <= limit {
                return Ok(value);
            }
        }
        self.at(friction, omega)
    }

    /// Follows the motion from rest wherever it can differ from the cycle in closed form.
    pub(super) fn doubt_all(&mut self) {
        self.doubts_all = true;
    }

    fn amplitude(&self, friction: F, omega: F, trust: Trust) -> Result<F, Error> {
        let body = self.with(friction)?;
        let drive = self.drive.at(omega)?;
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
        // Without a higher static friction a force barely above the one that releases the body moves it by as little, and
        // settles as slowly: its amplitude is that of a body at rest but for 2⁻³³.
        let (eta, zeta) = (ratios.static_friction_ratio(), ratios.damping_ratio());
        let barely = if self.is_rough() { F::epsilon() * F::int(16) } else { F::exp2i(-33) };
        let is_barely_released = ratios.moves_from_rest() && ratios.alpha() <= eta * (one + barely);
        let ratios =
            if is_barely_released { Ratios::of_valid(ratios.omega(), eta, zeta, eta) } else { ratios };
        let is_over = || Error::BandTooCostly { steps: SEARCH_STEPS };
        if self.spend(STEPS_OF_A_FORMULA).is_break() {
            return Err(is_over());
        }
        let found =
            match amplitude.reached_from_rest(ratios, drive.excitation(), trust, &mut || self.spend(1)) {
                Err(Error::NotSettled { .. }) => return Ok(infinite()),
                Err(Error::Interrupted) => return Err(is_over()),
                found => found?,
            };
        let unit = amplitude.unit(&Scales::new(&body, &drive)?) / mass;
        Ok(found.value.map_or(infinite(), |value| value * unit))
    }

    /// The greatest amplitude, or one that is above `limit`.
    pub(super) fn value(&self, friction: F, limit: F) -> Result<F, Error> {
        Ok(self.crest(friction, limit)?.0)
    }

    /// The greatest amplitude, and the frequencies that have it to a relative 10⁻⁶, as ranges.
    pub(super) fn greatest(&self, friction: F) -> Result<(F, Vec<(F, F)>), Error> {
        let (most, values) = self.crest(friction, infinite())?;
        let nearly = most * (F::int(1) - F::ratio(1, 1_000_000));
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

    /// The greatest amplitude with the amplitudes of all frequencies looked at; or an amplitude above `limit` or an
    /// infinite one, with none.
    fn crest(&self, friction: F, limit: F) -> Result<(F, Vec<(F, F)>), Error> {
        let is_beyond = |value: F| value > limit || !value.is_finite();
        let suspects: Vec<F> = self.worst.borrow().iter().rev().copied().collect();
        for omega in suspects {
            let value = self.near(friction, omega, limit)?;
            if is_beyond(value) {
                self.remember(omega);
                return Ok((value, Vec::new()));
            }
        }
        let mut values = Vec::with_capacity(self.mesh.len());
        for &omega in &self.mesh {
            let value = self.near(friction, omega, limit)?;
            if is_beyond(value) {
                self.remember(omega);
                return Ok((value, Vec::new()));
            }
            values.push((omega, value));
        }
        if self.is_rough() {
            for omega in self.releases(friction)? {
                values.push((omega, self.near(friction, omega, limit)?));
            }
            values.sort_by(by_place);
        }
        let mut most = values.iter().fold(F::int(0), |most, place| most.or_larger(place.1));
        let mut peaks = Vec::new();
        for (i, &(omega, value)) in values.iter().enumerate() {
            let Some((from, to)) = beside_maximum(&values, i) else { continue };
            if value * F::int(2) < most {
                continue;
            }
            let share = F::epsilon() * F::exp2i(if self.is_rough() { 28 } else { 20 });
            let at = highest(from, to, share, |omega| self.near(friction, omega, limit))?;
            let found = (at, self.near(friction, at, limit)?);
            if found.1 > value {
                most = most.or_larger(found.1);
                peaks.push(found);
            }
            if is_beyond(found.1) {
                self.remember(omega);
                return Ok((found.1, Vec::new()));
            }
        }
        values.extend(peaks);
        values.sort_by(by_place);
        if let Some(worst) = values.iter().find(|place| place.1 >= most) {
            self.remember(worst.0);
        }
        Ok((most, values))
    }

    /// Remembers the frequency at which a friction is worst.
    fn remember(&self, omega: F) {
        let mut worst = self.worst.borrow_mut();
        worst.retain(|&other| (other - omega).abs() > omega * F::exp2i(-10));
        if worst.len() >= WORST {
            worst.remove(0);
        }
        worst.push(omega);
    }

    /// The frequencies between two neighbours of the mesh from which the body is released, just on the side of the motion.
    fn releases(&self, friction: F) -> Result<Vec<F>, Error> {
        let body = self.with(friction)?;
        let is_released = |omega| Ok::<_, Error>(self.drive.at(omega)?.ratios(&body)?.moves_from_rest());
        let mut found = Vec::new();
        for (&low, &high) in self.mesh.iter().zip(self.mesh.iter().skip(1)) {
            let is_low = is_released(low)?;
            if is_low != is_released(high)? {
                let (mut moving, mut resting) = if is_low { (low, high) } else { (high, low) };
                for _ in 0..40 {
                    let middle = moving + (resting - moving) / F::int(2);
                    if is_released(middle)? { moving = middle } else { resting = middle }
                }
                found.push(moving);
            }
        }
        Ok(found)
    }

    /// The frequencies of both meshes, the finer one, too, at which the amplitude is above `greatest`: local maxima, the
    /// worst first.
    pub(super) fn missed(&self, friction: F, greatest: F) -> Result<Vec<(F, F)>, Error> {
        let ends = self.mesh.first().zip(self.mesh.last());
        let Some((&low, &high)) = ends else { return Ok(Vec::new()) };
        let mut values = Vec::new();
        for omega in geometric(low, high, LOG_CHECKS).into_iter().chain(self.mesh.iter().copied()) {
            values.push((omega, self.at(friction, omega)?));
        }
        values.sort_by(by_place);
        let enough = greatest * (F::int(1) + F::exp2i(-33));
        let mut missed = Vec::new();
        for (i, &(omega, value)) in values.iter().enumerate() {
            // What is not above the other mesh may still be so between its frequencies.
            let beside = beside_maximum(&values, i).filter(|_| value * F::ratio(33, 32) >= greatest);
            let found = match beside {
                Some((from, to)) => {
                    let at =
                        highest(from, to, F::epsilon() * F::exp2i(28), |omega| self.at(friction, omega))?;
                    (at, self.at(friction, at)?)
                }
                None => (omega, value),
            };
            let most = if found.1 > value { found } else { (omega, value) };
            if most.1 > enough {
                missed.push(most);
            }
        }
        missed.sort_by(|a, b| b.1.partial_cmp(&a.1).unwrap_or(Ordering::Equal));
        let mut apart: Vec<(F, F)> = Vec::new();
        for place in missed {
            let is_new = apart.iter().all(|other| (other.0 - place.0).abs() > place.0 * F::exp2i(-8));
            if is_new && apart.len() < MISSED {
                apart.push(place);
            }
        }
        Ok(apart)
    }

    /// Adds frequencies to the mesh.
    pub(super) fn add(&mut self, frequencies: &[(F, F)]) {
        self.mesh.extend(frequencies.iter().map(|place| place.0));
        self.mesh.sort_by(|a, b| a.partial_cmp(b).unwrap_or(Ordering::Equal));
        self.mesh.dedup();
        for &(omega, _) in frequencies.iter().rev() {
            self.remember(omega);
            self.doubtful.push(omega);
        }
    }
}

/// The neighbours of a place whose value is above theirs; none beside a flat piece, which has no maximum inside.
fn beside_maximum<F: Float>(values: &[(F, F)], i: usize) -> Option<(F, F)> {
    let &(omega, value) = values.get(i)?;
    let before = i.checked_sub(1).and_then(|j| values.get(j));
    let after = i.checked_add(1).and_then(|j| values.get(j));
    let below = value * (F::int(1) - F::exp2i(-40));
    let is_maximum = [before, after].into_iter().flatten().all(|place| place.1 < below);
    let place = |found: Option<&(F, F)>| found.map_or(omega, |place| place.0);
    is_maximum.then(|| (place(before), place(after)))
}
