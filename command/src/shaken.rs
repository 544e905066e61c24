//! The body, the surface, the record and the start of `record`, and of its enclosure.

use crate::args::{RecordArgs, SurfaceArgs};
use crate::bits::Value;
use crate::failure::Failure;
use crate::floor::Oscillators;
use crate::{input, measured};
use stickslip::Excitation;
use stickslip::motion::record::{Body, Record};
use stickslip_front::inputs::units::{Kind, Reader};
use stickslip_front::inputs::{Given, Input, Role};
use stickslip_front::record::Summary;

/// The body, the record and the start of a motion.
pub(crate) struct Shaken<F> {
    pub(crate) given: Given<F>,
    pub(crate) body: Body<F>,
    pub(crate) record: Record<F>,
    pub(crate) summary: Summary,
    pub(crate) start: [F; 2],
    /// The greatest distance of the states of a motion, if it was given.
    pub(crate) interval: Option<F>,
    pub(crate) floor: Option<Oscillators<F>>,
    /// Whether the mass is known, on which forces and works depend.
    pub(crate) has_mass: bool,
}

impl<F: Value> Shaken<F> {
    pub(crate) fn read(args: &RecordArgs) -> Result<Self, Failure> {
        args.answer.format.is_json("record")?;
        let reader = args.answer.units.reader();
        let mut given = input::read::<F>(&args.machine, &reader)?;
        let interval = args.interval.as_ref().map(|text| {
            let interval = reader.value::<F>("--interval", text, Kind::Time)?;
            if interval > F::int(0) && interval.is_finite() {
                return Ok(interval);
            }
            Err(Failure::Input(format!("--interval {text}: must be > 0 and finite")))
        });
        let interval = interval.transpose()?;
        let floor = Oscillators::read(args, &reader)?;
        let surface = Surface::read(&args.surface, &reader)?;
        let start = surface.start(&reader, [args.x0.as_deref(), args.v0.as_deref()])?;
        let (record, summary) = measured::read::<F>(&args.file, &args.load, &reader)?;
        // From here on the mass is a unit of mass, where it cancels.
        let cancels = record.excitation() != Excitation::Force && given.cancel_mass();
        let body = surface.body(&given)?;
        Ok(Self { given, body, record, summary, start, interval, floor, has_mass: !cancels })
    }
}

/// The surface that a body slides on.
pub(crate) struct Surface<F> {
    slope: Option<F>,
    is_one_way: bool,
}

impl<F: Value> Surface<F> {
    /// Whether the body is no oscillator: without a spring, on a slope, or one that moves one way.
    pub(crate) fn is_special(&self, given: &Given<F>) -> bool {
        self.slope.is_some() || given.is_without_spring() || self.is_one_way
    }

    /// Whether the body lies on a slope.
    pub(crate) const fn is_inclined(&self) -> bool {
        self.slope.is_some()
    }

    pub(crate) fn read(args: &SurfaceArgs, reader: &Reader) -> Result<Self, Failure> {
        let slope = args.slope.as_ref().map(|text| {
            let slope = reader.value::<F>("--slope", text, Kind::Angle)?;
            // A bare number may be meant in degrees, in radians, or as a gradient.
            if slope != F::int(0) && !Reader::has_unit(text) {
                return Err(Failure::Input(format!(
                    "--slope {text}: must have a unit, {text}deg or {text}rad"
                )));
            }
            Ok(slope)
        });
        Ok(Self { slope: slope.transpose()?, is_one_way: args.one_way })
    }

    /// The displacement and the velocity at the start, typed in units.
    pub(crate) fn start(&self, reader: &Reader, typed: [Option<&str>; 2]) -> Result<[F; 2], Failure> {
        let start = input::start_in_units(reader, typed)?;
        if let [_, Some(text)] = typed
            && self.is_one_way
            && start[1] < F::int(0)
        {
            return Err(format!("--v0 {text}: must be ≥ 0 with --one-way").into());
        }
        Ok(start)
    }

    /// The body of the given inputs on this surface.
    pub(crate) fn body(&self, given: &Given<F>) -> Result<Body<F>, Failure> {
        if given.one_of(Role::Spring)?.is_none() && !given.has(Input::YieldAcceleration) {
            let missing = given.missing(&Input::of_role(Role::Spring));
            return Err(format!("{missing}. A body without a spring has --no-spring").into());
        }
        let body = given.body(self.slope)?;
        Ok(if self.is_one_way { body.one_way() } else { body })
    }
}

/// Whether values of a kind are those of a mass.
pub(crate) const fn needs_mass(kind: Kind) -> bool {
    matches!(kind, Kind::Force | Kind::Energy | Kind::Stiffness)
}
