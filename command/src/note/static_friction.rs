//! Static friction above the kinetic one: the cycle without a stop, a body at rest, and every start are three
//! statements.

use super::Note;
use crate::bits::Value;
use std::io::{self, Write};
use stickslip::{Measure, NoStop, Response};

/// The forces that release a body at rest, that a cycle without a stop needs, and that suffice for every start.
pub(super) fn forces<F: Value>(response: &Response<F>, note: &mut Note<'_, F, impl Write>) -> io::Result<()> {
    let found = NoStop::of(&response.ratios);
    let release = note.both(Measure::Force, response.ratios.static_friction_ratio());
    note.line("releases a body at rest", format_args!("above {release}"))?;
    if let Some((low, high)) = found.six_reversals {
        note.number("six-reversal cycle from", Measure::Force, low)?;
        note.number("  up to", Measure::Force, high)?;
    }
    note.number("cycle without a stop", Measure::Force, found.border)?;
    let Some(bound) = found.every_start.map(|bound| note.both(Measure::Force, bound)) else { return Ok(()) };
    note.line("every start slides", format_args!("above {bound}"))?;
    writeln!(note.out, "    (this bound suffices and is not the least)")
}
