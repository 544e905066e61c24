//! The next zero of a vibration, with a proof that none was missed.
//!
//! Along a slide the speed `f = s w`, and the acceleration likewise, obeys `f″ + f = g` with `g ∝ cos(θ + const)`: a
//! right side whose sign changes exactly once in a half turn of the drive. On a stretch shorter than π (in natural time)
//! where g keeps its sign and f > 0 at the beginning:
//!
//! * **g ≤ 0** (opposing). f/sin is concave in the sense of Sturm: f crosses zero once at most, and it does if and only if
//!   f < 0 at the end.
//! * **g ≥ 0** (helping). From any point, forward and backward, `f(φ ± h) ≥ f cos h ± f′ sin h` for 0 ≤ h ≤ π: nothing
//!   vanishes before the right side does, at `h = atan2(f, ∓f′)`. f < 0 at the end means exactly one zero. Otherwise both
//!   ends have such a cover, and where the two do not meet f has a single dip in between, which is searched until it is
//!   found below zero, covered, or touching zero to within the rounding of f: *grazing*.
//! * In both, a zero with f′ < 0 is the **first**: in the first case it is the only one, in the second the backward cover
//!   from it is `−f′ sin h > 0` over the whole stretch. So a zero that was merely guessed and polished proves itself.
//!
//! [`next_zero`] walks over the stretches. # Work
//!
//! A slide lasts at most `π(1 + 1/Ω)` of natural time, because `w(φ) + w(φ + π)` is free of the natural vibration and
//! changes sign every π/Ω. For 1/2 ≤ Ω ≤ 2 that is at most 3π of natural time and four changes of sign of g, hence
//! **at most 8 stretches** of up to 3 radians. Outside, f is a slow and a fast wave of amplitudes G and r; while the slow one
//! exceeds the other's amplitude there is no zero, and that part is left out ([`Safe`]). What remains of a window holds
//! a zero once it is as long as the fast period, and each window is at least half a slow period, not shorter than the
//! fast one: at most the end of one window and one fast period in the next are examined, two fast periods, again
//! at most 8 stretches. Within a stretch a step that does not halve the bracket is followed by a bisection: **at most
//! 2·PRECISION + 8 evaluations, and 2 or 3 as a rule**, because Householder's steps quadruple the good digits.

use crate::float::Float;

/// A value and its first three derivatives.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Jet<F> {
    pub(crate) value: F,
    pub(crate) first: F,
    pub(crate) second: F,
    pub(crate) third: F,
}

/// The first zero: at `at + step`, where `step` is the last, final one, and `motion` is that of `at`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Found<F, M> {
    pub(crate) at: F,
    pub(crate) step: F,
    pub(crate) motion: M,
    /// The function touches zero without crossing it.
    pub(crate) grazes: bool,
}

/// A window of natural time within which no zero can be: it repeats after `period`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Safe<F> {
    pub(crate) centre: F,
    pub(crate) half_width: F,
    pub(crate) period: F,
}

impl<F: Float> Safe<F> {
    /// The window that φ lies in or that comes next, as (beginning, end).
    fn next(&self, phi: F) -> (F, F) {
        // The end of a window, rounded, counts as beyond it.
        let rounding = F::int(16) * F::epsilon() * (phi + self.period);
        let turns = ((phi + rounding - self.centre - self.half_width) / self.period).floor() + F::int(1);
        let centre = self.centre + turns * self.period;
        (centre - self.half_width, centre + self.half_width)
    }
}

/// What is known of the function whose zero is sought.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Search<F> {
    pub(crate) omega: F,
    /// The angle of g at φ = 0 within its half turn, in `[−π/2, π/2)`: `|g| ∝ cos`.
    pub(crate) angle: F,
    /// Whether g ≥ 0 on that half turn.
    pub(crate) helping: bool,
    /// Whether f = 0 at φ = 0, from where it rises.
    pub(crate) from_zero: bool,
    /// Where to stop; the zero may be at the limit itself.
    pub(crate) limit: Option<F>,
    /// Where the zero is expected.
    pub(crate) hint: F,
    /// Where no zero can be.
    pub(crate) safe: Option<Safe<F>>,
    /// What rounding can make of a zero of f.
    pub(crate) noise: F,
}

/// A stretch (beginning, end) with g of one sign, and what is known of f at its beginning.
#[derive(Clone, Copy)]
struct Stretch<F> {
    from: F,
    to: F,
    jet: Option<Jet<F>>,
    from_zero: bool,
}

/// What a stretch turned out to hold: a zero, or none, with the function at its end where that was evaluated.
pub(crate) enum Verdict<F, M> {
    Zero(Found<F, M>),
    Clear(Option<(Jet<F>, M)>),
}

/// The first zero of f after φ = 0 and up to the limit, `start` being f at φ = 0; clear where there is none, with what f
/// is at the limit if that had to be known.
///
/// `f` gives the function with whatever else the caller wants to know of that instant.
pub(crate) fn next_zero<F: Float, M: Copy>(
    search: &Search<F>,
    start: Jet<F>,
    f: impl Fn(F) -> (Jet<F>, M),
) -> Verdict<F, M> {
    let three = F::int(3);
    let mut phi = F::int(0);
    let mut jet = Some(start);
    let mut from_zero = search.from_zero;
    let quarter = F::pi() / F::int(2);
    let mut half_turn = F::int(0);
    let mut helping = search.helping;
    // The bound of the module's head, with room for windows that rounding cuts in two.
    for _ in 0..MOST_STRETCHES {
        let boundary = (quarter - search.angle + half_turn * F::pi()) / search.omega;
        if boundary <= phi {
            half_turn = half_turn + F::int(1);
            helping = !helping;
            continue;
        }
        let mut to = boundary;
        if phi + three < to {
            to = phi + three;
        }
        if let Some(safe) = &search.safe {
            let (begins, ends) = safe.next(phi);
            if begins <= phi {
                let skipped = ((ends * search.omega + search.angle) / F::pi() + F::ratio(1, 2)).floor();
                if modulo_two(skipped - half_turn) {
                    helping = !helping;
                }
                (half_turn, phi, jet, from_zero) = (skipped, ends, None, false);
                if search.limit.is_some_and(|l| l <= phi) {
                    return Verdict::Clear(None);
                }
                continue;
            }
            if begins < to {
                to = begins;
            }
        }
        let mut last = false;
        if let Some(limit) = search.limit
            && limit <= to
        {
            (to, last) = (limit, true);
        }
        let stretch = Stretch { from: phi, to, jet, from_zero };
        let verdict =
            if helping { in_helping(search, stretch, &f) } else { in_opposing(search, stretch, &f) };
        match verdict {
            Verdict::Clear(end) if !last => jet = end.map(|(jet, _)| jet),
            answer @ (Verdict::Zero(_) | Verdict::Clear(_)) => return answer,
        }
        phi = to;
        from_zero = false;
    }
    Verdict::Clear(None)
}

const MOST_STRETCHES: u32 = 64;

fn modulo_two<F: Float>(n: F) -> bool {
    let half = n / F::int(2);
    half != half.floor()
}

/// The zero of a stretch where g ≤ 0: there is one if and only if f < 0 at the end.
fn in_opposing<F: Float, M: Copy>(
    search: &Search<F>,
    stretch: Stretch<F>,
    f: &impl Fn(F) -> (Jet<F>, M),
) -> Verdict<F, M> {
    let Stretch { from, to, jet, .. } = stretch;
    // A hint beyond the stretch says that no zero is expected: the end decides.
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

/// The first zero of the bound `f cos h + f′ sin h + g (1 − cos h)` with g as it is at h = 0; zero where there is none.
fn first_zero_of_bound<F: Float>(jet: Jet<F>) -> F {
    let Jet { value, first, second, .. } = jet;
    let g = second + value;
    let discriminant = first.square() + value * (value - F::int(2) * g);
    if discriminant < F::int(0) {
        return F::int(0);
    }
    let root = discriminant.sqrt();
    // tan(h/2) = f/(√ − f′) = (√ + f′)/(f − 2g): the form without cancellation.
    let h = if first > F::int(0) {
        (root + first).atan2(value - F::int(2) * g)
    } else {
        value.atan2(root - first)
    };
    F::int(2) * h
}

/// The zero of f in (low, high], where it has one at most and is positive before it.
///
/// `below` says that f(high) < 0 is known; otherwise f(high) ≥ 0 means that there is no zero.
fn bracketed<F: Float, M: Copy>(
    search: &Search<F>,
    low: F,
    high: F,
    below: bool,
    guess: F,
    f: &impl Fn(F) -> (Jet<F>, M),
) -> Verdict<F, M> {
    let (begin, end) = (low, high);
    let (mut low, mut high, mut below, mut phi) = (low, high, below, guess);
    let mut last_width = high - low;
    let mut slow = false;
    loop {
        let (jet, motion) = f(phi);
        let zero = F::int(0);
        let at = phi;
        let crossing = |step| Verdict::Zero(Found { at, step, motion, grazes: false });
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
        if jet.first < zero && is_final(search, &jet, phi, step) && next > begin && next <= end {
            return crossing(step);
        }
        let width = high - low;
        if width <= F::epsilon() * high {
            return crossing(zero);
        }
        if !below {
            // Nothing is known beyond `low` but the end to look at.
            phi = if jet.first < zero && next > low && next < end { next } else { end };
            continue;
        }
        let inside = next > low && next < high;
        // Two steps in a row that do not halve the bracket call for a bisection, unless they are already tiny.
        let halved = width * F::int(2) <= last_width;
        let bisect = !inside || (slow && !halved && step.abs() * F::int(64) > width);
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
fn householder<F: Float>(jet: &Jet<F>) -> F {
    let Jet { value, first, second, third } = *jet;
    let (three, six) = (F::int(3), F::int(6));
    let bent = value * second;
    let above = value * (six * first.square() - three * bent);
    let below = six * first * (first.square() - bent) + value.square() * third;
    -above / below
}

/// Whether what a step leaves is below the rounding of φ.
///
/// It leaves a multiple of `h⁴`, which is made of κ = f″h/f′ and of derivatives of the order of `max(1, Ω) h` each.
#[inline]
fn is_final<F: Float>(search: &Search<F>, jet: &Jet<F>, phi: F, step: F) -> bool {
    let curvature = (jet.second * step / jet.first).abs();
    let turned = step.abs() * F::int(1).or_larger(search.omega);
    let left = step.abs() * (curvature + turned) * (curvature + turned).square();
    left <= F::epsilon() / F::int(4) * phi.abs().or_larger(step.abs())
        || jet.value == F::int(0)
        || step.abs() <= F::epsilon() * phi.abs()
}

/// The first zero of a stretch where g ≥ 0.
fn in_helping<F: Float, M: Copy>(
    search: &Search<F>,
    stretch: Stretch<F>,
    f: &impl Fn(F) -> (Jet<F>, M),
) -> Verdict<F, M> {
    let Stretch { from, to, jet, from_zero } = stretch;
    // From zero upwards the cover is π long: the whole stretch.
    if from_zero {
        return Verdict::Clear(None);
    }
    if let Some(j) = jet
        && forward_cover(j) >= to - from
    {
        return Verdict::Clear(None);
    }
    if search.hint > from
        && search.hint < to
        && let Some(found) = polished_guess(search, from, to, f)
    {
        return Verdict::Zero(found);
    }
    let (left, left_motion) = match jet {
        Some(j) => (j, None),
        None => {
            let (j, m) = f(from);
            (j, Some(m))
        }
    };
    let (right, right_motion) = f(to);
    if let Some(motion) = left_motion
        && left.value <= F::int(0)
    {
        // A stretch that begins at a zero to within rounding.
        return Verdict::Zero(Found { at: from, step: F::int(0), motion, grazes: left.first >= F::int(0) });
    }
    if right.value < F::int(0) {
        return bracketed(search, from, to, true, start_of_bracket(from, to, left), f);
    }
    dip(search, (from, left), (to, right), right_motion, f)
}

/// A first guess inside a bracket: where the tangent bound vanishes, or the middle.
fn start_of_bracket<F: Float>(from: F, to: F, left: Jet<F>) -> F {
    let h = first_zero_of_bound(left);
    if h > F::int(0) && from + h < to { from + h } else { (from + to) / F::int(2) }
}

/// How far ahead f is positive where g ≥ 0: the first zero of `f cos h + f′ sin h`.
#[inline]
fn forward_cover<F: Float>(jet: Jet<F>) -> F {
    jet.value.atan2(-jet.first)
}

/// Householder's method from the hint; an answer only where it settles on a downward zero in (from, to].
fn polished_guess<F: Float, M: Copy>(
    search: &Search<F>,
    from: F,
    to: F,
    f: &impl Fn(F) -> (Jet<F>, M),
) -> Option<Found<F, M>> {
    let mut phi = search.hint;
    for _ in 0..MOST_POLISHES {
        let (jet, motion) = f(phi);
        let step = householder(&jet);
        let next = phi + step;
        let inside = next > from && next <= to && jet.first < F::int(0);
        if !inside {
            return None;
        }
        if is_final(search, &jet, phi, step) {
            return Some(Found { at: phi, step, motion, grazes: false });
        }
        phi = next;
    }
    None
}

/// Six steps multiply the good digits by 4⁶: more never pays.
const MOST_POLISHES: u32 = 6;

/// The dip between two points with f ≥ 0 where g ≥ 0: a zero, a grazing, or nothing.
///
/// Each point evaluated in the gap between the two covers replaces the end on its side. Next to a dip the covers of a
/// pair at distance d leave a gap of the order of d², so that the gap closes quadratically.
fn dip<F: Float, M: Copy>(
    search: &Search<F>,
    left: (F, Jet<F>),
    right: (F, Jet<F>),
    right_motion: M,
    f: &impl Fn(F) -> (Jet<F>, M),
) -> Verdict<F, M> {
    let end = right.1;
    let (from, two) = (left.0, F::int(2));
    let mut low = left.0 + forward_cover(left.1);
    let mut high = right.0 - right.1.value.atan2(right.1.first);
    let mut lowest = right;
    for _ in 0..2 * F::PRECISION {
        if low >= high {
            return Verdict::Clear(Some((end, right_motion)));
        }
        let phi = (low + high) / two;
        let (jet, motion) = f(phi);
        // How far below this point the dip can be: f′²/2f″.
        let depth = jet.first.square() / (two * jet.second);
        if jet.value.abs() <= search.noise && depth <= search.noise {
            return Verdict::Zero(Found { at: phi, step: F::int(0), motion, grazes: true });
        }
        if jet.value < F::int(0) {
            return bracketed(search, from, phi, true, (low + phi) / two, f);
        }
        if jet.first < F::int(0) {
            low = phi + forward_cover(jet);
        } else {
            high = phi - jet.value.atan2(jet.first);
        }
        lowest = (phi, jet);
    }
    let (phi, _) = lowest;
    let (_, motion) = f(phi);
    Verdict::Zero(Found { at: phi, step: F::int(0), motion, grazes: true })
}
