//! Systems whose friction laws and springs are curves: of those of `systems`, with Stribeck's law or a formula in place of constant
//! frictions and springs by points. Formulas are smooth, bend at a corner, or grow steeply.

use super::systems::Structure;
use crate::system::Kind;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use arbitrary::{Arbitrary, Result, Unstructured};

/// A law that is a curve, over the speed or the stretch.
#[derive(Debug, Clone)]
pub enum Curve {
    /// `kinetic + (static − kinetic) e^{−(v/speed)^exponent} + viscous v`.
    Stribeck {
        /// The friction at high speeds, without the viscous part.
        kinetic: f64,
        /// The friction at the speed 0.
        static_friction: f64,
        /// The speed over which it falls.
        speed: f64,
        /// The exponent.
        exponent: f64,
        /// The slope of the viscous part.
        viscous: f64,
    },
    /// A formula with three constants.
    Formula {
        /// The formula as files have it, of v or x.
        text: String,
        /// Its value.
        value: fn(f64, [f64; 3]) -> f64,
        /// The constants.
        constants: [f64; 3],
    },
}

/// The value of a formula and its text.
type Shape = (fn(f64, [f64; 3]) -> f64, fn([f64; 3]) -> String);

/// Frictions over the speed, ≥ 0 for constants > 0.
const FRICTIONS: [Shape; 6] = [
    (|v, [a, b, c]| a + b * (-v / c).exp(), |[a, b, c]| format!("{a} + {b}*exp(-v/{c})")),
    (|v, [a, b, c]| a + b / (1.0 + (v / c) * (v / c)), |[a, b, c]| format!("{a} + {b}/(1 + (v/{c})^2)")),
    (|v, [a, b, c]| a + b * (v / c).tanh(), |[a, b, c]| format!("{a} + {b}*tanh(v/{c})")),
    (|v, [a, b, c]| (a + b - c * v).max(a), |[a, b, c]| format!("max({a} + {b} - {c}*v, {a})")),
    (|v, [a, b, c]| a + b * (v + c).sqrt(), |[a, b, c]| format!("{a} + {b}*sqrt(v + {c})")),
    (|v, [a, b, c]| a + b * v + c * v * v * v, |[a, b, c]| format!("{a} + {b}*v + {c}*v^3")),
];

/// Forces over the stretch, which rise for constants > 0 within the motions of these systems.
const SPRINGS: [Shape; 6] = [
    (|x, [a, b, _]| a * x + b * x * x * x, |[a, b, _]| format!("{a}*x + {b}*x^3")),
    (|x, [a, _, _]| a * x.sin(), |[a, _, _]| format!("{a}*sin(x)")),
    (|x, [a, b, _]| a * (x / b).tanh(), |[a, b, _]| format!("{a}*tanh(x/{b})")),
    (|x, [a, b, _]| a * (x - b).max(0.0), |[a, b, _]| format!("{a}*max(x - {b}, 0)")),
    (|x, [a, b, _]| a * x * (1.0 + b * x * x).sqrt(), |[a, b, _]| format!("{a}*x*sqrt(1 + {b}*x^2)")),
    (|x, [a, b, c]| a * x.abs() * x + b * (x - c), |[a, b, c]| format!("{a}*abs(x)*x + {b}*(x - {c})")),
];

impl Curve {
    /// The force at a speed ≥ 0, or at a stretch.
    #[must_use]
    pub fn value(&self, at: f64) -> f64 {
        match self {
            Self::Stribeck { kinetic, static_friction, speed, exponent, viscous } => {
                kinetic + (static_friction - kinetic) * (-(at / speed).powf(*exponent)).exp() + viscous * at
            }
            Self::Formula { value, constants, .. } => value(at, *constants),
        }
    }

    fn of_constants(shapes: &[Shape; 6], place: usize, constants: [f64; 3]) -> Option<Self> {
        let &(value, text) = shapes.get(place)?;
        Some(Self::Formula { text: text(constants), value, constants })
    }
}

/// A system of which some laws are curves.
#[derive(Debug, Clone)]
pub struct Curved {
    /// The system, a start and a time. The laws of its elements at the places of curves do not count.
    pub structure: Structure,
    /// The places of elements with their curves.
    pub curves: Vec<(usize, Curve)>,
}

impl<'a> Arbitrary<'a> for Curved {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        let mut structure = Structure::arbitrary(u)?;
        let mut curves = Vec::new();
        let model = &mut structure.model;
        // Bodies without masses carry contacts of one friction each.
        let has_joint = model.mass.iter().enumerate().any(|(i, row)| row.get(i) == Some(&0.0));
        let some = |u: &mut Unstructured<'a>, low: u8| -> Result<f64> {
            Ok(f64::from(u.int_in_range(low..=16)?) / 8.0)
        };
        for (place, element) in model.elements.iter_mut().enumerate() {
            let shape = u.int_in_range(0..=11_usize)?;
            let constants = [some(u, 1)?, some(u, 1)?, some(u, 1)?];
            let curve = match &mut element.kind {
                Kind::Contact { normal: None, peak, .. } if !has_joint => {
                    let curve = if shape < FRICTIONS.len() {
                        Curve::of_constants(&FRICTIONS, shape, constants)
                    } else {
                        let [kinetic, more, speed] = constants;
                        let (exponent, viscous) = (some(u, 4)?, some(u, 0)?);
                        let static_friction = kinetic + more;
                        Some(Curve::Stribeck { kinetic, static_friction, speed, exponent, viscous })
                    };
                    *peak = 1.0;
                    curve
                }
                Kind::Spring { .. } => Curve::of_constants(&SPRINGS, shape / 2, constants),
                Kind::Contact { .. }
                | Kind::Elastic { .. }
                | Kind::Stop { .. }
                | Kind::HardStop { .. }
                | Kind::UnderStop { .. } => None,
            };
            curves.extend(curve.map(|curve| (place, curve)));
        }
        Ok(Self { structure, curves })
    }
}
