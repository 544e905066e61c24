//! Many systems on all cores.

use super::{Error, Model, System};
use crate::float::Float;
use alloc::vec::Vec;
use rayon::prelude::*;

/// The answers of many models in their order, on all cores: each model is checked, and `solve` is called with its system.
///
/// An error of one model is its own: the others have their answers. The answers have the bits of one core.
///
/// ```
/// use stickslip::system::{Element, Harmonic, Kind, Law, Model, Signal, State, solve_each};
/// // A body of 1 on a spring of 1 under 2 sin 1.5t, for three frictions.
/// let model = |friction: f64| Model {
///     mass: vec![vec![1.0]],
///     damping: vec![vec![0.0]],
///     stiffness: vec![vec![1.0]],
///     elements: vec![Element {
///         name: "ground".into(),
///         direction: vec![1.0],
///         moves: Signal::constant(0.0),
///         kind: Kind::Contact { law: Law::constant(friction), peak: 1.0, normal: None },
///     }],
///     harmonics: vec![Harmonic { frequency: 1.5, sin: vec![2.0], cos: vec![] }],
///     ..Model::default()
/// };
/// let models: Vec<_> = [0.2, 0.5, 3.0].map(model).into();
/// let greatest = solve_each(&models, |system| {
///     system.steady(&State::rest(1)).map(|steady| steady.motion.max_displacement[0])
/// });
/// assert!(greatest.into_iter().collect::<Result<Vec<_>, _>>()?.is_sorted_by(|a, b| a > b));
/// # Ok::<(), stickslip::system::Error>(())
/// ```
pub fn solve_each<F: Float + Send + Sync, T: Send>(
    models: &[Model<F>],
    solve: impl Fn(&System<F>) -> Result<T, Error> + Sync,
) -> Vec<Result<T, Error>> {
    models.par_iter().map(|model| System::new(model).and_then(|system| solve(&system))).collect()
}
