//! The half cycle in compensated pairs, at up to the precision of f64: where driven and free vibration nearly cancel,
//! in a flat maximum of the velocity or of the border's condition.

use super::free::{Free, Waves, wide_frequency};
use super::half_period::{HalfPeriod, wide_sin_cos};
use super::rising::{Moment, Rising};
use crate::float::pair::Pair;
use crate::float::{Field, Float};

/// Free vibration and the drive at one time.
#[derive(Clone, Copy)]
pub(crate) struct WideState<F> {
    pub(crate) velocity: Pair<F>,
    pub(crate) acceleration: Pair<F>,
    /// (sin Ωτ, cos Ωτ).
    pub(crate) drive: (Pair<F>, Pair<F>),
}

/// The waves of a half cycle at one time, by parts that are loops of their own in a batch.
#[derive(Clone, Copy)]
pub(crate) struct WideWaves<F> {
    /// 1/d.
    pub(crate) over_d: Pair<F>,
    /// (sin dτ, cos dτ).
    pub(crate) swing: (Pair<F>, Pair<F>),
    /// `e^{−ζτ}`.
    pub(crate) decay: Pair<F>,
    /// (sin Ωτ, cos Ωτ).
    pub(crate) drive: (Pair<F>, Pair<F>),
}

impl<F: Float> WideWaves<F> {
    /// For ζ < 1; with `side` −1 backwards in time.
    #[inline(always)]
    pub(super) fn at((omega, zeta): (F, F), side: F, time: Pair<F>) -> Self {
        let (over_d, swing) = Self::swing(zeta, time);
        let decay = Self::growth(zeta, side, time).exp();
        Self { over_d, swing, decay, drive: Self::drive(omega, time) }
    }

    /// (sin Ωτ, cos Ωτ).
    #[inline(always)]
    pub(crate) fn drive(omega: F, time: Pair<F>) -> (Pair<F>, Pair<F>) {
        wide_sin_cos(time * omega)
    }

    /// 1/d, and (sin dτ, cos dτ).
    #[inline(always)]
    pub(crate) fn swing(zeta: F, time: Pair<F>) -> (Pair<F>, (Pair<F>, Pair<F>)) {
        let (d, over_d) = wide_frequency(zeta);
        (over_d, wide_sin_cos(d * time))
    }

    #[inline(always)]
    fn growth(zeta: F, side: F, time: Pair<F>) -> Pair<F> {
        time * -(side * zeta)
    }

    /// `e^{−ζτ}` without branches, for `ζτ < e ln 2`, e = [`Float::RATIO_EXPONENT`].
    #[cfg(feature = "batch")]
    #[inline(always)]
    pub(crate) fn decay(zeta: F, side: F, time: Pair<F>) -> Pair<F> {
        Self::growth(zeta, side, time).exp_moderate().1
    }
}

impl<F: Float> WideState<F> {
    /// From (x, v), by the waves.
    ///
    /// The velocity is `v c − (x + ζv) s`, the acceleration `a c − (v + ζa) s`, with c and s/d the two waves.
    #[inline(always)]
    pub(super) fn of(zeta: F, (x, v): (Pair<F>, Pair<F>), side: F, waves: &WideWaves<F>) -> Self {
        let WideWaves { over_d, swing: (sine, cosine), decay, drive } = *waves;
        let a = -x.plus(v * (F::int(2) * zeta));
        let (across, along) = (x.plus(v * zeta) * over_d, v.plus(a * zeta) * over_d);
        let (sine, cosine) = (sine * decay, cosine * decay);
        let sine = Pair::new(side * sine.hi, side * sine.lo);
        Self { velocity: v * cosine - across * sine, acceleration: a * cosine - along * sine, drive }
    }
}

impl<F: Float> Rising<F> {
    /// The half cycle with all digits of a, G, H, d and T.
    #[inline(always)]
    pub(super) fn in_pairs(&self) -> Rising<Pair<F>> {
        let half = self.half.in_pairs();
        let max_displacement = Pair::new(self.max_displacement, self.rest);
        Rising { amplitude: max_displacement + half.shift, max_displacement, rest: Pair::int(0), half }
    }
}

impl<F: Float> HalfPeriod<F> {
    /// [`HalfPeriod::wide`] with the digits of d and T.
    #[inline(always)]
    pub(super) fn in_pairs(&self) -> HalfPeriod<Pair<F>> {
        let wide = self.wide();
        HalfPeriod { free: Free::new(wide.free.zeta), period: Pair::pi() / self.omega, ..wide }
    }
}

impl<F: Float> HalfPeriod<Pair<F>> {
    /// Free vibration from the end of the half cycle on this side, by the waves.
    #[inline(always)]
    pub(crate) fn free_from(&self, zeta: F, side: F, waves: &WideWaves<F>) -> WideState<F> {
        let (b, shift) = (self.h * self.omega.hi, Pair::new(side * self.shift.hi, side * self.shift.lo));
        let start = (Pair::int(1).plus(shift), Pair::new(side * b.hi, side * b.lo));
        WideState::of(zeta, start, side, waves)
    }

    /// The half cycle at τ in [0, T].
    #[inline(always)]
    pub(super) fn wide_at(&self, tau: Pair<F>) -> Moment<Pair<F>> {
        let waves = self.free.wide_waves(tau);
        let free = self.free.after(waves, Pair::int(1) + self.shift, self.omega * self.h);
        Moment { tau, drive: wide_sin_cos(self.omega * tau), waves, free }
    }

    /// The moment at T − u; for ζ < 1.
    #[inline(always)]
    pub(super) fn wide_before_end(&self, u: Pair<F>) -> Moment<Pair<F>> {
        let (decay, (sine, cosine)) = self.free.wide_swing(u);
        let waves = Waves { cosine: cosine / decay, sine: -(sine / decay) };
        let free = self.free.after(waves, Pair::int(1) - self.shift, -(self.omega * self.h));
        let (s, c) = wide_sin_cos(self.omega * u);
        Moment { tau: self.period - u, drive: (s, -c), waves, free }
    }
}

impl<F: Float> Free<Pair<F>> {
    /// `e^{−ζt}`, and `sin(dt)/d` and `cos dt`; for ζ < 1.
    #[inline(always)]
    fn wide_swing(&self, t: Pair<F>) -> (Pair<F>, (Pair<F>, Pair<F>)) {
        let (sine, cosine) = wide_sin_cos(self.frequency * t);
        ((-(self.zeta * t)).exp_falling().1, (sine / self.frequency, cosine))
    }

    /// [`Free::waves`] at t ≥ 0.
    #[inline(always)]
    fn wide_waves(&self, t: Pair<F>) -> Waves<Pair<F>> {
        let (zero, half) = (F::int(0), F::ratio(1, 2));
        if self.square.hi > zero {
            let (decay, (sine, cosine)) = self.wide_swing(t);
            return Waves { cosine: decay * cosine, sine: decay * sine };
        }
        if self.frequency.hi == zero {
            let (_, decay) = (-t).exp_falling();
            return Waves { cosine: decay, sine: decay * t };
        }
        let ((_, slow), (fall, _)) =
            ((-(self.slow_rate() * t)).exp_falling(), (-(self.frequency * t).times(2)).exp_falling());
        let gap = fall * half;
        Waves { cosine: slow * (Pair::int(1) + gap), sine: -(slow * gap / self.frequency) }
    }
}
