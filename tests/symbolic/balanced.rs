//! The form of eq. 21–25 that Newton's method solves is equivalent to them, and its Jacobian is correct.

use super::ideal::Ideal;
use super::scalar::{Symbol, angle, free, reset};
use super::setting::int;
use stickslip::Real;
use stickslip::cycle::border::slip_excess;
use stickslip::cycle::matching::Unknowns;
use stickslip::cycle::matching::balanced::Balanced;
use stickslip::cycle::phase_function::one_minus_square;

/// The system and its unknowns in symbols; the angles β = π/2Ω, and therefore π₁ = 2β, are named.
fn system() -> (Balanced<Symbol>, Unknowns<Symbol>) {
    reset();
    let [v, delta, deviation, friction] = ["v", "d", "e", "κ"].map(free);
    let [omega, t1, t2] = ["Ω", "t₁", "t₂"].map(free);
    let sin_cos_beta = angle("β", Symbol::pi() / (int(2) * omega));
    let _ = (angle("t₁", t1), angle("t₂", t2), angle("θ", (t2 - t1) / omega));
    let balanced = Balanced { omega, one_minus_square: one_minus_square(omega), sin_cos_beta, friction };
    let unknowns = Unknowns {
        velocity_phase: t1,
        displacement_phase: t2,
        max_velocity: v,
        max_displacement: delta,
        deviation,
    };
    (balanced, unknowns)
}

#[test]
fn it_is_equations_21_to_25_times_a_regular_matrix() {
    let (system, u) = system();
    let [f1, f2, f3, f4, f5] = system.residuals(&u);
    let [e21, e22, e23, e24, e25] = system.given().residuals(&u);
    let twice = int(2) * system.sin_cos_beta.1;
    for (name, zero) in [("21", f1 - e21), ("23", f3 - e23), ("25", f5 - e25)] {
        assert!(zero.is_zero(), "{name}");
    }
    let rows = [("21 − 22", twice * f2 - (e21 - e22)), ("23 − 24", twice * f4 - (e23 - e24))];
    let ideal = Ideal::new(&[], &rows.map(|(_, row)| row));
    for (name, row) in rows {
        ideal.assert_exactly(name, row);
    }
    assert!(!ideal.holds(twice * f2 + (e21 - e22)));
    // Eq. 59 in units of A, p₀/k = A(1 − Ω²) with k = A = 1: the excess force equals the friction, downwards.
    let b = system.given().friction_displacement;
    let sine = u.displacement_phase.sin();
    let force = slip_excess(system.one_minus_square, sine, int(1), u.max_displacement, b) + b;
    let e59 = system.turning_point(&u);
    assert!(Ideal::new(&[], &[force]).holds(force * force - (e59 - b) * (e59 - b)));
}

#[test]
fn the_jacobian_is_the_derivative() {
    let (system, u) = system();
    let by = [u.velocity_phase, u.displacement_phase, u.max_velocity, u.max_displacement, u.deviation];
    let residuals = system.residuals(&u);
    let friction = system.by_friction(&u);
    let turning_point = system.turning_point(&u);
    let gradient = system.turning_point_gradient(&u);
    let mut entries = Vec::new();
    for ((row, residual), by_friction) in system.jacobian(&u).iter().zip(residuals).zip(friction) {
        entries.extend(row.iter().zip(by).map(|(entry, x)| (*entry, residual.derivative(x))));
        entries.push((by_friction, residual.derivative(system.friction)));
    }
    let last = by.into_iter().chain([system.friction]);
    entries.extend(gradient.into_iter().zip(last.map(|x| turning_point.derivative(x))));
    assert_eq!(entries.len(), 36);
    let mut vanishing = 0;
    for (i, (entry, derivative)) in entries.iter().enumerate() {
        assert!((*entry - *derivative).is_zero(), "entry {i}: {entry:?} for {derivative:?}");
        if entry.is_zero() {
            vanishing += 1;
        } else {
            assert!(!(*entry + *derivative).is_zero(), "entry {i} with the other sign");
        }
    }
    assert_eq!(vanishing, 3 + 3 + 3);
}
