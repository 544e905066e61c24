//! The linear oscillator over half a period of the drive: the quantities of the damped cycle that depend on Ω
//! and ζ alone.

use super::free::Free;
use crate::float::{Field, Float, Real};
use crate::phase_function::{PhaseFunction, one_minus_square, turned};

/// Over the half period `T = π/Ω` of natural time, with `d = √(1 − ζ²)`:
///
/// ```text
/// q = √((1 − Ω²)² + 4ζ²Ω²),   N = cosh ζT + cos dT,
/// G = [sinh ζT − (ζ/d) sin dT]/N,   H = sin dT/(d Ω N),   K = qH.
/// ```
///
/// They solve the matching conditions of the cycle with two reversals, `(−G, −ΩH)ᵀ = tanh(AT/2) (1, 0)ᵀ`, A
/// being the matrix of free vibration. At ζ = 0 G = 0, q = |1 − Ω²| and H = tan(π/2Ω)/Ω, so that K is the
/// phase function with the sign of 1 − Ω.
///
/// Computed from half the angle, `N/2 = sinh²(ζT/2) + cos²(dT/2)`, a sum of squares, with dT/2 reduced from
/// π/2Ω, whose reduction is exact: no digit is lost at Ω = 1, at Ω = 1/n or as ζ → 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct HalfPeriod<F> {
    pub(crate) omega: F,
    pub(crate) free: Free<F>,
    /// T.
    pub(crate) period: F,
    /// `q sin δ = 2ζΩ` and `q cos δ = 1 − Ω²`, δ the lag of the linear oscillator.
    pub(crate) lag: (F, F),
    /// q.
    pub(crate) stiffness: F,
    /// G.
    pub(crate) shift: F,
    /// H.
    pub(crate) h: F,
    /// K = qH.
    pub(crate) k: F,
    /// `e^{−ζT}`, `e^{−ζT} cos dT` and `e^{−ζT} sin(dT)/d`.
    pub(crate) decay: F,
    pub(crate) cosine: F,
    pub(crate) sine: F,
    /// `η − 1`, by how much the static friction is above the kinetic one, in r_y.
    pub(crate) static_excess: F,
    /// Whether driven and free vibration nearly cancel over the half period.
    pub(crate) is_resonant: bool,
}

impl<F: Float> HalfPeriod<F> {
    /// At a frequency ratio and a damping ratio ζ > 0 that are in their domains.
    pub(crate) fn new(omega: F, zeta: F) -> Self {
        let (two, free) = (F::int(2), Free::new(zeta));
        let half = F::pi() / (two * omega);
        let period = F::pi() / omega;
        let lag = (two * zeta * omega, one_minus_square(omega));
        let stiffness = lag.0.hypot(lag.1);
        let decay = (-(zeta * period)).exp();
        // Both waves at T/2: (e^{−ζT/2} cos(dT/2), e^{−ζT/2} sin(dT/2)/d).
        let (c, s) = waves_at_half(&free, omega, half);
        // e^{−ζT} N/2
        let hyperbolic = (-(zeta * period)).exp_m1() / two;
        let n = hyperbolic.square() + c.square();
        let h = s * c / (omega * n);
        let shift = shift_numerator(&free, period, decay, s * c) / n;
        Self {
            omega,
            free,
            period,
            lag,
            stiffness,
            shift,
            h,
            k: stiffness * h,
            decay,
            cosine: c.square() - free.square * s.square(),
            sine: two * s * c,
            static_excess: F::int(0),
            // H = K/q exceeds T.
            is_resonant: stiffness * period < F::int(1) && zeta * F::int(8) < F::int(1),
        }
    }
}

impl<F: Field> HalfPeriod<F> {
    /// The same in another number type, each part converted on its own.
    pub(crate) fn map<G: Float>(self, to: impl Fn(F) -> G) -> HalfPeriod<G> {
        HalfPeriod {
            omega: to(self.omega),
            free: self.free.map(&to),
            period: to(self.period),
            lag: (to(self.lag.0), to(self.lag.1)),
            stiffness: to(self.stiffness),
            shift: to(self.shift),
            h: to(self.h),
            k: to(self.k),
            decay: to(self.decay),
            cosine: to(self.cosine),
            sine: to(self.sine),
            static_excess: to(self.static_excess),
            is_resonant: self.is_resonant,
        }
    }
}

impl<F: Real> HalfPeriod<F> {
    /// The lag δ of the linear oscillator, in (0, π).
    pub(crate) fn phase_lag(&self) -> F {
        self.lag.0.atan2(self.lag.1)
    }
}

impl<F: Field> HalfPeriod<F> {
    /// The same with a static friction of η times the kinetic one.
    pub(crate) fn with_static_friction(self, eta: F) -> Self {
        Self { static_excess: eta - F::int(1), ..self }
    }

    /// `1 + G + 2ζΩH`: the deceleration at the maximum of the cycle that is barely held back there, in units
    /// of B ω_n².
    pub(crate) fn holding(&self) -> F {
        F::int(1) + self.shift + self.lag.0 * self.h
    }
}

/// `(e^{−ζT/2} cos(dT/2), e^{−ζT/2} sin(dT/2)/d)`; `half` is T/2.
fn waves_at_half<F: Float>(free: &Free<F>, omega: F, half: F) -> (F, F) {
    // Towards ζ = 1 d vanishes, and a difference would lose it; there no pole is near enough to ask for more.
    if free.zeta * F::int(2) > F::int(1) {
        let waves = free.waves(half);
        return (waves.cosine, waves.sine);
    }
    let (s, c) = half_angle(free, omega, half);
    let decay = (-(free.zeta * half)).exp();
    (decay * c, decay * s / free.frequency)
}

/// `(sin, cos)` of dT/2 for ζ < 1; `half` is T/2.
pub(crate) fn half_angle<F: Float>(free: &Free<F>, omega: F, half: F) -> (F, F) {
    // dT/2 = π/2Ω − (1 − d) T/2, 1 − d = ζ²/(1 + d); the first is q π/2 + w with w to full relative accuracy.
    let p = PhaseFunction::of_valid(omega);
    let less = free.zeta.square() / (F::int(1) + free.frequency) * half;
    turned(p.quarter(), (p.remainder() - less).sin_cos())
}

/// `e^{−ζT} [sinh ζT − (ζ/d) sin dT]/2`, given `e^{−ζT}` and `e^{−ζT} sin(dT/2) cos(dT/2)/d`.
///
/// Of the order ζT³/6: by its series where T or ζT is small, and far above ζ = 1, where the two hyperbolic
/// sines are nearly equal, by the half sum and half difference of their arguments.
fn shift_numerator<F: Float>(free: &Free<F>, period: F, decay: F, product: F) -> F {
    let (one, two, zeta) = (F::int(1), F::int(2), free.zeta);
    if period * zeta.or_larger(one) <= two {
        return decay * series(free, period) / two;
    }
    if zeta * F::int(4) <= F::int(5) {
        // (1 − e^{−2ζT})/4 − ζ e^{−ζT} sin(dT/2) cos(dT/2)/d
        return -(-(two * zeta * period)).exp_m1() / F::int(4) - zeta * product;
    }
    // With r = ζ + |d|, p = rT/2, m = T/2r: [r cosh p sinh m − sinh p cosh m/r]/|d|.
    let (r, slow) = (zeta + free.frequency, free.slow_rate());
    let (p, m) = ((-(r * period)).exp_m1(), (-(slow * period)).exp_m1());
    (slow * p * (two + m) - r * (two + p) * m) / (F::int(8) * free.frequency)
}

/// `sinh ζT − (ζ/d) sin dT = ζT · T² Σ_{j≥1} [U^j − V^j]/(T² (2j+1)!)`, U = (ζT)², V = (ζ² − 1)T², where `U
/// − V = T²`, so that the quotient is `Σ U^i V^{j−1−i}`: nothing cancels.
fn series<F: Float>(free: &Free<F>, period: F) -> F {
    let (u, v) = ((free.zeta * period).square(), -(free.square * period.square()));
    let most = u.or_larger(v.abs());
    let (mut quotient, mut power, mut factor) = (F::int(1), F::int(1), F::ratio(1, 6));
    let mut sum = factor;
    // U ≤ 4 and |V| ≤ 4: the factorial wins from the second term on.
    for j in 2..=i32::try_from(F::PRECISION).unwrap_or(i32::MAX) {
        power = power * v;
        quotient = quotient * u + power;
        factor = factor / F::int((2 * j) * (2 * j + 1));
        sum = sum + factor * quotient;
        // No later quotient is larger than j most^{j−1}.
        if factor * (quotient.abs() + power.abs()) * most <= sum.abs() * F::epsilon() {
            break;
        }
    }
    free.zeta * period * period.square() * sum
}
