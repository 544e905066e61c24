//! Time of systems: a step, an event, a steady motion, and how they grow.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use stickslip::Ratios;
use stickslip::motion::{LongRun, State as Phase};
use stickslip::system::{Element, Harmonic, Kind, Law, Model, Signal, State, System};

/// A chain of bodies on springs with a contact at one of them and a force on the last.
fn chain(n: usize, at: usize, friction: f64, force: f64) -> Model<f64> {
    let mut stiffness = vec![vec![0.0; n]; n];
    let mut damping = vec![vec![0.0; n]; n];
    let mut mass = vec![vec![0.0; n]; n];
    for i in 0..n {
        mass[i][i] = if i == 0 { 1.0 } else { 0.5 };
        for (matrix, factor) in [(&mut stiffness, 1.0), (&mut damping, 0.02)] {
            let k = if i == 0 { 2.0 } else { 1.0 } * factor;
            matrix[i][i] += k;
            if i > 0 {
                matrix[i - 1][i - 1] += k;
                matrix[i - 1][i] -= k;
                matrix[i][i - 1] -= k;
            }
        }
    }
    let unit = |i: usize, x: f64| (0..n).map(|j| if i == j { x } else { 0.0 }).collect::<Vec<_>>();
    Model {
        mass,
        damping,
        stiffness,
        elements: vec![Element {
            name: "contact".into(),
            direction: unit(at, 1.0),
            moves: Signal::constant(0.0),
            kind: Kind::Contact { law: Law::constant(friction), peak: 1.0, normal: None },
        }],
        harmonics: vec![Harmonic { frequency: 0.9, sin: unit(n - 1, force), cos: vec![] }],
        ..Model::default()
    }
}

fn systems(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("systems");
    let period = std::f64::consts::TAU / 0.9;
    for n in [1, 2, 4, 8, 16] {
        let system = System::new(&chain(n, 0, 1.0, 1.5)).unwrap();
        let start = State::rest(n);
        group.bench_function(BenchmarkId::new("steady", n), |b| b.iter(|| black_box(&system).steady(&start)));
        group.bench_function(BenchmarkId::new("answers_of_100_periods", n), |b| {
            b.iter(|| black_box(&system).simulate(&start, 100.0 * period));
        });
        group.bench_function(BenchmarkId::new("state_after_100_periods", n), |b| {
            b.iter(|| black_box(&system).states(&start, &[100.0 * period]));
        });
        // Without friction each velocity zero is a reversal; with much there is no event.
        let free = System::new(&chain(n, 0, 0.0, 1.5)).unwrap();
        group.bench_function(BenchmarkId::new("free_100_periods", n), |b| {
            b.iter(|| black_box(&free).states(&start, &[100.0 * period]));
        });
        let stuck = System::new(&chain(n, 0, 1e9, 1.5)).unwrap();
        group.bench_function(BenchmarkId::new("stuck_100_periods", n), |b| {
            b.iter(|| black_box(&stuck).states(&start, &[100.0 * period]));
        });
    }
    let ratios = Ratios::new(0.9, 1.5).and_then(|r| r.with_damping_ratio(0.02)).unwrap();
    group.bench_function("one_body_by_motion", |b| {
        b.iter(|| LongRun::from_start(black_box(ratios), Phase::default()))
    });
    group.finish();
}

criterion_group!(benches, systems);
criterion_main!(benches);
