//! The peak velocity from the middle of the half cycle, without exponentials, circular functions or branches, so
//! that loops over it can be vectorised.
//!
//! With σ the time since the middle, `x″ + 2ζx′ + x = f_s cos Ωσ − f_c sin Ωσ − 1` makes every derivative of the two
//! before and one of the drive, and the drive is of the order of α: Taylor's series about the middle has no terms
//! that cancel, though beside Ω = 1 the driven and the free part do. One of low order leads close to the maximum; the
//! whole series is summed there, and `cycle::arrival` completes the iteration.

use crate::cycle::velocity::arrival::{Nearby, Reciprocals};
use crate::float::Float;
use crate::float::circular::{SinCos, TO_ONE};
use crate::float::pair::Pair;

/// The state in the middle of the half cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Middle<F> {
    /// x′/(Bω_n), less ΩΔ₀/B.
    pub(crate) velocity: F,
    /// x″/(Bω_n²).
    pub(crate) slope: F,
    /// x/B.
    pub(crate) displacement: F,
}

/// The moment of the peak velocity.
#[derive(Clone, Copy)]
pub(crate) struct Crest<F> {
    /// The time since the middle, in 1/ω_n.
    pub(crate) sigma: F,
    /// V₀/(Bω_d).
    pub(crate) velocity: F,
    /// Δ₁/B.
    pub(crate) displacement: F,
    /// Whether it is near enough to the middle.
    pub(crate) is_found: bool,
}

/// Terms of the series: for |Ωσ| and |σ| ≤ 17/16 the next is 3e-17.
const TERMS: usize = 19;

/// The constants of the iteration.
#[derive(Clone, Copy)]
pub(crate) struct Constants<F> {
    drive: SinCos<F, 7, 6>,
    reciprocals: Reciprocals<F>,
    /// 1/n from n = 1 on.
    all: [F; TERMS + 2],
}

impl<F: Float> Constants<F> {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        let mut all = [F::int(1); TERMS + 2];
        for (reciprocal, n) in all.iter_mut().zip(1..) {
            *reciprocal = F::ratio(1, n);
        }
        Self { drive: TO_ONE.of(), reciprocals: Reciprocals::new(), all }
    }
}

/// The first `N` derivatives of the velocity from itself and from the first of them, with those of the drive: its
/// first and second derivative.
#[inline(always)]
pub(super) fn slopes<F: Float, const N: usize>(
    (omega, zeta): (F, F),
    [velocity, slope]: [F; 2],
    [odd, even]: [F; 2],
) -> [F; N] {
    let (square, damping) = (omega * omega, F::int(-2) * zeta);
    let (mut before, mut last, mut drive, mut next) = (velocity, slope, odd, even);
    // No closure, which would not be compiled for the instructions of a loop.
    let mut all = [last; N];
    for slot in &mut all {
        *slot = last;
        last = damping.mul_add(last, drive - before);
        before = *slot;
        (drive, next) = (next, -(square * drive));
    }
    all
}

impl<F: Float> Middle<F> {
    /// The peak velocity of the half cycle with these f_c and f_s and this Δ₀/B.
    #[inline(always)]
    pub(crate) fn arrive(
        &self,
        constants: &Constants<F>,
        (omega, zeta): (F, F),
        (along, across): (F, F),
        displacement: Pair<F>,
    ) -> Crest<F> {
        let (one, square, inverse) = (F::int(1), omega * omega, F::int(1) / omega);
        let Constants { drive, reciprocals, all } = constants;
        let velocity = omega.mul_add(displacement.hi, self.velocity);
        let drives = [-(omega * along), -(square * across)];
        let derivatives: [F; TERMS] = slopes((omega, zeta), [velocity, self.slope], drives);
        let slower = if omega > one { inverse } else { one };
        let sigma = start(&derivatives, constants);
        let mut steps = *all;
        for step in &mut steps {
            *step = *step * sigma;
        }
        // The slope is Σ f_n σⁿ/n!, and its integrals have σⁿ⁺¹/(n + 1)! and σⁿ⁺²/(n + 2)!.
        let ([once @ .., _, _], [_, twice @ .., _], [_, _, thrice @ ..]) = (&steps, &steps, &steps);
        let slope = series(&derivatives, once);
        let rise = sigma * series(&derivatives, twice);
        // The displacement since the middle.
        let way = sigma * (sigma * F::ratio(1, 2)).mul_add(series(&derivatives, thrice), velocity);
        let (so, co) = drive.sin_cos(omega * sigma);
        // f = f_c cos Ωτ + f_s sin Ωτ, Ωτ = π/2 + Ωσ
        let odd = -(omega * along.mul_add(co, across * so));
        let even = -(square * across.mul_add(co, -(along * so)));
        let risen = velocity + rise;
        let slopes = slopes((omega, zeta), [risen, slope], [odd, even]);
        let found = Nearby { psi: sigma, velocity: risen, slopes, displacement: F::int(0), slower }
            .fastest(reciprocals);
        let is_near = sigma.abs() <= F::ratio(17, 16) * slower;
        let gain = self.velocity + (rise + found.gain);
        Crest {
            sigma: found.psi,
            velocity: displacement.hi + inverse.mul_add(gain, displacement.lo),
            displacement: self.displacement + (way - found.displacement),
            is_found: found.is_found & is_near,
        }
    }
}

/// A σ near the maximum: a step of Halley's from the middle, and one by the next three derivatives.
#[inline(always)]
fn start<F: Float>(derivatives: &[F; TERMS], constants: &Constants<F>) -> F {
    let [f0, f1, f2, f3, f4, f5, ..] = *derivatives;
    let [_, half, third, quarter, fifth, ..] = constants.all;
    let two = F::int(2);
    let halley = |f0: F, f1: F, f2: F| -(two * f0 * f1) / (two * f1).mul_add(f1, -(f0 * f2));
    let x = halley(f0, f1, f2);
    let (h2, h3, h4, h5) = (x * half, x * third, x * quarter, x * fifth);
    let value = h5.mul_add(f5, f4).mul_add(h4, f3).mul_add(h3, f2).mul_add(h2, f1).mul_add(x, f0);
    let slope = h4.mul_add(f5, f4).mul_add(h3, f3).mul_add(h2, f2).mul_add(x, f1);
    let bend = h3.mul_add(f5, f4).mul_add(h2, f3).mul_add(x, f2);
    x + halley(value, slope, bend)
}

/// `f_0 + s_0 (f_1 + s_1 (f_2 + …))`.
#[inline(always)]
fn series<F: Float>(derivatives: &[F; TERMS], steps: &[F; TERMS]) -> F {
    let mut sum = F::int(0);
    for (&derivative, &step) in derivatives.iter().zip(steps).rev() {
        sum = sum.mul_add(step, derivative);
    }
    sum
}
