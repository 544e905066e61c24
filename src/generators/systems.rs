//! Systems of one to six bodies with one to five elements of all kinds, under constants, harmonics and records. Half of them have
//! round numbers, so that things happen at the same instant, and two elements in three have the direction of an
//! earlier one, or a sum of two. One system in five has a body without mass, with elements that it may carry.

use super::ordinary;
use crate::system::{Beyond, Element, Harmonic, Kind, Law, Model, Normal, Record, Signal, State, System};
use alloc::vec;
use alloc::vec::Vec;
use arbitrary::{Arbitrary, Result, Unstructured};

/// A system, a start, and a time to follow it.
#[derive(Debug, Clone, PartialEq)]
pub struct Structure {
    /// The system.
    pub model: Model<f64>,
    /// The start.
    pub start: State<f64>,
    /// The end of the motion.
    pub until: f64,
}

/// Draws numbers, round ones or not.
struct Numbers<'u, 'a> {
    u: &'u mut Unstructured<'a>,
    is_round: bool,
}

impl Numbers<'_, '_> {
    fn within(&mut self, low: f64, high: f64) -> Result<f64> {
        if self.is_round {
            let quarter = ((high - low) / 4.0).log2().ceil().exp2();
            let part = self.u.int_in_range(0..=4_u8)?;
            Ok((low + quarter * f64::from(part)).min(high))
        } else {
            ordinary(self.u, low, high)
        }
    }

    fn list(&mut self, count: usize, low: f64, high: f64) -> Result<Vec<f64>> {
        (0..count).map(|_| self.within(low, high)).collect()
    }

    /// One in `count`.
    fn one_in(&mut self, count: u8) -> Result<bool> {
        Ok(self.u.int_in_range(1..=count)? == 1)
    }

    /// A direction: from one body to another or to the ground, any, or one of combinations of those before.
    fn direction(&mut self, n: usize, before: &[Element<f64>]) -> Result<Vec<f64>> {
        let last = before.len().saturating_sub(1);
        let one = |i: usize| before.get(i).map(|e| e.direction.clone()).unwrap_or_default();
        let kind = self.u.int_in_range(0..=8_u8)?;
        let mut direction = match kind {
            0..=1 if !before.is_empty() => one(self.u.int_in_range(0..=last)?),
            2 if !before.is_empty() => {
                let (a, b) = (one(self.u.int_in_range(0..=last)?), one(self.u.int_in_range(0..=last)?));
                let sign = if self.one_in(2)? { 1.0 } else { -1.0 };
                a.iter().zip(&b).map(|(a, b)| a + sign * b).collect()
            }
            3 => self.list(n, -1.0, 1.0)?,
            _ => {
                let mut direction = vec![0.0; n];
                let from = self.u.int_in_range(0..=n.saturating_sub(1))?;
                let to = self.u.int_in_range(0..=n)?;
                for (place, sign) in [(from, 1.0), (to, -1.0)] {
                    if let Some(b) = direction.get_mut(place) {
                        *b += sign;
                    }
                }
                direction
            }
        };
        if direction.iter().all(|&b| b == 0.0)
            && let Some(first) = direction.first_mut()
        {
            *first = 1.0;
        }
        Ok(direction)
    }

    fn signal(&mut self, constant: f64, waves: usize, size: f64) -> Result<Signal<f64>> {
        let count = self.u.int_in_range(0..=waves)?;
        Ok(Signal {
            sin: self.list(count, -size, size)?,
            cos: self.list(count, -size, size)?,
            ..Signal::constant(constant)
        })
    }

    fn element(&mut self, n: usize, waves: usize, before: &[Element<f64>]) -> Result<Element<f64>> {
        let direction = self.direction(n, before)?;
        let friction = if self.one_in(12)? { 0.0 } else { self.within(0.125, 1.0)? };
        let peak = if self.one_in(2)? { 1.0 } else { self.within(1.0, 2.0)? };
        let mut moves = Signal::constant(0.0);
        let kind = match self.u.int_in_range(0..=10_u8)? {
            0 => {
                Kind::Elastic { stiffness: self.within(1.0, 60.0)?, friction: friction + 0.125, normal: None }
            }
            1 => {
                moves = self.signal(0.0, waves, 0.2)?;
                let gap = self.within(-0.125, 1.0)?;
                Kind::Stop { gap, stiffness: self.within(4.0, 60.0)?, damping: self.within(0.0, 0.5)? }
            }
            2 => {
                moves.constant = self.within(-0.5, 0.5)?;
                let (middle, end) = (self.within(0.0, 1.0)?, self.within(0.0, 1.0)?);
                let law = Law { points: vec![(0.0, friction), (0.25, middle), (0.75, end)] };
                Kind::Contact { law, peak, normal: None }
            }
            3 => {
                let signal = self.signal(1.0, waves, 0.75)?;
                let displacement = if self.one_in(2)? { Vec::new() } else { self.list(n, -0.25, 0.25)? };
                let normal = Some(Normal { signal, displacement, velocity: Vec::new() });
                Kind::Contact { law: Law::constant(friction), peak, normal }
            }
            4 => {
                let constant = self.within(-0.5, 0.5)?;
                moves = self.signal(constant, waves, 0.5)?;
                Kind::Contact { law: Law::constant(friction), peak, normal: None }
            }
            5 => {
                moves = self.signal(0.0, waves, 0.2)?;
                let gap = self.within(-0.125, 0.75)?;
                // Restitutions of 0 and 1, too.
                let restitution = self.within(-0.125, 1.125)?.clamp(0.0, 1.0);
                Kind::HardStop { gap, restitution }
            }
            6 => {
                moves = self.signal(0.0, waves, 0.2)?;
                let count = self.u.int_in_range(2..=5_usize)?;
                let mut points = vec![(self.within(-1.0, 0.25)?, self.within(-2.0, 2.0)?)];
                for _ in 1..count {
                    let (x, force) = points.last().copied().unwrap_or_default();
                    let (length, slope) = (self.within(0.125, 1.0)?, self.within(-1.0, 24.0)?);
                    points.push((x + length, force + slope * length));
                }
                Kind::Spring { points }
            }
            _ => Kind::Contact { law: Law::constant(friction), peak, normal: None },
        };
        Ok(Element { name: String::new(), direction, moves, kind })
    }

    /// An element of a system with a body without mass. No two contacts have directions that depend on each other: each begins at a body of its own.
    fn element_of_joint(&mut self, n: usize, place: usize) -> Result<Element<f64>> {
        let mut direction = vec![0.0; n];
        let other = self.u.int_in_range(place..=n)?;
        for (i, sign) in [(place, 1.0), (other, -1.0)] {
            if let Some(b) = direction.get_mut(i).filter(|_| i != place || other != place || sign > 0.0) {
                *b += sign;
            }
        }
        let friction = self.within(0.125, 1.0)?;
        let kind = match self.u.int_in_range(0..=3_u8)? {
            0 => Kind::Elastic { stiffness: self.within(1.0, 60.0)?, friction, normal: None },
            1 => Kind::Stop {
                gap: self.within(-0.125, 1.0)?,
                stiffness: self.within(4.0, 60.0)?,
                damping: 0.0,
            },
            _ => Kind::Contact { law: Law::constant(friction), peak: 1.0, normal: None },
        };
        Ok(Element { name: String::new(), direction, moves: Signal::constant(0.0), kind })
    }
}

impl<'a> Arbitrary<'a> for Structure {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        let n = u.int_in_range(1..=6_usize)?;
        let is_round = u.ratio(1, 2)?;
        let mut numbers = Numbers { u, is_round };
        let mut mass = vec![vec![0.0; n]; n];
        let (mut damping, mut stiffness) = (mass.clone(), mass.clone());
        for (i, row) in mass.iter_mut().enumerate() {
            if let Some(m) = row.get_mut(i) {
                *m = numbers.within(0.5, 2.0)?;
            }
        }
        // Each body has a spring to the one before it, and perhaps to another one, or to the ground.
        for i in 0..n {
            let other = numbers.u.int_in_range(0..=n)?;
            for to in [i.checked_sub(1), Some(other).filter(|&j| j < n && j != i)] {
                let (k, c) = (numbers.within(0.5, 8.0)?, numbers.within(0.0, 0.5)?);
                for (matrix, x) in [(&mut stiffness, k), (&mut damping, c)] {
                    for (a, b, x) in
                        [(Some(i), Some(i), x), (to, to, x), (Some(i), to, -x), (to, Some(i), -x)]
                    {
                        if let (Some(a), Some(b)) = (a, b)
                            && let Some(entry) = matrix.get_mut(a).and_then(|row| row.get_mut(b))
                        {
                            *entry += x;
                        }
                    }
                }
            }
        }
        let waves = numbers.u.int_in_range(0..=3_usize)?;
        let base = numbers.within(0.5, 3.0)?;
        let harmonics = (1..=waves)
            .map(|k| {
                let order = f64::from(u32::try_from(k).unwrap_or(1));
                let cos = if numbers.one_in(2)? { Vec::new() } else { numbers.list(n, -1.0, 1.0)? };
                Ok(Harmonic { frequency: base * order, sin: numbers.list(n, -1.0, 1.0)?, cos })
            })
            .collect::<Result<Vec<_>>>()?;
        let mut records: Vec<Record<f64>> = Vec::new();
        if waves == 0 || numbers.one_in(4)? {
            let count = numbers.u.int_in_range(2..=12_usize)?;
            let step = numbers.within(0.25, 1.25)?;
            let times = (0..count).map(|k| step * f64::from(u32::try_from(k).unwrap_or(0))).collect();
            let (values, force) = (numbers.list(count, -1.0, 1.0)?, numbers.list(n, -1.0, 1.0)?);
            records.push(Record { times, values, force, beyond: Beyond::Zero });
        }
        let joint = if n > 1 && numbers.one_in(5)? {
            Some(numbers.u.int_in_range(0..=n.saturating_sub(1))?)
        } else {
            None
        };
        let count = numbers.u.int_in_range(1..=5_usize)?;
        let mut elements: Vec<Element<f64>> = Vec::new();
        for place in 0..if joint.is_some() { count.min(n) } else { count } {
            let element = match joint {
                Some(_) => numbers.element_of_joint(n, place)?,
                None => numbers.element(n, waves, &elements)?,
            };
            elements.push(element);
        }
        if let Some(i) = joint {
            if let Some(entry) = mass.get_mut(i).and_then(|row| row.get_mut(i)) {
                *entry = 0.0;
            }
            // A record begins and ends at once, by which such a body would jump.
            for record in &mut records {
                record.force.get_mut(i).into_iter().for_each(|force| *force = 0.0);
            }
        }
        let constant = if numbers.one_in(2)? { Vec::new() } else { numbers.list(n, -0.5, 0.5)? };
        let at_rest = numbers.one_in(3)?;
        let mut start = State::rest(n);
        if !at_rest {
            start.displacement = numbers.list(n, -1.0, 1.0)?;
            start.velocity = numbers.list(n, -1.0, 1.0)?;
        }
        let until = numbers.within(2.0, 12.0)?;
        // Nothing is beyond a stop that gives no way; some bodies are at one.
        for element in &mut elements {
            let Kind::HardStop { gap, .. } = &mut element.kind else { continue };
            let along = element.direction.iter().zip(&start.displacement).map(|(b, x)| b * x).sum::<f64>();
            let ways = element.moves.sin.iter().zip(&harmonics).map(|(sin, h)| sin / h.frequency);
            let least = along + ways.sum::<f64>() + if numbers.one_in(4)? { 0.0 } else { 0.125 };
            *gap = gap.max(least);
        }
        let mut model = Model {
            coordinates: Vec::new(),
            mass,
            damping,
            stiffness,
            elements,
            constant,
            harmonics,
            records,
            moved: Vec::new(),
            levels: Vec::new(),
        };
        // Friction under the force of such a stop, where that does not depend on it.
        let stops =
            |model: &Model<f64>| model.elements.iter().position(|e| matches!(e.kind, Kind::HardStop { .. }));
        if let Some(stop) = stops(&model) {
            let direction = numbers.direction(n, &[])?;
            let (coefficient, peak) = (numbers.within(0.0, 1.0)?, numbers.within(1.0, 1.5)?);
            let kind = Kind::UnderStop { stop, coefficient, peak };
            let moves = Signal::constant(if numbers.one_in(2)? { 0.0 } else { numbers.within(-0.5, 0.5)? });
            model.elements.push(Element { name: String::new(), direction, moves, kind });
            if System::new(&model).is_err() {
                model.elements.pop();
            }
        }
        Ok(Self { model, start, until })
    }
}
