//! `stickslip design force` and `friction` with a static friction above the kinetic one: the force that releases a
//! body at rest, the border of the motion without a stop, and a bound that suffices for every start.

use super::{AnswerRow, some};
use crate::bits::Value;
use stickslip::inputs::units::Kind;
use stickslip::{NoStop, Ratios};

/// The sentences on the force, which `text` gives its unit.
pub(super) fn by_force<F: Value>(
    ratios: &Ratios<F>,
    found: &NoStop<F>,
    text: impl Fn(F) -> String,
) -> String {
    let every_start = match found.every_start {
        Some(bound) => format!("Every start leads to sliding without a stop above {}.", text(bound)),
        None => "The start decides between this motion and others.".to_owned(),
    };
    format!(
        "A body at rest is released above a force of {}. A motion without a stop exists and attracts its \
         neighbourhood at {} or more. {every_start}",
        text(ratios.static_friction_ratio()),
        text(found.border)
    )
}

/// The sentences on the friction bound, given as a part of the force.
pub(super) fn by_friction<F: Value>(
    ratios: &Ratios<F>,
    found: &NoStop<F>,
    text: impl Fn(F) -> String,
) -> String {
    let one = F::int(1);
    let every_start = match found.every_start {
        Some(bound) => format!("Every start leads to sliding without a stop below {}.", text(one / bound)),
        None => "The start decides between this motion and others.".to_owned(),
    };
    format!(
        "A body at rest is released with a friction bound below {}. A motion without a stop exists and attracts its \
         neighbourhood with {} or less. {every_start}",
        text(one / ratios.static_friction_ratio()),
        text(one / found.border)
    )
}

/// The force or the friction that releases a body at rest, and the one that suffices for every start, from
/// the force ratio.
pub(super) fn fields<F: Value>(
    ratios: &Ratios<F>,
    found: &NoStop<F>,
    [release, every_start]: [&'static str; 2],
    kind: Kind,
    to: impl Fn(F) -> F,
) -> AnswerRow<F> {
    let release = (release, kind, some(to(ratios.static_friction_ratio())));
    let bound = found.every_start.map(|bound| (every_start, kind, some(to(bound))));
    [release].into_iter().chain(bound).collect()
}
