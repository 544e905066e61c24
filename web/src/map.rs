//! The map of stops over Ω and α.

use crate::asked::Asked;
use serde_json::{Value, json};
use std::ops::ControlFlow;
use stickslip::motion::{DEFAULT_BUDGET, LongRun, State};
use stickslip::{Border, Error, Ratios, observed};

/// The regime and the stops in a cycle at every pair of `omegas` and `alphas`, row by row of α, for the motion from rest;
/// −1 where there is no cycle, −2 where the stops cannot be counted, with static friction in 300 periods; and the border over the list `border` of frequency ratios.
pub(crate) fn map(asked: &Asked<'_>) -> Result<Value, String> {
    let (omegas, alphas) = (asked.numbers("omegas"), asked.numbers("alphas"));
    let (zeta, eta) = (asked.number("damping_ratio", 0.0), asked.number("static_friction_ratio", 1.0));
    let ratios =
        |omega, alpha| Ratios::new(omega, alpha)?.with_damping_ratio(zeta)?.with_static_friction_ratio(eta);
    let stops = |omega, alpha| -> Result<i64, Error> {
        let ratios = ratios(omega, alpha)?;
        // A motion that depends on its start may never repeat itself; a picture does not wait for its last word.
        let periods = if eta > 1.0 { 300 } else { DEFAULT_BUDGET };
        let limit = LongRun::within(ratios, State::default(), periods, &mut || ControlFlow::Continue(()));
        let Ok(limit) = limit else { return Ok(-2) };
        Ok(match limit.steady_state() {
            Some(_) => observed(ratios, &limit).sticks.map_or(-2, i64::from),
            None if matches!(limit, LongRun::NotConverged { .. } | LongRun::Irregular(_)) => -2,
            None => -1,
        })
    };
    let mut all = Vec::with_capacity(omegas.len() * alphas.len());
    for &alpha in &alphas {
        for &omega in &omegas {
            all.push(stops(omega, alpha).map_err(|e| e.to_string())?);
        }
    }
    let border = asked.numbers("border").into_iter();
    let border = border.map(|omega| Ok(Border::of(&ratios(omega, 1.0)?).min_force_ratio));
    let border: Vec<f64> = border.collect::<Result<_, Error>>().map_err(|e| e.to_string())?;
    Ok(json!({ "stops": all, "border": border }))
}
