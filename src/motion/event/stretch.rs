//! One stretch of the search for a zero: shorter than half a free period, with a right side g of one sign
//! (`event` has the proofs).

use super::search::{FoundZero, Verdict, ZeroSearch};
use crate::float::Float;
use crate::motion::slide::motion::SlideJet;

/// A stretch (beginning, end) on which g has one sign, and the known properties of f at its beginning.
#[derive(Clone, Copy)]
pub(crate) struct Stretch<F> {
    pub(crate) from: F,
    pub(crate) to: F,
    pub(crate) jet: Option<SlideJet<F>>,
    pub(crate) from_zero: bool,
}

/// The zero of a stretch where g ≤ 0: there is one if and only if f < 0 at the end.
pub(crate) fn in_opposing<F: Float, M: Copy>(
    search: &ZeroSearch<'_, F>,
    stretch: Stretch<F>,
    f: &impl Fn(F) -> (SlideJet<F>, M),
) -> Verdict<F, M> {
    let Stretch { from, to, jet, .. } = stretch;
    // A hint beyond the stretch predicts no zero: the end decides.
    let mut guess = to;
    if search.hint > from && search.hint < to {
        guess = search.hint;
    } else if let Some(j) = jet
        && search.hint <= from
    {
        let h = first_zero_of_bound(j);
        if h > F::int(0) && from + h < to {
            guess = from + h;
        }
    }
    bracketed(search, from, to, false, guess, f)
}

/// The first zero of the bound `f cos h + f′ sin h + g (1 − cos h)` with g fixed at its value at h = 0; zero
/// if there is none.
fn first_zero_of_bound<F: Float>(jet: SlideJet<F>) -> F {
    let SlideJet { value, first, second, .. } = jet;
    let g = second + value;
    let discriminant = first.square() + value * (value - F::int(2) * g);
    if discriminant < F::int(0) {
        return F::int(0);
    }
    let root = discriminant.sqrt();
    // tan(h/2) = f/(√ − f′) = (√ + f′)/(f − 2g): this takes the form without cancellation.
    let h = if first > F::int(0) {
        (root + first).atan2(value - F::int(2) * g)
    } else {
        value.atan2(root - first)
    };
    F::int(2) * h
}

/// The zero of f in (low, high]; f is positive at `low` and has one zero at most.
///
/// `below` says that f(high) < 0 is known; otherwise f(high) ≥ 0 means that there is no zero.
fn bracketed<F: Float, M: Copy>(
    search: &ZeroSearch<'_, F>,
    low: F,
    high: F,
    below: bool,
    guess: F,
    f: &impl Fn(F) -> (SlideJet<F>, M),
) -> Verdict<F, M> {
    let (begin, end) = (low, high);
    let (mut low, mut high, mut below, mut phi) = (low, high, below, guess);
    let mut last_width = high - low;
    let mut slow = false;
    let mut steps = 0;
    loop {
        steps = u32::saturating_add(steps, 1);
        let (jet, motion) = f(phi);
        let zero = F::int(0);
        let at = phi;
        let crossing = |step| Verdict::Zero(FoundZero { at, step, motion, grazes: false });
        if jet.value > zero {
            low = phi;
            if phi >= end && !below {
                return Verdict::Clear(Some((jet, motion)));
            }
        } else {
            (high, below) = (phi, true);
        }
        let step = householder(&jet);
        let next = phi + step;
        if jet.first < zero && is_final(search.pace, &jet, phi, step) && next > begin && next <= end {
            return crossing(step);
        }
        let width = high - low;
        if width <= F::epsilon() * high {
            return crossing(zero);
        }
        if !below {
            // The end is examined next unless the step leads to a point between `low` and the end, and in any
            // case after as many steps as the type has digits.
            let inside = next > low && next < end && steps <= F::precision();
            phi = if jet.first < zero && inside { next } else { end };
            continue;
        }
        let inside = next > low && next < high;
        // Two steps in a row that do not halve the bracket call for a bisection, unless they are already
        // tiny.
        let halved = width * F::int(2) <= last_width;
        let bisect =
            !inside || steps > F::precision() || (slow && !halved && step.abs() * F::int(64) > width);
        (slow, last_width) = (!halved && !bisect, width);
        phi = if bisect { (low + high) / F::int(2) } else { next };
        if phi <= low || phi >= high {
            return crossing(zero);
        }
    }
}

/// Householder's step of third order towards a zero, which quadruples the good digits:
/// `−f (6f′² − 3ff″)/(6f′³ − 6ff′f″ + f²f‴)`.
#[inline]
fn householder<F: Float>(jet: &SlideJet<F>) -> F {
    let SlideJet { value, first, second, third } = *jet;
    let (three, six) = (F::int(3), F::int(6));
    let bent = value * second;
    let above = value * (six * first.square() - three * bent);
    let below = six * first * (first.square() - bent) + value.square() * third;
    -above / below
}

/// Whether the error that remains after a step is below the rounding of φ.
///
/// The step leaves an error of order `h⁴`. Its factor consists of κ = f″h/f′ and of derivatives of the order
/// of `max(1, Ω, 2ζ) h` each.
#[inline]
fn is_final<F: Float>(pace: F, jet: &SlideJet<F>, phi: F, step: F) -> bool {
    let curvature = (jet.second * step / jet.first).abs();
    let turned = step.abs() * pace;
    let left = step.abs() * (curvature + turned) * (curvature + turned).square();
    left <= F::epsilon() / F::int(4) * phi.abs().or_larger(step.abs())
        || jet.value == F::int(0)
        || step.abs() <= F::epsilon() * phi.abs()
}

/// The first zero of a stretch where g ≥ 0.
pub(crate) fn in_helping<F: Float, M: Copy>(
    search: &ZeroSearch<'_, F>,
    stretch: Stretch<F>,
    f: &impl Fn(F) -> (SlideJet<F>, M),
) -> Verdict<F, M> {
    let Stretch { from, to, jet, from_zero } = stretch;
    // From zero upwards the cover is π/√(1 − ζ²) long: the whole stretch.
    if from_zero {
        return Verdict::Clear(None);
    }
    if let Some(j) = jet
        && search.cover.reaches_forward(j, to - from)
    {
        return Verdict::Clear(None);
    }
    if search.hint > from
        && search.hint < to
        && let Some(found) = polished_guess(search.hint, search.pace, (from, to), f)
    {
        return Verdict::Zero(found);
    }
    let (right, right_motion) = f(to);
    let (left, left_motion) = match jet {
        Some(j) => (j, None),
        // The interval covered from the end need not be searched.
        None if right.value > F::int(0) && search.cover.reaches_back(right, to - from) => {
            return Verdict::Clear(Some((right, right_motion)));
        }
        None => {
            let (j, m) = f(from);
            (j, Some(m))
        }
    };
    if let Some(motion) = left_motion
        && left.value <= F::int(0)
    {
        // The stretch begins at a zero to within rounding.
        return Verdict::Zero(FoundZero {
            at: from,
            step: F::int(0),
            motion,
            grazes: left.first >= F::int(0),
        });
    }
    if right.value < F::int(0) {
        return bracketed(search, from, to, true, start_of_bracket(from, to, left), f);
    }
    dip(search, (from, left), (to, right), right_motion, f)
}

/// A first guess inside a bracket: where the tangent bound vanishes, or the middle.
fn start_of_bracket<F: Float>(from: F, to: F, left: SlideJet<F>) -> F {
    let h = first_zero_of_bound(left);
    if h > F::int(0) && from + h < to { from + h } else { (from + to) / F::int(2) }
}

/// Householder's method from the hint; a result only if it settles on a downward zero in (from, to].
pub(crate) fn polished_guess<F: Float, M: Copy>(
    hint: F,
    pace: F,
    (from, to): (F, F),
    f: &impl Fn(F) -> (SlideJet<F>, M),
) -> Option<FoundZero<F, M>> {
    let mut phi = hint;
    for _ in 0..MOST_POLISHES {
        let (jet, motion) = f(phi);
        let step = householder(&jet);
        let next = phi + step;
        let inside = next > from && next <= to && jet.first < F::int(0);
        if !inside {
            return None;
        }
        if is_final(pace, &jet, phi, step) {
            return Some(FoundZero { at: phi, step, motion, grazes: false });
        }
        phi = next;
    }
    None
}

/// Six steps multiply the number of correct digits by 4⁶: more are never useful.
const MOST_POLISHES: u32 = 6;

/// The dip between two points with f ≥ 0 where g ≥ 0: a zero, a grazing, or nothing.
///
/// Each point evaluated in the gap between the two covers replaces the end on its side. Next to a dip the
/// covers of a pair at distance d leave a gap of the order of d², so that the gap closes quadratically. Where
/// u falls (`cover`), its backward cover is longer than half a stretch, and the point replaces the left end;
/// where it rises, the right one.
fn dip<F: Float, M: Copy>(
    search: &ZeroSearch<'_, F>,
    left: (F, SlideJet<F>),
    right: (F, SlideJet<F>),
    right_motion: M,
    f: &impl Fn(F) -> (SlideJet<F>, M),
) -> Verdict<F, M> {
    let end = right.1;
    let (from, two) = (left.0, F::int(2));
    let mut low = left.0 + search.cover.forward(left.1);
    let mut high = right.0 - search.cover.backward(right.1);
    let mut lowest = right;
    for _ in 0..F::precision().saturating_mul(2).saturating_add(MOST_ORDERS) {
        if low >= high {
            return Verdict::Clear(Some((end, right_motion)));
        }
        let phi = between(low, high);
        let (jet, motion) = f(phi);
        // The greatest depth of the dip below this point: f′²/2f″.
        let depth = jet.first.square() / (two * jet.second);
        let noise = noise(search, phi, &jet);
        if jet.value.abs() <= noise && depth <= noise {
            return Verdict::Zero(FoundZero { at: phi, step: F::int(0), motion, grazes: true });
        }
        if jet.value < F::int(0) {
            return bracketed(search, from, phi, true, (low + phi) / two, f);
        }
        if search.cover.falls(jet) {
            low = phi + search.cover.forward(jet);
        } else {
            high = phi - search.cover.backward(jet);
        }
        lowest = (phi, jet);
    }
    // The gap is closed to within ε² (`event`): the dip is here.
    let (phi, jet) = lowest;
    let (_, motion) = f(phi);
    if jet.value.abs() > noise(search, phi, &jet) {
        return Verdict::Lost(phi);
    }
    Verdict::Zero(FoundZero { at: phi, step: F::int(0), motion, grazes: true })
}

/// A point within a gap (low, high) with 0 ≤ low: its middle, or, for a dip that begins many orders of magnitude before the gap
/// ends, the geometric mean. A start with a velocity far below the rounding of the forces has its dip there.
fn between<F: Float>(low: F, high: F) -> F {
    let distant = F::epsilon() * high;
    if low >= distant {
        (low + high) / F::int(2)
    } else if low > F::int(0) {
        low.sqrt() * high.sqrt()
    } else {
        distant
    }
}

/// The geometric means that take a gap from any exponent of a number to the order of its end: each halves the difference of the
/// exponents, which is below 2³².
const MOST_ORDERS: u32 = 32;

/// The rounding error of the lowest value of a dip: the rounding of f and of φ, which has a relative error of
/// ε.
fn noise<F: Float>(search: &ZeroSearch<'_, F>, phi: F, jet: &SlideJet<F>) -> F {
    let unit = F::int(4) * F::epsilon() * phi;
    search.noise_at(phi) + jet.second.abs() * unit.square() / F::int(2)
}
