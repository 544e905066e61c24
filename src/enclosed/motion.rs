//! The exact motion in balls: a proof that a periodic motion exists.
//!
//! A symmetric motion is determined by half a cycle, any other by a whole one: successive slides, each from
//! rest to rest, with stops between some of them. Its start is given by two numbers if the body never stops
//! (phase and place of a reversal), and by one if it does (the place of a stop, from which the phase of the
//! release follows). The map of the motion, mirrored after half a cycle, minus the start is a function F of
//! these numbers, and a zero of F is a periodic motion.
//!
//! **Existence and uniqueness.** For a box X around an approximate start m, and the derivatives of F over all
//! of X in balls, the interval Newton operator is `N = m − F′(X)⁻¹ F(m)`. If N lies inside X, F has exactly
//! one zero in X, and the zero is in N (Neumaier, *Interval Methods for Systems of Equations*, 1990, theorem
//! 5.1.7). Then *this periodic motion exists and is the only one of its kind in the box*.
//!
//! **The map is that of the motion.** This is proved over all of X as well (`certificate`). The velocity
//! keeps its sign throughout each slide, and its zero is the only one there. The force stays below the
//! friction force throughout each stop and passes it at the release, and it exceeds the bound at each
//! reversal. A grazing zero or a stop of zero length cannot be proved in balls: then there is no claim, and
//! [`Unproved`] names the event.
//!
//! | file | content |
//! |---|---|
//! | `outline` | the order of events, from the exact motion at f64 |
//! | `slide` | one slide in closed form, its end and its derivatives |
//! | `certificate` | no event was passed |
//! | `map` | the map of the part that repeats, and its derivatives |
//! | `steady` | the zero, and what the motion is |
//! | `unproved` | why a motion is not proved |

mod certificate;
mod map;
mod outline;
mod slide;
mod statistics;
mod steady;
mod unproved;

pub use steady::Steady;
pub(super) use steady::steady;
pub use unproved::{Event, Unproved};
