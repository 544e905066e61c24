//! `stickslip design friction --over`: the friction that minimises the peak amplitude over a frequency band.

use super::{AskedDesign, DesignAnswer, searched_field, some};
use crate::args::{CurveQuantity, DesignAim};
use crate::bits::{Value, digits};
use crate::curve::AskedCurve;
use crate::failure::{Failure, Outcome};
use crate::figure::{PLAIN, Target};
use crate::row::Cell;
use stickslip::Excitation;
use stickslip::design::{self, Aim, BandFriction, BandFrictionKind};
use stickslip_front::inputs::Input;
use stickslip_front::inputs::units::Kind;

impl DesignAim {
    /// The amplitude, the curve that shows it, its name, and its kind.
    const fn shown(self) -> (Aim, CurveQuantity, &'static str, Kind) {
        match self {
            Self::Displacement => {
                (Aim::Displacement, CurveQuantity::Displacement, "displacement", Kind::Length)
            }
            Self::AbsoluteDisplacement => {
                (Aim::AbsoluteDisplacement, CurveQuantity::Absolute, "absolute displacement", Kind::Length)
            }
            Self::TransmittedForce => {
                (Aim::TransmittedForce, CurveQuantity::Force, "transmitted force", Kind::Force)
            }
            Self::Acceleration => {
                (Aim::Acceleration, CurveQuantity::Acceleration, "absolute acceleration", Kind::Acceleration)
            }
        }
    }
}

impl<F: Value> AskedDesign<'_, F> {
    pub(super) fn friction_over_band(&self, over: &str) -> Result<DesignAnswer<F>, Failure> {
        let Some(of) = self.args.of else {
            let names = "displacement, absolute-displacement, transmitted-force or acceleration";
            return Err(format!("--of is missing beside --over {over}: {names}").into());
        };
        if !self.physical {
            return Err(format!("--over {over}: needs a machine in units, and --mass is missing").into());
        }
        if self.given.has(Input::Frequency) {
            let frequency = self.given.label(Input::Frequency);
            return Err(format!("{frequency}: must be left out beside --over {over}").into());
        }
        let Some((from, to)) = over.split_once(':') else {
            return Err(format!("--over {over}: must be LOW:HIGH, such as 0.5Hz:2Hz").into());
        };
        let end = |text: &str| self.reader.value::<F>("--over", text, Kind::Frequency);
        let (low, high) = (end(from)?, end(to)?);
        if low >= high {
            return Err(format!("--over {over}: the lower end must be < the upper end").into());
        }
        let body = self.body(true, false)?;
        let drive = self.drive(&body, self.one)?;
        let found = design::best_friction_over_band(&body, &drive, low..=high, of.shown().0)
            .map_err(|e| self.fail(e).about(&format!("--over {over}")))?;
        if let Some(file) = &self.args.picture {
            self.picture(file, over, of, found.friction.to_f64())?;
        }
        let coefficient = found.friction / (body.mass() * self.given.gravity()?);
        let mut fields = vec![
            ("friction", Kind::Force, some(found.friction)),
            ("friction_coefficient", Kind::Ratio, some(coefficient)),
            ("greatest", of.shown().3, some(found.greatest)),
        ];
        if !found.at.is_empty() {
            let mut ranges = found.at.iter().map(|&(from, to)| (from, Some(to)));
            fields.push(("at_frequencies", Kind::Frequency, Cell::Intervals([ranges.next(), ranges.next()])));
        }
        fields.push(("greatest_friction", Kind::Force, Cell::Number(found.up_to)));
        fields.push(("rest_friction", Kind::Force, some(found.rest)));
        fields.push(("optimum", Kind::Ratio, Cell::Text(found.kind.name())));
        if !(found.kind == BandFrictionKind::Rest && found.greatest == F::int(0)) {
            fields.push(searched_field());
        }
        Ok(DesignAnswer::one(self.sentence(of, over, &found), fields))
    }

    fn sentence(&self, of: DesignAim, over: &str, found: &BandFriction<F>) -> String {
        let ((_, _, words, kind), force) = (of.shown(), self.system().force());
        let band = over.replacen(':', " to ", 1);
        let friction = format!("{} {force}", digits(found.friction));
        let hertz = |omega: F| digits(omega / (F::int(2) * F::pi()));
        let greatest = format!("{} {}", digits(found.greatest), self.system().name(kind));
        match found.kind {
            BandFrictionKind::Rest if found.greatest == F::int(0) => format!(
                "The peak {words} from {band} is 0 with a friction force of {friction} or more, because the \
                 body rests. Below that, more friction usually means less motion."
            ),
            BandFrictionKind::None => {
                format!("The peak {words} from {band} falls with the friction: {greatest} with almost none.")
            }
            BandFrictionKind::Rest | BandFrictionKind::Interior | _ => {
                let places: Vec<String> = found
                    .at
                    .iter()
                    .map(|&(from, to)| {
                        if from == to {
                            format!("{} Hz", hertz(from))
                        } else {
                            format!("{} to {} Hz", hertz(from), hertz(to))
                        }
                    })
                    .collect();
                let (forces, least) = match found.up_to {
                    _ if found.kind == BandFrictionKind::Rest => {
                        (format!("of {friction} or more, with which the body does not slide"), "")
                    }
                    None => (format!("of {friction}"), ""),
                    Some(end) if end >= found.rest => {
                        (format!("of {friction} or more, also at rest"), "with the least of them ")
                    }
                    Some(end) => {
                        (format!("from {friction} to {} {force}", digits(end)), "with the least of them ")
                    }
                };
                format!(
                    "The peak {words} from {band} is least with a friction force {forces}: {greatest}, \
                     {least}at {}. The friction is found by a search that is not a proof.",
                    places.join(" and at ")
                )
            }
        }
    }

    /// The curves with half the friction, with it, and with twice as much.
    fn picture(&self, file: &std::path::Path, over: &str, of: DesignAim, friction: f64) -> Outcome {
        let input = self.given.amplitude().ok().and_then(|(input, _)| input.excitation());
        let what = match of.shown() {
            // Over a moving surface the absolute acceleration is that force over m.
            (Aim::Acceleration, ..) if input.is_some_and(Excitation::carries_surface) => CurveQuantity::Force,
            (_, what, ..) => what,
        };
        let target = Target::new("--picture", Some(file), self.args.overwrite, &PLAIN)?;
        let frictions = [0.5, 1.0, 2.0].map(|share| share * friction);
        let curve = AskedCurve::of_frictions(what, over, &self.args.machine, frictions, self.reader)?;
        target.draw(&mut std::io::sink(), || curve.drawn())
    }
}
