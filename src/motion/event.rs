//! The next zero of a vibration, with a proof that there is none before it.
//!
//! # Assumptions
//!
//! `f″ + 2ζf′ + f = g`, the derivatives of f up to the third at any φ, and `g ∝ ± cos(Ωφ + const)`: a right
//! side whose sign changes exactly once in each half turn of the drive. Along a slide the speed `f = s w` is
//! such a function, with `g = s αΩ cos θ`, and so is the acceleration.
//!
//! # Proof
//!
//! On a stretch shorter than π (in natural time) where g keeps its sign and f > 0 at the beginning, by
//! Sturm's comparison with the free vibration:
//!
//! * **g ≤ 0** (opposing). f/sin is concave in the sense of Sturm: f crosses zero once at most, and it does
//!   if and only if f < 0 at the end.
//! * **g ≥ 0** (helping). From any point, forward and backward, `f(φ ± h) ≥ f cos h ± f′ sin h` for
//!   0 ≤ h ≤ π: f does not vanish before that bound does, at `h = atan2(f, ∓f′)`, the *cover* of that point.
//!   f < 0 at the end means exactly one zero. Otherwise both ends have a cover, and where the two do not meet
//!   f has a single dip in between, which is searched until it is found below zero, covered, or touching zero
//!   to within the rounding of f: *grazing*.
//! * In both cases a zero with f′ < 0 is the **first**: in the first case it is the only one, in the second
//!   the backward cover from it is `−f′ sin h > 0` over the whole stretch. So a zero that was predicted and
//!   refined needs no further proof.
//!
//! **With damping** the same holds for `u = e^{ζφ} f`, which has the zeros and the signs of f: `u″ + (1 − ζ²)
//! u = e^{ζφ} g`, with a right side of the sign of g. A stretch may be as long as π/√(1 − ζ²), and of any
//! length for ζ ≥ 1, where a free vibration vanishes at most once. The covers are those of u (`cover`).
//!
//! These are statements of exact arithmetic. In floating point, four quantities are used as computed, without
//! a margin for their rounding: f > 0 at the beginning of a stretch, the sign of f at its end, the covers,
//! and the place where g changes its sign. A dip counts as grazing where it is within `4ε` of the sum of the
//! terms of f. A zero can therefore be missed, or a grazing reported without one, where f comes that close to
//! zero without clearly crossing it. There, the next float of an input gives the other answer.
//!
//! # Work
//!
//! [`next_zero`] examines the stretches in order. A slide lasts at most `π(1 + 1/Ω)` of natural time, because
//! `w(φ) + w(φ + π)` does not contain the natural vibration and changes sign every π/Ω. For 1/2 ≤ Ω ≤ 2 that
//! is at most 3π of natural time and four changes of sign of g, hence **at most 8 stretches** of up to 3⅛
//! radians. Outside this range, f is the sum of a slow and a fast wave of amplitudes G and r. While the slow
//! wave exceeds the amplitude of the fast one there is no zero, and that part is skipped
//! ([`search::Safe`]). The remaining part of a window contains a zero once it is as long as the fast
//! period, up to the rounding of the window's ends. Each window is at least half a slow period long, and not
//! shorter than the fast period. So at most the end of one window and one fast period in the next are
//! examined: two fast periods, again 8 stretches, or a few more where rounding matters. A search beyond
//! `π(1 + 2/Ω)`, one change of sign more than any slide, is [`Verdict::Lost`]: an error, never an answer. With
//! damping the skipped part is recomputed from the current position (`window`), because the free wave decays,
//! and the bound on the time differs.
//!
//! Within a stretch a bracket is halved at each step after the first PRECISION, so that it is closed after as
//! many more. Each point in a dip halves the gap between the covers at least, so that after 2·PRECISION of
//! them it is 4ε² wide: f varies within it by less than 4ε² times its slope, far below the rounding of f. A
//! dip at less than ε of the gap's end is approached by geometric means, 32 of them at most.
//! Should f not be at zero to within its rounding there, that is [`Verdict::Lost`], too. Together **at most
//! 4·PRECISION + 40 evaluations a stretch**. In practice Householder's steps (Householder 1970) quadruple the
//! good digits: 3.7 evaluations a slide on average over 40,000 slides of every kind (a test holds 3.76 on
//! average and 14 at most), 1 or 2 in a steady motion.

pub(crate) mod cover;
pub(crate) mod expect;
pub(crate) mod fastest;
pub(crate) mod search;
pub(crate) mod stretch;
pub(crate) mod velocity_zero;
pub(crate) mod window;

use super::slide::motion::SlideJet;
use crate::float::Float;
use search::{Verdict, ZeroSearch};
use stretch::{Stretch, in_helping, in_opposing};
use window::VelocityWaves;

/// The first zero of f after φ = 0 and up to the limit, where `start` is f at φ = 0. If there is none, the
/// result is clear, and contains f at the limit if that was computed.
///
/// `f` returns the function at an instant, together with any other value that the caller needs of that
/// instant.
pub(crate) fn next_zero<F: Float, M: Copy>(
    search: &ZeroSearch<'_, F>,
    start: SlideJet<F>,
    f: impl Fn(F) -> (SlideJet<F>, M),
) -> Verdict<F, M> {
    let longest = search.cover.longest();
    let mut phi = F::int(0);
    let mut jet = Some(start);
    let mut from_zero = search.from_zero;
    let quarter = F::pi() / F::int(2);
    let mut half_turn = F::int(0);
    let mut helping = search.helping;
    // From rest there is no zero within the rounding of a phase: an apparent one is rounding, and the slide
    // would follow itself.
    let mut passed = if from_zero { F::int(4) * F::epsilon() / search.omega } else { phi };
    if from_zero && search.limit.is_some_and(|limit| limit <= passed) {
        return Verdict::Clear(None);
    }
    // The window at which a stretch ended: if it were computed again from there, rounding could leave a
    // remainder of the stretch.
    let mut entered = None;
    let mut waves = None;
    for stretches in 0..u32::MAX {
        if stretches >= USUAL_STRETCHES && is_overdue(search, phi, stretches) {
            return Verdict::Lost(phi);
        }
        let boundary = (quarter - search.angle + half_turn * F::pi()) / search.omega;
        if boundary <= passed {
            half_turn = half_turn + F::int(1);
            helping = !helping;
            continue;
        }
        let mut to = boundary;
        if phi + longest < to {
            to = phi + longest;
        }
        if let Some(safe) = &search.safe {
            let (begins, ends) = entered.take().unwrap_or_else(|| safe.next(phi));
            let is_empty = begins >= ends;
            if is_empty {
                // The window is narrower than its rounding.
            } else if begins <= phi {
                let skipped = search.half_turn_at(ends);
                if modulo_two(skipped - half_turn) {
                    helping = !helping;
                }
                (half_turn, phi, passed, jet, from_zero) = (skipped, ends, ends, None, false);
                if search.limit.is_some_and(|l| l <= phi) {
                    return Verdict::Clear(None);
                }
                continue;
            } else if begins < to {
                to = begins;
                entered = Some((begins, ends));
            }
        }
        if let Some(slide) = search.waves
            && !from_zero
            && let Some(ends) = waves.get_or_insert_with(|| VelocityWaves::of(slide)).end(phi)
        {
            let skipped = search.half_turn_at(ends);
            if modulo_two(skipped - half_turn) {
                helping = !helping;
            }
            (half_turn, phi, passed, jet) = (skipped, ends, ends, None);
            if search.limit.is_some_and(|l| l <= phi) {
                return Verdict::Clear(None);
            }
            continue;
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
            answer @ (Verdict::Zero(_) | Verdict::Clear(_) | Verdict::Lost(_)) => return answer,
        }
        (phi, passed) = (to, to);
        from_zero = false;
    }
    Verdict::Lost(phi)
}

/// Stretches that are examined before the time is checked.
const USUAL_STRETCHES: u32 = 64;

/// Whether φ is beyond the longest slide, with a half turn more for rounding, or so late that its phase has no digits, or there were more
/// stretches than such a time can contain.
#[cold]
#[inline(never)]
fn is_overdue<F: Float>(search: &ZeroSearch<'_, F>, phi: F, stretches: u32) -> bool {
    let (one, two, omega) = (F::int(1), F::int(2), search.omega);
    let usual = F::pi() * (one + two / omega);
    let longest = search.waves.map_or(usual, |slide| VelocityWaves::of(slide).longest());
    // A damped slide can last longer, and may then have more stretches in proportion.
    let times = if longest > usual { longest / usual } else { one };
    let most = F::int(8) * (F::int(8) + omega + one / omega) * times;
    // A half turn of the drive is no longer told from the next one: without a spring a body far from its place creeps so long.
    let is_lost = omega * phi * F::epsilon() * F::int(16) > one;
    is_lost || phi > longest || F::from_f64(f64::from(stretches)) > most
}

fn modulo_two<F: Float>(n: F) -> bool {
    let half = n / F::int(2);
    half != half.floor()
}

#[cfg(test)]
mod tests {
    use super::{SlideJet, Verdict, ZeroSearch, next_zero};
    use crate::cycle::damped::free::Free;
    use crate::motion::event::cover::Cover;
    use std::cell::Cell;
    use std::f64::consts::PI;

    fn search(omega: f64, limit: Option<f64>) -> ZeroSearch<'static, f64> {
        let (from_zero, safe, short_noise) = (false, None, None);
        ZeroSearch {
            omega,
            pace: omega.max(1.0),
            cover: Cover::new(Free::new(0.0)),
            waves: None,
            angle: 0.3,
            helping: true,
            from_zero,
            limit,
            hint: 1.0,
            safe,
            noise: 1e-15,
            short_noise,
        }
    }

    /// For a function without a zero, unlike the velocity of any slide, the search ends without an answer.
    #[test]
    fn a_search_that_passes_its_bound_says_so() {
        for omega in [1e-3, 0.3, 0.7, 1.0, 1.9, 40.0] {
            let jet = SlideJet { value: 1.0, first: 0.0, second: 0.0, third: 0.0 };
            let evaluations = Cell::new(0);
            let f = |_| {
                evaluations.set(evaluations.get() + 1);
                (jet, ())
            };
            let Verdict::Lost(phi) = next_zero(&search(omega, None), jet, f) else { panic!("Ω = {omega}") };
            assert!(
                phi > PI * (1.0 + 2.0 / omega) && phi < 300.0 + 2.0 * PI * (1.0 + 2.0 / omega),
                "{omega}: {phi}"
            );
            assert!(f64::from(evaluations.get()) < 10.0 * (64.0 + omega + 1.0 / omega), "{omega}");
            // With an earlier limit, the search stops there.
            assert!(matches!(next_zero(&search(omega, Some(2.0)), jet, f), Verdict::Clear(_)), "{omega}");
        }
    }
}
