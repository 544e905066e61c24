//! The cycle with viscous damping by exact algebra, as far as it is algebraic: the closed forms for half a
//! cycle.
//!
//! C and S are cosh ζT and sinh ζT, c and r are cos dT and sin(dT)/d, with `C² − S² = 1` and `c² + (1 − ζ²)
//! r² = 1`. The algebra therefore holds for ζ below, at and above 1. The exponential of the free vibration
//! over half a period is then `M = (C − S) [[c + ζr, r], [−r, c − ζr]]`. The formulae are those of
//! docs/development/theory/damping.md; `verify` checks that the library's numbers agree with them.

use super::ideal::Ideal;
use super::scalar::{Symbol, free, reset};
use super::setting::int;

struct HalfPeriod {
    zeta: Symbol,
    omega: Symbol,
    /// C, S, c, r.
    parts: [Symbol; 4],
    /// G and b = ΩH.
    shift: Symbol,
    b: Symbol,
    /// `M`, row by row.
    m: [[Symbol; 2]; 2],
    relations: Vec<Symbol>,
}

impl HalfPeriod {
    fn new() -> Self {
        reset();
        let [zeta, omega, cosh, sinh, c, r] = ["ζ", "Ω", "C", "S", "c", "r"].map(free);
        let n = cosh + c;
        let decay = cosh - sinh;
        Self {
            zeta,
            omega,
            parts: [cosh, sinh, c, r],
            shift: (sinh - zeta * r) / n,
            b: r / n,
            m: [[decay * (c + zeta * r), decay * r], [-(decay * r), decay * (c - zeta * r)]],
            relations: vec![
                cosh * cosh - sinh * sinh - int(1),
                c * c + (int(1) - zeta * zeta) * r * r - int(1),
            ],
        }
    }

    fn after(&self, (x, w): (Symbol, Symbol)) -> (Symbol, Symbol) {
        let [[a, b], [c, d]] = self.m;
        (a * x + b * w, c * x + d * w)
    }

    fn holds(&self, claim: Symbol) -> bool {
        Ideal::without_relations(&self.relations, &[claim]).holds(claim)
    }
}

/// The free part of the rising half goes from (1 + G, b) to (1 − G, −b), which takes the body from rest at
/// −Δ₀ to rest at Δ₀.
#[test]
fn the_shift_and_the_quadrature_solve_the_matching_conditions() {
    let half = HalfPeriod::new();
    let (x, w) = half.after((int(1) + half.shift, half.b));
    assert!(half.holds(x - (int(1) - half.shift)) && half.holds(w + half.b));
    // The motion from −1 − a cos Ωτ − H sin Ωτ + h and its derivative: at rest at −Δ₀ and at Δ₀ = a − G.
    let a = free("a");
    assert!(half.holds((int(-1) - a + (int(1) + half.shift)) + (a - half.shift)));
    assert!(half.holds((int(-1) + a + x) - (a - half.shift)) && half.holds(half.b + w));
    // This fails with another sign, and without the decay.
    let (x, w) = half.after((int(1) - half.shift, half.b));
    assert!(!half.holds(x - (int(1) + half.shift)) && !half.holds(w + half.b));
}

/// `s = (R − 1)/(R + 1)`, R = Ω²a − G − 2ζΩH, is the ratio of the accelerations after and before the
/// reversal.
#[test]
fn the_reversal_ratio_and_the_characteristic_polynomial() {
    let half = HalfPeriod::new();
    let (a, lambda) = (free("a"), free("λ"));
    let two = int(2);
    let r = half.omega * half.omega * a - half.shift - two * half.zeta * half.b;
    // x″(T) = −Ω²a + h″, h″ = −h − 2ζh′ from (1 − G, −b); at the reversal friction changes by 2.
    let before = -(half.omega * half.omega * a) - (int(1) - half.shift) + two * half.zeta * half.b;
    let after = before + two;
    assert!(half.holds(before + r + int(1)) && half.holds(after + r - int(1)));
    // det(λ + JM) = λ² + (M₁₁ + sM₂₂) λ + s e^{−2ζT}, J = diag(1, s).
    let s = (r - int(1)) / (r + int(1));
    let [[m11, m12], [m21, m22]] = half.m;
    let determinant = (lambda + m11) * (lambda + s * m22) - m12 * s * m21;
    let [cosh, sinh, ..] = half.parts;
    let decay = cosh - sinh;
    let polynomial = lambda * lambda + (m11 + s * m22) * lambda + s * decay * decay;
    assert!(half.holds(determinant - polynomial));
    assert!(!half.holds(determinant - polynomial - (s * decay - s * decay * decay)));
}

/// The excess force at the turning point, `Ω²a ≥ 1 + G + 2ζΩH`, and the reason why that is above 1: `G + 2ζΩH
/// = [sinh ζT + (ζ/d) sin dT]/N`.
#[test]
fn the_turning_point_holds_more_than_without_damping() {
    let half = HalfPeriod::new();
    let [cosh, sinh, c, r] = half.parts;
    let holding = half.shift + int(2) * half.zeta * half.b;
    assert!(half.holds(holding - (sinh + half.zeta * r) / (cosh + c)));
    assert!(!half.holds(holding - (sinh - half.zeta * r) / (cosh + c)));
}

/// `g′ = −D p` does not contain the drive, with p = h‴ + Ω²h′ = (Ω² + 4ζ² − 1) h′ + 2ζh; in symbols for h,
/// h′, cos Ωτ and sin Ωτ.
#[test]
fn the_drive_drops_out_of_the_border_s_derivative() {
    let half = HalfPeriod::new();
    let [h, h1, sine, cosine] = ["h", "h′", "sin Ωτ", "cos Ωτ"].map(free);
    let (zeta, omega, b, two) = (half.zeta, half.omega, half.b, int(2));
    let h2 = -h - two * zeta * h1;
    let h3 = -h1 - two * zeta * h2;
    let h4 = -h2 - two * zeta * h3;
    // n = b cos Ωτ − h′ and D = Ω sin Ωτ with their derivatives; g = n′D − nD′.
    let (n, n2) = (b * cosine - h1, -(omega * omega * b * cosine) - h3);
    let (d, d2) = (omega * sine, -(omega * omega * omega * sine));
    let slope = n2 * d - n * d2;
    let p = (omega * omega + int(4) * zeta * zeta - int(1)) * h1 + two * zeta * h;
    assert!(half.holds(slope + d * p) && half.holds(p - (h3 + omega * omega * h1)));
    // p is itself a free vibration.
    let (p1, p2) = (h4 + omega * omega * h2, -h3 - two * zeta * h4 + omega * omega * h3);
    assert!(half.holds(p2 + two * zeta * p1 + p));
    assert!(!half.holds(slope - d * p));
}

/// `A₁ = 8(y − qG)/(q(y² + K²))` has its only extremum for y > 0 where y² = K² + 2qGy.
#[test]
fn the_best_force_ratio_is_where_the_derivative_changes_its_sign() {
    reset();
    let [y, shift, k, dy] = ["y", "qG", "K", "dy"].map(free);
    let size = |y: Symbol| (y - shift) / (y * y + k * k);
    // The difference quotient minus its limit is a multiple of dy.
    let numerator = (size(y + dy) - size(y)) * (y * y + k * k) * ((y + dy) * (y + dy) + k * k);
    let slope = k * k + int(2) * shift * y - y * y;
    let ideal = Ideal::without_relations(&[dy * dy], &[numerator - dy * slope]);
    assert!(ideal.holds(numerator - dy * slope) && !ideal.holds(numerator + dy * slope));
}
