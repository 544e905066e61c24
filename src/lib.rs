//! The harmonically forced Coulomb-friction oscillator
//!
#![doc = include_str!("formulae/motion.html")]
//!
//! in closed form: whether the body sticks, how far, how fast and when it moves, the force that keeps it from
//! sticking, and the energy it dissipates. The crate also computes its exact motion, stops included. All
//! formulae are generic over a number type ([`Float`]). They follow H.-K. Hong and C.-S. Liu, “Non-sticking
//! oscillation formulae for Coulomb friction under harmonic loading”, *Journal of Sound and Vibration*
//! **244** (2001) 883–898, whose equation numbers are used throughout, and are exact where the paper is not
//! (`docs/errata.md`).
//!
//! ```
//! use stickslip::{Drive, Oscillator, Regime, Steady};
//! // 50 kN s²/m on 1000 kN/m, friction force 5 kN, driven by 12 kN at 2π rad/s
//! let body = Oscillator::new(50.0, 1000.0, 5.0)?;
//! let drive = Drive::force(12.0, std::f64::consts::TAU)?;
//! let steady = Steady::of(&body, &drive)?;
//! assert_eq!(steady.regime, Regime::NonSticking);
//! assert!((steady.max_displacement - 0.009914465_f64).abs() < 1e-9); // m
//! # Ok::<(), stickslip::Error>(())
//! ```
//!
//! # From input to answer
//!
//! [`Oscillator`] and [`Drive`] → [`Steady`], in their units, or in ratios: [`Ratios`] (Ω, α) → [`PhaseFunction`] K(Ω) → [`Cycle`],
//! [`Border`] → [`Response`], [`Verdict`] → [`design`], the inverse problems, and [`uncertainty`], parameters
//! that are not known exactly; [`Scales`] leads back to physical units, [`Output`] names the outputs.
//!
//! # The closed forms
//!
//! All lengths are in units of B = r_y/k. The formulae depend on Ω through one function, smooth through Ω = 1
//! ([`PhaseFunction`]):
//!
#![doc = include_str!("formulae/phase_function.html")]
//!
//! The peak displacement and its phase ([`Cycle::max_displacement`], [`Cycle::displacement_phase`]):
//!
#![doc = include_str!("formulae/displacement.html")]
#![doc = include_str!("formulae/displacement_phase.html")]
//!
//! The velocity on the half cycle from the minimum to the maximum, `|ψ| ≤ π/2Ω` ([`Cycle::velocity_at`]). Its
//! maximum is V₀, at t₁ ([`Cycle::max_velocity`], [`Cycle::velocity_phase`]), as also given by eq. 49 with
//! the signs of its roots corrected:
//!
#![doc = include_str!("formulae/velocity.html")]
#![doc = include_str!("formulae/max_velocity.html")]
#![doc = include_str!("formulae/deviation.html")]
//!
//! The minimum force ratio without sticking ([`Border`]). Eq. 61 is the special case S = 1/Ω², which holds
//! for Ω ≥ 1/2 (proof in `src/cycle/border.rs`):
//!
#![doc = include_str!("formulae/border.html")]
//!
//! The dissipation per cycle in units of the static energy, and the force ratio that maximises A₁
//! ([`Cycle::loop_size_stiffness`], [`Cycle::loop_size_inertia`], [`Response::best_force_ratio`]):
//!
#![doc = include_str!("formulae/dissipation.html")]
#![doc = include_str!("formulae/best_force_ratio.html")]
//!
//! The contraction of a disturbance in half a cycle, max |λ| ([`cycle::Multipliers`]):
//!
#![doc = include_str!("formulae/multipliers.html")]
//!
//! The exact motion, for any Ω and α and from any start, is in [`motion`].
//!
//! # Symbols
//!
//! | symbol | in code | meaning | unit |
//! |---|---|---|---|
//! | m, k, r_y | [`Oscillator`] | mass, stiffness, friction force | |
//! | c, r₊, r₋ | [`Oscillator`] | damping constant, friction by direction | |
//! | p₀, u_g0, ω_d, p̄ | [`Drive`] | force amplitude, base amplitude, angular frequency, mean force | |
//! | ω_n | [`Oscillator::natural_frequency`] | √(k/m) | |
//! | B | [`Oscillator::friction_displacement`] | r_y/k | length |
//! | Ω, α | [`Ratios`] | ω_d/ω_n, p₀/r_y | 1 |
//! | T | in [`PhaseFunction`] | tan(π/2Ω) = sin π₁/(1 + cos π₁) | 1 |
//! | K | [`PhaseFunction::value`] | (1 − Ω²) T/Ω | 1 |
//! | Δ₀, ω_d t₂ | [`Cycle::max_displacement`], [`Cycle::displacement_phase`] | peak displacement, its phase | B, rad |
//! | V₀, ω_d t₁ | [`Cycle::max_velocity`], [`Cycle::velocity_phase`] | peak velocity, its phase | Bω_d, rad |
//! | Δ₁ | [`Cycle::deviation`] | displacement at the peak velocity | B |
//! | α_min | [`Border::min_force_ratio`] | minimum force ratio without sticking | 1 |
//! | A₁, A₂ | [`Cycle::loop_size_stiffness`], [`Cycle::loop_size_inertia`] | loop per static energy | 1 |
//! | α*, A₁max | [`Response::best_force_ratio`], [`Response::best_loop_size`] | the largest loop | 1 |
//! | λ | [`Cycle::contraction`], [`Cycle::multipliers`] | multipliers per half cycle, the largest | 1 |
//! | τ* | [`Border::border_phase`] | where the velocity first touches zero | rad |
//!
//! # Features
//!
//! * `std`, a default: the processor's fused operations and Brent's method of the crate roots. Without it
//!   the library is `no_std` with alloc, several times slower, and a search for a zero may differ in its last digits;
//! * `identify`, the other default: friction and damping from what was measured (`design::identify`). It takes half of the time to
//!   compile the library;
//! * `mp`: the number `float::Mp<LIMBS>` of 64 to 8192 bits and more, for every formula here. It links
//!   GMP and MPFR (LGPL-3.0-or-later), which the first build compiles from C in about five minutes and which
//!   needs m4 and make;
//! * `dual`: the number `float::Dual<N>` with derivatives by N parameters, and `sensitivity`: every
//!   output by every parameter;
//! * `random`: Monte-Carlo over distributions of the parameters (`uncertainty::MonteCarlo`);
//! * `serde`: machines, ratios and states to and from serde's formats, and every result and error to them;
//! * `batch`: many points at once by vector instructions chosen at run time (`batch::Batch`); `rayon`: on
//!   threads;
//! * `generators`: adversarial inputs for property tests and fuzzing of code that uses this library
//!   (`generators`);
//! * `system`: several bodies with several contacts, laws of speed, elastic contacts and stops (`system`);
//! * `matching`: the matching problem solved by Newton's method with nalgebra
//!   (`cycle::matching::newton`), over `Mp` too with `mp`.

#![cfg_attr(not(any(feature = "std", test)), no_std)]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![cfg_attr(
    not(test),
    deny(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::indexing_slicing,
        clippy::arithmetic_side_effects,
        clippy::unreachable,
        clippy::wildcard_enum_match_arm
    )
)]

extern crate alloc;

// Tests of the formulae by their internal names, written with the crate's name as users write it.
#[cfg(test)]
extern crate self as stickslip;
#[cfg(test)]
#[path = "../tests/drawn/mod.rs"]
mod drawn;
#[cfg(test)]
#[path = "../tests/formulae/mod.rs"]
mod formulae;
#[cfg(all(test, feature = "matching"))]
#[path = "../tests/matching/mod.rs"]
mod matching;
#[cfg(test)]
#[path = "../tests/symbolic/mod.rs"]
mod symbolic;

#[cfg(feature = "batch")]
#[cfg_attr(
    not(test),
    allow(clippy::arithmetic_side_effects, reason = "places within the slices given, and lanes of numbers")
)]
pub mod batch;
#[cfg_attr(
    not(test),
    allow(
        clippy::arithmetic_side_effects,
        reason = "the counters of series and lobes, bounded by the precision and by u16"
    )
)]
pub mod cycle;
pub mod design;
#[cfg(feature = "mp")]
#[cfg_attr(
    not(test),
    allow(
        clippy::arithmetic_side_effects,
        reason = "operators of balls and of ratios; exponents, which are bounded"
    )
)]
pub mod enclosed;
pub mod float;
// The numbers of the tests are those of the programs in tests/.
#[cfg(test)]
#[path = "../tests/random/generator.rs"]
mod random;

#[cfg(feature = "generators")]
#[doc(hidden)]
pub mod generators;
mod greatest;
mod machine;
pub mod motion;
mod named;
mod output;
#[cfg(doctest)]
mod pages;
mod root;
#[cfg(feature = "dual")]
#[cfg_attr(not(test), allow(clippy::arithmetic_side_effects, reason = "operators of duals over f64"))]
pub mod sensitivity;
#[cfg(feature = "serde")]
mod serialized;
mod steady;
#[cfg(feature = "system")]
#[cfg_attr(
    not(test),
    allow(
        clippy::arithmetic_side_effects,
        reason = "places within a state and degrees of polynomials, both small"
    )
)]
pub mod system;
pub mod uncertainty;

/// For the crates of this repository, which read inputs and print answers: it may change without notice.
#[doc(hidden)]
pub mod internal {
    pub use crate::machine::oscillator::critical_damping;
    pub use crate::machine::ratios::{non_negative, positive, springless_exponent};
    pub use crate::motion::limit::observed::{Observed, Stops, observed, stops_per_cycle};
    pub use crate::output::{Column, Dimension, Kind, ResponseAnswer, Value, When, definitions};
}

/// The crates whose types and traits occur in this API, in the required versions.
pub mod dependencies {
    #[cfg(feature = "generators")]
    pub use arbitrary;
    #[cfg(feature = "matching")]
    pub use nalgebra;
    pub use num_traits;
    #[cfg(feature = "random")]
    pub use rand;
    #[cfg(feature = "mp")]
    pub use rug;
}

pub use cycle::{Border, Cycle};
pub use float::{Field, Float, Real};
pub use machine::error::{Error, Number, Quantity};
pub use machine::oscillator::{Drive, Excitation, Oscillator, Scales};
pub use named::UnknownName;
pub use output::{Definition, Measure, Output};
// The values of whole answers, for the command and the Python package.
pub use cycle::phase_function::PhaseFunction;
pub use cycle::regime::{Family, NoStop, Regime, Verdict};
pub use machine::ratios::Ratios;
// The regime of an exact motion, as the command and the Python package report it.
pub use cycle::response::Response;
pub use steady::{Sample, Steady};
