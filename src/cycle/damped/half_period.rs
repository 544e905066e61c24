//! The linear oscillator over half a period of the drive: the quantities of the damped cycle that depend on Ω
//! and ζ alone.

use super::free::Free;
use super::long::{Long, to_acute};
use super::middle::Middle;
use super::pole::Pole;
use super::tangent::Tangent;
use crate::cycle::phase_function::{PhaseFunction, one_minus_square, one_minus_square_wide, reduced, turned};
use crate::float::circular::by_quarters;
use crate::float::pair::Pair;
use crate::float::{Field, Float, at_precision, fused};

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
/// π/2Ω, whose reduction is exact, and in pairs: no digit is lost at Ω = 1/n or as ζ → 0. Beside Ω = 1 the
/// pole is divided out first ([`Pole`]).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct HalfPeriod<F> {
    pub(crate) omega: F,
    /// 1/Ω.
    pub(crate) inverse: F,
    pub(crate) free: Free<F>,
    /// T.
    pub(crate) period: F,
    /// `1 − Ω² = q cos δ`, δ the lag of the linear oscillator.
    pub(crate) one_minus_square: F,
    /// q.
    pub(crate) stiffness: F,
    /// G.
    pub(crate) shift: F,
    /// H.
    pub(crate) h: F,
    /// K = qH.
    pub(crate) k: F,
    /// What rounding took from q, G and H.
    pub(crate) rest: [F; 3],
    /// The form by which G and H were found, and what it gives beside them: see [`HalfPeriod::beyond`] and
    /// [`HalfPeriod::middle`]. One field for both keeps an answer small.
    pub(crate) form: Form,
    pub(crate) parts: [F; 3],
    /// `e^{−ζT}`, `e^{−ζT} cos dT` and `e^{−ζT} sin(dT)/d`.
    pub(crate) decay: F,
    pub(crate) cosine: F,
    pub(crate) sine: F,
    /// η, the static friction in r_y.
    pub(crate) static_friction: F,
    /// Whether driven and free vibration nearly cancel over the half period.
    pub(crate) is_resonant: bool,
}

impl<F: Float> HalfPeriod<F> {
    /// At a frequency ratio and a damping ratio ζ > 0 that are in their domains.
    pub(crate) fn new(omega: F, zeta: F) -> Self {
        fused!(<F>(omega: F, zeta: F) -> HalfPeriod<F> { HalfPeriod::at_ratios(omega, zeta) })
    }

    #[inline(always)]
    fn at_ratios(omega: F, zeta: F) -> Self {
        if let Some(half) = Self::by_tangent(omega, zeta) {
            return half.with_waves(waves_at_end(&half.free, omega));
        }
        if let Some(half) = Self::by_waves(omega, zeta) {
            return half;
        }
        if let Some(Pole { stiffness, shift, h, beyond }) = Pole::beside(omega, zeta) {
            let parts = [stiffness.normalised(), shift.normalised(), h.normalised()];
            let half = Self::of_pairs(omega, zeta, F::int(1) / omega, parts);
            let half = half.with_waves(waves_at_end(&half.free, omega));
            return Self { form: Form::Pole, parts: [beyond.hi, beyond.lo, F::int(0)], ..half };
        }
        let Half { shift, h, waves } = half(omega, zeta);
        let (shift, h) = (shift.normalised(), h.normalised());
        Self::of_responses(omega, zeta, F::int(1) / omega, shift, h).with_waves(waves)
    }

    /// All that Δ₀ and the border at the turning point need: without the waves at T, which are NaN.
    #[inline(always)]
    pub(super) fn of_amplitude(omega: F, zeta: F) -> Self {
        Self::by_tangent(omega, zeta).unwrap_or_else(|| Self::at_ratios(omega, zeta))
    }

    /// The half period by [`Long`] where that is accurate.
    #[inline(always)]
    fn by_waves(omega: F, zeta: F) -> Option<Self> {
        if const { F::PRECISION > f64::MANTISSA_DIGITS } || omega >= F::ratio(1, 2) {
            return None;
        }
        let Long { inverse, shift, h, waves, is_accurate } = Long::at(omega, zeta);
        let half = Self::of_responses(omega, zeta, inverse, shift, h).with_waves(waves);
        if is_accurate { Some(half) } else { None }
    }

    /// The half period by [`Tangent`] where that is accurate; the waves at T are NaN.
    #[inline(always)]
    fn by_tangent(omega: F, zeta: F) -> Option<Self> {
        // Below it is not accurate.
        if const { F::PRECISION > f64::MANTISSA_DIGITS } || omega < F::ratio(1, 2) {
            return None;
        }
        let Tangent { inverse, shift, h, middle, is_accurate } = Tangent::at(omega, zeta);
        let half = Self::of_responses(omega, zeta, inverse, shift, h);
        let parts = [middle.velocity, middle.slope, middle.displacement];
        if is_accurate { Some(Self { form: Form::Tangent, parts, ..half }) } else { None }
    }

    /// From 1/Ω, G and H, normalised; the waves at T are NaN.
    #[inline(always)]
    pub(crate) fn of_responses(omega: F, zeta: F, inverse: F, shift: Pair<F>, h: Pair<F>) -> Self {
        Self::of_pairs(omega, zeta, inverse, [stiffness(omega, zeta).normalised(), shift, h])
    }

    #[inline(always)]
    fn with_waves(self, [decay, cosine, sine]: [F; 3]) -> Self {
        Self { decay, cosine, sine, ..self }
    }

    /// From q, G, H and 1/Ω, normalised; the waves at T are NaN.
    #[inline(always)]
    fn of_pairs(omega: F, zeta: F, inverse: F, [stiffness, shift, h]: [Pair<F>; 3]) -> Self {
        let (period, nan) = (F::pi() / omega, F::int(0) / F::int(0));
        Self {
            omega,
            inverse,
            free: Free::new(zeta),
            period,
            one_minus_square: one_minus_square(omega),
            stiffness: stiffness.hi,
            shift: shift.hi,
            h: h.hi,
            k: (stiffness * h).value(),
            rest: [stiffness.lo, shift.lo, h.lo],
            form: Form::Definition,
            parts: [nan; 3],
            decay: nan,
            cosine: nan,
            sine: nan,
            static_friction: F::int(1),
            // H = K/q exceeds T.
            is_resonant: stiffness.hi * period < F::int(1) && zeta * F::int(8) < F::int(1),
        }
    }

    /// This half period with all digits of q, G, H and K.
    #[inline(always)]
    pub(crate) fn wide(&self) -> HalfPeriod<Pair<F>> {
        let [stiffness, shift, h] = self.rest;
        let (stiffness, h) = (Pair::new(self.stiffness, stiffness), Pair::new(self.h, h));
        HalfPeriod {
            inverse: Pair::reciprocal(self.omega, self.inverse),
            // Where Ω is near 1 the leading digits of 1 − Ω² cancel, and its two parts overlap.
            one_minus_square: one_minus_square_wide(self.omega).normalised(),
            stiffness,
            shift: Pair::new(self.shift, shift),
            h,
            k: stiffness * h,
            ..self.map(Pair::exact)
        }
    }
}

/// The form by which G and H of a half period were found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form {
    /// Their definition.
    Definition,
    /// [`Pole`].
    Pole,
    /// [`Tangent`].
    Tangent,
}

impl<F: Field> HalfPeriod<F> {
    /// Beside the pole at Ω = 1, `(πQ/2)² − 4` of `Q = q √(G² + H²)`, as the sum of two parts ([`Pole`]).
    #[inline(always)]
    pub(crate) fn beyond(&self) -> Option<[F; 2]> {
        let [hi, lo, _] = self.parts;
        if matches!(self.form, Form::Pole) { Some([hi, lo]) } else { None }
    }

    /// The middle of the half cycle, where [`Tangent`] is accurate.
    #[inline(always)]
    pub(crate) fn middle(&self) -> Option<Middle<F>> {
        let [velocity, slope, displacement] = self.parts;
        if matches!(self.form, Form::Tangent) { Some(Middle { velocity, slope, displacement }) } else { None }
    }

    /// Converts each part of the half period to another number type.
    #[inline(always)]
    pub(crate) fn map<G>(self, to: impl Fn(F) -> G) -> HalfPeriod<G> {
        HalfPeriod {
            omega: to(self.omega),
            inverse: to(self.inverse),
            free: self.free.map(&to),
            period: to(self.period),
            one_minus_square: to(self.one_minus_square),
            stiffness: to(self.stiffness),
            shift: to(self.shift),
            h: to(self.h),
            k: to(self.k),
            rest: self.rest.map(&to),
            form: self.form,
            parts: self.parts.map(&to),
            decay: to(self.decay),
            cosine: to(self.cosine),
            sine: to(self.sine),
            static_friction: to(self.static_friction),
            is_resonant: self.is_resonant,
        }
    }
}

#[cfg(any(feature = "identify", feature = "mp"))]
impl<F: crate::float::Real> HalfPeriod<F> {
    /// The lag δ of the linear oscillator, in (0, π).
    pub(crate) fn phase_lag(&self) -> F {
        self.damper().atan2(self.one_minus_square)
    }
}

impl<F: Field> HalfPeriod<F> {
    /// This half period with a static friction of η times the kinetic one.
    pub(crate) fn with_static_friction(self, eta: F) -> Self {
        Self { static_friction: eta, ..self }
    }

    /// `2ζΩ = q sin δ`, δ the lag of the linear oscillator.
    #[inline(always)]
    pub(crate) fn damper(&self) -> F {
        (self.free.zeta * self.omega).times(2)
    }

    /// q².
    #[inline(always)]
    pub(crate) fn squared_stiffness(&self) -> F {
        self.damper().square().plus(self.one_minus_square.square())
    }

    /// `1 + G + 2ζΩH`: the deceleration at the maximum of the cycle that is barely held back there, in units
    /// of B ω_n².
    #[inline(always)]
    pub(crate) fn holding(&self) -> F {
        F::int(1) + self.shift + self.damper() * self.h
    }
}

/// `(sin, cos)` of dT/2 for ζ < 1; `half` is T/2.
pub(crate) fn half_angle<F: Float>(free: &Free<F>, omega: F, half: F) -> (F, F) {
    // dT/2 = π/2Ω − (1 − d) T/2, 1 − d = ζ²/(1 + d); the first is q π/2 + w with w to full relative accuracy.
    let p = PhaseFunction::of_valid(omega);
    let less = free.zeta.square() / (F::int(1) + free.frequency) * half;
    turned(p.quarter(), (p.remainder() - less).sin_cos())
}

/// q.
#[inline(always)]
fn stiffness<F: Float>(omega: F, zeta: F) -> Pair<F> {
    // As in `HalfPeriod::wide`.
    (zeta.wide() * omega).times(2).hypot(one_minus_square_wide(omega).normalised())
}

/// G, H, and e^{−ζT}, e^{−ζT} cos dT and e^{−ζT} sin(dT)/d.
struct Half<R, F> {
    shift: R,
    h: R,
    waves: [F; 3],
}

/// The waves at T in the arithmetic of the type, for ζ < 1.
fn waves_at_end<F: Float>(free: &Free<F>, omega: F) -> [F; 3] {
    let half = F::pi() / (F::int(2) * omega);
    // Towards ζ = 1 d vanishes, and a difference would lose it.
    let is_slow = free.zeta * F::int(2) > F::int(1);
    let (s, c) = if is_slow { (free.frequency * half).sin_cos() } else { half_angle(free, omega, half) };
    let decay = (-(free.zeta * half)).exp();
    let (s, c) = (decay * s / free.frequency, decay * c);
    [decay.square(), c.square() - free.square * s.square(), F::int(2) * s * c]
}

/// Which forms apply: decided once for every arithmetic.
#[derive(Clone, Copy)]
struct Forms {
    /// ζ < 1, = 1 and > 5/4.
    swings: bool,
    is_critical: bool,
    is_stiff: bool,
    /// T max(ζ, 1) ≤ 2
    is_short: bool,
}

/// G and H away from the pole.
#[inline(always)]
fn half<F: Float>(omega: F, zeta: F) -> Half<Pair<F>, F> {
    let (one, two) = (F::int(1), F::int(2));
    let kind = Forms {
        swings: zeta < one,
        is_critical: zeta == one,
        is_stiff: zeta * F::int(4) > F::int(5),
        is_short: F::pi() * zeta.or_larger(one) <= two * omega,
    };
    if const { F::PRECISION > f64::MANTISSA_DIGITS } {
        return at_precision!(guarded, <F>(omega: F, zeta: F, kind: Forms) -> Half<Pair<F>, F>, |there, back: G| {
            let (omega, free) = (there(omega), Free::new(there(zeta)));
            let middle = G::pi() / (G::int(2) * omega);
            // Towards ζ = 1 d vanishes, and a difference would lose it; there no pole is near enough to ask for
            // more.
            let angle = if free.zeta * G::int(2) > G::int(1) {
                (free.frequency * middle).sin_cos()
            } else {
                half_angle(&free, omega, middle)
            };
            let exp = |x: G| (x.exp_m1(), x.exp());
            let Half { shift, h, waves } = at_middle(&free, (omega, middle), angle, kind, exp, series_rest);
            let pair = |x| Pair::rounded(x, &there, &back);
            Half { shift: pair(shift), h: pair(h), waves: waves.map(&back) }
        });
    }
    let (wide, free) = (omega.wide(), Free::new(zeta.wide()));
    let middle = Pair::pi() / (wide * two);
    let angle = if kind.swings { wide_half_angle(&free, omega, middle) } else { (wide, wide) };
    let rest = |u: Pair<F>, v: Pair<F>| Pair::exact(series_rest(u.hi, v.hi));
    let Half { shift, h, waves } =
        at_middle(&free, (wide, middle), angle, kind, |x: Pair<F>| x.exp_falling(), rest);
    Half { shift, h, waves: waves.map(Pair::value) }
}

/// `(sin, cos)` of dT/2 for ζ < 1 as pairs; `middle` is T/2.
#[inline(always)]
fn wide_half_angle<F: Float>(free: &Free<Pair<F>>, omega: F, middle: Pair<F>) -> (Pair<F>, Pair<F>) {
    let (quarter, angle) = if free.zeta.hi * F::int(2) > F::int(1) {
        (0, free.frequency * middle)
    } else {
        let (quarter, w) = reduced(omega);
        (quarter, w - free.zeta.square() / (Pair::int(1) + free.frequency) * middle)
    };
    // The waves of so long a time are zero.
    if angle.hi.abs() > F::int(8192) {
        return (Pair::int(0), Pair::int(1));
    }
    turned(quarter, wide_sin_cos(angle))
}

/// `(sin, cos)` as pairs, at up to the precision of f64; without branches.
#[inline(always)]
pub(super) fn wide_sin_cos<F: Float>(angle: Pair<F>) -> (Pair<F>, Pair<F>) {
    let (turns, acute) = to_acute(angle);
    by_quarters(turns, F::sin_cos_acute(acute))
}

/// Whether the supremum of the border's condition may be away from the turning point.
#[inline(always)]
pub(crate) fn has_lobes<F: Float>(half: &HalfPeriod<F>) -> bool {
    half.free.swings() & (half.omega * F::int(2) < half.free.frequency)
}

/// The amplitude that keeps the body from sticking at its turning points: ρ(0⁺), or with a static friction of
/// η times the kinetic one `(η + G + 2ζΩH)/Ω²`.
#[inline(always)]
pub(crate) fn turning_point<F: Field>(half: &HalfPeriod<F>) -> F {
    half.static_friction.plus(half.shift).plus(half.damper() * half.h) * half.inverse.square()
}

/// G and H from the middle of the half period: `(omega, middle)` is (Ω, T/2), `angle` (sin, cos) of dT/2 for
/// ζ < 1, `exp` is (eˣ − 1, eˣ) for x ≤ 0.
///
/// `sinh ζT − (ζ/d) sin dT` is of the order ζT³/6: by its series where T or ζT is small, and far above ζ = 1,
/// where the two hyperbolic sines are nearly equal, by the half sum and half difference of their arguments.
#[inline(always)]
fn at_middle<R: Field>(
    free: &Free<R>,
    (omega, middle): (R, R),
    angle: (R, R),
    kind: Forms,
    exp: impl Fn(R) -> (R, R),
    rest: impl Fn(R, R) -> R,
) -> Half<R, R> {
    let (one, two, zeta, d) = (R::int(1), R::int(2), free.zeta, free.frequency);
    let period = middle.times(2);
    // e^{−ζT} − 1, e^{−ζT}, and e^{−ζT/2} cos(dT/2), e^{−ζT/2} sin(dT/2)/d
    let (fall, decay, c, s, creep) = if kind.swings {
        let (fall, decay) = exp(-(zeta * middle));
        (fall * (fall + two), decay.square(), decay * angle.1, decay * angle.0 / d, (one, one))
    } else {
        // e^{−ζt} cosh |d|t = e^{−t/(ζ+|d|)} (1 + e^{−2|d|t})/2, and so for the sine.
        let ((slow, left), (fast, rest)) = (exp(-(free.slow_rate() * middle)), exp(-(d * period)));
        let all = slow * (slow + two);
        let sine = if kind.is_critical { middle } else { -fast / d.times(2) };
        (all + fast + all * fast, left.square() * rest, left * (one + fast / two), left * sine, (slow, fast))
    };
    let n = (fall / two).square() + c.square();
    // e^{−ζT} [sinh ζT − (ζ/d) sin dT]/2
    let numerator = if kind.is_short {
        // ζT · T² Σ_{j≥1} [U^j − V^j]/(T² (2j+1)!), U = (ζT)², V = (ζ² − 1)T²; U − V = T².
        let square = period.square();
        let (u, v) = (zeta.square() * square, -(free.square * square));
        let sum = R::ratio(1, 6) + (u + v) * R::ratio(1, 120) + rest(u, v);
        decay * zeta * period * square * sum / two
    } else if kind.is_stiff {
        // With r = ζ + |d|, p = rT/2, m = T/2r: [r cosh p sinh m − sinh p cosh m/r]/|d|.
        let (slow, fast) = creep;
        let half = slow + fast + slow * fast;
        let (p, m) = (half * (half + two), slow * (slow + two));
        (free.slow_rate() * p * (two + m) - (zeta + d) * (two + p) * m) / d.times(8)
    } else {
        // (1 − e^{−2ζT})/4 − ζ e^{−ζT} sin(dT/2) cos(dT/2)/d
        -(fall * (fall + two)) / R::int(4) - zeta * (s * c)
    };
    Half {
        shift: numerator / n,
        h: s * c / (omega * n),
        waves: [decay, c.square() - free.square * s.square(), (s * c).times(2)],
    }
}

/// `Σ_{j≥3} [U^j − V^j]/((U − V)(2j+1)!)`, the quotients being `Σ U^i V^{j−1−i}`, so that nothing cancels.
fn series_rest<F: Float>(u: F, v: F) -> F {
    let most = u.or_larger(v.abs());
    let (mut quotient, mut power, mut factor) = (u + v, v, F::ratio(1, 120));
    let mut sum = F::int(0);
    // U ≤ 4 and |V| ≤ 4: the factorial wins.
    for j in 3..=i32::try_from(F::precision()).unwrap_or(i32::MAX) {
        power = power * v;
        quotient = quotient * u + power;
        factor = factor / F::int((2 * j) * (2 * j + 1));
        sum = sum + factor * quotient;
        // No later quotient is larger than j most^{j−1}, and the first term is 1/6.
        if factor * (quotient.abs() + power.abs()) * most <= F::epsilon() / F::int(8) {
            break;
        }
    }
    sum
}

/// The quantities by their definitions, at twelve times the digits of f64.
#[cfg(all(test, feature = "mp"))]
pub(super) mod definition {
    use crate::float::Field;
    use crate::float::mp::Mp;
    use crate::float::pair::Pair;

    pub(crate) type Wide = Mp<12>;

    /// G and H.
    pub(crate) fn responses(omega: f64, zeta: f64) -> (Wide, Wide) {
        let (o, z, one, two) = (Wide::from(omega), Wide::from(zeta), Wide::int(1), Wide::int(2));
        let d = (one - z * z).sqrt();
        let t = Wide::pi() / o;
        let (e, (s, c)) = ((-(z * t)).exp(), (d * t).sin_cos());
        let n = (one / e + e) / two + c;
        (((one / e - e) / two - z / d * s) / n, s / (d * o * n))
    }

    /// Both parts of a pair.
    pub(crate) fn wide(x: Pair<f64>) -> Wide {
        Wide::from(x.hi) + Wide::from(x.lo)
    }

    /// Fails where the relative error of a pair is above `unit`.
    #[track_caller]
    pub(crate) fn is_near(found: Pair<f64>, due: Wide, unit: f64, at: (f64, f64)) {
        let off = ((wide(found) - due) / due).abs().to_f64();
        assert!(off <= unit, "{at:?}: {off:e} for {due}");
    }
}
