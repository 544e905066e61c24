//! The map of stops over Ω and α, and the place of a machine in it.

use crate::asked::Asked;
use serde_json::{Value, json};
use std::ops::ControlFlow;
use stickslip::internal::observed;
use stickslip::motion::{DEFAULT_BUDGET, LongRun, State};
use stickslip::{Border, Error, Ratios, Regime};

/// The names of the places without a number of stops, by their codes −1, −2, …
pub(crate) const NAMES: [&str; 6] = [
    "at rest",
    "irregular",
    "not settled",
    "not computed",
    "grows without bound",
    "stops too short to count",
];

/// The stops in a cycle of a limit, as its verdict counts them; a negative number is the code of one of [`NAMES`].
pub(crate) fn place(ratios: Ratios<f64>, limit: &Result<LongRun<f64>, Error>) -> i64 {
    let Ok(limit) = limit else { return -4 };
    match limit {
        LongRun::Rest(_) => -1,
        LongRun::Irregular(_) => -2,
        LongRun::NotConverged { .. } => -3,
        LongRun::Unbounded { .. } => -5,
        LongRun::Periodic(_) | LongRun::Family(_) => {
            let seen = observed(ratios, limit);
            match seen.sticks {
                None => -6,
                Some(0) if seen.regime == Regime::Sticking => -6,
                Some(stops) => i64::from(stops),
            }
        }
    }
}

/// The place of every pair of `omegas` and `alphas`, row by row of α, or of every pair of the flat list `points`, for the
/// motion from the displacement `x` and the velocity `v` + `w`/Ω, within `periods` periods; and the border over the list
/// `border` of frequency ratios.
pub(crate) fn map(asked: &Asked<'_>) -> Result<Value, String> {
    let (zeta, eta) = (asked.number("damping_ratio", 0.0), asked.number("static_friction_ratio", 1.0));
    let (x, v, w) = (asked.number("x", 0.0), asked.number("v", 0.0), asked.number("w", 0.0));
    let periods = asked.count("periods", u64::from(DEFAULT_BUDGET), u64::from(DEFAULT_BUDGET)) as u32;
    let ratios =
        |omega, alpha| Ratios::new(omega, alpha)?.with_damping_ratio(zeta)?.with_static_friction_ratio(eta);
    let stops = |omega, alpha| -> Result<i64, Error> {
        let ratios = ratios(omega, alpha)?;
        let start = State::new(0.0, x, v + w / omega)?;
        let limit = LongRun::within(ratios, start, periods.max(1), &mut || ControlFlow::Continue(()));
        Ok(place(ratios, &limit))
    };
    let (omegas, alphas, points) =
        (asked.numbers("omegas"), asked.numbers("alphas"), asked.numbers("points"));
    let grid = alphas.iter().flat_map(|&alpha| omegas.iter().map(move |&omega| (omega, alpha)));
    let pairs = points.chunks_exact(2).filter_map(|pair| Some((*pair.first()?, *pair.last()?)));
    let all = grid.chain(pairs).map(|(omega, alpha)| stops(omega, alpha)).collect::<Result<Vec<_>, _>>();
    let border = asked.numbers("border").into_iter();
    let border = border.map(|omega| Ok(Border::of(&ratios(omega, 1.0)?).min_force_ratio));
    let border: Vec<f64> = border.collect::<Result<_, Error>>().map_err(|e| e.to_string())?;
    Ok(json!({ "stops": all.map_err(|e| e.to_string())?, "border": border, "names": NAMES }))
}
