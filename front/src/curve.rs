//! A response curve: the frequencies that were asked for, and those between them that its peaks and corners need.

mod resolve;

pub use resolve::{Origin, resolved, resonant};

/// The number of intervals into which a curve is divided in search of its peaks.
const PROBES: u32 = 512;
/// The number of places tried in a unit of 1/Ω, and the least Ω for which they are.
const PER_PERIOD: f64 = 24.0;
const SLOWEST: f64 = 0.03;

/// The kinds of steady motion of a system that have a height: one that has not settled has none of its own, and its scatter has no end
/// of peaks.
pub const SETTLED: [&str; 3] = ["periodic", "rest", "uniform"];

/// The reason why a frequency is in a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// The frequency was requested.
    Grid,
    /// The frequency is the natural one.
    Natural,
    /// The curve has a maximum at this frequency.
    Peak,
    /// The frequency is next to a maximum or an onset, where a line through the other points would be inaccurate.
    Flank,
    /// The body begins to move from rest at this frequency, or ends.
    Onset,
    /// The frequency was tried in search of maxima, and is not in the curve.
    Probe,
}

impl Source {
    /// The name in a table.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Grid => "grid",
            Self::Natural => "natural",
            Self::Peak => "peak",
            Self::Flank => "flank",
            Self::Onset => "onset",
            Self::Probe => "probe",
        }
    }
}

/// A place of a curve.
pub trait Place: Copy {
    /// Its frequency, on the axis.
    fn x(&self) -> f64;
    /// Its value: infinite where the motion is unbounded, NaN where there is none.
    fn height(&self) -> f64;
    /// Whether the body rests for good.
    fn is_stuck(&self) -> bool;
    /// The reason why it is in the curve.
    fn source(&self) -> Source;
    /// This place for another reason.
    #[must_use]
    fn because(self, source: Source) -> Self;
}

/// The axis of a curve.
#[derive(Debug, Clone)]
pub struct Axis<'a, A> {
    /// The frequencies that were asked for, in their order.
    pub values: &'a [f64],
    /// The frequency at a share of the axis from 0 to 1.
    pub at: A,
    /// Whether equal shares are equal ratios.
    pub is_logarithmic: bool,
    /// The natural frequency on this axis; NaN if it has none.
    pub natural: f64,
}

impl<A: Fn(f64) -> f64> Axis<'_, A> {
    /// The least and the greatest frequency.
    fn ends(&self) -> (f64, f64) {
        let ends = self
            .values
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(*x), high.max(*x)));
        if ends.0 <= ends.1 { ends } else { (f64::NAN, f64::NAN) }
    }

    /// Frequencies between those of the grid, so that no peak wider than a five-hundredth of the axis is missed. Below
    /// the natural frequency the peaks of a motion with stops follow each other in equal steps of 1/Ω, and so do these.
    /// Those next to a frequency of the curve would only repeat it.
    fn probes(&self) -> Vec<f64> {
        let (low, high) = self.ends();
        if self.values.len() >= PROBES as usize {
            return Vec::new();
        }
        let natural = self.natural;
        let mut own: Vec<f64> =
            self.values.iter().copied().chain(Some(natural).filter(|x| x.is_finite())).collect();
        own.sort_by(f64::total_cmp);
        let evenly = (1..PROBES).map(|i| (self.at)(f64::from(i) / f64::from(PROBES)));
        let longest = 1.0 / SLOWEST;
        let (from, to) = ((natural / high).max(1.0), (natural / low).min(longest));
        let inverse = (1..(longest * PER_PERIOD) as u32).map(|i| f64::from(i) / PER_PERIOD);
        let slowly = inverse.filter(|period| *period > from && *period < to).map(|period| natural / period);
        let is_other = |&x: &f64| {
            let after = own.partition_point(|own| *own < x);
            let beside = [after.checked_sub(1), Some(after)];
            let away = (high - low).abs().min(x.abs()) * 1e-6;
            beside.into_iter().flatten().filter_map(|i| own.get(i)).all(|own| (own - x).abs() > away)
        };
        let mut found: Vec<f64> = evenly.chain(slowly).filter(is_other).collect();
        found.sort_by(f64::total_cmp);
        found.dedup_by(|a, b| (*a - *b).abs() <= a.abs() * 1e-6);
        found
    }

    /// The curve in ascending order: through the frequencies of the axis, its natural frequency, its maxima and the
    /// frequencies at which the body begins to move or ends, and beside them as many more as a line needs. `each` computes
    /// the first places, in any order, `at` one more.
    ///
    /// # Errors
    /// Those of `each` and `at`.
    pub fn through<P: Place, E>(
        &self,
        each: impl FnOnce(Vec<(f64, Source)>) -> Result<Vec<P>, E>,
        at: impl Fn(f64, Source) -> Result<P, E>,
    ) -> Result<Vec<P>, E> {
        let grid = self.values.iter().map(|x| (*x, Source::Grid));
        let probes = self.probes().into_iter().map(|x| (x, Source::Probe));
        let mut places = each(grid.chain(probes).collect())?;
        let ((low, high), natural) = (self.ends(), self.natural);
        if low < natural && natural < high && places.iter().all(|place| place.x() != natural) {
            places.push(at(natural, Source::Natural)?);
        }
        places.sort_by(|a, b| a.x().total_cmp(&b.x()));
        let mut with_onsets = Vec::with_capacity(places.len());
        for (i, place) in places.iter().enumerate() {
            with_onsets.push(*place);
            if let Some(next) = places.get(i.saturating_add(1))
                && place.is_stuck() != next.is_stuck()
            {
                with_onsets.extend(onset(*place, *next, &at)?);
            }
        }
        // The peaks among all places first, and then the curve through those that are drawn.
        let places = self.resolved(&with_onsets, |_| false, &at)?;
        let is_drawn = |place: &&P| !matches!(place.source(), Source::Probe | Source::Flank);
        let places: Vec<P> = places.iter().filter(is_drawn).copied().collect();
        let is_corner = |place: &P| matches!(place.source(), Source::Onset | Source::Peak);
        self.resolved(&places, is_corner, &at)
    }

    /// The curve through these places, resolved at its peaks and beside its corners.
    fn resolved<P: Place, E>(
        &self,
        places: &[P],
        is_corner: impl Fn(&P) -> bool,
        at: &impl Fn(f64, Source) -> Result<P, E>,
    ) -> Result<Vec<P>, E> {
        let of = |place: &P| (place.x(), place.height());
        let all = resolved(places, self.is_logarithmic, of, is_corner, |x| at(x, Source::Flank))?;
        let named = |(place, origin): (P, Origin)| match (origin, place.source()) {
            (Origin::Peak, Source::Flank | Source::Probe) => place.because(Source::Peak),
            _ => place,
        };
        Ok(all.into_iter().map(named).collect())
    }
}

/// The last place at rest and the first in motion, or the other way round, between two places.
fn onset<P: Place, E>(mut a: P, mut b: P, at: &impl Fn(f64, Source) -> Result<P, E>) -> Result<[P; 2], E> {
    loop {
        let x = a.x() + (b.x() - a.x()) / 2.0;
        if x <= a.x() || x >= b.x() {
            return Ok([a, b].map(|place| place.because(Source::Onset)));
        }
        let middle = at(x, Source::Onset)?;
        if middle.is_stuck() == a.is_stuck() {
            a = middle;
        } else {
            b = middle;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Axis, Place, Source};
    use std::convert::Infallible;

    #[derive(Clone, Copy)]
    struct At {
        x: f64,
        source: Source,
    }

    /// At rest below 0.6, then a resonance at 1 that is narrower than the steps of the grid.
    const ONSET: f64 = 0.6;
    const ZETA: f64 = 0.01;

    impl Place for At {
        fn x(&self) -> f64 {
            self.x
        }

        fn height(&self) -> f64 {
            if self.is_stuck() {
                return 0.0;
            }
            (self.x - ONSET) / (1.0 - self.x * self.x).hypot(2.0 * ZETA * self.x)
        }

        fn is_stuck(&self) -> bool {
            self.x < ONSET
        }

        fn source(&self) -> Source {
            self.source
        }

        fn because(self, source: Source) -> Self {
            Self { source, ..self }
        }
    }

    #[test]
    fn peaks_and_onsets_are_found_between_the_samples() {
        let values = [0.2, 0.5, 0.9, 1.7, 2.0];
        let axis =
            Axis { values: &values, at: |share| 0.2 * 10f64.powf(share), is_logarithmic: true, natural: 1.0 };
        let at = |x, source| Ok::<_, Infallible>(At { x, source });
        let each = |all: Vec<(f64, Source)>| all.into_iter().map(|(x, source)| at(x, source)).collect();
        let Ok(places) = axis.through(each, at);
        assert!(places.windows(2).all(|pair| pair[0].x <= pair[1].x));
        let of = |source| places.iter().filter(move |place| place.source == source).collect::<Vec<_>>();
        // The two numbers between which the body begins to move.
        let onset: Vec<f64> = of(Source::Onset).iter().map(|place| place.x).collect();
        assert_eq!(onset, [ONSET.next_down(), ONSET]);
        let [peak] = of(Source::Peak)[..] else { panic!("{}", of(Source::Peak).len()) };
        let y = peak.height();
        let dense = (0..200_000).map(|i| At { x: 0.9 + 1e-6 * f64::from(i), source: Source::Grid }.height());
        assert!(dense.fold(0.0, f64::max) <= y * (1.0 + 1e-9), "{y}");
        assert!(
            values.iter().all(|x| places.iter().any(|place| place.x == *x && place.source == Source::Grid))
        );
        assert!(!places.iter().any(|place| place.source == Source::Probe));
    }
}
