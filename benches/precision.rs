//! Time per point of the closed forms at 256, 1024 and 4096 bits.

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use stickslip::float::Mp;
use stickslip::{Cycle, Field, Float, PhaseFunction, Ratios};

/// {Δ₀, eq. 61, A₁}
fn triple<F: Float>(omega: F, alpha: F) -> Option<[F; 3]> {
    let p = PhaseFunction::new(omega).ok()?;
    let (k, one) = (p.value(), F::int(1));
    let q = (one - omega) * (one + omega);
    // The formulae as written, at the precision of the type.
    let delta = alpha.leg(k) / q.abs();
    Some([delta, k.hypot(q / omega.square()), (delta / alpha / alpha).times(8)])
}

/// A checked [`Cycle`], with all its outputs.
fn cycle<F: Float>(omega: F, alpha: F) -> Option<Cycle<F>> {
    Cycle::new(Ratios::new(omega, alpha).ok()?).ok()
}

fn at<const L: usize>(criterion: &mut Criterion) {
    let (omega, alpha) = (Mp::<L>::ratio(23, 14), Mp::<L>::ratio(11, 3));
    let mut group = criterion.benchmark_group(format!("{} bits", Mp::<L>::BITS));
    macro_rules! bench {
        ($($name:literal: $kernel:expr;)*) => {$(
            group.bench_function($name, |b| b.iter(|| $kernel(black_box(omega), black_box(alpha))));
        )*};
    }
    bench! {
        "Δ₀, border, A₁": triple;
        "Δ₀, border, A₁, t₁, V₀ and all other outputs": cycle;
    }
    group.finish();
}

fn precision(criterion: &mut Criterion) {
    at::<4>(criterion);
    at::<16>(criterion);
    at::<64>(criterion);
}

criterion_group!(benches, precision);
criterion_main!(benches);
