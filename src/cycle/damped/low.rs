//! The peak velocity of the half cycle below Ω = d/2, d = √(1 − ζ²), without a search: one of two roots, and a
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

use super::free::{Free, Waves};
use super::lobes::{Constants, reach};
use super::rising::Rising;
use crate::float::Float;

/// The velocity by the time since the driven part's crest.
pub(crate) struct Crests<F> {
    omega: F,
    free: Free<F>,
    over_d: F,
    given: Constants<F>,
    /// R, K, and the phase e of the free part in [−π, π].
    swing: F,
    size: F,
    phase: F,
    /// The time of the driven part's crest since the start of the half cycle, and the velocity of the free part at that start.
    centre: F,
    start: F,
}

/// v and its first three derivatives.
type LowJet<F> = [F; 4];

/// A maximum of the velocity: a time near it since the start of the half cycle, the velocity close by, and more than the
/// maximum exceeds it.
#[derive(Clone, Copy)]
struct Root<F> {
    time: F,
    velocity: F,
    rise: F,
}

impl<F: Float> Rising<F> {
    /// A time near that of the peak velocity, if it is known to be that below Ω = d/2.
    #[inline(always)]
    pub(super) fn fastest_of_two(&self) -> Option<F> {
        Crests::of(self, Constants::new()).fastest()
    }
}

/// The steps to the maximum towards the nearer crest, of which each is a loop of its own in a batch.
#[cfg(feature = "batch")]
#[derive(Clone, Copy)]
pub(crate) struct Climb<F> {
    /// The distance from the driven part's crest after the last step.
    pub(crate) delta: F,
    /// Whether another step may find the maximum, and whether one has.
    pub(crate) is_open: bool,
    pub(crate) is_found: bool,
    /// A time near the maximum that was found, and the velocity close by.
    pub(crate) time: F,
    pub(crate) velocity: F,
}

/// By parts without branches, for batches.
#[cfg(feature = "batch")]
impl<F: Float> Crests<F> {
    #[inline(always)]
    pub(crate) fn of_parts(
        (omega, zeta): (F, F),
        [frequency, over_d, swing, size, phase, centre, start]: [F; 7],
        given: &Constants<F>,
    ) -> Self {
        let free = Free { frequency, ..Free::new(zeta) };
        Self { omega, free, over_d, given: *given, swing, size, phase, centre, start }
    }

    /// Before the first step.
    #[inline(always)]
    pub(crate) fn foot(&self) -> Climb<F> {
        let (delta, zero) = (self.first_guess(self.phase.abs()), F::int(0));
        Climb { delta, is_open: true, is_found: false, time: zero, velocity: zero }
    }

    /// The next step.
    #[inline(always)]
    pub(crate) fn climb(&self, from: &Climb<F>) -> Climb<F> {
        let towards = (F::int(1).times_sign_of(self.phase), self.phase.abs());
        let (Root { time, velocity, .. }, delta, is_inside, is_near) =
            self.step(towards, F::int(0), from.delta);
        let is_now = from.is_open & is_inside & is_near;
        Climb {
            delta,
            is_open: from.is_open & is_inside & !is_near,
            is_found: from.is_found | is_now,
            time: if is_now { time } else { from.time },
            velocity: if is_now { velocity } else { from.velocity },
        }
    }
}

impl<F: Float> Crests<F> {
    #[inline(always)]
    fn of(rising: &Rising<F>, given: Constants<F>) -> Self {
        let Free { zeta, frequency, .. } = rising.half.free;
        let over_d = F::int(1) / frequency;
        let [swing, centre, start] = Self::driven(rising);
        let is_far = (zeta * centre > reach()) | (centre > F::int(1024));
        let waves = if is_far {
            rising.half.free.waves(centre)
        } else {
            Self::waves_near(&rising.half.free, over_d, centre, &given)
        };
        let [size, phase] = Self::polar(Self::free_at(rising, over_d, waves));
        Self {
            omega: rising.half.omega,
            free: rising.half.free,
            over_d,
            given,
            swing,
            size,
            phase,
            centre,
            start,
        }
    }

    /// R, the time of the driven part's crest, and the velocity of the free part at the start.
    #[inline(always)]
    pub(crate) fn driven(rising: &Rising<F>) -> [F; 3] {
        let (half, a) = (&rising.half, rising.amplitude);
        let (omega, h) = (half.omega, half.h);
        let drive = a.mul_add(a, h * h).sqrt();
        let over_drive = F::int(1) / drive;
        // Ωτ = π/2 + atan(H/a).
        let turn = F::angle_of(a * over_drive, -(h * over_drive));
        [omega * drive, turn * half.inverse, omega * h]
    }

    /// The waves at a time that is not far.
    #[inline(always)]
    pub(crate) fn waves_near(free: &Free<F>, over_d: F, time: F, given: &Constants<F>) -> Waves<F> {
        let decay = given.exponential.at(-(free.zeta * time));
        let (sine, cosine) = given.circular.turned(free.frequency * time);
        Waves { cosine: decay * cosine, sine: decay * (sine * over_d) }
    }

    /// K times the sine and the cosine of the free part's phase, by the waves at the driven part's crest.
    #[inline(always)]
    pub(crate) fn free_at(rising: &Rising<F>, over_d: F, waves: Waves<F>) -> (F, F) {
        let half = &rising.half;
        let at = half.free.after(waves, F::int(1) + half.shift, half.omega * half.h);
        (at.a, (at.v + half.free.zeta * at.a) * over_d)
    }

    /// K and that phase.
    #[inline(always)]
    pub(crate) fn polar((sine, cosine): (F, F)) -> [F; 2] {
        let size = sine.mul_add(sine, cosine * cosine).sqrt();
        let over_size = F::int(1) / size;
        [size, F::angle_of(sine.abs() * over_size, cosine * over_size).times_sign_of(sine)]
    }

    /// `(sin y, cos y)` for y in [0, π].
    #[inline(always)]
    fn upper(&self, angle: F) -> (F, F) {
        self.given.circular.upper(angle)
    }

    /// At the distance δ from the driven part's crest towards a crest of the free part e away, on the side `side`, where
    /// 0 ≤ x ≤ π: v and its derivatives by δ.
    #[inline(always)]
    fn at(&self, side: F, e: F, delta: F) -> LowJet<F> {
        let (Free { zeta, square, frequency: d }, omega) = (self.free, self.omega);
        let ((sin_drive, cos_drive), (sine, cosine)) =
            (self.upper(omega * delta), self.upper(d.mul_add(-delta, e)));
        // By the time towards the crest damping has the sign of the side.
        let zeta = side * zeta;
        let size = self.size * self.given.exponential.at(-(zeta * delta));
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
        let mut delta = start;
        for _ in 0..6 {
            let (root, next, is_inside, is_near) = self.step((side, e), least, delta);
            if !is_inside {
                return None;
            }
            if is_near {
                return Some(root);
            }
            delta = next;
        }
        None
    }

    /// A step from the distance δ: the maximum if it is near, the next δ, whether that is inside, and near.
    #[inline(always)]
    fn step(&self, (side, e): (F, F), least: F, delta: F) -> (Root<F>, F, bool, bool) {
        let two = F::int(2);
        let [velocity, slope, bend, third] = self.at(side, e, delta);
        let step = -(two * slope * bend) / (two * bend).mul_add(bend, -(slope * third));
        // Rounding may lead beyond an end where the root is beside it.
        let next = (delta + step).or_larger(least);
        let is_near = (step.abs() <= F::ratio(1, 128)) & ((third * step).abs() * two <= -bend);
        let time = side.mul_add(next, self.centre);
        let root = Root { time, velocity, rise: (slope * step).abs() };
        (root, next, next <= e * self.over_d, is_near)
    }

    /// The distance of the maximum from the crest of the driven part where Ωδ and dδ are small.
    #[inline(always)]
    fn first_guess(&self, e: F) -> F {
        let one = F::int(1);
        // With K for K e^{−ζs} and sin Ωδ = Ω/d sin dδ, x = arg(1 + (Ω²R/dK) e^{ie}).
        let ratio = self.omega * self.omega * self.swing / (self.free.frequency * self.size);
        let (sine, cosine) = self.upper(e);
        let (y, x) = (ratio * sine, ratio.mul_add(cosine, one));
        let scale = one / x.mul_add(x, y * y).sqrt();
        (e - F::angle_of(y * scale, x * scale)) * self.over_d
    }

    /// [`Crests::fastest`] by the bounds that most points need, without branches: whether the maximum that was found is the
    /// greatest.
    #[cfg(feature = "batch")]
    #[inline(always)]
    pub(crate) fn is_greatest(&self, top: &Climb<F>) -> bool {
        let (zero, one, two) = (F::int(0), F::int(1), F::int(2));
        let (side, e) = (one.times_sign_of(self.phase), self.phase.abs());
        let certain = top.velocity - self.noise();
        let (is_left, beyond) = (side < zero, two * F::pi() - e);
        let left = if is_left { e } else { beyond };
        let height = self.height(left);
        let is_first = ((beyond - F::pi()) * self.over_d > self.centre) & !is_left;
        let is_earlier_less = self.exceeds_few_earlier(left, height, certain);
        let is_right_less = self.swing * self.upper((F::pi() - e) * (self.omega * self.over_d)).1 <= certain;
        let is_left_less = self.exceeds_left(beyond, height, certain);
        let is_other_less = if is_left { self.is_single(e, height) & is_right_less } else { is_left_less };
        let is_moderate =
            (self.free.zeta * self.centre.or_larger(two * two * F::pi() * self.over_d)) <= reach();
        let has_lobes = self.omega * two < self.free.frequency;
        has_lobes & is_moderate & top.is_found & (is_first | (is_earlier_less & is_other_less))
    }

    /// [`Crests::exceeds_earlier`] without branches, where three troughs suffice.
    #[cfg(feature = "batch")]
    #[inline(always)]
    fn exceeds_few_earlier(&self, e: F, height: F, velocity: F) -> bool {
        let (zeta, half) = (self.free.zeta, F::pi() * self.over_d);
        let growth = self.given.exponential.at(zeta * (half + half));
        let highest = self.highest();
        let (mut trough, mut height) = (e * self.over_d + half, height);
        let (mut is_less, mut is_open) = (false, true);
        for _ in 0..3 {
            height = height * growth;
            let driven = self.swing * self.upper(self.omega * trough).1;
            let is_last = (trough >= self.centre) | (driven + highest <= velocity);
            let most = if trough + half > self.centre { self.start } else { height };
            is_less |= is_open & is_last;
            is_open &= !is_last & (driven + most <= velocity);
            trough = trough + (half + half);
        }
        is_less | (is_open & (trough >= self.centre))
    }

    /// The rounding of a velocity.
    #[inline(always)]
    fn noise(&self) -> F {
        F::int(32) * F::epsilon() * (self.swing + self.size)
    }

    #[inline(always)]
    fn fastest(&self) -> Option<F> {
        let (zero, one, two) = (F::int(0), F::int(1), F::int(2));
        let (side, e) = (one.times_sign_of(self.phase), self.phase.abs());
        if self.free.zeta * two * two * F::pi() * self.over_d > reach() {
            return None;
        }
        let near = self.root((side, e), zero, self.first_guess(e))?;
        let noise = self.noise();
        let certain = near.velocity - noise;
        let beyond = two * F::pi() - e;
        if (beyond - F::pi()) * self.over_d > self.centre && side > zero {
            return Some(near.time);
        }
        let left = if side < zero { e } else { beyond };
        let height = self.height(left);
        if !self.exceeds_earlier(left, height, certain) {
            return None;
        }
        let is_above = if side < zero {
            if !self.is_single(e, height) {
                return None;
            }
            // Where f < 0 there.
            self.swing * self.upper((F::pi() - e) * (self.omega * self.over_d)).1 <= certain
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
        self.size * d * self.given.exponential.at(zeta * e * self.over_d)
    }

    /// No velocity of the free part is above this.
    #[inline(always)]
    fn highest(&self) -> F {
        let growth = self.free.zeta * self.centre;
        let all = self.given.exponential.at(if growth < reach() { growth } else { reach() });
        // Beyond this it is of no use.
        let most =
            if growth <= reach() { self.size * self.free.frequency * all } else { F::int(1) / F::int(0) };
        most.or_larger(self.start)
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
        let (mut s, mut c) = self.upper(omega * (e * self.over_d));
        let is_concave = self.is_concave(c, height);
        // In four parts the free part falls as F e^{−ζt} (cos dt + (ζ/d) sin dt), and the driven part rises.
        let (sin_part, cos_part) = self.upper(omega * (F::pi() * F::ratio(1, 4) * self.over_d));
        let (root, ratio) = (F::ratio(1, 2).sqrt(), self.free.zeta * self.over_d);
        let mut is_below = true;
        for bound in [one, root * (one + ratio), ratio, zero.or_larger(root * (ratio - one))] {
            // Ω times the distance from the driven part's crest decreases.
            (s, c) = (s.mul_add(cos_part, -(c * sin_part)), c.mul_add(cos_part, s * sin_part));
            is_below &= self.swing.mul_add(c, height * bound) <= velocity;
        }
        is_concave | is_below
    }

    /// Whether v has one stationary point between the left crest, at most half a turn away, and s = 0.
    #[inline(always)]
    fn is_single(&self, e: F, height: F) -> bool {
        let Free { zeta, frequency: d, .. } = self.free;
        let (sine, cosine) = self.upper(e * F::ratio(1, 2));
        (zeta * sine <= F::int(2) * d * cosine)
            | self.is_concave(self.upper(self.omega * (e * self.over_d)).1, height)
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
        let (zeta, half) = (self.free.zeta, F::pi() * self.over_d);
        let mut trough = e * self.over_d + half;
        if trough >= self.centre {
            return true;
        }
        let growth = self.given.exponential.at(zeta * (half + half));
        let highest = self.highest();
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
