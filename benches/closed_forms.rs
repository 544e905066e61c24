//! Time per point of the closed forms.

mod kernels;
mod points;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;

fn closed_forms(criterion: &mut Criterion) {
    let points = points::points(4096);
    let mut group = criterion.benchmark_group("closed_forms");
    group.throughput(Throughput::Elements(points.len() as u64));
    macro_rules! bench {
        ($name:literal, $kernel:path) => {
            group.bench_function($name, |b| {
                b.iter(|| {
                    for &(omega, alpha) in &points {
                        black_box($kernel(black_box(omega), black_box(alpha)));
                    }
                });
            });
        };
    }
    bench!("triple", kernels::triple);
    bench!("cycle", kernels::cycle);
    group.finish();
}

criterion_group!(benches, closed_forms);
criterion_main!(benches);
