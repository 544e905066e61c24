//! The peak velocity of a half cycle with a single stationary point of the velocity, which is known
//! beforehand for most Ω ≥ d/2, d = √(1 − ζ²).
//!
//! # One stationary point
//!
//! In the velocity v the driven part drops out of `v″ + Ω²v = p`, `p = h‴ + Ω²h′`, and p is a free vibration. Let the
//! body not stick: v > 0 within the half cycle, and v = 0 at its ends. Let Ω ≥ d/2: then p has at most two zeros in the
//! half cycle, and because p(0) + p(T) = 4ζ > 0 it is not negative at both ends (`border`). **If p ≤ 0 in the middle,
//! v has one stationary point**, its maximum:
//!
//! * Where p ≤ 0, v″ = p − Ω²v < 0.
//! * Where p > 0 before the middle, it is so from the start on, and `v′ = v′(0) cos Ωτ + ∫ p(s) cos Ω(τ − s) ds > 0`,
//!   because v′(0) ≥ 0 and no angle exceeds π/2. Likewise v′ < 0 where p > 0 after the middle.
//!
//! So v′ is positive, decreases through zero, and is negative.
//!
//! In the middle h = sech(AT/2) (1, 0)ᵀ, A being the matrix of free vibration, and the partial fractions of sech give
//!
//! ```text
//! p(T/2) = (8ζΩ⁴/π) Σ (−1)^((n−1)/2) n(n² − 1)/D_n,   D_n = (n²Ω² − 1)² + 4ζ²n²Ω²,   n = 3, 5, 7, …
//! ```
//!
//! The first term is negative, and where the terms decrease in size so is the sum. With u = n²Ω² they do if
//! `3u² + (10 − 20ζ²) u ≥ 13`, and if that holds for n = 3 it holds for all. Where [`Tangent`](super::tangent::Tangent)
//! is accurate, Ω ≥ 1/2 and `(π/2Ω)² ζ² ≤ 3/2` give u ≥ 9/4 and ζ² ≤ u/14, and it does hold. Elsewhere p(T/2) is
//! computed.
//!
//! # The iteration
//!
//! It is that of [`mod@super::middle`]. Where that does not reach, Taylor's formula of the seventh order leads from the
//! middle, or a search from anywhere, close to the maximum, and is applied there once more (`cycle::arrival`): with the
//! velocity, the acceleration and the displacement in pairs, because a flat maximum has its time only to the digits that
//! are left of the acceleration.

use super::border::has_lobes;
use super::free::{Free, FreeState, Waves};
use super::half_period::HalfPeriod;
use super::middle::{Constants, Crest, slopes};
use super::rising::{Moment, Rising, Vibration};
use super::wide::{WideState, WideWaves};
use crate::cycle::velocity::arrival::{Arrived, Nearby, Reciprocals};
use crate::float::pair::Pair;
use crate::float::{Field, Float, fused};

/// The time of the peak velocity, and its value.
#[derive(Clone, Copy)]
pub(crate) struct Summit<F> {
    /// The time since the middle of the half cycle, in 1/ω_n.
    pub(crate) sigma: F,
    /// V₀/(Bω_d).
    pub(crate) velocity: F,
    /// x/B.
    pub(crate) displacement: F,
}

impl<F: Float> Rising<F> {
    /// The peak velocity.
    pub(crate) fn summit(&self) -> Summit<F> {
        if F::PRECISION <= f64::MANTISSA_DIGITS
            && let Some(found) = self.one_summit()
        {
            return found.differentiated(self);
        }
        if F::PRECISION <= f64::MANTISSA_DIGITS
            && let Some(found) = self.summit_of_two()
        {
            return found.differentiated(self);
        }
        let tau = super::fastest::fastest_time(&self.vibration());
        if F::PRECISION <= f64::MANTISSA_DIGITS
            && let Some(found) = self.summit_near(tau)
        {
            return found.differentiated(self);
        }
        let moment = self.at(tau);
        let [velocity, slope, _] = self.velocity(&moment);
        let Self { half: HalfPeriod { omega, period, .. }, .. } = *self;
        Summit {
            sigma: tau - period / F::int(2),
            velocity: velocity / omega,
            displacement: self.displacement_by(&moment, slope),
        }
    }

    /// Whether the velocity has one stationary point, by the proof above, given the middle.
    #[inline(always)]
    fn has_one_summit(&self, middle: &FreeState<F>) -> bool {
        let (half, n) = (&self.half, F::int);
        let (u, square) = (n(9) * half.omega.square(), half.free.zeta.square());
        let is_falling = n(3) * u.square() + (n(10) - n(20) * square) * u >= n(13);
        let is_not_above = is_falling || half.weighted(middle.v, middle.x) <= n(0);
        !has_lobes(half) && self.does_not_stick() && is_not_above
    }

    /// Whether x″ ≥ 0 at the start but for rounding.
    #[inline(always)]
    pub(crate) fn does_not_stick(&self) -> bool {
        self.deceleration() >= -(F::int(8) * F::epsilon() * self.half.holding())
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
    /// The maximum of the velocity near a moment, by Taylor's formula: the time until then, and as displacement the
    /// amount to subtract from that at the moment. `(s, c)` are sine and cosine of Ωτ.
    ///
    /// `x″ + 2ζx′ + x = f − 1` makes every derivative of the two before and one of the drive.
    #[inline(always)]
    fn fastest_near(&self, (s, c): (F, F), [velocity, f0]: [F; 2]) -> Arrived<F> {
        let ((along, across), omega) = (self.force(), self.omega);
        let (zeta, square) = (self.free.zeta, omega.square());
        let drives = [omega * (across * c - along * s), -(square * (along * c + across * s))];
        let slopes = slopes((omega, zeta), [velocity, f0], drives);
        let slower = self.fastest_turn();
        Nearby { psi: F::int(0), velocity, slopes, displacement: F::int(0), slower }
            .fastest(&Reciprocals::new())
    }

    /// The time in which the fastest of its waves turns by 1.
    #[inline(always)]
    fn fastest_turn(&self) -> F {
        let damping = F::int(2) * self.free.zeta;
        F::int(1) / self.omega.or_larger(F::int(1)).or_larger(damping)
    }
}

impl<F: Float> Rising<F> {
    /// The peak velocity, if it is known to be the only stationary one, and close enough.
    #[inline(always)]
    fn one_summit(&self) -> Option<Summit<F>> {
        let rising = self;
        fused!(<'a, F>(rising: &'a Rising<F>) -> Option<Summit<F>> {
            rising.summit_by_series().or_else(|| rising.summit_by_steps())
        })
    }

    /// As a batch finds it.
    #[inline(always)]
    fn summit_by_series(&self) -> Option<Summit<F>> {
        let HalfPeriod { omega, free: Free { zeta, .. }, .. } = self.half;
        let displacement = Pair::new(self.max_displacement, self.rest);
        let (along, across) = self.drive();
        let drive = (along.value(), across.value());
        let found = self.half.middle()?.arrive(&Constants::new(), (omega, zeta), drive, displacement);
        let Crest { sigma, velocity, displacement, is_found } = found;
        (is_found && self.does_not_stick()).then_some(Summit { sigma, velocity, displacement })
    }

    #[inline(always)]
    fn summit_by_steps(&self) -> Option<Summit<F>> {
        let (motion, middle, half) = (self.vibration(), self.middle(), &self.half);
        if !self.has_one_summit(&middle.free) {
            return None;
        }
        let velocity = half.omega * self.amplitude + middle.free.v;
        let slope = half.omega.square() * half.h + middle.free.a;
        let start = motion.fastest_near(middle.drive, [velocity, slope]).psi;
        self.summit_near(middle.tau + start)
    }

    /// The peak velocity below Ω = d/2, where it is known without a search.
    fn summit_of_two(&self) -> Option<Summit<F>> {
        if !has_lobes(&self.half) {
            return None;
        }
        let rising = self;
        fused!(<'a, F>(rising: &'a Rising<F>) -> Option<Summit<F>> {
            let tau = rising.fastest_of_two()?;
            // With so small a displacement or after so many turns, pairs would have no more digits than the type.
            if tau * F::epsilon() * F::exp2i(12) > F::int(1) {
                return rising.arrive(tau);
            }
            let mut time = Pair::exact(tau);
            for _ in 0..4 {
                if !(time.hi > F::int(0) && time.hi < rising.half.period) {
                    return None;
                }
                let waves = WideWaves::at((rising.half.omega, rising.half.free.zeta), F::int(1), time);
                let (found, next, is_found) = rising.arrive_below(time, &waves);
                if is_found {
                    return Some(found);
                }
                time = next;
            }
            None
        })
    }

    /// The maximum near τ, by Taylor's formula from there.
    fn summit_near(&self, tau: F) -> Option<Summit<F>> {
        let rising = self;
        fused!(<'a, F>(rising: &'a Rising<F>, tau: F) -> Option<Summit<F>> { rising.arrive(tau) })
    }

    /// The maximum velocity near a time τ below Ω = d/2, by the waves there, the time of the next step, and whether it is
    /// near enough; without branches.
    #[inline(always)]
    pub(crate) fn arrive_below(&self, tau: Pair<F>, waves: &WideWaves<F>) -> (Summit<F>, Pair<F>, bool) {
        let (motion, half) = (self.vibration(), &self.half);
        let HalfPeriod { omega, free: Free { zeta, .. }, .. } = *half;
        let [_, shift, h] = half.rest;
        let (shift, h) = (Pair::new(half.shift, shift), Pair::new(half.h, h));
        let rest = Pair::new(self.max_displacement, self.rest);
        let (amplitude, start) = (rest.plus(shift), (Pair::int(1).plus(shift), h * omega));
        let WideState { velocity, acceleration, drive: (s, c) } =
            WideState::of(zeta, start, F::int(1), waves);
        // The driven part of the displacement is −(a cos Ωτ + H sin Ωτ).
        let (along, across) = ((amplitude * c).plus(h * s), (amplitude * s).plus(-(h * c)));
        let displacement = -(along + acceleration + velocity * (F::int(2) * zeta) + Pair::int(1));
        let velocity = across * omega + velocity;
        let slope = (along * omega * omega + acceleration).value();
        let found = motion.fastest_near((s.hi, c.hi), [velocity.hi, slope]);
        let next = tau + Pair::exact(found.psi);
        // From farther away its last correction, whose square it takes at the start, would be too large.
        let is_near = found.psi.abs() * F::int(64) <= motion.fastest_turn();
        let inverse = Pair::reciprocal(omega, half.inverse);
        let middle = Pair::pi() * F::ratio(1, 2) * inverse;
        let summit = Summit {
            sigma: (next - middle).value(),
            velocity: ((velocity + Pair::exact(found.gain)) * inverse).value(),
            displacement: (displacement - Pair::exact(found.displacement)).value(),
        };
        (summit, next, found.is_found & is_near)
    }

    #[inline(always)]
    pub(super) fn arrive(&self, tau: F) -> Option<Summit<F>> {
        let (motion, half) = (self.vibration(), &self.half);
        let middle = Pair::pi() / half.omega * F::ratio(1, 2);
        let mut tau = tau.wide();
        for _ in 0..4 {
            if !(tau.hi > F::int(0) && tau.hi < half.period) {
                return None;
            }
            let HalfCyclePlace { velocity, slope, displacement, drive } = self.place(tau);
            let found = motion.fastest_near(drive, [velocity.hi, slope]);
            tau = tau + Pair::exact(found.psi);
            // From farther away its last correction, whose square it takes at the start, would be too large.
            let is_near = found.psi.abs() * F::int(64) <= motion.fastest_turn();
            if found.is_found && is_near {
                return Some(Summit {
                    sigma: (tau - middle).value(),
                    velocity: ((velocity + Pair::exact(found.gain)) / half.omega).value(),
                    displacement: (displacement - Pair::exact(found.displacement)).value(),
                });
            }
        }
        None
    }

    /// The half cycle at τ, in pairs: in a flat maximum of the velocity the driven and the free acceleration cancel, and
    /// far above Ω = 1 the displacements. Beside Ω = 1 their circular functions would not have digits enough, and both
    /// are computed as one.
    #[inline(always)]
    fn place(&self, tau: Pair<F>) -> HalfCyclePlace<F> {
        let (omega, one) = (self.half.omega, F::int(1));
        // After so many turns, or with so small a displacement, pairs would have no more digits than the type.
        let loss = (tau.hi * omega.or_larger(one)).or_larger(omega.square());
        if self.half.is_resonant || loss * F::epsilon() * F::exp2i(12) > one {
            let at = self.at(tau.value());
            let [velocity, slope, _] = self.velocity(&at);
            let displacement = self.displacement_by(&at, slope);
            return HalfCyclePlace {
                velocity: velocity.wide(),
                slope,
                displacement: displacement.wide(),
                drive: at.drive,
            };
        }
        let rising = self.in_pairs();
        let at = rising.half.wide_at(tau);
        let [velocity, slope, _] = rising.velocity(&at);
        let (s, c) = at.drive;
        let displacement = at.free.x - Pair::int(1) - rising.amplitude * c - rising.half.h * s;
        HalfCyclePlace { velocity, slope: slope.value(), displacement, drive: (s.hi, c.hi) }
    }
}

/// The half cycle at one time: `x′/(B ω_n)`, `x″/(B ω_n²)`, x/B, and sine and cosine of Ωτ.
struct HalfCyclePlace<F> {
    velocity: Pair<F>,
    slope: F,
    displacement: Pair<F>,
    drive: (F, F),
}

impl<F: Float> Summit<F> {
    /// This time of the half cycle with its derivatives: τ as the root of x″ = 0, the velocity at the constant τ, where it is
    /// stationary.
    #[inline]
    fn differentiated(self, rising: &Rising<F>) -> Self {
        let middle = rising.half.period / F::int(2);
        let sigma = self.sigma.implicit_root(|sigma| {
            let [_, slope, curvature] = rising.velocity(&rising.at(middle + sigma));
            (slope, curvature)
        });
        let at = |sigma| rising.at(middle + sigma);
        let velocity =
            self.velocity.differentiated_as(|| rising.velocity(&at(sigma.constant()))[0] / rising.half.omega);
        let displacement = self.displacement.differentiated_as(|| rising.displacement(&at(sigma)));
        Self { sigma, velocity, displacement }
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

    fn rising(omega: f64, zeta: f64, over: f64) -> Rising<f64> {
        let half = HalfPeriod::new(omega, zeta);
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
                let (omega, middle) = (rising.half.omega, rising.half.period / 2.0);
                let tau = fastest_time(&rising.vibration());
                let [velocity, _, curvature] = rising.velocity(&rising.at(tau));
                let noise = 64.0 * f64::EPSILON * (rising.swing() + 1.0 + rising.half.h.abs());
                prop_assert!((omega * found.velocity - velocity).abs() <= noise, "{} {velocity}", found.velocity);
                // A time is as accurate as the slope, which grows with the distance from it.
                let rounding = noise * omega.max(1.0) / curvature.abs() + 4.0 * f64::EPSILON * tau;
                prop_assert!((middle + found.sigma - tau).abs() <= rounding, "{} {tau}", found.sigma);
                let there = rising.displacement(&rising.at(middle + found.sigma));
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
            if rising.half.middle().is_some() || rising.has_one_summit(&rising.middle().free) {
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
