//! The equations of the paper by exact algebra over ℚ, on the library's own functions.
//!
//! `docs/development/proof.md` states which equation follows from which, and in what sense.

mod angles;
mod balanced;
mod border;
mod damped;
mod den_hartog;
mod dissipation;
mod fraction;
mod ideal;
mod matching;
mod one_text;
mod operators;
mod polynomial;
mod scalar;
mod setting;
mod velocity;
