//! Slices for the results of batches.

use std::hint::black_box;
use stickslip::batch::Batch;
use stickslip::{Output, Ratios, Regime};

/// {Δ₀, α_min, A₁}, which one loop computes, and the outputs that need further loops.
const OUTPUTS: [Output; 9] = [
    Output::MaxDisplacement,
    Output::MinForceRatio,
    Output::LoopSizeStiffness,
    Output::MaxVelocity,
    Output::VelocityPhase,
    Output::DisplacementPhase,
    Output::Deviation,
    Output::Contraction,
    Output::LoopSizeInertia,
];
/// Numbers of outputs, counted from the first.
pub(crate) const THREE: usize = 3;
pub(crate) const FIVE: usize = 5;
/// All outputs and the regime.
pub(crate) const ALL: usize = OUTPUTS.len();

pub(crate) struct Room {
    regime: Vec<Option<Regime>>,
    numbers: [Vec<f64>; ALL],
}

#[allow(dead_code, reason = "no program uses all of them")]
impl Room {
    pub(crate) fn new(n: usize) -> Self {
        Self { regime: vec![None; n], numbers: std::array::from_fn(|_| vec![0.0; n]) }
    }

    fn columns<'a>(&'a mut self, batch: Batch<'a>, count: usize) -> Batch<'a> {
        let slices = OUTPUTS.into_iter().zip(&mut self.numbers).take(count);
        let batch = slices.fold(batch, |batch, (output, slice)| batch.with(output, slice));
        if count == ALL { batch.with_regime(&mut self.regime) } else { batch }
    }

    pub(crate) fn run(
        &mut self,
        batch: impl Fn() -> Batch<'static>,
        omega: &[f64],
        alpha: &[f64],
        count: usize,
    ) {
        assert_eq!(self.columns(batch(), count).run(black_box(omega), black_box(alpha)), Ok(()));
    }

    /// Points that may have a damper.
    pub(crate) fn run_each(
        &mut self,
        batch: impl Fn() -> Batch<'static>,
        points: &[Ratios<f64>],
        count: usize,
    ) {
        let points = black_box(points);
        let at = |i: usize| points.get(i).copied();
        assert_eq!(self.columns(batch(), count).run_each(points.len(), at), Ok(()));
    }
}
