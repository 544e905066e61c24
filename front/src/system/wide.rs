//! A system in numbers of any precision. It is compiled here, once for all of them.

use super::built::NamedSystem;
use super::grid::{Cell, Grid};
use super::one_body::{OneBody, Repeated};
use crate::inputs::units::System as Units;
use crate::text::Folder;
use serde_json::Value;
use std::ops::ControlFlow;
use std::path::Path;
use stickslip::enclosed::Enclosure;
use stickslip::float::Widest;
use stickslip::motion::record::{Body, Record};
use stickslip::system::{Border, Cycle, Error, Motion, State, Steady};

/// The motion to which a body under a record that repeats itself comes from a start, as [`OneBody::steady`], in numbers of the precision that is
/// set; it is followed as long as `keep_going` returns [`ControlFlow::Continue`].
///
/// # Errors
/// As [`OneBody::new`], and the inner ones as [`OneBody::steady`].
pub fn steady_of_body(
    body: &Body<Widest>,
    units: Units,
    start: [Widest; 2],
    record: &Record<Widest>,
    keep_going: fn() -> ControlFlow<()>,
) -> Result<Result<Steady<Widest>, Error>, String> {
    let one = OneBody::new(body, units, start, Repeated::Record(record))?;
    Ok(one.while_allowed(keep_going).steady())
}

/// A described system with its motions, in numbers of the precision that is set.
#[derive(Debug, Clone)]
pub struct WideSystem(NamedSystem<Widest>);

impl WideSystem {
    /// As [`NamedSystem::new`], of a value that [`parsed_as_typed`](super::parsed_as_typed) returned; motions are followed as long as
    /// `keep_going` returns [`ControlFlow::Continue`].
    ///
    /// # Errors
    /// As there; also where the file has a law that is a curve, or a sweep.
    pub fn new(
        value: &Value,
        set: &[(&str, &str)],
        folder: &Path,
        units: Option<&Units>,
        keep_going: fn() -> ControlFlow<()>,
    ) -> Result<Self, String> {
        let found = NamedSystem::read(value, set.iter().copied(), &Folder::new(folder), units)?;
        Ok(Self(found.while_allowed(keep_going)))
    }

    /// The system.
    #[must_use]
    pub const fn named(&self) -> &NamedSystem<Widest> {
        &self.0
    }

    /// As [`NamedSystem::with_record`].
    ///
    /// # Errors
    /// As there.
    pub fn with_record(self, record: &Record<Widest>, name: &str) -> Result<Self, String> {
        self.0.shaken(record, name).map(Self)
    }

    /// As [`NamedSystem::until`].
    ///
    /// # Errors
    /// As there.
    pub fn until(&mut self, name: &str, typed: Option<&str>) -> Result<Widest, String> {
        self.0.until_by(name, typed, |own, level, latest| {
            Ok(own.system.first_passage(&own.described.start, level, latest)?)
        })
    }

    /// As [`NamedSystem::simulate`].
    ///
    /// # Errors
    /// As [`System::simulate`](stickslip::system::System::simulate).
    pub fn simulate(&self, until: Widest) -> Result<Motion<Widest>, Error> {
        self.0.system.simulate(&self.0.described.start, until)
    }

    /// The motion from the start of the file until a time, enclosed, as sharp as so many bits: its start and the motion.
    ///
    /// # Errors
    /// As [`System::enclosed`](stickslip::system::System::enclosed).
    pub fn enclosed(&self, until: Widest, bits: u32) -> Result<(State<Enclosure>, Motion<Enclosure>), Error> {
        let start = &self.0.described.start;
        let found = self.0.system.enclosed(start, until, bits)?;
        Ok((start.map(&|x| Enclosure::read(*x, bits)), found))
    }

    /// As [`NamedSystem::steady`].
    ///
    /// # Errors
    /// As [`System::steady`](stickslip::system::System::steady).
    pub fn steady(&self) -> Result<Steady<Widest>, Error> {
        self.0.system.steady(&self.0.described.start)
    }

    /// As [`NamedSystem::states`].
    ///
    /// # Errors
    /// As [`System::states`](stickslip::system::System::states).
    pub fn states(&self, start: &State<Widest>, times: &[Widest]) -> Result<Vec<State<Widest>>, Error> {
        self.0.system.states(start, times)
    }

    /// The border, and the cycle at the load of the file, where it is a motion.
    ///
    /// # Errors
    /// As [`System::border`](stickslip::system::System::border).
    pub fn border(&self) -> Result<(Border<Widest>, Option<Cycle<Widest>>), Error> {
        self.0.border_with_cycle()
    }
}

impl Grid<'_> {
    /// The cells of a row's answer in numbers of the precision that is set, without records and without laws that are curves. `until` is the
    /// end of a motion, as it is typed with the option `name`.
    ///
    /// # Errors
    /// As [`Grid::answer`].
    pub fn answer_in_full(
        &self,
        row: u64,
        until: Option<(&str, &str)>,
    ) -> Result<Vec<Cell<'static, Widest>>, String> {
        self.answer_in(row, until)
    }
}
