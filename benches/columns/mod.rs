//! Slices for the batches to write to.

use std::hint::black_box;
use stickslip::Regime;
use stickslip::batch::{Batch, Cycles, FixedOmega, Triple};

pub(crate) struct Columns {
    regime: Vec<Option<Regime>>,
    columns: [Vec<f64>; 9],
}

#[allow(dead_code, reason = "no program uses all of them")]
impl Columns {
    pub(crate) fn new(n: usize) -> Self {
        Self { regime: vec![None; n], columns: std::array::from_fn(|_| vec![0.0; n]) }
    }

    fn three(&mut self) -> Triple<'_> {
        let [a, b, c, ..] = &mut self.columns;
        Triple { max_displacement: a, min_force_ratio: b, loop_size_stiffness: c }
    }

    fn all(&mut self) -> Cycles<'_> {
        let [a, b, c, d, e, f, g, h, i] = &mut self.columns;
        Cycles {
            regime: &mut self.regime,
            max_displacement: a,
            displacement_phase: b,
            max_velocity: c,
            velocity_phase: d,
            deviation: e,
            min_force_ratio: f,
            contraction: g,
            loop_size_stiffness: h,
            loop_size_inertia: i,
        }
    }

    pub(crate) fn triple(&mut self, batch: Batch, omega: &[f64], alpha: &[f64]) {
        assert_eq!(batch.triple(black_box(omega), black_box(alpha), self.three()), Ok(()));
    }

    pub(crate) fn cycles(&mut self, batch: Batch, omega: &[f64], alpha: &[f64]) {
        assert_eq!(batch.cycles(black_box(omega), black_box(alpha), self.all()), Ok(()));
    }

    pub(crate) fn triple_at(&mut self, batch: Batch, row: &FixedOmega, alpha: &[f64]) {
        assert_eq!(batch.triple_at(black_box(row), black_box(alpha), self.three()), Ok(()));
    }

    pub(crate) fn cycles_at(&mut self, batch: Batch, row: &FixedOmega, alpha: &[f64]) {
        assert_eq!(batch.cycles_at(black_box(row), black_box(alpha), self.all()), Ok(()));
    }
}
