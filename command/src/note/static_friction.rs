//! Static friction above the kinetic one: the cycle without a stop, a body at rest, and every start are three
//! statements.

use super::digits;
use crate::bits::Value;
use std::io::{self, Write};
use stickslip::{NoStop, Regime, Response};

/// The verdict in one sentence, or two.
pub(super) fn verdict<F: Value>(response: &Response<F>) -> String {
    let ratios = response.ratios;
    let margin = digits(ratios.alpha() / response.border.min_force_ratio);
    let from_rest = if ratios.moves_from_rest() {
        "a body at rest is released".to_owned()
    } else {
        format!(
            "a body at rest within ±{} B stays at rest",
            digits(ratios.static_friction_ratio() - ratios.alpha())
        )
    };
    match response.regime {
        Regime::Stuck => {
            "Stuck: α ≤ 1, so the force never exceeds friction and the body comes to rest for good.".to_owned()
        }
        Regime::Sticking => format!(
            "Sticking: the body stops again and again, from every start. The force is {margin} of the minimum for \
             continuous sliding."
        ),
        Regime::NonSticking => format!(
            "Non-sticking: in the long run the body never stops, from every start. The force is {margin} times the \
             minimum for continuous sliding."
        ),
        Regime::Unbounded => {
            "Unbounded: at Ω = 1 friction cannot hold the resonance, and the displacement grows in every cycle, from \
             every start."
                .to_owned()
        }
        Regime::DependsOnStart => {
            let without_stop = match response.reversals_per_cycle() {
                Some(2) => "a cycle without a stop exists and attracts its neighbourhood",
                Some(_) => "a cycle of six reversals without a stop exists and attracts its neighbourhood",
                None if response.has_motion_without_stop() => "a motion without a stop exists and grows without bound",
                None => "every other motion ends at rest or stops again and again",
            };
            format!("Depends on the start: {from_rest}, and {without_stop}.")
        }
    }
}

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
