//! Periodic motions that no start leads to, such as unstable ones.

use super::LimitData;
use crate::bits::{Value, digits};
use crate::failure::{Failure, Outcome};
use crate::interrupt;
use crate::note::line;
use crate::progress;
use crate::record::Record;
use std::io::Write;
use stickslip::Ratios;
use stickslip::motion::{
    Attractors, LongRun, PeriodicMotions, Signature, State, SteadyState, periodic_motions_from,
};

/// A motion that no start leads to, with its number and that of its mirror image.
struct Other<F> {
    number: usize,
    mirror: Option<usize>,
    steady: SteadyState<F>,
}

/// All motions found to which no start leads.
pub(super) struct Others<F>(Vec<Other<F>>);

impl<F: Value> Others<F> {
    pub(super) const fn none() -> Self {
        Self(Vec::new())
    }

    /// Searches by Newton's method from the starts, in parallel; the numbers continue those of the limits.
    pub(super) fn search(
        all: &Attractors<F>,
        ratios: Ratios<F>,
        count: u64,
        at: impl Fn(u64) -> Result<State<F>, Failure> + Sync,
        turns: u32,
    ) -> Result<Self, Failure> {
        let mut motions = PeriodicMotions::new();
        progress::in_order(
            0..count,
            |number| Ok(periodic_motions_from(ratios, at(number)?, turns, &mut interrupt::keep_going)?),
            |found| Ok(found.into_iter().try_for_each(|steady| motions.add(steady))?),
        )?;
        let mut numbers = Vec::new();
        let mut next = all.limits.len();
        for motion in motions.found() {
            let signature = Signature::of(&LongRun::Periodic(motion.steady_state))?;
            let place = all.place_of(&signature);
            numbers.push((place.is_none(), 1 + place.unwrap_or(next)));
            next += usize::from(place.is_none());
        }
        let number = |place: usize| numbers.get(place).map(|(_, number)| *number);
        let others = motions.found().iter().zip(&numbers).filter(|(_, (is_other, _))| *is_other);
        Ok(Self(
            others
                .map(|(motion, (_, own))| Other {
                    number: *own,
                    mirror: motion.mirror.and_then(number),
                    steady: motion.steady_state,
                })
                .collect(),
        ))
    }

    pub(super) fn rows(&self) -> Vec<Record<F>> {
        let row = |Other { number, mirror, steady }: &Other<F>| {
            LimitData {
                number: *number,
                name: if steady.is_stable() { "periodic" } else { "unstable" },
                share: 0.0,
                starts: 0,
                first: None,
                mirror: *mirror,
                limit: Some(LongRun::Periodic(*steady)),
                range: None,
            }
            .record()
        };
        self.0.iter().map(row).collect()
    }

    pub(super) fn text(&self, turns: u32, length: impl Fn(F) -> String, out: &mut impl Write) -> Outcome {
        let of = if turns == 1 { "one turn".to_owned() } else { format!("{turns} turns or fewer") };
        let found = match self.0.len() {
            0 => "No periodic motion",
            1 => "A periodic motion",
            _ => "Periodic motions",
        };
        writeln!(out, "\n{found} of {of} that no start leads to, by a search from the same starts.")?;
        for Other { number, mirror, steady } in &self.0 {
            let stability = if steady.is_stable() { "stable" } else { "unstable" };
            let mirror = mirror.map_or(String::new(), |number| format!(", the mirror image of {number}"));
            writeln!(out, "\n{number}. {}, {stability}{mirror}", stickslip::words::shape(steady))?;
            line(out, "maximum displacement", length(steady.max_displacement.value))?;
            line(out, "minimum displacement", length(steady.min_displacement.value))?;
            line(out, "stops in a cycle", steady.sticks_per_cycle)?;
            let [(re, im), _] = steady.multipliers;
            let imaginary =
                if im == F::int(0) { String::new() } else { format!(" ± {} i", digits(im.abs())) };
            line(out, "greatest multiplier", format_args!("{}{imaginary} in a cycle", digits(re)))?;
        }
        Ok(())
    }
}
