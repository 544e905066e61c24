//! The maximum velocity of the half cycle below Ω = d/2, d = √(1 − ζ²), without a search: one of two roots, and a
//! proof that it is the greatest of all.
//!
//! The driven part `R cos Ωs`, `R = Ωα/q`, is a function of the time s since its crest, which lies within the half cycle.
//! With e the phase of the free part at s = 0, and x = e − ds,
//!
//! ```text
//! v  = R cos Ωs + K e^{−ζs} (d cos x − ζ sin x),    v′ = −ΩR sin Ωs + K e^{−ζs} sin x,
//! v″ = −Ω²R cos Ωs − K e^{−ζs} (ζ sin x + d cos x),  K > 0.
//! ```
//!
//! The free part is at a crest where x is a multiple of 2π, in a trough where it is an odd multiple of π, and falls and
//! rises in between. Its crests fall with time, `f(s + 2π/d) = e^{−2πζ/d} f(s)`. Let `s_L ≤ 0 ≤ s_R = s_L + 2π/d` be the two
//! around that of the drive, `e_R = ds_R`, `e_L = −ds_L`, and F the height of the free part at s_L.
//!
//! * **After s_R** the driven part falls, and the free part stays below its crest: v < v(s_R).
//! * **One root on the side of the nearer crest**, at the distance δ from s = 0. There v′ = 0 is
//!   `e^{∓ζδ} sin(e − dδ)/sin Ωδ = ΩR/K`, e = e_R or e_L, and the logarithm of the left side has the derivative
//!   `∓ζ − [d cot(e − dδ) + Ω cot Ωδ]`. For e ≤ π and Ω < d the bracket is at least `2d cot(e/2)` ≥ 0. So the left side
//!   falls on the right, and on the left if `ζ ≤ 2d cot(e_L/2)`. It is one root, too, where v″ < 0 up to the crest, as it
//!   is if `Ω²R cos Ωs_L ≥ F/d`, because the free part's acceleration is at most K e^{−ζs}.
//! * **At most one maximum on the other side.** From s = 0 to the trough v only falls, or rises. Between the trough and
//!   the crest the derivative above has the derivative `(Ω/sin Ωδ)² − (d/sin x)² < 0`: it has one zero at most, and v′ two.
//! * **Where the left crest is the nearer one**, v is less on the right: at a time where f ≥ 0, the mirror image about
//!   s = 0 has the same driven part and no smaller free part, or v(s_L) is larger; where f < 0, `v < R cos Ω(π − e_L)/d`.
//! * **Before s_L**, with `P = 2π/d`, from the trough after each crest s_L − jP to the next crest v is below its value at that
//!   crest, and from the crest to the trough at most `R cos Ω(s_L − (j − ½)P) + F e^{jζP}`, with the free part's velocity at
//!   the start for the last term if the crest is before it. If all these are below the maximum found, so is v.
//!
//! Every comparison is of bounds: where one fails, the search decides ([`super::fastest`]).

use super::free::Free;
use super::rising::Rising;
use crate::float::Float;
use crate::float::circular::{SinCos, TO_HALF_PI};

/// The velocity by the time since the driven part's crest.
struct Crests<F> {
    omega: F,
    free: Free<F>,
    circular: SinCos<F, 8, 8>,
    /// R, K, and the phase e of the free part in [−π, π].
    swing: F,
    size: F,
    phase: F,
    /// The time of the driven part's crest since the start of the half cycle, and the velocity of the free part at that start.
    centre: F,
    start: F,
}

/// v and its first three derivatives.
type Jet<F> = [F; 4];

/// A maximum of the velocity: a time near it since the start of the half cycle, the velocity close by, and more than the
/// maximum exceeds it.
#[derive(Clone, Copy)]
struct Root<F> {
    time: F,
    velocity: F,
    rise: F,
}

impl<F: Float> Rising<F> {
    /// A time near that of the maximum velocity, if it is known to be that below Ω = d/2.
    #[inline(always)]
    pub(super) fn fastest_of_two(&self) -> Option<F> {
        Crests::of(self).fastest()
    }
}

impl<F: Float> Crests<F> {
    #[inline(always)]
    fn of(rising: &Rising<F>) -> Self {
        let (half, circular) = (&rising.half, TO_HALF_PI.of::<F>());
        let (omega, free) = (half.omega, half.free);
        let (a, h) = (rising.amplitude, half.h);
        let drive = a.mul_add(a, h * h).sqrt();
        // Ωτ = π/2 + atan(H/a).
        let turn = F::angle_of(a / drive, -(h / drive));
        let centre = turn * half.inverse;
        let (waves, start) = (free.waves(centre), omega * h);
        let at = free.after(waves, F::int(1) + half.shift, start);
        let (sine, cosine) = (at.a, (at.v + free.zeta * at.a) / free.frequency);
        let size = sine.mul_add(sine, cosine * cosine).sqrt();
        let phase = F::angle_of(sine.abs() / size, cosine / size).times_sign_of(sine);
        Self { omega, free, circular, swing: omega * drive, size, phase, centre, start }
    }

    /// `(sin y, cos y)` for y in [0, π].
    #[inline(always)]
    fn upper(&self, angle: F) -> (F, F) {
        let (s, c) = self.circular.sin_cos(angle - F::pi() * F::ratio(1, 2));
        (c, -s)
    }

    /// At the distance δ from the driven part's crest towards a crest of the free part e away, on the side `side`, where
    /// 0 ≤ x ≤ π: v and its derivatives by δ.
    #[inline(always)]
    fn at(&self, side: F, e: F, delta: F) -> Jet<F> {
        let (Free { zeta, square, frequency: d }, omega) = (self.free, self.omega);
        let ((sin_drive, cos_drive), (sine, cosine)) =
            (self.upper(omega * delta), self.upper(d.mul_add(-delta, e)));
        // By the time towards the crest damping has the sign of the side.
        let zeta = side * zeta;
        let size = self.size * (-(zeta * delta)).exp();
        let (s, c) = (size * sine, size * d * cosine);
        let driven = self.swing * cos_drive;
        let pull = omega * self.swing * sin_drive;
        let bend = omega * omega;
        [
            (-zeta).mul_add(s, driven + c),
            s - pull,
            -(bend.mul_add(driven, zeta.mul_add(s, c))),
            bend.mul_add(pull, zeta.mul_add(zeta, -square).mul_add(s, F::int(2) * zeta * c)),
        ]
    }

    /// The maximum towards a crest e away, which steps of Halley's lead to from this start, if it is not nearer to the
    /// crest of the driven part than `least`.
    #[inline(always)]
    fn root(&self, (side, e): (F, F), least: F, start: F) -> Option<Root<F>> {
        let two = F::int(2);
        let most = e / self.free.frequency;
        let mut delta = start;
        for _ in 0..6 {
            let [velocity, slope, bend, third] = self.at(side, e, delta);
            let step = -(two * slope * bend) / (two * bend).mul_add(bend, -(slope * third));
            // Rounding may lead beyond an end where the root is beside it.
            let next = (delta + step).or_larger(least);
            let is_inside = next <= most;
            if !is_inside {
                return None;
            }
            let is_near = step.abs() <= F::ratio(1, 128) && (third * step).abs() * two <= -bend;
            if is_near {
                let time = side.mul_add(next, self.centre);
                return Some(Root { time, velocity, rise: (slope * step).abs() });
            }
            delta = next;
        }
        None
    }

    #[inline(always)]
    fn fastest(&self) -> Option<F> {
        let (zero, one, two) = (F::int(0), F::int(1), F::int(2));
        let (Free { frequency: d, .. }, omega) = (self.free, self.omega);
        let (side, e) = (one.times_sign_of(self.phase), self.phase.abs());
        // With K for K e^{−ζs} and sin Ωδ = Ω/d sin dδ, x = arg(1 + (Ω²R/dK) e^{ie}).
        let ratio = omega * omega * self.swing / (d * self.size);
        let (sine, cosine) = self.upper(e);
        let (y, x) = (ratio * sine, ratio.mul_add(cosine, one));
        let r = x.mul_add(x, y * y).sqrt();
        let near = self.root((side, e), zero, (e - F::angle_of(y / r, x / r)) / d)?;
        let noise = F::int(32) * F::epsilon() * (self.swing + self.size);
        let certain = near.velocity - noise;
        let beyond = two * F::pi() - e;
        let (left, height) = if side < zero { (e, self.height(e)) } else { (beyond, self.height(beyond)) };
        if (beyond - F::pi()) / d > self.centre && side > zero {
            return Some(near.time);
        }
        if !self.exceeds_earlier(left, height, certain) {
            return None;
        }
        let is_above = if side < zero {
            if !self.is_single(e, height) {
                return None;
            }
            // Where f < 0 there.
            self.swing * self.upper(omega * ((F::pi() - e) / d)).1 <= certain
        } else {
            self.exceeds_left(beyond, height, certain)
        };
        if is_above || self.prevails(-side, beyond) {
            return Some(near.time);
        }
        let far = self.far(-side, beyond)?;
        if far.velocity + far.rise <= certain {
            Some(near.time)
        } else {
            (near.velocity + near.rise <= far.velocity - noise).then_some(far.time)
        }
    }

    /// The maximum between the trough and the crest that is farther away.
    #[inline(always)]
    fn far(&self, side: F, e: F) -> Option<Root<F>> {
        let (Free { zeta, frequency: d, .. }, one) = (self.free, F::int(1));
        // sin x = ΩR sin Ωδ/(K e^{−ζs}) beside the crest.
        let size = self.size * (-(side * zeta * (e / d))).exp();
        let sine = self.omega * self.swing * self.upper(self.omega * (e / d)).0 / size;
        let sine = if sine < one { sine } else { one };
        let x = sine * (sine * sine).mul_add(F::ratio(1, 6), one);
        self.root((side, e), (e - F::pi()) / d, (e - x) / d)
    }

    /// F, the height of the free part at the left crest, e away.
    #[inline(always)]
    fn height(&self, e: F) -> F {
        let Free { zeta, frequency: d, .. } = self.free;
        self.size * d * (zeta * (e / d)).exp()
    }

    /// Whether v″ < 0 up to the left crest.
    #[inline(always)]
    fn is_concave(&self, cosine: F, height: F) -> bool {
        self.omega * self.omega * self.swing * cosine * self.free.frequency >= height
    }

    /// Whether no velocity between the left crest, e away, and the trough after it exceeds this one.
    #[inline(always)]
    fn exceeds_left(&self, e: F, height: F, velocity: F) -> bool {
        let (zero, one, omega) = (F::int(0), F::int(1), self.omega);
        let d = self.free.frequency;
        let (mut s, mut c) = self.upper(omega * (e / d));
        if self.is_concave(c, height) {
            return true;
        }
        // In four parts the free part falls as F e^{−ζt} (cos dt + (ζ/d) sin dt), and the driven part rises.
        let (sin_part, cos_part) = self.upper(omega * (F::pi() * F::ratio(1, 4) / d));
        let (root, ratio) = (F::ratio(1, 2).sqrt(), self.free.zeta / d);
        let mut is_below = true;
        for bound in [one, root * (one + ratio), ratio, zero.or_larger(root * (ratio - one))] {
            // Ω times the distance from the driven part's crest decreases.
            (s, c) = (s.mul_add(cos_part, -(c * sin_part)), c.mul_add(cos_part, s * sin_part));
            is_below &= self.swing.mul_add(c, height * bound) <= velocity;
        }
        is_below
    }

    /// Whether v has one stationary point between the left crest, at most half a turn away, and s = 0.
    #[inline(always)]
    fn is_single(&self, e: F, height: F) -> bool {
        let Free { zeta, frequency: d, .. } = self.free;
        let (sine, cosine) = self.upper(e * F::ratio(1, 2));
        zeta * sine <= F::int(2) * d * cosine || self.is_concave(self.upper(self.omega * (e / d)).1, height)
    }

    /// Whether `ΩR sin Ωδ ≥ K e^{−ζs} sin x` from the trough to the farther crest, e away: then v falls away from the driven
    /// part's crest.
    ///
    /// By sixteenths of a turn. With y = π − x, 0 at the trough, sin x/y falls, and so does sin Ωδ/δ, so that
    /// `sin x/sin Ωδ ≤ (sin y₀/y₀) y₁/sin Ωδ₁` from y₀ to y₁.
    #[inline(always)]
    fn prevails(&self, side: F, e: F) -> bool {
        let (Free { zeta, frequency: d, .. }, pi) = (self.free, F::pi());
        let least = |a: F, b: F| if a < b { a } else { b };
        let part = pi * F::ratio(1, 8) / d;
        let fall = (-(side * zeta * part)).exp();
        let mut delta = (e - pi) / d;
        let mut size = self.size * (-(side * zeta * delta)).exp();
        let mut pull = self.omega * self.swing * self.upper(self.omega * delta).0;
        let (mut sine, mut ratio) = (F::int(0), F::int(1));
        for i in 1..=8 {
            delta = delta + part;
            let next = size * fall;
            let most = size.or_larger(next);
            let at_end = self.omega * self.swing * self.upper(self.omega * delta).0;
            let y = pi * F::ratio(i, 8);
            let sine_at_end = self.upper(y).0;
            if at_end < most * ratio * y && least(pull, at_end) < most * sine.or_larger(sine_at_end) {
                return false;
            }
            (size, pull, sine, ratio) = (next, at_end, sine_at_end, sine_at_end / y);
        }
        true
    }

    /// Whether no velocity before the left crest, e away and of this height, exceeds this one.
    #[inline(always)]
    fn exceeds_earlier(&self, e: F, height: F, velocity: F) -> bool {
        let (Free { zeta, frequency: d, .. }, pi) = (self.free, F::pi());
        let half = pi / d;
        let mut trough = e / d + half;
        if trough >= self.centre {
            return true;
        }
        let growth = (zeta * (half + half)).exp();
        let highest = (self.size * d * (zeta * self.centre).exp()).or_larger(self.start);
        let mut height = height;
        while trough < self.centre {
            height = height * growth;
            let driven = self.swing * self.upper(self.omega * trough).1;
            if driven + highest <= velocity {
                return true;
            }
            // From a crest before the start the free part falls, too.
            let most = if trough + half > self.centre { self.start } else { height };
            if driven + most > velocity {
                return false;
            }
            trough = trough + (half + half);
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use crate::cycle::damped::border;
    use crate::cycle::damped::fastest::fastest_time;
    use crate::cycle::damped::half_period::HalfPeriod;
    use crate::cycle::damped::rising::Rising;
    use crate::drawn::cases;
    use proptest::prelude::*;

    fn rising(turns: f64, zeta: f64, over: f64) -> Rising<f64> {
        // Ω is 1/turns of the highest for which this is needed.
        let half = HalfPeriod::new((1.0 - zeta * zeta).sqrt() / 2.0 / turns, zeta);
        Rising::of_force(half, border(&half).min_force_ratio * over)
    }

    proptest! {
        #![proptest_config(cases(4000))]

        /// No velocity of the search is above the one found, on and above the border and where two maxima are as large.
        #[test]
        fn it_is_that_of_the_search(
            turns in prop_oneof![1.0001f64..3.0, 1.0f64..30.0, (1i32..6, -9f64..-1.0).prop_map(|(n, e)| f64::from(n) + 10f64.powf(e))],
            zeta in prop_oneof![(-9.0f64..0.0).prop_map(|e| 10f64.powf(e)), 0.001f64..0.999],
            over in prop_oneof![Just(1.0), 1.0f64..1.2, 1.0f64..6.0, 1.0f64..1000.0],
        ) {
            let rising = rising(turns, zeta, over);
            if let Some(tau) = rising.fastest_of_two() {
                let searched = fastest_time(&rising.vibration());
                let velocity = |tau| rising.velocity(&rising.at(tau))[0];
                let noise = 64.0 * f64::EPSILON * (rising.swing() + 1.0 + rising.half.h.abs());
                let found = rising.arrive(tau).map(|found| found.velocity * rising.half.omega);
                prop_assert!(found.is_none_or(|found| (found - velocity(searched)).abs() <= noise), "{tau} {searched}");
                // The time may be the other one of two.
                prop_assert!(velocity(tau) >= velocity(searched) * (1.0 - 1e-4), "{tau} {searched}");
            }
        }
    }

    #[test]
    fn most_need_no_search() {
        let (mut all, mut found) = (0, 0);
        for i in 0..60 {
            for zeta in [1e-6, 0.01, 0.05, 0.2, 0.5, 0.8] {
                for over in [1.0, 1.05, 1.5, 3.0] {
                    let rising = rising(1.003 + f64::from(i) / 7.0, zeta, over);
                    all += 1;
                    found += u32::from(rising.fastest_of_two().is_some());
                }
            }
        }
        assert!(25 * found >= 24 * all, "{found} of {all}");
    }
}
