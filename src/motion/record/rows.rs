//! Numbers of bodies side by side, or of steps, in rows that loops take in vector lanes.

#[cfg(feature = "batch")]
use super::quiet::{Limits, Quiet};
use crate::float::Float;

/// A number of each lane, or of each step of a block.
pub(super) type Row<F, const L: usize> = [F; L];

#[inline(always)]
pub(super) fn at<F: Float, const L: usize>(row: &Row<F, L>, lane: usize) -> F {
    row.get(lane).copied().unwrap_or_else(|| F::int(0))
}

#[inline(always)]
pub(super) fn set<T, const L: usize>(row: &mut [T; L], lane: usize, value: T) {
    if let Some(place) = row.get_mut(lane) {
        *place = value;
    }
}

#[inline(always)]
pub(super) fn select<F>(condition: bool, yes: F, no: F) -> F {
    if condition { yes } else { no }
}

/// The numbers of a structure of all lanes.
#[cfg(feature = "batch")]
macro_rules! rows {
    ($rows:ident of $one:ident: $($field:ident,)*) => {
        #[derive(Debug)]
        pub(super) struct $rows<F, const L: usize> {
            $(pub(super) $field: Row<F, L>,)*
        }

        impl<F: Float, const L: usize> $rows<F, L> {
            pub(super) fn none() -> Self {
                let none = $one::<F>::none();
                Self { $($field: [none.$field; L],)* }
            }

            #[inline(always)]
            pub(super) fn at(&self, lane: usize) -> $one<F> {
                $one { $($field: at(&self.$field, lane),)* }
            }

            #[inline(always)]
            pub(super) fn set(&mut self, lane: usize, one: &$one<F>) {
                $(set(&mut self.$field, lane, one.$field);)*
            }
        }
    };
}

#[cfg(feature = "batch")]
pub(super) use rows;

#[cfg(feature = "batch")]
rows! {
    QuietRows of Quiet:
    factor, damper, push, rate, square, omega, sign, impulse, step, ramp, x_of_x, v_of_x, v_of_v, area_of_v,
    area_of_slope, beyond_v, beyond_a, below, beyond_jerk, never,
}

#[cfg(feature = "batch")]
rows! {
    LimitsRows of Limits:
    most_speed, fastest, most_a, least_a, most_free, least_free,
}
