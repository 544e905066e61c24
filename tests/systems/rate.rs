//! How fast a system changes, and how many steps it is followed for.

use crate::compared::Origin::ByHand;
use crate::compared::{agreed, compared};
use stickslip::system::{Element, Harmonic, Kind, Law, Model, Signal, System};

/// The greatest root of `s² − (c + |slope|) s − k`, or the frequency of the load.
#[test]
fn the_rate_is_the_greatest_root_by_hand() {
    for (damping, slope, frequency) in [(0.0, 0.0, 1.0), (50.0, 0.0, 1.0), (2.0, 7.0, 1.0), (0.0, 0.0, 300.0)]
    {
        let law = Law { points: vec![(0.0, 1.0), (1.0, 1.0 + 0.1 * slope), (2.0, 1.0 + 1.1 * slope)] };
        let system = System::new(&Model {
            mass: vec![vec![1.0]],
            damping: vec![vec![damping]],
            stiffness: vec![vec![100.0]],
            elements: vec![Element {
                name: "contact".into(),
                direction: vec![1.0],
                moves: Signal::constant(0.0),
                kind: Kind::Contact { law, peak: 1.0, normal: None },
            }],
            harmonics: vec![Harmonic { frequency, sin: vec![1.0], cos: vec![] }],
            ..Model::default()
        })
        .unwrap();
        let rate = damping + slope;
        let due = (rate / 2.0 + f64::hypot(rate / 2.0, 10.0)).max(frequency);
        let found: f64 = system.steps_per_time();
        assert!(found >= (1.0 - 1e-12) * due, "{damping} {slope}: {found} {due}");
        compared("fn system::System::steps_per_time", found, due, ByHand, 0.01 * due);
    }
}

/// A motion is followed for 512·10⁶ products of steps: 2n rows of displacements and velocities, by as many columns with sine,
/// cosine and 1 beside them. A small state has the steps of 256 products, for what a step costs beside them.
#[test]
fn the_most_steps_are_the_budget_by_hand() {
    for (n, due) in
        [(60_usize, 512_000_000 / (120 * 123)), (20, 512_000_000 / (40 * 43)), (2, 512_000_000 / 256)]
    {
        let diagonal = |value: f64| -> Vec<Vec<f64>> {
            (0..n).map(|i| (0..n).map(|j| if i == j { value } else { 0.0 }).collect()).collect()
        };
        let system: System<f64> = System::new(&Model {
            mass: diagonal(1.0),
            damping: diagonal(0.0),
            stiffness: diagonal(2.0),
            harmonics: vec![Harmonic { frequency: 1.0, sin: vec![1.0; n], cos: vec![] }],
            ..Model::default()
        })
        .unwrap();
        agreed("fn system::System::most_steps", system.most_steps(), due, ByHand);
    }
}
