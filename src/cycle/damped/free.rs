//! Free vibration with viscous damping: `x″ + 2ζx′ + x = 0` in natural time.

use crate::float::pair::Pair;
use crate::float::{Field, Float, Signed};

/// Free vibration at a damping ratio ζ > 0, below, at and above ζ = 1.
///
/// With `d = √(1 − ζ²)` its two waves are `e^{−ζt} cos dt` and `e^{−ζt} sin(dt)/d`; above ζ = 1 d is
/// imaginary, and they are `e^{−ζt} cosh |d|t` and `e^{−ζt} sinh(|d|t)/|d|`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Free<F> {
    pub(crate) zeta: F,
    /// `d² = 1 − ζ²`.
    pub(crate) square: F,
    /// `|d|`.
    pub(crate) frequency: F,
}

/// d and 1/d in pairs, for ζ < 1 and up to the precision of f64.
#[inline(always)]
pub(super) fn wide_frequency<F: Float>(zeta: F) -> (Pair<F>, Pair<F>) {
    let one = F::int(1);
    let square = Pair::fast_two_sum(one, -zeta) * Pair::fast_two_sum(one, zeta);
    let root = square.hi.sqrt();
    let near = one / root;
    let low = ((-root).mul_add(root, square.hi) + square.lo) * (F::ratio(1, 2) * near);
    let rest = ((-near).mul_add(root, one) - near * low) * near;
    (Pair::new(root, low), Pair::new(near, rest))
}

/// `e^{−ζt} cos dt` and `e^{−ζt} sin(dt)/d`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Waves<F> {
    pub(crate) cosine: F,
    pub(crate) sine: F,
}

/// Displacement, velocity and their derivatives at one time.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FreeState<F> {
    pub(crate) x: F,
    pub(crate) v: F,
    pub(crate) a: F,
    /// The third and the fourth derivative.
    pub(crate) jerk: F,
    pub(crate) snap: F,
}

impl<F: Field> FreeState<F> {
    /// A bound of all later velocities: `x′` is a free vibration, too, whose energy `(x′² + x″²)/2`
    /// decreases.
    #[inline]
    pub(crate) fn velocity_bound(&self) -> F {
        self.v.hypot(self.a)
    }

    /// No acceleration later on is larger than this.
    #[inline]
    pub(crate) fn acceleration_bound(&self) -> F {
        self.a.hypot(self.jerk)
    }

    /// No third or fourth derivative later on is larger than this.
    #[inline]
    pub(crate) fn jerk_bound(&self) -> F {
        self.jerk.hypot(self.snap)
    }
}

impl<F: Field> Free<F> {
    /// Converts each part to another number type.
    #[inline(always)]
    pub(crate) fn map<G>(self, to: impl Fn(F) -> G) -> Free<G> {
        Free { zeta: to(self.zeta), square: to(self.square), frequency: to(self.frequency) }
    }

    #[inline(always)]
    pub(crate) fn new(zeta: F) -> Self {
        let one = F::int(1);
        let square = (one - zeta) * (one + zeta);
        Self { zeta, square, frequency: square.abs().sqrt() }
    }

    /// `1/(ζ + |d|)`, the slower of the two rates of decay above ζ = 1: `ζ − |d|` without cancellation.
    #[inline]
    pub(crate) fn slow_rate(&self) -> F {
        F::int(1) / (self.zeta + self.frequency)
    }

    /// The motion from (x₀, v₀) after the time t whose waves are given.
    #[inline(always)]
    pub(crate) fn after(&self, waves: Waves<F>, x0: F, v0: F) -> FreeState<F> {
        let (zeta, two) = (self.zeta, F::int(2));
        let Waves { cosine, sine } = waves;
        let x = x0 * cosine + (v0 + zeta * x0) * sine;
        let v = v0 * cosine - (zeta * v0 + x0) * sine;
        let next = |x: F, v: F| -(x + two * zeta * v);
        let a = next(x, v);
        let jerk = next(v, a);
        FreeState { x, v, a, jerk, snap: next(a, jerk) }
    }
}

impl<N: Signed> Free<N> {
    /// Both waves at t ≥ 0.
    #[inline]
    pub(crate) fn waves(&self, t: N) -> Waves<N> {
        match self.square.positive() {
            Some(true) => {
                let (decay, (s, c)) = ((-(self.zeta * t)).exponential(), (self.frequency * t).sin_cos());
                Waves { cosine: decay * c, sine: decay * (s / self.frequency) }
            }
            Some(false) => self.decaying(t),
            None => self.about_one(t),
        }
    }

    /// Both waves where the sign of 1 − ζ is uncertain, by entire functions of 1 − ζ².
    #[cold]
    fn about_one(&self, t: N) -> Waves<N> {
        let decay = (-(self.zeta * t)).exponential();
        let [cosine, sine] = (-(self.square * t.square())).hyperbolic();
        Waves { cosine: decay * cosine, sine: decay * (t * sine) }
    }

    /// Both waves at t ≥ 0 from ζ = 1 on.
    fn decaying(&self, t: N) -> Waves<N> {
        let half = N::ratio(1, 2);
        match self.frequency.positive() {
            Some(true) => {
                // e^{−ζt} cosh |d|t = e^{−t/(ζ+|d|)} (1 + e^{−2|d|t})/2, and so for the sine.
                let slow = (-(self.slow_rate() * t)).exponential();
                let gap = -(-(self.frequency * t * N::int(2))).exponential_less_one();
                Waves { cosine: slow * (N::int(1) - gap * half), sine: slow * (gap * half / self.frequency) }
            }
            Some(false) => {
                let decay = (-t).exponential();
                Waves { cosine: decay, sine: decay * t }
            }
            None => self.about_one(t),
        }
    }
}

impl<F: Float> Free<F> {
    /// Whether the body swings: ζ < 1.
    #[inline]
    pub(crate) fn swings(&self) -> bool {
        self.square > F::int(0)
    }

    /// `e^{−ζt} cos dt − 1` without cancellation, at t ≥ 0.
    pub(crate) fn cosine_less_one(&self, t: F) -> F {
        let (half, two) = (F::ratio(1, 2), F::int(2));
        if self.swings() {
            let fall = (-(self.zeta * t)).exp_m1();
            return fall - two * (F::int(1) + fall) * (self.frequency * t * half).sin().square();
        }
        let (slow, gap) = ((-(self.slow_rate() * t)).exp_m1(), (-(self.frequency * t * two)).exp_m1());
        slow + (F::int(1) + slow) * gap * half
    }

    /// `1 − c`, `c = e^{−ζt} (cos dt + (ζ/d) sin dt)`: the displacement of a body from rest under a unit
    /// force, at t ≥ 0; `sine` is [`Waves::sine`] at t.
    ///
    /// By its power series for a short time; from ζ = 1 on as `1 − e^{−μt} − μs` with the slower rate of
    /// decay μ.
    pub(crate) fn step_response(&self, t: F, sine: F) -> F {
        let (one, two) = (F::int(1), F::int(2));
        let damping = two * self.zeta;
        if t * (one + damping) * two > one {
            if self.swings() {
                return -(self.cosine_less_one(t) + self.zeta * sine);
            }
            let slow = self.slow_rate();
            return -((-(slow * t)).exp_m1() + slow * sine);
        }
        // V⁽ⁿ⁺²⁾ = −V⁽ⁿ⁾ − 2ζV⁽ⁿ⁺¹⁾ from V″ = 1 on: each term is less than half of the one before.
        let (mut before, mut derivative) = (F::int(0), one);
        let mut power = t.square() / two;
        let mut sum = F::int(0);
        for n in 3..=F::precision().saturating_add(3) {
            sum = sum + derivative * power;
            if (derivative.abs() + before.abs()) * power <= F::epsilon() * sum.abs() {
                break;
            }
            (before, derivative) = (derivative, -(before + damping * derivative));
            power = power * t / F::from_f64(f64::from(n));
        }
        sum
    }
}
