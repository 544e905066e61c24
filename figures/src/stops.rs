//! A map of the number of stops per cycle over Ω and α.

use crate::shared::{evenly, from_rest, of_frequency_ratio};
use stickslip::Border;
use stickslip::motion::LongRun;
use stickslip_draw::{Axis, Figure, Panel, Plane, Scale, Series, Style};

/// Names of the numbers of stops, from light to dark: as in all figures, the lightest colour means no stop,
/// and the darkest means rest.
const NAMES: [&str; 6] =
    ["no stop", "1 or 2 stops", "3 or 4 stops", "5 or 6 stops", "7 stops or more", "at rest"];

/// Stops per cycle of the exact motion from rest, with the border.
pub(super) fn per_cycle() -> Figure {
    let (x, y): (Vec<f64>, Vec<f64>) =
        (evenly(0.0525, 1.4975, 290).collect(), evenly(0.05, 7.95, 159).collect());
    let places = y.iter().flat_map(|&alpha| x.iter().map(move |&omega| (omega, alpha)));
    let values = places.map(|(omega, alpha)| class(omega, alpha)).collect();
    let names = NAMES.map(str::to_owned).to_vec();
    let border = evenly(0.05, 1.5, 2901)
        .filter_map(|omega| Border::new(omega).ok().map(|b| (omega, b.min_force_ratio)));
    Figure::new(
        "stops",
        "Stops per cycle",
        "Stops in a cycle of the exact steady motion from rest, with the exact border (line). At α ≤ 1 the \
            body does not move.",
        vec![
            Panel::new(
                "",
                of_frequency_ratio(0.05, 1.5),
                Axis::linear("force ratio α = p₀/r_y", 0.0, 8.0),
                vec![Series::new("exact border α_min", Style::Thick, 0, border)],
            )
            .over(Plane {
                label: "stops per cycle".to_owned(),
                x,
                y,
                values,
                scale: Scale::Names(names),
            }),
        ],
    )
}

/// The index in the list of names; NaN where the motion did not settle.
fn class(omega: f64, alpha: f64) -> f64 {
    match from_rest(omega, alpha) {
        Ok(LongRun::Rest(_)) => 5.0,
        Ok(LongRun::Periodic(s) | LongRun::Family(s)) => f64::from(s.sticks_per_cycle.div_ceil(2).min(4)),
        Ok(LongRun::Unbounded { .. }) => 0.0,
        Ok(LongRun::Irregular(_) | LongRun::NotConverged { .. }) | Err(_) => f64::NAN,
    }
}
