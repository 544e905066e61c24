//! The figures of the paper, redrawn from this library's results, and some additional ones.
//!
//! | file | figures |
//! |---|---|
//! | `oscillator` | 1: the oscillator and its law of friction |
//! | `symmetry` | 3: the error measures |
//! | `response` | 4–7: Δ₀/B, the two phases, Δ₁/B, V₀/(Bω_d) |
//! | `border` | 8: the least force ratio without sticking; the neighbourhood of the poles 1/3 and 1/5 |
//! | `dissipation` | 9a, 9b, 10a, 10b: the loop sizes |
//! | `stops` | the map of stops per cycle |
//! | `portrait` | 2: a cycle without stops in the phase plane; two motions with their transients |
//! | `accuracy` | digits lost near Ω = 1 |
//! | `multipliers` | the rate at which the motion settles |
//! | `damping` | the effect of viscous damping |
//! | `impacts` | blows at a rigid stop, whose period doubles |
//! | `shared` | what several of them show |
//!
//! A figure is data first: [`Figure::write_csv`] writes the data that [`Figure::svg`] draws. The crate `stickslip-draw` draws it.
//!
//! ```
//! let border = stickslip_figures::figure("8").unwrap();
//! assert!(border.svg()?.starts_with("<svg"));
//! # Ok::<(), std::io::Error>(())
//! ```

#![cfg_attr(
    not(test),
    deny(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::indexing_slicing,
        clippy::unreachable,
        clippy::wildcard_enum_match_arm
    )
)]

mod accuracy;
mod border;
mod damping;
mod dissipation;
mod impacts;
mod multipliers;
mod oscillator;
mod portrait;
mod response;
mod shared;
mod stops;
mod symmetry;

pub use stickslip_draw::Figure;

/// Defines the figures from one row each: the name, and the function that makes it.
macro_rules! figures {
    ($($name:literal => $of:path),* $(,)?) => {
        /// The names of all figures, in order; those of the paper have their numbers.
        pub const NAMES: [&str; [$($name),*].len()] = [$($name),*];

        /// The figure with that name, one of [`NAMES`].
        #[must_use]
        pub fn figure(name: &str) -> Option<Figure> {
            match name {
                $($name => Some($of()),)*
                _ => None,
            }
        }
    };
}

figures! {
    "1" => oscillator::with_friction,
    "2" => portrait::in_phase_plane,
    "3" => symmetry::errors,
    "4" => response::max_displacement,
    "5" => response::phases,
    "6" => response::deviation,
    "7" => response::max_velocity,
    "8" => border::least_force,
    "9a" => dissipation::best_force,
    "9b" => dissipation::largest_loop,
    "10a" => dissipation::loop_by_friction,
    "10b" => dissipation::loop_by_frequency,
    "stops" => stops::per_cycle,
    "portrait" => portrait::two_motions,
    "accuracy" => accuracy::beside_one,
    "multipliers" => multipliers::of_the_cycle,
    "poles" => border::beside_poles,
    "damping" => damping::four_ratios,
    "impacts" => impacts::over_frequency,
}
