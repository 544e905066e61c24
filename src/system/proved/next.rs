//! The branch at an event, by certain signs alone.
//!
//! The rule is that of `next_branch`: with the forces T of the contacts at rest their accelerations are `a = a₀ − G T`. One that sticks has
//! a = 0 and |T| < R, one that slides has `T = s R` and `s a > 0`. G is positive definite, so that no other choice has even the signs with
//! `≤` and `≥`: a choice whose signs are certain is the only one.

use super::super::mode::{Mode, sign};
use super::branch::pull;
use super::doubt::Doubt;
use super::machine::{Machine, Number, Part, Row, add_times, at, dot, solved};
use crate::float::Field;
use alloc::vec;
use alloc::vec::Vec;

/// A contact at rest, and whether its friction is the kinetic one.
#[derive(Debug, Clone, Copy)]
pub(super) struct AtRest {
    pub(super) element: usize,
    pub(super) is_lowered: bool,
}

/// Decides contacts at rest in a state, and sets their modes: they stick as long as they can.
pub(super) fn decide(
    machine: &Machine,
    z: &[Number],
    contacts: &[AtRest],
    modes: &mut [Mode],
) -> Result<(), Doubt> {
    let mut contacts = contacts.to_vec();
    for _ in 0..=contacts.len() {
        let found = Choice::new(machine, z, &contacts, modes)?.found()?;
        let mut is_lower = false;
        for (contact, way) in contacts.iter_mut().zip(&found) {
            let Some(mode) = modes.get_mut(contact.element) else { continue };
            *mode = way.map_or(Mode::Stuck, |forward| Mode::Slides { forward, piece: 0 });
            let has_peak = machine.parts.get(contact.element).is_some_and(Part::has_peak);
            if way.is_some() && has_peak && !contact.is_lowered {
                contact.is_lowered = true;
                is_lower = true;
            }
        }
        if !is_lower {
            return Ok(());
        }
    }
    Err(Doubt::of(
        contacts.first().map(|c| c.element),
        "the order in which contacts begin to slide is not certain",
    ))
}

/// What some contacts at rest may do.
struct Choice {
    elements: Vec<usize>,
    /// a₀.
    free: Row,
    coupling: Vec<Row>,
    bounds: Row,
}

impl Choice {
    fn new(machine: &Machine, z: &[Number], contacts: &[AtRest], modes: &[Mode]) -> Result<Self, Doubt> {
        let size = machine.size;
        let mut force = machine.force.clone();
        for (i, (part, mode)) in machine.parts.iter().zip(modes).enumerate() {
            if !contacts.iter().any(|c| c.element == i)
                && let Some(row) = part.tension(*mode, size)
            {
                pull(&mut force, &part.direction, &row);
            }
        }
        let force: Row = force.iter().map(|row| dot(row, z)).collect();
        let (mut free, mut bounds) = (Vec::new(), Vec::new());
        for contact in contacts {
            let Some(part) = machine.parts.get(contact.element) else { continue };
            free.push(dot(&part.response, &force) - dot(&part.moves, z));
            let bound = dot(&part.friction(size, !contact.is_lowered), z);
            if !bound.is_positive() {
                return Err(Doubt::of(Some(contact.element), "its friction is not certainly above 0"));
            }
            bounds.push(bound);
        }
        let elements: Vec<usize> = contacts.iter().map(|c| c.element).collect();
        let coupling =
            elements.iter().map(|&i| elements.iter().map(|&j| machine.coupling(i, j)).collect()).collect();
        Ok(Self { elements, free, coupling, bounds })
    }

    /// The direction of each contact that slides.
    fn found(&self) -> Result<Vec<Option<bool>>, Doubt> {
        let mut ways: Vec<Option<bool>> = vec![None; self.elements.len()];
        // The contact with the least place whose midpoints contradict its way takes another one: that ends, as G is positive definite.
        for _ in 0..1 << 12 {
            let (tension, acceleration) = self.forces(&ways).ok_or_else(|| self.doubt(0))?;
            let wrong = ways.iter().enumerate().find_map(|(i, way)| {
                let (force, bound) = (at(&tension, i).mid(), at(&self.bounds, i).mid());
                match way {
                    None if force > bound => Some((i, Some(true))),
                    None if force < -bound => Some((i, Some(false))),
                    None => None,
                    Some(forward) => {
                        let along = Number::exact(sign(*forward)) * at(&acceleration, i);
                        (along.mid() < Number::int(0).mid()).then_some((i, None))
                    }
                }
            });
            if let Some((i, way)) = wrong {
                ways.iter_mut().skip(i).take(1).for_each(|old| *old = way);
                continue;
            }
            for (i, way) in ways.iter().enumerate() {
                let is_certain = match way {
                    None => at(&tension, i).abs().is_below(&at(&self.bounds, i)),
                    Some(forward) => (Number::exact(sign(*forward)) * at(&acceleration, i)).is_positive(),
                };
                if !is_certain {
                    return Err(self.doubt(i));
                }
            }
            return Ok(ways);
        }
        Err(self.doubt(0))
    }

    fn doubt(&self, i: usize) -> Doubt {
        Doubt::of(
            self.elements.get(i).copied(),
            "whether it sticks or slides is not certain: its force is at its bound",
        )
    }

    /// The forces and the accelerations.
    fn forces(&self, ways: &[Option<bool>]) -> Option<(Row, Row)> {
        let mut tension: Row = (ways.iter().enumerate())
            .map(|(i, way)| {
                way.map_or_else(|| Number::int(0), |s| Number::exact(sign(s)) * at(&self.bounds, i))
            })
            .collect();
        let rest = |tension: &Row| -> Row {
            self.free.iter().zip(&self.coupling).map(|(free, row)| *free - dot(row, tension)).collect()
        };
        let stuck: Vec<usize> = (0..ways.len()).filter(|i| ways.get(*i) == Some(&None)).collect();
        let left = rest(&tension);
        let inner: Vec<Row> = stuck
            .iter()
            .filter_map(|&i| self.coupling.get(i))
            .map(|row| stuck.iter().map(|&j| at(row, j)).collect())
            .collect();
        let sides: Vec<Row> = stuck.iter().map(|&i| vec![at(&left, i)]).collect();
        for (&i, held) in stuck.iter().zip(solved(&inner, &sides)?) {
            add_times(tension.get_mut(i..=i)?, Number::int(1), &held);
        }
        let acceleration = rest(&tension);
        Some((tension, acceleration))
    }
}
