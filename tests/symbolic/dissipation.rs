//! Eq. 63–67: the loop, and the force ratio that makes it largest.

use super::ideal::Ideal;
use super::scalar::{Symbol, free, reset};
use super::setting::int;
use stickslip::Field;
use stickslip::cycle::equations::{
    best_force_ratio, best_loop_size, loop_size, loop_size_inertia, loop_size_stiffness, max_displacement,
};
use stickslip::cycle::phase_function::one_minus_square;

#[test]
fn equations_63_64_and_67_are_one_loop() {
    reset();
    let [alpha, k, friction, stiffness, mass, omega, delta] =
        ["α", "K", "r_y", "k", "m", "Ω", "Δ₀"].map(free);
    // p₀ = α r_y, ω_d² = Ω² k/m, B = r_y/k.
    let p0 = alpha * friction;
    let size = loop_size(friction, delta);
    let stiff = loop_size_stiffness(delta * stiffness / friction, alpha);
    assert!((int(2) * stiffness * size / (p0 * p0) - stiff).is_zero(), "64");
    let drive = omega * omega * stiffness / mass;
    let inertia = loop_size_inertia(stiff, omega);
    assert!((int(2) * mass * drive * size / (p0 * p0) - inertia).is_zero(), "67");
    assert!(!(stiff - inertia).is_zero());
    // As printed: [8/(α|1−Ω²|)] √[1 − (K/α)²].
    let q = one_minus_square(omega);
    let stiff = loop_size_stiffness(max_displacement(k, alpha, q), alpha);
    let printed = int(8) / (alpha * q.abs()) * (int(1) - (k / alpha) * (k / alpha)).sqrt();
    let ideal = Ideal::new(&[], &[stiff, printed]);
    assert!(ideal.holds(stiff * stiff - printed * printed), "64 as printed, both sides positive");
    assert!(!ideal.holds(int(2) * stiff * stiff - printed * printed));
}

#[test]
fn equation_65_is_the_zero_of_the_derivative_of_64() {
    reset();
    let [alpha, k, omega] = ["α", "K", "Ω"].map(free);
    let q = one_minus_square(omega);
    let delta = max_displacement(k, alpha, q);
    let slope = loop_size_stiffness(delta, alpha).derivative(alpha);
    // dA₁/dα = 8 (2K² − α²)/(α³ |1−Ω²|² Δ₀/B): positive below √2 |K|, negative above.
    let magnitude = q.abs() * q.abs() * delta;
    let excess = int(2) * k * k - alpha * alpha;
    let ideal = Ideal::new(&[], &[slope]);
    assert!(ideal.holds(slope * alpha * alpha * alpha * magnitude - int(8) * excess));
    for wrong in [k * k - alpha * alpha, int(2) * k * k + alpha * alpha, int(4) * k * k - alpha * alpha] {
        assert!(!ideal.holds(slope * alpha * alpha * alpha * magnitude - int(8) * wrong));
    }
    // Eq. 65 is its positive zero.
    let best = best_force_ratio(k);
    let ideal = Ideal::new(&[], &[best]);
    assert!(ideal.holds(int(2) * k * k - best * best), "65");
    assert!(!ideal.holds(int(3) * k * k - best * best));
}

#[test]
fn equation_66_is_64_at_65() {
    reset();
    let [k, omega] = ["K", "Ω"].map(free);
    let q = one_minus_square(omega);
    let best = best_force_ratio(k);
    let largest = loop_size_stiffness(max_displacement(k, best, q), best);
    let by_66 = best_loop_size(k, q);
    let ideal = Ideal::new(&[], &[largest, by_66]);
    assert!(ideal.holds((largest - by_66) * (largest + by_66)), "66, both sides positive");
    assert!(!ideal.holds((largest - by_66) * (largest + int(2) * by_66)));
    // As printed in 65 and 66: T for K.
    let tangent = free("T");
    let k = q * tangent / omega;
    let printed_65 = int(2).sqrt() * (q * tangent).abs() / omega;
    let printed_66 = int(4) * omega / (q * q * tangent.abs());
    let (by_65, by_66): (Symbol, Symbol) = (best_force_ratio(k), best_loop_size(k, q));
    let ideal = Ideal::new(&[], &[printed_65, printed_66, by_65, by_66]);
    assert!(ideal.holds(printed_65 * printed_65 - by_65 * by_65), "65 as printed");
    assert!(ideal.holds(printed_66 * printed_66 - by_66 * by_66), "66 as printed");
    assert!(!ideal.holds(printed_66 * printed_66 - int(4) * by_66 * by_66));
}
