//! The samples of a record in time, again and again where it repeats itself.

use super::model::{Beyond, Record};
use crate::float::Float;

/// A place in time among the samples of a record.
struct Place<F> {
    /// How often the record has been over.
    cycle: F,
    /// The number of the first sample after it, which may be none.
    next: usize,
}

impl<F: Float> Record<F> {
    fn first(&self) -> F {
        self.times.first().copied().unwrap_or(F::int(0))
    }

    fn last(&self) -> F {
        self.times.last().copied().unwrap_or(F::int(0))
    }

    /// The time from the first sample to the last.
    pub(crate) fn length(&self) -> F {
        self.last() - self.first()
    }

    /// Whether it repeats itself.
    pub(crate) fn repeats(&self) -> bool {
        self.beyond == Beyond::Repeat
    }

    /// The instant of a time among the samples. The last one is the first of the next cycle, to the last bit.
    fn instant(&self, time: F, cycle: F) -> F {
        let (first, last) = (self.first(), self.last());
        if self.repeats() && time == last {
            first + self.length() * (cycle + F::int(1))
        } else if time == first {
            first + self.length() * cycle
        } else {
            time + self.length() * cycle
        }
    }

    fn place(&self, time: F) -> Place<F> {
        let mut cycle = F::int(0);
        if self.repeats() {
            let (first, one) = (self.first(), F::int(1));
            cycle = ((time - first) / self.length()).floor();
            // The quotient is rounded.
            if self.instant(first, cycle + one) <= time {
                cycle = cycle + one;
            } else if self.instant(first, cycle) > time {
                cycle = cycle - one;
            }
        }
        Place { cycle, next: self.times.partition_point(|&t| self.instant(t, cycle) <= time) }
    }

    /// p and p′ from a time on.
    pub(crate) fn from(&self, time: F) -> (F, F) {
        let Place { cycle, next } = self.place(time);
        let value = |k: usize| self.values.get(k).copied().unwrap_or(F::int(0));
        let Some((before, (&a, &b))) =
            next.checked_sub(1).and_then(|k| Some((k, (self.times.get(k)?, self.times.get(next)?))))
        else {
            let held = if next == 0 { value(0) } else { value(next - 1) };
            return (if self.beyond == Beyond::Hold { held } else { F::int(0) }, F::int(0));
        };
        let slope = (value(next) - value(before)) / (b - a);
        (value(before) + slope * (time - self.instant(a, cycle)), slope)
    }

    /// The instant of the first sample after a time.
    pub(crate) fn next(&self, time: F) -> Option<F> {
        let Place { cycle, next } = self.place(time);
        self.times.get(next).map(|&t| self.instant(t, cycle))
    }

    /// The greatest sizes of p and p′.
    pub(crate) fn reach(&self) -> (F, F) {
        let largest = self.values.iter().fold(F::int(0), |most, x| most.or_larger(x.abs()));
        let pairs = self.times.iter().zip(&self.values);
        let steepest = pairs.clone().zip(pairs.skip(1)).fold(F::int(0), |most, ((&a, &p), (&b, &q))| {
            if b > a { most.or_larger(((q - p) / (b - a)).abs()) } else { most }
        });
        (largest, steepest)
    }

    /// Whether p changes at once somewhere, but for its beginning and its end.
    pub(crate) fn jumps(&self) -> bool {
        let pairs = self.times.iter().zip(&self.values);
        let has_step = pairs.clone().zip(pairs.skip(1)).any(|((a, p), (b, q))| a == b && p != q);
        has_step || (self.repeats() && self.values.first() != self.values.last())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The values and instants of a wave with a step, over cycles whose length is not a machine number.
    #[test]
    fn a_record_repeats_itself() {
        let third = 1.0_f64 / 3.0;
        let record = Record {
            times: vec![0.0, 0.1, 0.1, third],
            values: vec![1.0, 2.0, -1.0, 0.5],
            force: vec![],
            beyond: Beyond::Repeat,
        };
        let mut time = -1.0;
        let mut count = 0;
        while time < 40.0 {
            let next = record.next(time).unwrap();
            assert!(next > time, "{time} {next}");
            let middle = f64::midpoint(time, next);
            let (value, slope) = record.from(middle);
            let phase = middle - third * (middle / third).floor();
            let due = if phase < 0.1 {
                (1.0 + phase / 0.1, 10.0)
            } else {
                (-1.0 + 1.5 * (phase - 0.1) / (third - 0.1), 1.5 / (third - 0.1))
            };
            assert!(
                (value - due.0).abs() < 1e-11 && (slope - due.1).abs() < 1e-12,
                "{middle}: {value} {slope} {due:?}"
            );
            (time, count) = (next, count + 1);
        }
        assert!((245..=248).contains(&count), "{count}");
        assert_eq!(record.from(0.1), (-1.0, 1.5 / (third - 0.1)));
        assert_eq!(record.from(third), (1.0, 10.0));
    }
}
