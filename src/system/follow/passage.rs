//! The first event within a step, and the guards that are zero there.

use super::{Fired, Follower, sizes_of};
use crate::float::Float;
use crate::machine::error::written;
use crate::system::branch::LOW_COUNT;
use crate::system::error::Error;
use crate::system::first_passage::first_zero;
use crate::system::matrix::dot;
use alloc::vec::Vec;

impl<F: Float> Follower<'_, F> {
    /// The first guard that is certainly negative within a time of at most a step, with its place in that time. Of a branch with few entries
    /// the Taylor terms of the state over that time are left behind.
    pub(super) fn first_event(&mut self, time: F) -> Result<Option<(F, usize)>, Error> {
        let Some(branch) = self.branches.current() else { return Ok(None) };
        let mut event: Option<(F, usize)> = None;
        let mut add = |found: Option<F>, number: usize| {
            if let Some(at) = found
                && event.is_none_or(|(first, _)| at < first)
            {
                event = Some((at, number));
            }
        };
        let unbounded = |time: F| Error::Unbounded { time: written(time) };
        let is_bounded = |c: &[F], error: F| error.is_finite() && c.iter().all(|c| c.is_finite());
        if branch.few.is_some() {
            branch.all_terms(&self.z, time, &mut self.terms);
            branch.errors(&self.sizes, &mut self.errors);
            for (number, (guard, &error)) in branch.guards.iter().zip(&self.errors).enumerate() {
                let c = &mut self.values;
                guard.polynomial_of(&self.terms, c);
                if !is_bounded(c, error) {
                    return Err(unbounded(self.clock.value));
                }
                add(first_zero(c, error, branch.step / time), number);
            }
            return Ok(event);
        }
        branch.hull.at(&self.z, &self.sizes, &mut self.values, &mut self.errors);
        let certain = |(values, &error): (&[F; LOW_COUNT], &F)| values.iter().all(|&value| value > error);
        let values = self.values.as_chunks().0;
        let clear = values.iter().zip(&self.errors).all(certain);
        let is_near = self.blows.is_near();
        if clear && !is_near {
            return Ok(None);
        }
        let open = values.iter().zip(&self.errors).map(certain);
        for ((number, guard), is_certain) in branch.guards.iter().enumerate().zip(open) {
            if is_near {
                let state = (&*self.z, &*self.sizes);
                if let Some(found) = self.blows.passage(branch, guard, state, time / branch.step) {
                    add(found, number);
                    continue;
                }
            }
            if is_certain {
                continue;
            }
            let c = &mut self.terms;
            guard.polynomial(&self.z, time / branch.step, c);
            let error = dot(&guard.error, &self.sizes);
            if !is_bounded(c, error) {
                return Err(unbounded(self.clock.value));
            }
            add(first_zero(c, error, branch.step / time), number);
        }
        Ok(event)
    }

    /// The guards that are zero now: the one found, and those that rounding cannot tell from it.
    pub(super) fn fired(&self, number: usize, is_forced: bool) -> Vec<Fired> {
        let Some(branch) = self.branch() else { return Vec::new() };
        let (mut errors, slopes) = (Vec::new(), branch.derivative(&self.z));
        let mut sizes = Vec::new();
        sizes_of(self.system, branch, &self.z, &mut sizes);
        branch.errors(&sizes, &mut errors);
        let mut fired = Vec::new();
        // The one that was found is the first.
        let order = [number].into_iter().chain((0..branch.guards.len()).filter(|&i| i != number));
        let guards = order.filter_map(|i| branch.guards.get(i).zip(errors.get(i)));
        for (k, (guard, &error)) in guards.enumerate() {
            let doubt = error * F::int(4);
            let (value, slope) = (dot(&guard.row, &self.z), dot(&guard.row, &slopes));
            // A velocity that has just begun is zero, too.
            if k == 0 || (value <= doubt && slope * branch.step < -doubt) {
                let (element, trigger, others) = (guard.element, guard.trigger, guard.others.clone());
                fired.push(Fired { is_forced, element, trigger, others });
            }
        }
        fired
    }
}
