//! The non-sticking cycle with viscous damping, ζ > 0, in closed form.
//!
//! The equation of motion in natural time, `x″ + 2ζx′ + x + sgn x′ = α sin θ` (units of B = r_y/k), has
//! between its reversals a driven and a free part, and the cycle with two reversals and no stop follows from
//! its matching conditions as without damping ([`mod@half_period`]). With `K = qH` the table of ζ = 0 holds
//! with q for |1 − Ω²| and a shift G of the displacement:
//!
//! | | ζ = 0 | ζ > 0 |
//! |---|---|---|
//! | Δ₀/B | √(α² − K²)/\|1 − Ω²\| | a − G, a = √(α² − K²)/q |
//! | ω_d t₂ | cos ω_d t₂ = K/α, sign of the sine that of 1 − Ω | cos(ω_d t₂ − δ) = K/α, sin(ω_d t₂ − δ) = qa/α |
//! | border | hypot(K, (1 − Ω²) S), S ≥ 1/Ω² | hypot(K, qS), S ≥ (1 + G + 2ζΩH)/Ω² |
//! | A₁ | 8(Δ₀/B)/α² | the same, friction's part |
//! | α*, A₁max | √2 \|K\|, 4/(\|K\| \|1 − Ω²\|) | √(2Q(Q + qG)), 4/(q(Q + qG)), Q = hypot(K, qG) |
//! | λ | λ² + (1 + s) cos(π/Ω) λ + s = 0 | λ² + (M₁₁ + sM₂₂) λ + s e^{−2ζT} = 0 |

pub(crate) mod border;
pub(crate) mod fastest;
pub(crate) mod free;
pub(crate) mod half_period;
pub(crate) mod lobes;
pub(crate) mod long;
pub(crate) mod low;
pub(crate) mod middle;
mod peaks;
mod pole;
pub(crate) mod resonance;
pub(crate) mod rising;
pub(crate) mod squared;
mod summit;
pub(crate) mod tangent;
pub(crate) mod touch;
pub(crate) mod wide;
mod work;

use super::border::Border;
use super::displacement::velocity_phase;
use super::dissipation::{loop_size_inertia, loop_size_stiffness};
use super::stability::MultiplierPair;
use crate::float::pair::Pair;
use crate::float::{Field, Float, Signed, fused};
use crate::machine::ratios::Ratios;
#[cfg(feature = "batch")]
use border::{Refined, refined};
use border::{least_displacement, supremum, turning_point};
pub(crate) use half_period::HalfPeriod;
use pole::Pole;
use rising::Rising;
use summit::Summit;
#[cfg(feature = "batch")]
use wide::WideState;

/// The steady non-sticking motion with damping: the outputs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DampedCycle<F> {
    pub(crate) rising: Rising<F>,
    pub(crate) max_displacement: F,
    pub(crate) displacement_phase: F,
    pub(crate) max_velocity: F,
    pub(crate) velocity_phase: F,
    pub(crate) deviation: F,
}

impl<F: Float> DampedCycle<F> {
    /// The cycle at ratios on or above the border.
    pub(crate) fn at(half: HalfPeriod<F>, alpha: F) -> Self {
        Self::of(Rising::of_force(half, alpha))
    }

    /// The cycle at ratios on or above the border, with NaN for the outputs of the peak velocity.
    pub(crate) fn without_velocity(half: HalfPeriod<F>, alpha: F) -> Self {
        Self::of_displacement(Rising::of_force(half, alpha))
    }

    fn of_displacement(rising: Rising<F>) -> Self {
        let nan = F::int(0) / F::int(0);
        Self {
            rising,
            max_displacement: rising.max_displacement,
            displacement_phase: rising.displacement_phase(),
            max_velocity: nan,
            velocity_phase: nan,
            deviation: nan,
        }
    }

    /// The cycle of equations 21–25 whose half is given, stops or none.
    pub(crate) fn of(rising: Rising<F>) -> Self {
        let (found, omega) = (Self::of_displacement(rising), rising.half.omega);
        let Summit { sigma, velocity, displacement } = rising.summit();
        Self {
            max_velocity: velocity,
            velocity_phase: velocity_phase(found.displacement_phase, omega, -sigma),
            deviation: displacement,
            ..found
        }
    }

    /// R, the deceleration at the maximum.
    fn deceleration(&self) -> F {
        self.rising.deceleration()
    }

    /// Multipliers per half cycle.
    ///
    /// ```text
    /// λ = [−(RC + Z) ± √(E² − R² S² + Z (Z + 2RC))]/(R + 1),
    /// ```
    ///
    /// with `E = e^{−ζT}`, `C = E cos dT`, `S = E sin dT`, `Z = E (ζ/d) sin dT`.
    pub(crate) fn multipliers(&self) -> MultiplierPair<F> {
        let (half, size) = self.rising.half.of_size_one();
        let inverse = F::int(1) / self.deceleration();
        match MultiplierPair::new(half.multipliers(inverse), inverse, half.decay) {
            MultiplierPair::Complex { re, im } => MultiplierPair::Complex { re: size * re, im: size * im },
            MultiplierPair::Real(larger, smaller) => MultiplierPair::Real(size * larger, size * smaller),
        }
    }

    /// The contraction of a small disturbance in half a cycle, max |λ|.
    pub(crate) fn contraction(&self) -> F {
        let (half, size) = self.rising.half.of_size_one();
        size * half.contraction(F::int(1) / self.deceleration()).unwrap_or_else(F::unknown)
    }

    /// Displacement x/B and velocity x′/(Bω_d) of the rising half cycle, at the phase since its start.
    pub(crate) fn rising_at(&self, phase: F) -> (F, F) {
        let half = &self.rising.half;
        let moment = self.rising.at(phase / half.omega);
        (self.rising.displacement(&moment), self.rising.velocity(&moment)[0] / half.omega)
    }

    /// Converts each part of the cycle to another number type.
    pub(crate) fn map<G: Float>(self, to: impl Fn(F) -> G) -> DampedCycle<G> {
        DampedCycle {
            rising: self.rising.map(&to),
            max_displacement: to(self.max_displacement),
            displacement_phase: to(self.displacement_phase),
            max_velocity: to(self.max_velocity),
            velocity_phase: to(self.velocity_phase),
            deviation: to(self.deviation),
        }
    }
}

impl<F: Float> Rising<F> {
    /// At an α on or above the border.
    ///
    /// Beside the pole at Ω = 1 a and G are large and nearly equal, and α² − K² and q²G² with them: there
    /// `Δ₀/B = (α² − Q²)/(q² (a + G))`, `a² = (α² − Q²)/q² + G²`, Q² = K² + q²G² ([`Pole`]).
    pub(crate) fn of_force(half: HalfPeriod<F>, alpha: F) -> Self {
        fused!(<F>(half: HalfPeriod<F>, alpha: F) -> Rising<F> { Rising::at_force(half, alpha) })
    }

    #[inline(always)]
    fn at_force(half: HalfPeriod<F>, alpha: F) -> Self {
        let wide = half.wide();
        // An α on the rounded border may be below the true one. a is then at least its value on the border.
        let (amplitude, displacement) = match half.beyond() {
            Some([hi, lo]) => {
                let excess = Pole::excess(Pair::new(hi, lo), alpha) / wide.stiffness.square();
                let amplitude = (excess + wide.shift.square()).sqrt();
                let (displacement, least) = (excess / (amplitude + wide.shift), least_displacement(&wide));
                if displacement.value() >= least.value() {
                    (amplitude, displacement)
                } else {
                    (turning_point(&wide), least)
                }
            }
            None => return Self::of_square(half, wide.squared_amplitude(alpha), turning_point(&wide)),
        };
        Self::of_parts(half, amplitude, displacement)
    }

    /// From a², where a is at least `least`.
    #[inline(always)]
    pub(crate) fn of_square(half: HalfPeriod<F>, square: Pair<F>, least: Pair<F>) -> Self {
        let amplitude = square.sqrt();
        let excess = (amplitude.hi - least.hi) + (amplitude.lo - least.lo);
        let amplitude = if excess >= F::int(0) { amplitude } else { least };
        Self::of_parts(half, amplitude, amplitude.less(half.wide().shift))
    }

    #[inline(always)]
    fn of_parts(half: HalfPeriod<F>, amplitude: Pair<F>, displacement: Pair<F>) -> Self {
        let displacement = displacement.normalised();
        Self { half, amplitude: amplitude.value(), max_displacement: displacement.hi, rest: displacement.lo }
    }

    /// A₁ and A₂, friction's part.
    #[inline(always)]
    pub(crate) fn loop_sizes(&self, alpha: F) -> (F, F) {
        let displacement = Pair::new(self.max_displacement, self.rest);
        let size = loop_size_stiffness(displacement, alpha.wide());
        (size.value(), loop_size_inertia(size, self.half.omega.wide()).value())
    }

    /// ω_d t₂, in [0, 2π).
    pub(crate) fn displacement_phase(&self) -> F {
        let rising = self;
        fused!(<'a, F>(rising: &'a Rising<F>) -> F { displacement_phase(rising.drive()) })
    }
}

/// ω_d t₂ from the drive `f_c cos Ωτ + f_s sin Ωτ` since the start of the half cycle: half a turn later it is
/// `α sin ω_d t₂ = −f_c`, `α cos ω_d t₂ = −f_s`.
#[inline(always)]
pub(crate) fn displacement_phase<F: Float>((along, across): (Pair<F>, Pair<F>)) -> F {
    let (one, half) = (F::int(1), F::ratio(1, 2));
    let inverse = -(one / along.hi.mul_add(along.hi, across.hi * across.hi).sqrt());
    let (sine, cosine) = (along * inverse, across * inverse);
    // Of size 1, without the error of the root.
    let short = half * (-sine.hi).mul_add(sine.hi, (-cosine.hi).mul_add(cosine.hi, one));
    let unit = |part: Pair<F>| part.hi + short.mul_add(part.hi, part.lo);
    let (sine, cosine) = (unit(sine), unit(cosine));
    // The angle to the nearest axis, at a multiple of π/2.
    let (zero, up, right) = (F::int(0), sine.abs(), cosine.abs());
    let is_steep = up > right;
    let angle = F::angle_of(if is_steep { right } else { up }, if is_steep { up } else { right });
    let (is_below, is_left) = (sine < zero, cosine < zero);
    let steep = if is_below { F::ratio(3, 2) } else { half };
    let flat = if is_left {
        one
    } else if is_below {
        F::int(2)
    } else {
        zero
    };
    let half_turns = if is_steep { steep } else { flat };
    let angle = if is_below ^ is_left ^ is_steep { -angle } else { angle };
    let part = half_turns.mul_add(F::pi_rest().0, angle);
    let phase = half_turns.mul_add(F::pi(), part);
    // Rounding can carry a tiny negative phase to the period itself.
    if phase >= F::int(2) * F::pi() { zero } else { phase }
}

impl<F: Field> Rising<F> {
    /// `R = Ω²a − G − 2ζΩH`: the deceleration at the maximum, in which the force of friction is 1.
    pub(crate) fn deceleration(&self) -> F {
        let half = &self.half;
        half.omega.square() * self.amplitude - (half.holding() - F::int(1))
    }
}

impl<F: Float> HalfPeriod<F> {
    /// This half period with free waves that are divided by a size, which is 1 unless their squares would underflow.
    /// The multipliers are proportional to it.
    fn of_size_one(self) -> (Self, F) {
        let size = self.decay.or_larger(self.cosine.abs());
        if size >= F::least_ratio() || size == F::int(0) {
            return (self, F::int(1));
        }
        let (decay, cosine, sine) = (self.decay / size, self.cosine / size, self.sine / size);
        (Self { decay, cosine, sine, ..self }, size)
    }
}

impl<F: Field> HalfPeriod<F> {
    /// The mean of the two multipliers of half a cycle, and the square of their deviation from it, times
    /// (1 + 1/R)²; by 1/R.
    pub(crate) fn multipliers(&self, inverse: F) -> (F, F) {
        let (c, z) = (self.cosine, self.free.zeta * self.sine);
        // All divided by R, so that an infinite R gives the limit.
        let mean = -((c + z * inverse) / (F::int(1) + inverse));
        let discriminant = (self.decay * inverse).square() - self.free.square * self.sine.square()
            + z * inverse * (z * inverse + F::int(2) * c);
        (mean, discriminant)
    }
}

impl<N: Signed> HalfPeriod<N> {
    /// The larger modulus of the two multipliers of half a cycle, by 1/R; where they are complex `E √((R − 1)/(R + 1))`.
    pub(crate) fn contraction(&self, inverse: N) -> Option<N> {
        let (mean, discriminant) = self.multipliers(inverse);
        let complex = self.decay * MultiplierPair::product(inverse).sqrt();
        let real = mean.abs() + discriminant.larger(N::int(0)).sqrt() / (N::int(1) + inverse);
        N::chosen(discriminant.negative(), complex, real)
    }
}

/// The border: `α_min = q hypot(S, H) = hypot(K, qS)`, at the turning point with S = (η + G + 2ζΩH)/Ω².
pub(crate) fn border<F: Float>(half: &HalfPeriod<F>) -> Border<F> {
    fused!(<'a, F>(half: &'a HalfPeriod<F>) -> Border<F> { border_of(half) })
}

#[inline(always)]
fn border_of<F: Float>(half: &HalfPeriod<F>) -> Border<F> {
    let wide = half.wide();
    let least = turning_point(&wide);
    let at_turning_point = force_ratio(&wide, least);
    match supremum(half, &wide, least) {
        None => {
            Border::of_parts(at_turning_point, at_turning_point, F::int(0), least_displacement(&wide).value())
        }
        Some((touch, amplitude)) => {
            // The two are rounded.
            let inside = inner_force_ratio(&wide, amplitude).or_larger(at_turning_point);
            let displacement = (amplitude - wide.shift).value();
            Border::of_parts(inside, at_turning_point, touch.phase(half.omega), displacement)
        }
    }
}

/// The force ratio from which on the body does not stick at its turning points, and the least Δ₀/B there.
#[inline(always)]
pub(crate) fn at_turning_point<F: Float>(half: &HalfPeriod<F>) -> (F, F) {
    fused!(<'a, F>(half: &'a HalfPeriod<F>) -> (F, F) {
        let half = half.wide();
        (force_ratio(&half, turning_point(&half)), least_displacement(&half).value())
    })
}

/// `q hypot(S, H)` for an S.
#[inline(always)]
fn force_ratio<F: Float>(half: &HalfPeriod<Pair<F>>, amplitude: Pair<F>) -> F {
    (amplitude.square().plus(half.h.square()) * half.squared_stiffness()).value().sqrt()
}

/// `hypot(K, qS)` for an S inside the half cycle, rounded once.
#[inline(always)]
fn inner_force_ratio<F: Float>(half: &HalfPeriod<Pair<F>>, amplitude: Pair<F>) -> F {
    half.k.hypot(half.stiffness * amplitude).value()
}

impl<F: Float> HalfPeriod<Pair<F>> {
    /// `a² = α²/q² − H²`.
    #[inline(always)]
    fn squared_amplitude(&self, alpha: F) -> Pair<F> {
        (alpha.wide().square() / self.squared_stiffness()).less(self.h.square()).normalised()
    }
}

/// a², S and α_min where the turning point decides the border: from Ω = d/2 on.
///
/// It has no branches, for loops; a² is meaningless below the border.
#[cfg(feature = "batch")]
#[inline(always)]
pub(crate) fn from_turning_point<F: Float>(half: &HalfPeriod<F>, alpha: F) -> (Pair<F>, Pair<F>, F) {
    let half = half.wide();
    let least = turning_point(&half);
    (half.squared_amplitude(alpha), least, force_ratio(&half, least))
}

/// α_min by the lobe of a half period and the state there, and whether it is that; without branches. `least` is S at the
/// turning point, and `at_turning_point` the force ratio there.
#[cfg(feature = "batch")]
#[inline(always)]
pub(crate) fn from_lobe<F: Float>(
    half: &HalfPeriod<F>,
    (side, time): (F, F),
    state: &WideState<F>,
    (least, at_turning_point): (Pair<F>, F),
) -> (F, bool) {
    let wide = half.wide();
    let Refined { amplitude, is_near, .. } = refined(half, &wide, side, time, state);
    let inside = inner_force_ratio(&wide, amplitude).or_larger(at_turning_point);
    let is_above = (amplitude - least).value() > F::int(0);
    (if is_above { inside } else { at_turning_point }, is_near)
}

/// {Δ₀, α_min, A₁} without the rest of the answer; NaN where there is no cycle.
pub(crate) fn amplitude<F: Float>(ratios: &Ratios<F>) -> [F; 3] {
    let (omega, alpha, zeta) = (ratios.omega(), ratios.alpha(), ratios.damping_ratio());
    let eta = ratios.static_friction_ratio();
    fused!(<F>(omega: F, alpha: F, zeta: F, eta: F) -> [F; 3] {
        let half = HalfPeriod::of_amplitude(omega, zeta).with_static_friction(eta);
        let rising = Rising::at_force(half, alpha);
        let (displacement, size) = (rising.max_displacement, rising.loop_sizes(alpha).0);
        let least = border_of(&half).min_force_ratio;
        let nan = F::int(0) / F::int(0);
        if exists(alpha, least) { [displacement, least, size] } else { [nan, least, nan] }
    })
}

/// Whether the cycle of two reversals exists at α, given its border.
#[inline(always)]
pub(crate) fn exists<F: Float>(alpha: F, border: F) -> bool {
    (alpha >= border) & (alpha > F::int(1))
}

/// The force ratio of the largest loop A₁ and that loop, to the digits of the half period.
pub(crate) fn best<F: Float>(half: &HalfPeriod<F>) -> (F, F) {
    fused!(<'a, F>(half: &'a HalfPeriod<F>) -> (F, F) {
        let (force_ratio, loop_size) = best_of(&half.wide());
        (force_ratio.value(), loop_size.value())
    })
}

/// The force ratio of the largest loop A₁ and that loop in any arithmetic, both by `Q = hypot(K, qG)`.
///
/// With y = qa, `A₁ = 8(y − qG)/(q(y² + K²))`; `dA₁/dy = 0` is `y² − 2qGy − K² = 0`, y = qG + Q.
#[inline(always)]
pub(crate) fn best_of<R: Field>(half: &HalfPeriod<R>) -> (R, R) {
    let shift = half.stiffness * half.shift;
    let q = half.k.hypot(shift);
    let two = R::int(2);
    ((two * q * (q + shift)).sqrt(), R::int(4) / (half.stiffness * (q + shift)))
}

/// The half period at ratios with ζ > 0.
pub(crate) fn half_period<F: Float>(ratios: &Ratios<F>) -> HalfPeriod<F> {
    HalfPeriod::new(ratios.omega(), ratios.damping_ratio())
        .with_static_friction(ratios.static_friction_ratio())
}
