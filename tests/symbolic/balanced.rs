//! Without a damper the form of eq. 21–25 that Newton's method solves is equivalent to them, and its Jacobian is correct.

use super::ideal::Ideal;
use super::scalar::{Symbol, angle, free, reset};
use super::setting::int;
use stickslip::Real;
use stickslip::cycle::border::slip_excess;
use stickslip::cycle::damped::free::{Free, Waves};
use stickslip::cycle::matching::balanced::Balanced;
use stickslip::cycle::matching::{Given, Unknowns};
use stickslip::cycle::phase_function::one_minus_square;

/// The system and its unknowns in symbols, where Ω < 1 and cos β > 0; the angles β = π/2Ω, and therefore π₁ = 2β, are
/// named.
fn system() -> (Balanced<Symbol>, Unknowns<Symbol>) {
    reset();
    let [v, delta, deviation, friction] = ["v", "d", "e", "κ"].map(free);
    let [omega, t1, t2] = ["Ω", "t₁", "t₂"].map(free);
    let (sine, cosine) = angle("β", Symbol::pi() / (int(2) * omega));
    let _ = (angle("t₁", t1), angle("t₂", t2), angle("θ", (t2 - t1) / omega));
    let balanced = Balanced {
        omega,
        free: Free { zeta: int(0), square: int(1), frequency: int(1) },
        stiffness: one_minus_square(omega),
        lag: (int(1), int(0)),
        root: cosine,
        swings: true,
        known: (cosine, -sine),
        friction,
    };
    let unknowns = Unknowns {
        velocity_phase: t1,
        displacement_phase: t2,
        max_velocity: v,
        max_displacement: delta,
        deviation,
    };
    (balanced, unknowns)
}

/// Free vibration without a damper.
fn waves(_: &Free<Symbol>, time: Symbol) -> Waves<Symbol> {
    let (sine, cosine) = time.sin_cos();
    Waves { cosine, sine }
}

#[test]
fn it_is_equations_21_to_25_times_a_regular_matrix() {
    let (system, u) = system();
    let ([f1, f2, f3, f4, f5], ..) = system.equations_by(&u, waves);
    let (b, omega) = (system.friction * system.root, system.omega);
    let given = Given { amplitude: int(1), friction_displacement: b, omega };
    let [e21, e22, e23, e24, e25] = given.residuals(&u);
    let twice = int(2) * system.root;
    let (c, s) = (system.root, -system.known.1);
    let (rate, position) = (twice * (f2 * c + f4 * s), twice * (f4 * c - f2 * s));
    for (name, zero) in [("21", f1 - e21), ("23", f3 - e23), ("25", f5 - e25)] {
        assert!(zero.is_zero(), "{name}");
    }
    let rows = [("21 − 22", rate - (e21 - e22)), ("23 − 24", position - (e23 - e24))];
    let ideal = Ideal::new(&[], &rows.map(|(_, row)| row));
    for (name, row) in rows {
        ideal.assert_exactly(name, row);
    }
    assert!(!ideal.holds(rate + (e21 - e22)));
    // Eq. 59 in units of A, p₀/k = A(1 − Ω²) with k = A = 1: the excess force equals the friction, downwards.
    let sine = u.displacement_phase.sin();
    let force = slip_excess(system.stiffness, sine, int(1), u.max_displacement, b) + b;
    let e59 = system.turning_point(&u);
    assert!(Ideal::new(&[], &[force]).holds(force * force - (e59 - b) * (e59 - b)));
}

#[test]
fn the_jacobian_is_the_derivative() {
    let (system, u) = system();
    let by = [u.velocity_phase, u.displacement_phase, u.max_velocity, u.max_displacement, u.deviation];
    let (residuals, jacobian, friction) = system.equations_by(&u, waves);
    let turning_point = system.turning_point(&u);
    let gradient = system.turning_point_gradient(&u);
    let mut entries = Vec::new();
    for ((row, residual), by_friction) in jacobian.iter().zip(residuals).zip(friction) {
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
