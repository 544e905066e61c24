//! Time of the exact motion: the steady state from rest and from the closed form, and a period of stepping.

mod motions;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use stickslip::{Cycle, Ratios};

/// Non-sticking points, of which the first three are those of the peers' programs; near resonance; sticking
/// points.
const POINTS: [(f64, f64); 8] =
    [(1.5, 2.5), (0.7, 3.0), (1.02, 2.0), (1.0001, 2.0), (2.5, 3.0), (0.6, 4.0), (0.4, 6.0), (0.7, 1.2)];

/// Motions with stops as (Ω, α, ζ).
const WITH_STOPS: [(f64, f64, f64); 8] = [
    (0.7, 1.2, 0.0),
    (0.4, 6.0, 0.0),
    (0.15, 3.0, 0.0),
    (0.9, 1.1, 0.0),
    (0.7, 1.2, 0.05),
    (0.4, 6.0, 0.05),
    (0.15, 3.0, 0.05),
    (0.9, 1.1, 0.05),
];

fn exact(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("exact");
    for (omega, alpha) in POINTS {
        let name = format!("{omega},{alpha}");
        group.bench_function(BenchmarkId::new("steady_from_rest", &name), |b| {
            b.iter(|| motions::steady_from_rest(black_box(omega), black_box(alpha)));
        });
        group.bench_function(BenchmarkId::new("ten_periods", &name), |b| {
            b.iter(|| motions::twenty_slides(black_box(omega), black_box(alpha)));
        });
        if let Ok(cycle) = Ratios::new(omega, alpha).and_then(Cycle::new) {
            group.bench_function(BenchmarkId::new("steady_from_cycle", &name), |b| {
                b.iter(|| motions::steady_from_cycle(black_box(&cycle)));
            });
        }
    }
    for (omega, alpha, zeta) in WITH_STOPS {
        group.bench_function(BenchmarkId::new("steady_with_stops", format!("{omega},{alpha},{zeta}")), |b| {
            b.iter(|| motions::steady_with_damping(black_box(omega), black_box(alpha), black_box(zeta)));
        });
    }
    group.finish();
}

criterion_group!(benches, exact);
criterion_main!(benches);
