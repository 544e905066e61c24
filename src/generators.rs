//! Adversarial inputs for property tests and fuzzing, made from random bytes by
//! [`arbitrary`](https://docs.rs/arbitrary), for fuzzers and for proptest alike.
//!
//! Random bits rarely reach the points where formulae break. About one number in eight here is an arbitrary
//! double; the others are at such a point, or some floats or a small fraction of themselves away from it:
//!
//! | number | where it is put |
//! |---|---|
//! | Ω | 1; 1/n and 1/(2n + 1); the least border; 1/2; the ends of its domain; any magnitude; ordinary values |
//! | α | 1; 4/π; the size of K, and √2 times it; the exact border and eq. 61 at that Ω, and some way above; subnormal and huge values |
//! | ζ | 0; 1; tiny values; ordinary values; any magnitude |
//! | the start | at rest at the friction force; at the edge of the places of rest; on the closed-form cycle; just before the velocity touches zero; a tiny speed; huge values |
//! | a machine | ordinary values, any magnitude, any bits, signs included |
//! | a system | ordinary and round values, dependent directions, elements of all kinds; laws that are curves |
//!
//! Arbitrary values are included, so that an input need not be valid. If there are fewer bytes than a value
//! needs, they are padded with zeros.
//!
//! ```
//! use arbitrary::{Arbitrary, Unstructured};
//! use stickslip::generators::Point;
//! use stickslip::{Ratios, Response};
//! // With libFuzzer: fuzz_target!(|point: Point| { … }). With proptest: bytes by `vec(any::<u8>(), 0..64)`, and
//! let bytes = [1, 0, 4, 0, 0];
//! let point = Point::arbitrary(&mut Unstructured::new(&bytes))?;
//! if let Ok(ratios) = Ratios::new(point.omega, point.alpha) {
//!     assert!(Response::new(ratios).border.min_force_ratio.is_finite());
//! }
//! # Ok::<(), arbitrary::Error>(())
//! ```

#[cfg(feature = "system")]
mod curves;
mod numbers;
mod point;
mod points;
mod records;
mod starts;
#[cfg(feature = "system")]
mod systems;

use arbitrary::{Arbitrary, Result, Unstructured};
#[cfg(feature = "system")]
pub use curves::{Curve, Curved};
#[cfg(test)]
pub(crate) use numbers::neighbours;
pub(crate) use numbers::{beside, magnitude, ordinary};
pub use point::Point;
pub(crate) use points::{damping_ratio, frequency_ratio};
pub use records::Shaken;
#[cfg(feature = "system")]
pub use systems::Structure;

/// A damping ratio. Where no bytes are left it is 0, so that inputs from before it existed keep their
/// meaning.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DampingRatio(pub f64);

impl<'a> Arbitrary<'a> for DampingRatio {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        damping_ratio(u).map(Self)
    }
}

/// A point and a state that the motion starts from: ω_d t in radians, x in units of B, x′ in B ω_d.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Start {
    /// Frequency ratio Ω and force ratio α.
    pub point: Point,
    /// Phase ω_d t.
    pub theta: f64,
    /// Displacement x/B.
    pub x: f64,
    /// Velocity x′/(Bω_d).
    pub v: f64,
}

impl<'a> Arbitrary<'a> for Start {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        let point = Point::arbitrary(u)?;
        let (theta, x, v) = starts::state(u, point)?;
        Ok(Self { point, theta, x, v })
    }
}

/// A body and its drive, in physical units that may be inconsistent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Machine {
    /// Mass m.
    pub mass: f64,
    /// Stiffness k.
    pub stiffness: f64,
    /// Friction force r_y.
    pub friction_bound: f64,
    /// Amplitude of the drive: p₀, or u_g0 where the base moves.
    pub amplitude: f64,
    /// Angular frequency ω_d.
    pub frequency: f64,
    /// Whether the base moves.
    pub base: bool,
}

impl<'a> Arbitrary<'a> for Machine {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        Ok(Self {
            mass: magnitude(u)?,
            stiffness: magnitude(u)?,
            friction_bound: magnitude(u)?,
            amplitude: magnitude(u)?,
            frequency: magnitude(u)?,
            base: bool::arbitrary(u)?,
        })
    }
}

/// Inputs of the inverse problems.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Question {
    /// Frequency ratio Ω and force ratio α.
    pub point: Point,
    /// The target, in units of B or B ω_d.
    pub target: f64,
    /// Lower end of a range of Ω.
    pub low: f64,
    /// Upper end.
    pub high: f64,
}

impl<'a> Arbitrary<'a> for Question {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        let point = Point::arbitrary(u)?;
        let (low, wide) = (frequency_ratio(u)?, ordinary(u, 0.0, 2.0)?);
        let high = match u.int_in_range(0..=3)? {
            0 => frequency_ratio(u)?,
            1 => beside(u, low)?,
            _ => low * wide.exp2(),
        };
        Ok(Self { point, target: points::target(u, point.omega)?, low, high })
    }
}

#[cfg(test)]
mod tests {
    use super::{DampingRatio, Machine, Point, Question, Start};
    use crate::motion::{End, State, Trajectory};
    use crate::random::Random;
    use crate::{Border, Ratios, Regime, Response};
    use arbitrary::{Arbitrary, Unstructured};
    use std::fmt::Debug;

    /// `count` values from pseudo-random bytes, the same in every run.
    fn many<T: for<'a> Arbitrary<'a>>(count: usize) -> impl Iterator<Item = T> {
        let mut random = Random(9);
        (0..count).map(move |_| {
            let bytes: Vec<u8> = (0..96).map(|_| random.byte()).collect();
            T::arbitrary(&mut Unstructured::new(&bytes)).unwrap()
        })
    }

    fn part<T>(count: usize, of: impl Fn(&T) -> bool) -> f64
    where
        T: for<'a> Arbitrary<'a>,
    {
        many::<T>(count).filter(of).count() as f64 / count as f64
    }

    #[test]
    fn every_regime_and_the_places_where_formulae_break_are_met() {
        let ratios = |p: &Point| Ratios::new(p.omega, p.alpha);
        let is = |regime: Regime| part(4000, |p| ratios(p).is_ok_and(|r| Response::new(r).regime == regime));
        for (regime, least) in [(Regime::NonSticking, 0.2), (Regime::Sticking, 0.05), (Regime::Stuck, 0.1)] {
            assert!(is(regime) > least, "{regime:?}: {}", is(regime));
        }
        assert!(is(Regime::Unbounded) > 0.005);
        assert!(part::<Point>(4000, |p| ratios(p).is_err()) > 0.05);
        assert!(part::<Point>(4000, |p| p.omega != 1.0 && (p.omega - 1.0).abs() < 1e-12) > 0.02);
        let beside = |p: &Point, n: f64| (p.omega * n - 1.0).abs() < 1e-12;
        assert!(part::<Point>(4000, |p| (2..200).any(|n| beside(p, f64::from(n)))) > 0.05);
        let close = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-12;
        let border = |p: &Point| Border::new(p.omega);
        assert!(part::<Point>(4000, |p| border(p).is_ok_and(|b| close(p.alpha, b.min_force_ratio))) > 0.05);
        assert!(part::<Point>(4000, |p| close(p.alpha, 1.0)) > 0.05);
        assert!(part::<Point>(4000, |p| p.alpha > 0.0 && p.alpha < f64::MIN_POSITIVE) > 0.01);
    }

    #[test]
    fn starts_lead_to_stops_and_grazings() {
        let first = |s: &Start, of: &dyn Fn(End) -> bool| {
            let (Ok(ratios), Ok(state)) =
                (Ratios::new(s.point.omega, s.point.alpha), State::new(s.theta, s.x, s.v))
            else {
                return false;
            };
            Trajectory::new(ratios, state)
                .is_ok_and(|motion| motion.take(1).any(|phase| of(phase.unwrap().ends_by)))
        };
        assert!(part::<Start>(4000, |s| first(s, &|end| end == End::Grazing)) > 0.002);
        assert!(part::<Start>(4000, |s| first(s, &|end| end == End::Stop)) > 0.02);
        assert!(part::<Start>(4000, |s| first(s, &|end| end == End::Release)) > 0.01);
        assert!(part::<Start>(4000, |s| first(s, &|end| end == End::Reversal)) > 0.05);
    }

    #[test]
    fn no_bytes_are_enough() {
        fn nothing<T: for<'a> Arbitrary<'a> + Debug>() {
            for length in 0..40 {
                assert!(T::arbitrary(&mut Unstructured::new(&vec![255; length])).is_ok(), "{length}");
            }
        }
        nothing::<Point>();
        nothing::<Start>();
        nothing::<Machine>();
        nothing::<Question>();
        nothing::<DampingRatio>();
        assert_eq!(DampingRatio::arbitrary(&mut Unstructured::new(&[])).unwrap(), DampingRatio(0.0));
    }

    #[test]
    fn machines_and_questions_are_valid_often_enough() {
        assert!(part::<Machine>(4000, |m| m.mass > 0.0 && m.stiffness > 0.0 && m.friction_bound > 0.0) > 0.2);
        assert!(
            part::<Question>(4000, |q| crate::design::bands(q.point.alpha, 0.0, q.low..=q.high).is_ok())
                > 0.1
        );
    }
}
