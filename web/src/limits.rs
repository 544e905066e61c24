//! The limits of several starts, which static friction makes many.

use crate::asked::{Asked, Problem, length};
use serde_json::{Value, json};
use stickslip::motion::{LongRun, Starts, attractors};
use stickslip_front::limits::PERIODS;
use stickslip_front::words;

/// The limits that `count` starts lead to, as `stickslip attractors` finds them.
pub(crate) fn limits(asked: &Asked<'_>) -> Result<Value, String> {
    let Problem { given, point, is_without_spring, .. } = asked.problem()?;
    if is_without_spring {
        return Err("stiffness: must be > 0. Without a spring a limit has any place".to_owned());
    }
    let spread = Starts::around(&point.ratios);
    let starts: Vec<_> = (0..asked.count("count", 64, 4096)).map(|number| spread.get(number)).collect();
    let found = attractors(point.ratios, &starts, PERIODS).map_err(|e| String::from(given.at_fault(&e)))?;
    let size = length(&point);
    let rows = found.limits.iter().map(|own| {
        let extrema = own.limit.extrema().map(|(low, high)| [low * size, high * size]);
        json!({
            "limit": own.limit.name(),
            "description": words::described(own),
            "share": own.starts as f64 / starts.len() as f64,
            "extrema": extrema,
            "mirror": own.mirror,
            "range": own.range.map(|(low, high)| [low * size, high * size]),
            "stops": own.limit.steady_state().map(|steady| steady.sticks_per_cycle),
            "is_family": matches!(own.limit, LongRun::Family(_)),
        })
    });
    Ok(json!({
        "limits": rows.collect::<Value>(), "starts": starts.len(), "reach": spread.reach(), "unsettled": found.unsettled(),
        "unit": point.machine.map_or("B".to_owned(), |_| given.system.length().to_owned()),
    }))
}
