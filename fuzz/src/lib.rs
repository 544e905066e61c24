//! What the fuzz targets check, compiled once for all of them. Every function panics on a finding.

#[path = "../../tests/invariants/batches.rs"]
mod batches;
#[path = "../../tests/invariants/blows.rs"]
mod blows;
#[path = "../../tests/invariants/curves.rs"]
mod curved;
#[path = "../../tests/invariants/mod.rs"]
mod invariants;
#[path = "../../tests/invariants/motion.rs"]
mod motions;
mod numbers;
mod reader;
#[path = "../../tests/invariants/records.rs"]
mod record;
#[path = "../../tests/invariants/rounded.rs"]
mod rounded;
#[path = "../../tests/invariants/systems.rs"]
mod structures;

pub use numbers::multiple;
pub use reader::reader;

use stickslip::generators::{Curved, DampingRatio, Machine, Point, Question, Shaken, Start, Structure};

/// Points, their number and the start of their slice: batches of every level are compared with each other and
/// with single points.
pub fn batch(input: (u8, u16, Vec<Point>)) {
    let (offset, length, points) = input;
    let points: Vec<(f64, f64)> = points.iter().map(|point| (point.omega, point.alpha)).collect();
    batches::batches(&points, usize::from(offset % 16), usize::from(length % 300));
}

/// Ω: the quantities that depend on it alone, at f64 compared with 512 bits.
pub fn borders(point: Point) {
    rounded::borders(point.omega);
}

/// Ω, α, ζ and a phase: the closed forms.
pub fn closed_forms(input: (Point, f64, DampingRatio)) {
    let (Point { omega, alpha }, phase, DampingRatio(zeta)) = input;
    invariants::damped_closed_forms(omega, alpha, zeta, phase);
}

/// A structure whose laws are curves: its answer, with its digits.
pub fn curves(curved: Curved) {
    curved::motion(&curved, 20);
}

/// The arguments of the inverse problems.
pub fn design(input: (Question, DampingRatio)) {
    let (q, DampingRatio(zeta)) = input;
    motions::damped_questions(q.point.omega, zeta, q.target, q.point.alpha, q.low, q.high);
}

/// Ω, α, ζ and a state: the motion from there.
pub fn exact_motion(input: (Start, DampingRatio)) {
    let (Start { point: Point { omega, alpha }, theta, x, v }, DampingRatio(zeta)) = input;
    motions::damped_trajectory(omega, alpha, zeta, theta, x, v);
}

/// Ω over the whole range of the exact motion, α and a state: the motion from there and its steady state.
pub fn long_runs(input: (u32, Start)) {
    let (part, Start { point: Point { alpha, .. }, theta, x, v }) = input;
    motions::any_frequency(part, alpha, theta, x, v);
}

/// Mass, stiffness, friction bound, amplitude and frequency: the answers in physical units.
pub fn physical_units(m: Machine) {
    invariants::physical_units(m.mass, m.stiffness, m.friction_bound, m.amplitude, m.frequency, m.base);
}

/// A body and a record: the motion under it.
pub fn records(shaken: Shaken) {
    record::followed(&shaken)
}

/// Ω, α, ζ, η and a state: the motion from there and its steady state.
pub fn static_friction(input: (Start, DampingRatio, u32)) {
    let (Start { point: Point { omega, alpha }, theta, x, v }, DampingRatio(zeta), part) = input;
    motions::static_motion(omega, alpha, zeta, motions::static_friction_ratio(part), theta, x, v);
}

/// Ω, α, ζ and a state: the steady state of the motion from there.
pub fn steady(input: (Start, DampingRatio)) {
    let (Start { point: Point { omega, alpha }, theta, x, v }, DampingRatio(zeta)) = input;
    motions::damped_long_run(omega, alpha, zeta, theta, x, v);
}

/// A structure with contacts, elastic contacts and stops under loads: its motion.
pub fn systems(structure: Structure) {
    structures::motion(&structure, 40);
    structures::slips(&structure);
}
