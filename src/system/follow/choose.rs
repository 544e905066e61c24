//! The choice of the branch: by the state alone, after the events of an instant, and after blows.

use super::Follower;
use crate::float::Float;
use crate::machine::error::written;
use crate::system::assembly::{Assembly, Part, Rule};
use crate::system::blow::{Strike, place_at_gap, strike};
use crate::system::error::Error;
use crate::system::massless;
use crate::system::matrix::{at, dot, set, size_of_dot};
use crate::system::mode::{Mode, lock, sign, slides};
use crate::system::next_branch::{AtRest, at_rest, decide, follows};
use crate::system::spring;
use crate::system::under::loaded;
use alloc::string::String;
use alloc::vec::Vec;

impl<F: Float> Follower<'_, F> {
    /// Decides what acts on coordinates without mass, and the contacts at rest, and enters the branch: `first` are the modes to
    /// be taken where they are consistent.
    pub(super) fn choose_light(
        &mut self,
        first: &[Vec<Mode>],
        resting: &[usize],
    ) -> Result<Vec<Mode>, Error> {
        let system = self.system;
        let open = massless::open(system, &self.z, first.first().map_or(&[], Vec::as_slice), resting);
        let found = massless::decide(system, &mut self.branches, &self.z, first, &open);
        let (modes, z) = found.map_err(|free| match free {
            Some(coordinate) => system.without_mass(
                coordinate,
                "is held neither by a spring or damper nor by a contact that sticks: give it one of these, or a mass",
            ),
            None => self.undecided(open.first().copied().unwrap_or(0)),
        })?;
        self.z = z;
        self.enter(&modes);
        Ok(modes)
    }

    /// Chooses the branch by the state alone, and enters it.
    pub(super) fn choose(&mut self) -> Result<Vec<Mode>, Error> {
        let (mut modes, mut resting) = self.modes_of_state()?;
        if !self.system.massless.is_empty() {
            let present = self.branch().map(|branch| branch.modes.clone());
            let first: Vec<Vec<Mode>> = present.into_iter().chain([modes]).collect();
            return self.choose_light(&first, &resting);
        }
        self.settle(&mut modes, resting.clone(), &[], true)?;
        self.enter(&modes);
        // A velocity that is zero but for rounding is told by the size that it could have within a step.
        let still: Vec<usize> = (modes.iter().enumerate())
            .filter(|(i, mode)| !resting.contains(i) && self.may_rest(*i, **mode))
            .map(|(i, _)| i)
            .collect();
        if !still.is_empty() {
            resting.extend(still);
            resting.sort_unstable();
            self.settle(&mut modes, resting, &[], true)?;
            self.enter(&modes);
        }
        Ok(modes)
    }

    /// The modes by the state alone, with the contacts at rest; those at coordinates without mass are not decided.
    pub(super) fn modes_of_state(&mut self) -> Result<(Vec<Mode>, Vec<usize>), Error> {
        let mut modes = Vec::with_capacity(self.system.parts.len());
        let mut resting = Vec::new();
        for (i, part) in self.system.parts.iter().enumerate() {
            let v = dot(&part.velocity, &self.z);
            let still = v.abs() <= size_of_dot(&part.velocity, &self.z) * F::epsilon() * F::int(64);
            let is_apart = part.normal().is_some_and(|row| dot(row, &self.z) < F::int(0));
            modes.push(match &part.rule {
                Rule::Hard { depth, .. } => {
                    let deep = dot(depth, &self.z);
                    let doubt = size_of_dot(depth, &self.z) * F::epsilon() * F::int(256);
                    // A body at its stop may be beyond it by the rounding of others, such as at the end of another motion, which may leave
                    // far less than ε of the unit.
                    let displacements = self.z.iter().take(self.system.n);
                    let reach = displacements.fold(F::epsilon(), |most, x| most.or_larger(x.abs()));
                    if deep > doubt.or_larger(reach * F::epsilon()) {
                        return Err(self.beyond(part, deep));
                    }
                    if deep >= -doubt {
                        place_at_gap(self.system, &mut self.z, &[i]);
                        self.blows.arrive(i);
                    }
                    if deep >= -doubt && still {
                        resting.push(i);
                        Mode::Resting
                    } else {
                        Mode::Away
                    }
                }
                Rule::Contact { .. } => {
                    if is_apart {
                        Mode::Apart
                    } else if self.system.is_light(part) {
                        Mode::Stuck
                    } else if still {
                        resting.push(i);
                        Mode::Stuck
                    } else {
                        slides(&part.rule, v)
                    }
                }
                Rule::Elastic { place, bound, .. } => {
                    let force = at(&self.z, *place);
                    let (forward, most) = (force > F::int(0), dot(bound, &self.z));
                    // Within rounding of its friction it is there.
                    let full = most * (F::int(1) - F::epsilon() * F::int(64));
                    let (mode, force) = if is_apart {
                        (Mode::Apart, F::int(0))
                    } else if force.abs() >= full && sign::<F>(forward) * v > F::int(0) {
                        (Mode::Yields { forward }, sign::<F>(forward) * most)
                    } else {
                        (Mode::Holds, force)
                    };
                    set(&mut self.z, *place, force);
                    mode
                }
                Rule::Stop { depth, stiffness, damping } => {
                    let deep = dot(depth, &self.z);
                    let force = *stiffness * deep + *damping * v;
                    if deep <= F::int(0) {
                        Mode::Away
                    } else if force > F::int(0) {
                        Mode::Pressed
                    } else {
                        Mode::Lifted
                    }
                }
                Rule::Spring { pieces } => {
                    spring::mode(pieces, part.stretch.as_deref().map_or(F::int(0), |row| dot(row, &self.z)))
                }
            });
        }
        Ok((modes, resting))
    }

    /// Whether an element in motion may come to rest here: a contact that slides, or a body at a stop that gives no way, without a velocity
    /// above rounding.
    pub(super) fn may_rest(&self, element: usize, mode: Mode) -> bool {
        let is_at = || self.blows.is_at(self.system, &self.z, element);
        (matches!(mode, Mode::Slides { piece: 0, .. }) || (mode == Mode::Away && is_at()))
            && self.is_slow(element)
    }

    pub(super) fn is_slow(&self, element: usize) -> bool {
        self.branch().is_some_and(|branch| branch.is_slow(self.system, element, &self.z))
    }

    /// A body beyond a stop that gives no way.
    fn beyond(&self, part: &Part<F>, deep: F) -> Error {
        let at = if self.time() > F::int(0) {
            alloc::format!(" at time {}", written(self.time()))
        } else {
            String::new()
        };
        Error::Unsupported {
            name: alloc::format!("{}: displacement beyond its gap by {}{at}", part.name, written(deep)),
            condition: "must be ≤ 0 at a stop with a restitution",
        }
    }

    /// The modes of contacts under stops as their stops have it: apart, or by their velocities where they were.
    pub(super) fn follow_stops(&self, modes: &mut [Mode]) {
        for (i, stop) in self.system.under_stops() {
            let touches = modes.get(stop) == Some(&Mode::Resting);
            let (Some(mode), Some(part)) = (modes.get_mut(i), self.system.parts.get(i)) else { continue };
            if !touches {
                *mode = Mode::Apart;
            } else if *mode == Mode::Apart {
                let v = dot(&part.velocity, &self.z);
                let still = v.abs() <= size_of_dot(&part.velocity, &self.z) * F::epsilon() * F::int(64);
                *mode = if still || self.is_slow(i) { Mode::Stuck } else { slides(&part.rule, v) };
            }
        }
    }

    /// Decides the contacts at rest, and takes their velocities out. `released` are those whose force has just reached its
    /// bound, with the direction; `arrives` tells whether one has not been at rest before.
    pub(super) fn settle(
        &mut self,
        modes: &mut [Mode],
        resting: Vec<usize>,
        released: &[(usize, bool)],
        arrives: bool,
    ) -> Result<(), Error> {
        let system = self.system;
        let Some((first, _)) = system.under_stops().next() else {
            return self.decide_at_rest(system, modes, resting, released, arrives);
        };
        // The force of a stop, under which a friction is decided, is that of the branch: which is the one that is decided with it.
        for _ in 0..=system.parts.len() {
            self.follow_stops(modes);
            let before = modes.to_vec();
            let mut resting = resting.clone();
            for (i, _) in system.under_stops() {
                let mode = before.get(i).copied().unwrap_or(Mode::Apart);
                resting.retain(|other| *other != i);
                if mode == Mode::Stuck || self.may_rest(i, mode) {
                    resting.push(i);
                }
            }
            resting.sort_unstable();
            self.decide_at_rest(&loaded(system, &before), modes, resting, released, arrives)?;
            self.follow_stops(modes);
            let other = |i: &usize| system.parts.get(*i).is_some_and(|part| part.under.is_none());
            if (0..modes.len()).filter(other).all(|i| modes.get(i) == before.get(i)) {
                return Ok(());
            }
        }
        Err(self.undecided(first))
    }

    /// Decides the contacts at rest once.
    fn decide_at_rest(
        &mut self,
        system: &Assembly<F>,
        modes: &mut [Mode],
        mut resting: Vec<usize>,
        released: &[(usize, bool)],
        arrives: bool,
    ) -> Result<(), Error> {
        if resting.is_empty() {
            return Ok(());
        }
        if system.is_dependent {
            // What depends on contacts at rest is at rest.
            let slides =
                |i: usize| matches!(modes.get(i), Some(Mode::Slides { .. })) && !resting.contains(&i);
            let more: Vec<usize> =
                (0..modes.len()).filter(|&i| slides(i) && follows(system, i, &resting)).collect();
            resting.extend(more);
            resting.sort_unstable();
        }
        // Velocities that have been taken out stay out.
        if arrives {
            at_rest(system, &mut self.z, &resting);
        }
        let release = |element: usize| released.iter().find(|(i, _)| *i == element).map(|r| r.1);
        let contacts: Vec<AtRest> =
            resting.iter().map(|&element| AtRest { element, released: release(element) }).collect();
        let choices = decide(system, &self.z, &contacts, modes).map_err(|element| self.undecided(element))?;
        for (contact, choice) in contacts.iter().zip(choices) {
            let Some(mode) = modes.get_mut(contact.element) else { continue };
            let is_stop =
                matches!(system.parts.get(contact.element).map(|p| &p.rule), Some(Rule::Hard { .. }));
            *mode = match choice {
                None if is_stop => Mode::Resting,
                None => Mode::Stuck,
                Some(_) if is_stop => Mode::Away,
                Some(forward) => Mode::Slides { forward, piece: 0 },
            };
            if is_stop {
                self.blows.arrive(contact.element);
            }
        }
        Ok(())
    }

    /// The blows at stops that are hit, and the contacts after them: those whose velocity they change slide.
    pub(super) fn strike(&mut self, modes: &mut [Mode], hit: &[usize]) -> Result<Option<Strike<F>>, Error> {
        let system = self.system;
        let Some(branch) = self.branches.current().filter(|_| !hit.is_empty()) else { return Ok(None) };
        let struck = strike(system, branch, &mut self.z, modes, hit, &mut self.blows);
        let struck = struck.map_err(|element| self.undecided(element))?;
        for (i, (part, mode)) in system.parts.iter().zip(modes).enumerate() {
            if matches!(mode, Mode::Stuck | Mode::Slides { .. }) {
                let stays = *mode == Mode::Stuck && struck.keeps(part);
                *mode = if stays || self.is_slow(i) {
                    Mode::Stuck
                } else {
                    slides(&part.rule, dot(&part.velocity, &self.z))
                };
            } else if let (Mode::Yields { forward }, Rule::Elastic { stiffness, bound, .. }) =
                (*mode, &part.rule)
            {
                // Its slider stops or turns with the body, but where the friction falls faster than the spring.
                let velocity = sign::<F>(forward) * dot(&part.velocity, &self.z);
                let rounding = branch.speed_error(i, &part.velocity, &self.z) * F::int(4);
                if *stiffness * (velocity - rounding) <= dot(bound, &branch.derivative(&self.z)) {
                    lock(part, mode, &mut self.z);
                }
            }
        }
        Ok(Some(struck))
    }
}
