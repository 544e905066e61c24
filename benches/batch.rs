//! Time per point of the batches, with every instruction set of the processor, and of the exact steady state.

mod columns;
mod points;

use columns::{ALL, FIVE, Room, THREE};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use stickslip::batch::{Batch, Level};

fn batch(criterion: &mut Criterion) {
    let n = 8192;
    let mut room = Room::new(n);
    let (omega, alpha): (Vec<_>, Vec<_>) = points::points(n).into_iter().unzip();
    let (low_omega, low_alpha): (Vec<_>, Vec<_>) = points::points_from(n, 0.35).into_iter().unzip();
    let mut group = criterion.benchmark_group("batch");
    group.throughput(Throughput::Elements(n as u64));
    let mut batches: Vec<(String, Box<dyn Fn() -> Batch<'static>>)> = Vec::new();
    for level in Level::ALL.into_iter().filter(|level| level.is_available()) {
        batches.push((format!("{level:?}"), Box::new(move || Batch::new().at_level(level))));
    }
    #[cfg(feature = "rayon")]
    batches.push(("threads".to_owned(), Box::new(|| Batch::new().on_threads())));
    for (name, batch) in batches.drain(..) {
        group
            .bench_function(format!("triple/{name}"), |b| b.iter(|| room.run(&batch, &omega, &alpha, THREE)));
        group.bench_function(format!("peaks/{name}"), |b| b.iter(|| room.run(&batch, &omega, &alpha, FIVE)));
        group.bench_function(format!("peaks from 0.35/{name}"), |b| {
            b.iter(|| room.run(&batch, &low_omega, &low_alpha, FIVE));
        });
        group.bench_function(format!("cycles/{name}"), |b| b.iter(|| room.run(&batch, &omega, &alpha, ALL)));
        group.bench_function(format!("cycles from 0.35/{name}"), |b| {
            b.iter(|| room.run(&batch, &low_omega, &low_alpha, ALL));
        });
        let row = vec![1.5; alpha.len()];
        group.bench_function(format!("triple at fixed Ω/{name}"), |b| {
            b.iter(|| room.run(&batch, &row, &alpha, THREE));
        });
        group.bench_function(format!("peaks at fixed Ω/{name}"), |b| {
            b.iter(|| room.run(&batch, &row, &alpha, FIVE));
        });
        group.bench_function(format!("cycles at fixed Ω/{name}"), |b| {
            b.iter(|| room.run(&batch, &row, &alpha, ALL));
        });
    }
    group.finish();
}

criterion_group!(benches, batch);
criterion_main!(benches);
