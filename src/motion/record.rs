//! The exact motion under a measured load: a record of a force, of an acceleration of the surface, or of a
//! displacement of the spring's support, with straight lines between its samples.
//!
//! Per mass the equation of motion is
//!
//! ```text
//! x″ + 2βx′ + ω²x + r sgn x′ = f(t) + p̄/m,     β = c/2m ≥ 0,  ω² = k/m ≥ 0,  r = friction/m.
//! ```
//!
//! While f is a straight line, slides and stops are closed forms. The body rests while the force on it is within
//! ±ηr, and is released at a time that a division gives. A slide is a sum of the responses of the linear oscillator to
//! an impulse, a step and a ramp (`linear`), and its stop is found with a proof that none was missed (`slide`).
//! `follow` goes from one to the next, `settle` on from the end of the record to rest, and `totals` collects the
//! answers.
//!
//! A spring is not required, nor a damper: a block on a surface, or on a slope, is a [`Body`] as well.
//!
//! ```
//! use stickslip::Excitation;
//! use stickslip::motion::record::{Body, Record};
//! // A block with µ = 0.1 on a surface that accelerates with 0.3 g for 1 s: Newmark's sliding block.
//! let g = 9.80665_f64;
//! let body = Body::new(1.0, 0.1 * g)?;
//! let pulse = vec![-0.3 * g, -0.3 * g];
//! let answer = body.follow(&Record::new(Excitation::SurfaceAcceleration, 1.0, pulse)?)?;
//! // With a pulse a = 0.3 g of length t and r = 0.1 g it slides by a(a − r)t²/(2r).
//! let newmark = 0.3 * g * (0.3 - 0.1) / (2.0 * 0.1);
//! assert!((answer.residual_displacement.unwrap() - newmark).abs() < 1e-14);
//! # Ok::<(), stickslip::Error>(())
//! ```

mod alone;
mod answers;
#[cfg(feature = "mp")]
#[cfg_attr(
    not(test),
    allow(
        clippy::arithmetic_side_effects,
        reason = "operators of balls and of multiple precision, which do not overflow"
    )
)]
mod balls;
mod body;
mod damper;
mod floor;
mod follow;
mod history;
#[cfg(feature = "batch")]
mod lanes;
mod linear;
mod load;
#[cfg(feature = "batch")]
mod many;
mod number;
mod quiet;
mod rows;
mod settle;
mod slide;
mod totals;
mod turns;

#[doc(hidden)]
pub use answers::Entry;
pub use answers::RecordAnswer;
#[cfg(feature = "mp")]
pub(crate) use balls::follow as follow_in_balls;
pub use body::Body;
pub use floor::FloorResponse;
pub use history::{RecordEvent, RecordMotion, RecordState};
pub use load::{After, Record};
#[cfg(feature = "batch")]
pub use many::follow_each;
#[cfg(feature = "batch")]
#[doc(hidden)]
pub use many::follow_each_while;
