//! {Δ₀, α_min, A₁} of a block.

use super::amplitude::{Amplitude, Domain};
use super::block::{AtPoint, Block, each, each_straight};
use super::careful;
use super::kernel::{Kernel, Work};
use super::low::{LowParts, LowSizes, has_low_loops};
use crate::float::circular::held;
use crate::phase_function::Quotient;

/// {Δ₀, α_min, A₁}.
pub(crate) struct TripleKernel;

impl Kernel<3> for TripleKernel {
    const MARK: usize = 1;

    #[inline(always)]
    fn pass(&self, omega: &Block, alpha: &Block, _: &mut Work, out: [&mut Block; 3]) {
        each(&Point::new(), [omega, alpha], out);
    }

    const IS_STRAIGHT: bool = true;

    #[inline(always)]
    fn pass_straight(&self, omega: &[Block], alpha: &[Block], [a, b, c]: [&mut [Block]; 3]) {
        each_straight(&Point::new(), omega, alpha, a, b, c);
    }

    #[inline(always)]
    fn pass_low(&self, omega: &Block, alpha: &Block, work: &mut Work, out: [&mut Block; 3]) {
        let [k, rest, inverse, sin_beta, cos_beta, border, ..] = work;
        each(&LowParts, [omega], [k, rest, inverse, sin_beta, cos_beta, border]);
        each::<5, 3>(&LowSizes::new(), [omega, alpha, k, rest, border], out);
    }

    fn has_low(&self, omega: f64) -> bool {
        has_low_loops(omega)
    }

    fn careful(&self, omega: f64, alpha: f64) -> [f64; 3] {
        careful::triple(omega, alpha)
    }
}

/// `[Δ₀, α_min, A₁]`; NaN for α_min says that the point is to be redone.
#[derive(Clone, Copy)]
struct Point(Quotient<f64>, Domain);

impl Point {
    #[inline(always)]
    fn new() -> Self {
        Self(held(Quotient::new()), Domain::new())
    }
}

impl AtPoint<2, 3> for Point {
    #[inline(always)]
    fn at(&self, [omega, alpha]: [f64; 2]) -> [f64; 3] {
        let found = Amplitude::high(&self.1, omega, alpha, self.0.at(omega));
        [found.displacement(), found.border, found.size()]
    }
}
