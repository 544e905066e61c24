//! Curves resolved at their peaks, so that a drawing shows them to the pixel.
//!
//! Samples cut off a resonance peak, or give a finite height to an unbounded one. Around each local maximum
//! of the samples the maximum itself is searched, and points are added until a line through them is accurate.

use core::convert::Infallible;

/// The source of a point of a resolved curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// A given sample.
    Given,
    /// A maximum: between two samples, or at one of them.
    Peak,
    /// A point beside a maximum.
    Flank,
}

/// The least distance of two added points, as a part of the axis: half a pixel of the widest plot.
const STEP: f64 = 1.0 / 1280.0;
/// The allowed error of a straight line in the logarithm of the value: half a pixel of an axis of one decade,
/// the shortest axis.
const RISE: f64 = 2.5e-3;
/// Values that agree to this relative tolerance count as equal: smaller differences are the rounding of a
/// searched output.
const EQUAL: f64 = 1e-10;
/// The least part of the larger interval beside a maximum that a step of the search takes.
const GOLDEN: f64 = 0.381_966_011_250_105;

/// The curve through `points` of ascending x, with points added around each local maximum.
///
/// `place` is a point's (x, y), with y infinite where the curve has no bound and NaN where it has no value;
/// `at` computes the point at any x. Between the samples that enclose a maximum, points are added until the
/// line through them is within half a pixel of the curve on a logarithmic y-axis, or half a pixel apart.
/// A maximum narrower than the samples is found where a sample lies on it or the curve rises towards it from
/// both sides: the natural frequency should therefore be among the samples. The gaps beside a sample that `bends` says
/// is a corner of the curve are resolved, too.
///
/// # Errors
/// Errors of `at`.
pub fn resolved<T: Clone, E>(
    points: &[T],
    logarithmic: bool,
    place: impl Fn(&T) -> (f64, f64),
    bends: impl Fn(&T) -> bool,
    at: impl Fn(f64) -> Result<T, E>,
) -> Result<Vec<(T, Origin)>, E> {
    let x = |point: Option<&T>| point.map_or(f64::NAN, |point| place(point).0);
    let (first, last) = (x(points.first()), x(points.last()));
    let curve = SampledCurve { logarithmic, length: along(logarithmic, first, last), place, at };
    let ends = points.iter().zip(points.iter().skip(1));
    let lengths: Vec<f64> =
        ends.map(|(a, b)| along(logarithmic, (curve.place)(a).0, (curve.place)(b).0)).collect();
    // For each gap between two samples: whether a maximum is next to it or in it, and the maxima in it.
    let mut gaps: Vec<(bool, Vec<T>)> = vec![(false, Vec::new()); points.len()];
    let mut peaks = Vec::new();
    for (i, point) in points.iter().enumerate() {
        let before = i.checked_sub(1).and_then(|i| points.get(i));
        let after = points.get(i.saturating_add(1));
        if bends(point) {
            for gap in [i.checked_sub(1), Some(i)].into_iter().flatten() {
                gaps.get_mut(gap).into_iter().for_each(|(beside, _)| *beside = true);
            }
        }
        if !curve.is_top(before, point, after) {
            continue;
        }
        let top = curve.top(before.unwrap_or(point), point, after.unwrap_or(point))?;
        let (own, found) = (curve.value(point), curve.value(&top));
        let is_sample = found <= own * (1.0 + EQUAL);
        // The end of a monotone curve is no peak, unless the curve is unbounded there.
        if is_sample && own.is_finite() && (before.is_none() || after.is_none()) {
            continue;
        }
        peaks.extend((is_sample && own.is_finite()).then_some(i));
        let is_before = (curve.place)(&top).0 < (curve.place)(point).0;
        for (gap, next, holds) in [
            (i.checked_sub(1), i.checked_sub(2), is_before),
            (Some(i), Some(i.saturating_add(1)), !is_before),
        ] {
            let Some((beside, tops)) = gap.and_then(|gap| gaps.get_mut(gap)) else { continue };
            *beside = true;
            if holds && !is_sample {
                tops.push(top.clone());
            }
            // A sample at the maximum itself, such as resonance, leaves a part of a gap on one side.
            let length = |gap: Option<usize>| gap.and_then(|gap| lengths.get(gap)).copied().unwrap_or(0.0);
            if length(gap) < 0.99 * length(next)
                && let Some((beside, _)) = next.and_then(|next| gaps.get_mut(next))
            {
                *beside = true;
            }
        }
    }
    let mut all = Vec::with_capacity(points.len());
    for (i, (point, (beside, tops))) in points.iter().zip(gaps).enumerate() {
        all.push((point.clone(), if peaks.binary_search(&i).is_ok() { Origin::Peak } else { Origin::Given }));
        let Some(next) = points.get(i.saturating_add(1)).filter(|_| beside) else { continue };
        let mut from = point.clone();
        for top in tops {
            curve.fill(&from, &top, &mut all)?;
            all.push((top.clone(), Origin::Peak));
            from = top;
        }
        curve.fill(&from, next, &mut all)?;
    }
    Ok(all)
}

struct SampledCurve<P, A> {
    logarithmic: bool,
    /// The length of the axis.
    length: f64,
    place: P,
    at: A,
}

impl<T: Clone, E, P: Fn(&T) -> (f64, f64), A: Fn(f64) -> Result<T, E>> SampledCurve<P, A> {
    /// The value at a point; where there is none, a number below all others.
    fn value(&self, point: &T) -> f64 {
        let (_, y) = (self.place)(point);
        if y.is_nan() { f64::NEG_INFINITY } else { y }
    }

    /// Whether a sample is a local maximum, and not of a constant stretch.
    fn is_top(&self, before: Option<&T>, point: &T, after: Option<&T>) -> bool {
        let own = self.value(point);
        let beside = [before, after].map(|other| other.map(|other| self.value(other)));
        let others = || beside.into_iter().flatten();
        own > 0.0 && others().all(|other| other <= own) && others().any(|other| other < own * (1.0 - EQUAL))
    }

    /// The highest point between two samples, where `middle` is at least as high as both: by golden-section
    /// search.
    fn top(&self, low: &T, middle: &T, high: &T) -> Result<T, E> {
        let (mut low, mut middle, mut high) = (low.clone(), middle.clone(), high.clone());
        loop {
            let [left, x, right] = [&low, &middle, &high].map(|point| (self.place)(point).0);
            let most = self.value(&middle);
            let least = self.value(&low).min(self.value(&high));
            // At a smooth maximum the values agree long before the places do.
            let is_narrow = right - left <= 4.0 * f64::EPSILON * x.abs();
            if most.is_infinite() || is_narrow || least >= most * (1.0 - EQUAL) {
                return Ok(middle);
            }
            let is_left = x - left > right - x;
            let next = if is_left { x - GOLDEN * (x - left) } else { x + GOLDEN * (right - x) };
            let tried = (self.at)(next)?;
            match (self.value(&tried) > most, is_left) {
                (true, true) => (middle, high) = (tried, middle),
                (true, false) => (low, middle) = (middle, tried),
                (false, true) => low = tried,
                (false, false) => high = tried,
            }
        }
    }

    /// Adds the points between two points that a line needs.
    fn fill(&self, from: &T, to: &T, all: &mut Vec<(T, Origin)>) -> Result<(), E> {
        let ((left, a), (right, b)) = ((self.place)(from), (self.place)(to));
        if a.is_nan() || b.is_nan() || along(self.logarithmic, left, right) <= STEP * self.length {
            return Ok(());
        }
        let share = |share: f64| {
            if self.logarithmic { left * (right / left).powf(share) } else { left + (right - left) * share }
        };
        let middle = (self.at)(share(0.5))?;
        let is_straight = |point: &T, share: f64| {
            let y = self.value(point);
            a == b && b == y || (y.ln() - a.ln() - (b.ln() - a.ln()) * share).abs() <= RISE
        };
        // The curve may cross the line at its middle.
        if is_straight(&middle, 0.5) && is_straight(&(self.at)(share(0.25))?, 0.25) {
            return Ok(());
        }
        self.fill(from, &middle, all)?;
        all.push((middle.clone(), Origin::Flank));
        self.fill(&middle, to, all)
    }
}

/// The distance of two places on an axis.
fn along(logarithmic: bool, from: f64, to: f64) -> f64 {
    if logarithmic { (to / from).ln() } else { to - from }
}

/// A curve over Ω, with these places of resonance among its points and resolved there.
pub fn resonant(
    omegas: impl Iterator<Item = f64>,
    resonances: &[f64],
    of: impl Fn(f64) -> f64,
) -> Vec<(f64, f64)> {
    let mut omegas: Vec<f64> = omegas.chain(resonances.iter().copied()).collect();
    omegas.sort_by(f64::total_cmp);
    let points: Vec<(f64, f64)> = omegas.into_iter().map(|omega| (omega, of(omega))).collect();
    let Ok::<_, Infallible>(all) =
        resolved(&points, false, |&point| point, |_| false, |omega| Ok((omega, of(omega))));
    all.into_iter().map(|(point, _)| point).collect()
}

#[cfg(test)]
mod tests {
    use super::{Infallible, Origin, resolved, resonant};

    fn evenly(from: f64, to: f64, count: u32) -> impl Iterator<Item = f64> {
        (0..count).map(move |i| from + (to - from) * f64::from(i) / f64::from(count - 1))
    }

    /// The value of the line through some points.
    fn on_line(points: &[(f64, f64)], x: f64) -> f64 {
        let after = points.iter().position(|point| point.0 >= x).unwrap().max(1);
        let ((a, at_a), (b, at_b)) = (points[after - 1], points[after]);
        (at_a.ln() + (at_b.ln() - at_a.ln()) * (x - a) / (b - a)).exp()
    }

    #[test]
    fn peaks_are_found_whatever_the_samples() {
        for zeta in [1e-9, 1e-6, 1e-3, 0.02, 0.3, 0.6] {
            let of = |omega: f64| 1.0 / (1.0 - omega * omega).hypot(2.0 * zeta * omega);
            let top: f64 = 1.0 / (2.0 * zeta * (1.0 - zeta * zeta).sqrt());
            for count in [2, 3, 10, 200, 2000] {
                let even = evenly(0.2, 2.0, count);
                let points = resonant(even, &[1.0], of);
                let found = points.iter().map(|point| point.1).fold(0.0, f64::max);
                assert!((found / top - 1.0).abs() < 1e-8, "{zeta} {count}: {found} for {top}");
                assert!(points.windows(2).all(|pair| pair[0].0 <= pair[1].0));
                if zeta > 0.5 {
                    // This peak is far from Ω = 1.
                    continue;
                }
                // The flanks of the peak are those of the curve, to a pixel of 1/640 of the axis.
                let gap = 1.8 / f64::from(count - 1);
                let (low, high) = ((1.0 - gap).max(0.2), (1.0 + gap).min(2.0));
                let pixel = 1.8 / 640.0;
                for x in evenly(low, high, 1000) {
                    let around = [x - pixel, x, x + pixel].map(of);
                    let (least, most) =
                        (around[0].min(around[1]).min(around[2]), around[0].max(around[1]).max(around[2]));
                    let drawn = on_line(&points, x);
                    assert!(
                        drawn > least * 0.99 && (drawn < most * 1.01 || (x - 1.0).abs() < pixel),
                        "{zeta} {count} {x}: {drawn}"
                    );
                }
                assert!(points.len() < count as usize + 300, "{}", points.len());
            }
        }
    }

    #[test]
    fn what_has_no_bound_stays_so_and_what_is_flat_stays_as_it_is() {
        let pole = |x: f64| 1.0 / (1.0 - x * x).abs();
        let points = resonant([0.5, 1.7].into_iter(), &[1.0], pole);
        assert!(points.contains(&(1.0, f64::INFINITY)) && points.len() > 20);
        for flat in [|_: f64| 3.0, |x: f64| 3.0 + 1e-13 * (40.0 * x).sin(), |_| 0.0, |_| f64::NAN, |x: f64| x]
        {
            assert_eq!(resonant([0.5, 0.7, 1.3, 1.9].into_iter(), &[], flat).len(), 4);
        }
        // A peak between the first two samples, on a logarithmic axis.
        let humped = |x: f64| Ok::<_, Infallible>((x, (-(x - 0.2f64).powi(2)).exp()));
        let samples: Vec<_> = [0.1, 0.4, 2.0].into_iter().map(|x| humped(x).unwrap()).collect();
        let Ok(points) = resolved(&samples, true, |&point| point, |_| false, humped);
        let tops: Vec<_> = points.iter().filter(|point| point.1 == Origin::Peak).collect();
        assert!(tops.len() == 1 && (tops[0].0.1 - 1.0).abs() < 1e-9, "{tops:?}");
        let single =
            resolved(&[(1.0, 2.0)], false, |&point| point, |_| false, |x| Ok::<_, Infallible>((x, 2.0)));
        assert_eq!(single, Ok(vec![((1.0, 2.0), Origin::Given)]));
    }
}
