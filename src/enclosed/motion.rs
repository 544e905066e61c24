//! The exact motion in balls: a periodic motion that is proved to exist.
//!
//! A symmetric motion is known from half a cycle, any other from a whole one: slides one after the other,
//! each from rest to rest, with stops between some of them. What it starts from is two numbers where the body
//! never stops (phase and place of a reversal) and one where it does (the place of a stop; the phase of the
//! release follows). The map of the motion less the start, mirrored after half a cycle, is a function F of
//! those, and a zero of F is a periodic motion.
//!
//! **Existence and uniqueness.** With a box X around an approximate start m, and the derivatives of F over
//! all of X in balls, the interval Newton operator `N = m − F′(X)⁻¹ F(m)` is computed. N inside X proves that
//! F has exactly one zero in X, and that it is in N (Neumaier, *Interval Methods for Systems of Equations*,
//! 1990, theorem 5.1.7). So *this periodic motion exists and is the only one of its kind in the box*.
//!
//! **That the map is the motion's** is shown over all of X as well (`certificate`): the velocity keeps its
//! sign throughout each slide, its zero is the only one there, the force stays below the friction bound
//! throughout each stop and passes it at the release, and exceeds it at each reversal. What is only touched,
//! a grazing or a stop of no length, cannot be shown in balls: then nothing is claimed, and [`Unproved`]
//! names the event.
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

pub use steady::{Steady, steady};
pub use unproved::{Event, Unproved};
