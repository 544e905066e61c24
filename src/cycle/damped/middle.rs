//! The maximum velocity from the middle of the half cycle, without exponentials, circular functions or branches, so
//! that loops over it can be vectorised.
//!
//! With σ the time since the middle, `x″ + 2ζx′ + x = f_s cos Ωσ − f_c sin Ωσ − 1` makes every derivative of the two
//! before and one of the drive, and the drive is of the order of α: Taylor's series about the middle has no terms
//! that cancel, though beside Ω = 1 the driven and the free part do. One of low order leads close to the maximum; the
//! whole series is summed there, and `cycle::arrival` completes the iteration.

use crate::cycle::arrival::{Nearby, Reciprocals};
use crate::float::circular::{SinCos, TO_ONE};
use crate::float::pair::Pair;
use crate::float::{Field, Float};

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

/// The moment of the maximum velocity.
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
        let mut n = 0;
        let all = [(); TERMS + 2].map(|()| {
            n += 1;
            F::ratio(1, n)
        });
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
    [(); N].map(|()| {
        let found = last;
        last = damping.mul_add(last, drive - before);
        before = found;
        (drive, next) = (next, -(square * drive));
        found
    })
}

impl<F: Float> Middle<F> {
    /// The maximum velocity of the half cycle with these f_c and f_s and this Δ₀/B.
    #[inline(always)]
    pub(crate) fn arrive(
        &self,
        constants: &Constants<F>,
        (omega, zeta): (F, F),
        (along, across): (F, F),
        displacement: Pair<F>,
    ) -> Crest<F> {
        let (one, square, inverse) = (F::int(1), omega * omega, F::int(1) / omega);
        let Constants { drive, reciprocals, all: reciprocals_of_all } = constants;
        let velocity = omega.mul_add(displacement.hi, self.velocity);
        let drives = [-(omega * along), -(square * across)];
        let derivatives: [F; TERMS] = slopes((omega, zeta), [velocity, self.slope], drives);
        let slower = if omega > one { inverse } else { one };
        let nearby = |psi, velocity, slopes, displacement| {
            Nearby { psi, velocity, slopes, displacement, slower }.fastest(reciprocals)
        };
        let [a, b, c, d, e, f, g, h, ..] = derivatives;
        let zero = F::int(0);
        let sigma = nearby(zero, velocity, [a, b, c, d, e, f, g, h], zero).psi;
        let steps = reciprocals_of_all.map(|reciprocal| sigma * reciprocal);
        let slope = series(&derivatives, &steps, 0);
        let rise = sigma * series(&derivatives, &steps, 1);
        // The displacement since the middle.
        let way = sigma * (sigma * F::ratio(1, 2)).mul_add(series(&derivatives, &steps, 2), velocity);
        let (so, co) = drive.sin_cos(omega * sigma);
        // f = f_c cos Ωτ + f_s sin Ωτ, Ωτ = π/2 + Ωσ
        let odd = -(omega * along.mul_add(co, across * so));
        let even = -(square * across.mul_add(co, -(along * so)));
        let near: [F; 8] = slopes((omega, zeta), [velocity + rise, slope], [odd, even]);
        let found = nearby(sigma, velocity + rise, near, zero);
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

/// `k! Σ f_n σⁿ/(n + k)!` by σ, σ/2, σ/3, ….
#[inline(always)]
fn series<F: Float>(derivatives: &[F; TERMS], steps: &[F; TERMS + 2], k: usize) -> F {
    let (mut sum, mut terms) = (F::int(0), derivatives.iter().zip(steps.iter().skip(k)).rev());
    if let Some((&last, _)) = terms.next() {
        sum = last;
    }
    let mut step = steps.iter().skip(k).take(TERMS - 1).rev();
    for (&derivative, _) in terms {
        if let Some(&step) = step.next() {
            sum = sum.mul_add(step, derivative);
        }
    }
    sum
}

impl<F: Field> Middle<F> {
    /// Converts each part to another number type.
    #[inline(always)]
    pub(crate) fn map<G>(self, to: impl Fn(F) -> G) -> Middle<G> {
        Middle { velocity: to(self.velocity), slope: to(self.slope), displacement: to(self.displacement) }
    }
}
