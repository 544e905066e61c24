//! Static friction above the kinetic one: the cycle without a stop, a body at rest, and every start are three
//! statements.

use crate::bits::Value;
use std::io::{self, Write};
use stickslip::{NoStop, Response};

/// The forces that release a body at rest, that a cycle without a stop needs, and that suffice for every start.
pub(super) fn forces<F: Value>(
    response: &Response<F>,
    text: impl Fn(F) -> String,
    out: &mut impl Write,
) -> io::Result<()> {
    let found = NoStop::of(&response.ratios);
    writeln!(out, "  releases a body at rest  above {}", text(response.ratios.static_friction_ratio()))?;
    if let Some((low, high)) = found.six_reversals {
        writeln!(out, "  six-reversal cycle from  {}", text(low))?;
        writeln!(out, "    up to                  {}", text(high))?;
    }
    writeln!(out, "  cycle without a stop     {}", text(found.border))?;
    match found.every_start {
        Some(bound) => {
            writeln!(out, "  every start slides       above {}", text(bound))?;
            writeln!(out, "    (this bound suffices and is not the least)")
        }
        None => Ok(()),
    }
}
