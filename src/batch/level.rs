//! The vector instruction sets for which the loops are compiled, chosen at run time.

#[cfg(target_arch = "x86_64")]
use pulp::x86::{V3, V4};

/// The instruction set of a batch.
///
/// One source serves all of them, with the same fused products in the same order, so that all give the same
/// bits. [`Level::Scalar`] is the library's own code for one point at a time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Level {
    /// Point by point, without the batch loops: where the processor has no fused product, the other levels
    /// would be slower.
    Scalar,
    /// The instructions for which the program was compiled.
    Portable,
    /// x86-64 with AVX2 and FMA: four points at a time.
    Avx2,
    /// x86-64 with AVX-512 (F, BW, CD, DQ, VL): eight points at a time.
    Avx512,
}

impl Level {
    /// Every level, the fastest last.
    pub const ALL: [Self; 4] = [Self::Scalar, Self::Portable, Self::Avx2, Self::Avx512];

    /// The fastest level that this processor supports.
    #[must_use]
    pub fn best() -> Self {
        if Self::Avx512.is_available() {
            Self::Avx512
        } else if Self::Avx2.is_available() {
            Self::Avx2
        } else if cfg!(any(target_arch = "aarch64", target_feature = "fma")) {
            Self::Portable
        } else {
            Self::Scalar
        }
    }

    /// Whether this processor supports the level.
    #[must_use]
    pub fn is_available(self) -> bool {
        match self {
            Self::Scalar | Self::Portable => true,
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => V3::is_available(),
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => V4::is_available(),
            #[cfg(not(target_arch = "x86_64"))]
            Self::Avx2 | Self::Avx512 => false,
        }
    }

    /// Runs the loops of `task` with these instructions, or with those of the program where the processor
    /// does not support them.
    #[inline]
    pub(crate) fn run<T: Loops>(self, task: T) -> T::Output {
        #[cfg(target_arch = "x86_64")]
        match self {
            Self::Avx2 => {
                if let Some(processor) = V3::try_new() {
                    return processor.vectorize(Vectorized(task));
                }
            }
            Self::Avx512 => {
                if let Some(processor) = V4::try_new() {
                    return processor.vectorize(Vectorized(task));
                }
            }
            Self::Scalar | Self::Portable => {}
        }
        task.run()
    }
}

/// Loops to be compiled once for each level: `run`, and every function that it calls, must be
/// `#[inline(always)]`.
pub(crate) trait Loops {
    /// The result.
    type Output;

    /// Runs them.
    fn run(self) -> Self::Output;
}

#[cfg(target_arch = "x86_64")]
struct Vectorized<T>(T);

#[cfg(target_arch = "x86_64")]
impl<T: Loops> pulp::NullaryFnOnce for Vectorized<T> {
    type Output = T::Output;

    #[inline(always)]
    fn call(self) -> T::Output {
        self.0.run()
    }
}
