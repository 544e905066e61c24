//! Free vibration: no drive, and friction takes 2B off the amplitude in every half cycle.
//!
//! Displacements in units of B = r_y/k, velocities in B ω_n, time in 1/ω_n. From (x₀, v₀) the body slides about the point
//! ∓1 that friction shifts its balance to. The first turn is at
//!
//! ```text
//! x₁ = s (R − 1),   R = hypot(x₀ + s, v₀),   s = sgn v₀
//! ```
//!
//! (x₁ = x₀ where v₀ = 0), and every half cycle after it takes x to `−sgn x (|x| − 2)`, until `|x| ≤ 1`, where the body
//! stays. So there are `n = ⌈(|x₁| − 1)/2⌉` of them, and the body rests at `(−1)ⁿ sgn x₁ (|x₁| − 2n)`.

use super::equation::Equation;
use super::state::State;
use super::trajectory::Trajectory;
use crate::error::Error;
use crate::float::Float;

/// Free vibration from a start, to rest.
///
/// ```
/// use stickslip::exact::FreeDecay;
/// let decay = FreeDecay::new(12.0f64, 6.0)?;
/// assert_eq!(decay.half_cycles(), 8);
/// assert!((decay.rest_position() - (15.0 - 205f64.sqrt())).abs() < 1e-14);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeDecay<F> {
    start: State<F>,
    first_turn: F,
    /// Half cycles after the first turn.
    turns: F,
}

impl<F: Float> FreeDecay<F> {
    /// Free vibration from the displacement x₀/B and the velocity v₀/(Bω_n).
    ///
    /// # Errors
    /// Where one of them is not finite or too large for the type.
    pub fn new(x: F, v: F) -> Result<Self, Error> {
        let start = State::new(F::int(0), x, v)?;
        let (zero, one, two) = (F::int(0), F::int(1), F::int(2));
        let first_turn = if v == zero {
            x
        } else {
            let sign = one.with_sign_of(v);
            sign * ((x + sign).hypot(v) - one)
        };
        let excess = first_turn.abs() - one;
        // ⌈y⌉ = −⌊−y⌋
        let turns = if excess > zero { -((-excess / two).floor()) } else { zero };
        Ok(Self { start, first_turn, turns })
    }

    /// How many half cycles it slides: velocity zeros until it rests, counted from the start. The first one is part of a
    /// half cycle where v₀ ≠ 0.
    pub fn half_cycles(&self) -> u64 {
        let first = u64::from(self.start.v != F::int(0));
        (self.turns.to_f64() as u64).saturating_add(first)
    }

    /// Where it turns first, x₁/B.
    pub const fn first_turn(&self) -> F {
        self.first_turn
    }

    /// Where it comes to rest, x/B. Accuracy at f64: that of x₁, half a unit in its last place.
    pub fn rest_position(&self) -> F {
        let left = self.first_turn.abs() - F::int(2) * self.turns;
        let half = self.turns / F::int(2);
        let rest = if half == half.floor() { left } else { -left };
        if self.first_turn < F::int(0) { -rest } else { rest }
    }

    /// When it comes to rest, in 1/ω_n: the part of the first half cycle, and π for each other.
    pub fn rest_time(&self) -> F {
        let (x, v) = (self.start.x, self.start.v);
        let sign = F::int(1).with_sign_of(v);
        // The angle left until the turn: R sin φ₁ = |v₀|.
        let first = if v == F::int(0) { F::int(0) } else { (sign * v).atan2(sign * x + F::int(1)) };
        first + self.turns * F::pi()
    }

    /// The same motion phase by phase, by the machinery of the driven one: phases are ω_n t.
    pub fn trajectory(&self) -> Trajectory<F> {
        Trajectory::of(Equation::free(F::int(0)), self.start)
    }
}

#[cfg(test)]
mod tests {
    use super::FreeDecay;
    use crate::exact::{End, Kind};

    #[test]
    fn the_closed_form_and_the_machinery_agree() {
        let starts: [(f64, f64); 11] = [
            (12.0, 6.0),
            (0.3, 0.0),
            (-0.3, 0.2),
            (5.5, -2.0),
            (-40.0, 17.0),
            (1.0, 0.0),
            (3.0, 0.0),
            (-2.5, 0.0),
            (1.5, 0.0),
            (-1.01, 0.0),
            (2.0, 0.0),
        ];
        for (x, v) in starts {
            let decay = FreeDecay::new(x, v).unwrap();
            let phases: Vec<_> = decay.trajectory().map(Result::unwrap).collect();
            let slides = phases.iter().filter(|p| p.kind() != Kind::Stick).count() as u64;
            let last = phases.last().unwrap();
            assert_eq!(slides, decay.half_cycles(), "({x}, {v})");
            assert_eq!(last.ends_by(), End::Never);
            let size = 1.0f64 + x.abs() + v.abs();
            assert!((last.start().x - decay.rest_position()).abs() < 4e-16 * size * (1 + slides) as f64);
            let time = last.start().phase.since(phases[0].start().phase);
            assert!((time - decay.rest_time()).abs() < 1e-15 * (4.0 + 4.0 * slides as f64), "({x}, {v})");
        }
    }

    #[test]
    fn the_textbook_case() {
        // m = k = r_y = 1, x₀ = 12, v₀ = 6
        let decay = FreeDecay::new(12.0f64, 6.0).unwrap();
        assert_eq!(decay.half_cycles(), 8);
        assert!((decay.rest_position() - 0.682_178_936_723_647).abs() < 1e-14);
    }

    /// From between one and two B the spring wins over friction once, and the body stops on the other side.
    #[test]
    fn a_start_just_beyond_the_friction_bound_slides_once() {
        for (x, rest) in
            [(1.5, 0.5), (-1.5, -0.5), (1.01, 0.99), (-1.01, -0.99), (2.0, 0.0), (2.5, -0.5), (-3.0, 1.0)]
        {
            let decay = FreeDecay::new(x, 0.0f64).unwrap();
            assert_eq!((decay.half_cycles(), decay.rest_time()), (1, std::f64::consts::PI), "{x}");
            assert!((decay.rest_position() - rest).abs() < 1e-15, "{x}: {}", decay.rest_position());
        }
        for x in [1.0, -1.0, 0.999, 0.0] {
            let decay = FreeDecay::new(x, 0.0f64).unwrap();
            assert_eq!((decay.half_cycles(), decay.rest_position(), decay.rest_time()), (0, x, 0.0));
        }
    }

    #[test]
    fn bad_starts_are_named() {
        let message = |x: f64, v: f64| FreeDecay::new(x, v).unwrap_err().to_string();
        assert_eq!(message(f64::NAN, 0.0), "displacement x/B = NaN must be finite");
        assert_eq!(message(0.0, f64::INFINITY), "velocity v = inf must be finite");
    }
}
