//! `stickslip design force` and `friction` with a static friction above the kinetic one: the force that releases a
//! body at rest, the border of the motion without a stop, and a bound that suffices for every start.

use super::{DesignAnswer, some};
use crate::bits::{Value, digits};
use stickslip::inputs::units::Kind;
use stickslip::{NoStop, Ratios};

/// The quantity whose bound is asked for: a force, or a friction.
pub(super) struct Divided<'a, F> {
    /// Whether it is a force, or a friction bound as a part of the force.
    pub(super) is_force: bool,
    /// The names of the one that releases a body at rest, and of the one that suffices for every start.
    pub(super) names: [&'static str; 2],
    pub(super) kind: Kind,
    /// The size of r_y, or for a friction that of the force.
    pub(super) scale: F,
    pub(super) unit: &'a str,
}

impl<F: Value> DesignAnswer<F> {
    /// The answer where static friction divides it into three; otherwise as it is.
    pub(super) fn divided(mut self, ratios: &Ratios<F>, of: &Divided<'_, F>) -> Self {
        if !ratios.has_higher_static_friction() {
            return self;
        }
        let (eta, found, one) = (ratios.static_friction_ratio(), NoStop::of(ratios), F::int(1));
        let Divided { is_force, names: [release, every_start], kind, scale, unit } = *of;
        let text = |x: F| format!("{} {unit}", digits(if is_force { x * scale } else { one / x * scale }));
        let [released, with, more, bound] = if is_force {
            ["above a force of", "at", "more", "above"]
        } else {
            ["with a friction bound below", "with", "less", "below"]
        };
        let of_every_start = match found.every_start {
            Some(least) => format!("Every start leads to sliding without a stop {bound} {}.", text(least)),
            None => "The start decides between this motion and others.".to_owned(),
        };
        self.sentence = format!(
            "A body at rest is released {released} {}. A motion without a stop exists and attracts its \
             neighbourhood {with} {} or {more}. {of_every_start}",
            text(eta),
            text(found.border)
        );
        let value = |x: F| some(if is_force { x * scale } else { scale / x });
        let release = (release, kind, value(eta));
        let bound = found.every_start.map(|bound| (every_start, kind, value(bound)));
        self.rows.iter_mut().for_each(|row| row.extend([release].into_iter().chain(bound)));
        self
    }
}
