//! The limits of several starts, which static friction makes many.

use crate::answer::length;
use crate::asked::{Asked, point};
use serde_json::{Value, json};
use stickslip::motion::{LongRun, Starts, attractors};
use stickslip::words;

/// The limits that `count` starts lead to, as `stickslip attractors` finds them.
pub(crate) fn limits(asked: &Asked<'_>) -> Result<Value, String> {
    let given = asked.given(&asked.reader()?)?;
    let point = point(&given)?;
    let spread = Starts::around(&point.ratios);
    let starts: Vec<_> = (0..asked.count("count", 64, 4096)).map(|number| spread.get(number)).collect();
    let found = attractors(point.ratios, &starts, stickslip::motion::DEFAULT_BUDGET)
        .map_err(|e| String::from(given.at_fault(&e)))?;
    let size = point.length();
    let rows = found.limits.iter().map(|own| {
        let extrema = own.limit.extrema().map(|(low, high)| [low * size, high * size]);
        let start = starts.get(own.first_start).map(|state| [state.x, state.v]);
        json!({
            "limit": own.limit.name(),
            "verdict": words::limit(point.ratios, &own.limit, |x| length(x, &point, &given.system)),
            "share": own.starts as f64 / starts.len() as f64,
            "extrema": extrema,
            "start": start,
            "mirror": own.mirror,
            "range": own.range.map(|(low, high)| [low * size, high * size]),
            "stops": own.limit.steady_state().map(|steady| steady.sticks_per_cycle),
            "rest": matches!(own.limit, LongRun::Rest(_)),
        })
    });
    Ok(json!({
        "limits": rows.collect::<Value>(), "starts": starts.len(), "reach": spread.reach(), "unsettled": found.unsettled(),
        "unit": point.machine.map_or("B".to_owned(), |_| given.system.length().to_owned()),
    }))
}
