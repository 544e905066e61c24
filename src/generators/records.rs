//! Bodies under records: steps from a thousandth of a period to many periods, any damping, friction from none to
//! more than the load, and samples that are at a bound, change sign or stay as they are.

use super::{magnitude, ordinary};
use arbitrary::{Arbitrary, Result, Unstructured};

/// A body and a record.
#[derive(Debug, Clone, PartialEq)]
pub struct Shaken {
    /// Mass.
    pub mass: f64,
    /// Stiffness: 0 for one body in four.
    pub stiffness: f64,
    /// Damping constant.
    pub damping: f64,
    /// Friction against motion with x′ > 0 and x′ < 0.
    pub friction: [f64; 2],
    /// Static friction ratio.
    pub static_friction_ratio: f64,
    /// Whether the body moves one way.
    pub is_one_way: bool,
    /// Displacement and velocity at the start.
    pub start: [f64; 2],
    /// What the samples are: an index of [`crate::Excitation`].
    pub excitation: u8,
    /// The steps between the samples: one for equal steps.
    pub steps: Vec<f64>,
    /// Samples.
    pub samples: Vec<f64>,
}

impl<'a> Arbitrary<'a> for Shaken {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        let mass = if u.ratio(1, 8)? { magnitude(u)? } else { ordinary(u, 0.5, 4.0)? };
        let step = ordinary(u, 0.005, 0.5)?;
        // The step in periods, from 1e-3 to 30.
        let cycles = 10f64.powf(ordinary(u, -3.0, 1.5)?);
        let omega = if u.ratio(1, 4)? { 0.0 } else { core::f64::consts::TAU * cycles / step };
        let zeta = match u.int_in_range(0..=5)? {
            0 => 0.0,
            1 => 1.0,
            2 => ordinary(u, 0.0, 40.0)?,
            3 => 10f64.powf(ordinary(u, -9.0, -1.0)?),
            _ => ordinary(u, 0.0, 0.3)?,
        };
        // Without a spring the damper is chosen by its decay in a step.
        let rate = if omega > 0.0 { 2.0 * zeta * omega } else { zeta / step };
        let level = ordinary(u, 0.2, 5.0)?;
        let friction = match u.int_in_range(0..=5)? {
            0 => 0.0,
            1 => level,
            2 => level * 10f64.powf(ordinary(u, -12.0, 0.0)?),
            _ => level * ordinary(u, 0.0, 1.2)?,
        };
        let backward = if u.ratio(1, 4)? { friction * ordinary(u, 0.0, 3.0)? } else { friction };
        let static_friction_ratio = if u.ratio(1, 3)? { ordinary(u, 1.0, 3.0)? } else { 1.0 };
        let is_one_way = u.ratio(1, 6)?;
        let start = if u.ratio(1, 3)? {
            let size = level * step * step;
            let v = ordinary(u, -3.0, 3.0)? * level * step;
            [ordinary(u, -10.0, 10.0)? * size, if is_one_way { v.abs() } else { v }]
        } else {
            [0.0; 2]
        };
        let count = u.int_in_range(2..=40usize)?;
        let mut samples = Vec::with_capacity(count);
        let mut last = 0.0;
        for _ in 0..count {
            last = match u.int_in_range(0..=7)? {
                0 => 0.0,
                1 | 2 => last,
                3 => friction * static_friction_ratio,
                4 => -friction,
                _ => ordinary(u, -1.5, 1.5)? * level,
            };
            samples.push(last);
        }
        let is_equal = !u.ratio(1, 4)?;
        let parts = if is_equal { 1 } else { count.saturating_sub(1) };
        let steps = (0..parts).map(|_| Ok(if is_equal { step } else { step * ordinary(u, 0.1, 3.0)? }));
        let steps = steps.collect::<Result<_>>()?;
        let excitation = u.int_in_range(0..=3u8)?;
        let (stiffness, damping) = (mass * omega * omega, mass * rate);
        // A sample is a force per mass, or an acceleration with its sign, in every kind of record.
        let size = match excitation {
            0 => mass,
            1 => -1.0,
            _ if omega > 0.0 => 1.0 / (omega * omega),
            _ => 1.0,
        };
        for sample in &mut samples {
            *sample *= size;
        }
        let friction = [friction * mass, backward * mass];
        Ok(Self {
            mass,
            stiffness,
            damping,
            friction,
            static_friction_ratio,
            is_one_way,
            start,
            excitation,
            steps,
            samples,
        })
    }
}
