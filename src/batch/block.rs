//! Blocks of points: short enough to stay in the first-level cache through several loops, long enough to fill
//! the vectors.

/// Points in a block.
pub(crate) const POINTS: usize = 128;

/// One quantity at the points of a block.
pub(crate) type Block = [f64; POINTS];

/// Computes `O` quantities from `I` others at one point, without branches or calls.
///
/// This is a trait with `#[inline(always)]` functions because closures and function pointers cannot be forced
/// inline, and a function that is not inlined is not compiled for the level's instructions.
pub(crate) trait AtPoint<const I: usize, const O: usize> {
    fn at(&self, inputs: [f64; I]) -> [f64; O];
}

/// One loop over a block: `outputs = f(inputs)`, point by point.
///
/// It is simple enough for the compiler to vectorise.
#[inline(always)]
pub(crate) fn each<const I: usize, const O: usize>(
    f: &impl AtPoint<I, O>,
    inputs: [&Block; I],
    mut outputs: [&mut Block; O],
) {
    for i in 0..POINTS {
        let values = f.at(inputs.map(|block| block.get(i).copied().unwrap_or(0.0)));
        for (block, value) in outputs.iter_mut().zip(values) {
            if let Some(slot) = block.get_mut(i) {
                *slot = value;
            }
        }
    }
}

/// Sets quantities of the point at place `i`.
#[inline]
pub(crate) fn set<const N: usize>(blocks: &mut [Block], i: usize, values: [f64; N]) {
    for (block, value) in blocks.iter_mut().zip(values) {
        if let Some(slot) = block.get_mut(i) {
            *slot = value;
        }
    }
}

/// `yes` where `condition` holds, `no` elsewhere. Both are computed, so that there is no branch.
#[inline(always)]
pub(crate) fn select(condition: bool, yes: f64, no: f64) -> f64 {
    if condition { yes } else { no }
}

/// Fills a block with `points`, repeating the last of them to the end.
pub(crate) fn pad(points: &[f64], block: &mut Block) {
    let last = points.last().copied().unwrap_or_default();
    for (slot, x) in block.iter_mut().zip(points.iter().copied().chain(core::iter::repeat(last))) {
        *slot = x;
    }
}
