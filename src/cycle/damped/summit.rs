//! The maximum velocity of a half cycle with a single stationary point of the velocity, which is known
//! beforehand for most Ω ≥ d/2, d = √(1 − ζ²).
//!
//! On the half cycle sin Ωτ > 0, and with `u = x″/sin Ωτ`
//!
//! ```text
//! u′ sin² Ωτ = W = x‴ sin Ωτ − Ω x″ cos Ωτ,   W′ = p′ sin Ωτ,   p = h‴ + Ω²h′,
//! ```
//!
//! because the driven part drops out of `x⁗ + Ω²x″`. At both ends W = −Ω |x″| ≤ 0, since the body starts with
//! x″ ≥ 0 and arrives with x″ ≤ 0. Where W < 0 throughout, u decreases from +∞ to −∞, x″ has **one zero**,
//! and the velocity has one stationary point, its maximum. W is greatest at an end or where p′ decreases
//! through zero. p′ is a free vibration, whose zeros are known, π/d apart, with at most one for ζ ≥ 1. So for
//! Ω ≥ d there is at most one in the half cycle, and the signs of p′ at the ends decide. For Ω ≥ d/2 there
//! are at most two, p′ decreases through one of them, and W must be evaluated there.
//!
//! **The iteration** is that of the motion without damping (`cycle::arrival`): in the middle of the
//! half cycle the state is known without circular functions; Taylor's formula of the seventh order leads
//! close to the maximum, and is applied there once more.

use super::free::Waves;
use super::rising::{Moment, Rising, Vibration};
use crate::cycle::arrival::{Arrived, Nearby, Reciprocals};
use crate::float::{Float, fused};

/// The time of the maximum velocity, and its value.
#[derive(Clone, Copy)]
pub(crate) struct Summit<F> {
    /// τ.
    pub(crate) tau: F,
    /// x′/(Bω_n).
    pub(crate) velocity: F,
    /// x/B.
    pub(crate) displacement: F,
}

impl<F: Float> Rising<F> {
    /// The maximum velocity.
    pub(crate) fn summit(&self) -> Summit<F> {
        if F::PRECISION <= f64::MANTISSA_DIGITS
            && let Some(found) = self.one_summit()
        {
            return found.differentiated(self);
        }
        let tau = super::fastest::fastest_time(&self.vibration());
        let moment = self.at(tau);
        let [velocity, slope, _] = self.velocity(&moment);
        Summit { tau, velocity, displacement: self.displacement_by(&moment, slope) }
    }

    /// Whether the velocity has one stationary point, by the proof above.
    #[inline(always)]
    fn has_one_summit(&self, motion: &Vibration<F>) -> bool {
        let (zero, one, half) = (F::int(0), F::int(1), &self.half);
        let (free, omega, b) = (&half.free, half.omega, half.omega * half.h);
        let is_fast = !free.swings() || omega >= free.frequency;
        if self.deceleration() < zero || !(is_fast || omega + omega >= free.frequency) {
            return false;
        }
        // p′ and p″ by h and h′.
        let rates = |x: F, v: F| {
            let a = -(x + F::int(2) * free.zeta * v);
            let jerk = -(v + F::int(2) * free.zeta * a);
            (half.weighted(a, v), half.weighted(jerk, a))
        };
        let (first, change) = rates(one + half.shift, b);
        let (last, _) = rates(one - half.shift, -b);
        if is_fast && (first <= zero || last >= zero) {
            return true;
        }
        if !free.swings() {
            return false;
        }
        // p′ = e^{−ζτ} P cos(dτ − χ) decreases through zero at dτ = χ + π/2.
        let angle = ((change + free.zeta * first) / free.frequency).atan2(first) + F::pi() * F::ratio(1, 2);
        let angle = if angle <= zero { angle + F::int(2) * F::pi() } else { angle };
        let tau = angle / free.frequency;
        if tau >= half.period {
            return true;
        }
        let at = motion.at(tau);
        let [_, slope, curvature] = motion.velocity(&at);
        let size = omega.square() * omega * (self.amplitude + half.h.abs()) + one + b.abs();
        let (s, c) = at.drive;
        curvature * s - omega * slope * c < -(F::epsilon().sqrt() * size)
    }

    /// The state in the middle of the half cycle, to half the digits: by `e^{−ζT} = c² + d²s²` and
    /// `e^{−ζT} cos dT = c² − d²s²`, c and s being the waves there, s > 0 because dT ≤ 2π.
    #[inline(always)]
    fn middle(&self) -> Moment<F> {
        let (half, two) = (&self.half, F::int(2));
        let cosine = ((half.decay + half.cosine) / two).or_larger(F::int(0)).sqrt().with_sign_of(half.sine);
        let sine = ((half.decay - half.cosine) / (two * half.free.square)).sqrt();
        let waves = Waves { cosine, sine };
        let free = half.free.after(waves, F::int(1) + half.shift, half.omega * half.h);
        Moment { tau: half.period / two, drive: (F::int(1), F::int(0)), waves, free }
    }
}

impl<F: Float> Vibration<F> {
    /// The maximum of the velocity near a moment, by Taylor's formula; the displacement is the amount to
    /// subtract from that at the moment.
    ///
    /// `x″ + 2ζx′ + x = f − 1` makes every derivative of the two before and one of the drive.
    #[inline(always)]
    fn fastest_near(&self, at: &Moment<F>, [velocity, f0]: [F; 2]) -> Arrived<F> {
        let ((along, across), (s, c), omega) = (self.force(), at.drive, self.omega);
        let (square, damping) = (omega.square(), F::int(-2) * self.free.zeta);
        let odd = omega * (across * c - along * s);
        let even = -(square * (along * c + across * s));
        let (odd3, even4) = (-(square * odd), -(square * even));
        let (odd5, even6) = (-(square * odd3), -(square * even4));
        let f1 = damping.mul_add(f0, odd - velocity);
        let f2 = damping.mul_add(f1, even - f0);
        let f3 = damping.mul_add(f2, odd3 - f1);
        let f4 = damping.mul_add(f3, even4 - f2);
        let f5 = damping.mul_add(f4, odd5 - f3);
        let f6 = damping.mul_add(f5, even6 - f4);
        let f7 = damping.mul_add(f6, -(square * odd5) - f5);
        let faster = omega.or_larger(F::int(1)).or_larger(-damping);
        let slopes = [f0, f1, f2, f3, f4, f5, f6, f7];
        Nearby { psi: at.tau, velocity, slopes, displacement: F::int(0), slower: F::int(1) / faster }
            .fastest(&Reciprocals::new())
    }
}

impl<F: Float> Rising<F> {
    /// The maximum velocity, if it is known to be the only stationary one, and close enough.
    #[inline(always)]
    fn one_summit(&self) -> Option<Summit<F>> {
        let rising = self;
        fused!(<'a, F>(rising: &'a Rising<F>) -> Option<Summit<F>> {
            let motion = rising.vibration();
            if !rising.has_one_summit(&motion) {
                return None;
            }
            let (middle, half) = (rising.middle(), &rising.half);
            let velocity = half.omega * rising.amplitude + middle.free.v;
            let slope = half.omega.square() * half.h + middle.free.a;
            let mut tau = motion.fastest_near(&middle, [velocity, slope]).psi;
            for _ in 0..4 {
                if !(tau > F::int(0) && tau < half.period) {
                    return None;
                }
                let moment = motion.at(tau);
                let [velocity, slope, _] = motion.velocity(&moment);
                let found = motion.fastest_near(&moment, [velocity, slope]);
                tau = found.psi;
                if found.is_found {
                    let displacement = rising.displacement_by(&moment, slope) - found.displacement;
                    return Some(Summit { tau, velocity: velocity + found.gain, displacement });
                }
            }
            None
        })
    }
}

impl<F: Float> Summit<F> {
    /// The same with its derivatives: τ as the root of x″ = 0, the velocity at the constant τ, where it is
    /// stationary.
    #[inline]
    fn differentiated(self, rising: &Rising<F>) -> Self {
        let tau = self.tau.implicit_root(|tau| {
            let [_, slope, curvature] = rising.velocity(&rising.at(tau));
            (slope, curvature)
        });
        let velocity = self.velocity.differentiated_as(|| rising.velocity(&rising.at(tau.constant()))[0]);
        let displacement = self.displacement.differentiated_as(|| rising.displacement(&rising.at(tau)));
        Self { tau, velocity, displacement }
    }
}

#[cfg(test)]
mod tests {
    use crate::cycle::damped::fastest::fastest_time;
    use crate::cycle::damped::rising::Rising;
    use crate::cycle::damped::{border, half_period_at};
    use crate::drawn::cases;
    use proptest::prelude::*;

    fn rising(omega: f64, zeta: f64, over: f64) -> Rising<f64> {
        let half = half_period_at(omega, zeta);
        Rising::of_force(half, border(&half).min_force_ratio * over)
    }

    /// Half cycles over the range of Ω for this method, any damping ratio, on and above the border.
    fn halves() -> impl Strategy<Value = Rising<f64>> {
        let omega =
            prop_oneof![0.1f64..0.5, 0.5f64..1.2, (0.0f64..3.0).prop_map(|e| 10f64.powf(e)), 0.99f64..1.01];
        let zeta = prop_oneof![(-6.0f64..0.5).prop_map(|e| 10f64.powf(e)), 0.001f64..1.0];
        let over = prop_oneof![Just(1.0), 1.0f64..1.2, 1.0f64..6.0];
        (omega, zeta, over).prop_map(|(omega, zeta, over)| rising(omega, zeta, over))
    }

    proptest! {
        #![proptest_config(cases(4000))]

        /// The result without a search agrees with that of the search.
        #[test]
        fn it_is_that_of_the_search(rising in halves()) {
            if let Some(found) = &rising.one_summit() {
                let tau = fastest_time(&rising.vibration());
                let [velocity, _, curvature] = rising.velocity(&rising.at(tau));
                let noise = 64.0 * f64::EPSILON * (rising.swing() + 1.0 + rising.half.h.abs());
                prop_assert!((found.velocity - velocity).abs() <= noise, "{} {velocity}", found.velocity);
                // A time is as accurate as the slope, which grows with the distance from it.
                let rounding = noise * rising.half.omega.max(1.0) / curvature.abs() + 4.0 * f64::EPSILON * tau;
                prop_assert!((found.tau - tau).abs() <= rounding, "{} {tau}", found.tau);
                let there = rising.displacement(&rising.at(found.tau));
                prop_assert!((found.displacement - there).abs() <= noise + velocity * rounding, "{there}");
            }
        }

        /// Where the proof applies, the slope changes its sign exactly once.
        #[test]
        fn the_proof_is_right(rising in halves()) {
            let motion = rising.vibration();
            let slope = |i: u32| {
                let at = motion.at(rising.half.period * f64::from(i) / 2000.0);
                motion.velocity(&at)[1]
            };
            let (omega, h) = (rising.half.omega, rising.half.h);
            let noise = 64.0 * f64::EPSILON * (rising.swing() * omega.max(1.0) + 1.0 + h.abs());
            if rising.has_one_summit(&motion) {
                let slopes = (1..2000).map(slope).filter(|slope| slope.abs() > noise);
                let signs: Vec<_> = slopes.map(|slope| slope > 0.0).collect();
                prop_assert!(signs.windows(2).all(|pair| pair[0] || !pair[1]));
            }
        }
    }

    /// For Ω ≥ 1/2 nearly every motion needs no search.
    #[test]
    fn most_need_no_search() {
        let (mut all, mut found) = (0, 0);
        for i in 0..100 {
            for zeta in [1e-4, 0.05, 0.3, 2.0] {
                for over in [1.05, 1.5, 3.0] {
                    let rising = rising(0.5 * 10f64.powf(f64::from(i) / 40.0), zeta, over);
                    all += 1;
                    found += usize::from(rising.one_summit().is_some());
                }
            }
        }
        assert!(20 * found >= 19 * all, "{found} of {all}");
    }
}
