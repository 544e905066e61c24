//! A spring whose law is a table: displacements and forces, mirrored where they begin at 0.

use super::node::{Fields, Node};

/// The points of a spring's table. `odd` says whether the points from 0 up hold below 0 with the opposite sign; where it is not given,
/// they do if they begin at 0.
pub(super) fn points(
    law: &Node<'_>,
    fields: &Fields<'_>,
    table: Vec<(f64, f64)>,
) -> Result<Vec<(f64, f64)>, String> {
    let odd = odd(fields)?;
    let (Some(&(first, force)), true) = (table.first(), table.len() >= 2) else {
        return Err(law.wrong(
            "must have two points or more, [displacement, force]; a straight spring has a stiffness",
        ));
    };
    if let Some(place) = (1..table.len()).find(|&i| at(&table, i) <= at(&table, i.saturating_sub(1))) {
        let (before, own) = (at(&table, place.saturating_sub(1)), at(&table, place));
        let number = place.saturating_add(1);
        return Err(law.wrong(&format!("displacement {number} is {own}, must be > {before} before it")));
    }
    match odd {
        Some(false) => Ok(table),
        None if first < 0.0 => Ok(table),
        Some(true) if first < 0.0 => {
            Err(law.wrong("must begin at the displacement 0 where odd mirrors it: leave out odd, or the points below 0"))
        }
        _ if first > 0.0 => Err(law.wrong(&format!(
            "begins at the displacement {first}, must begin at 0, from where it is mirrored, or below 0"
        ))),
        _ if force != 0.0 => Err(law.wrong(&format!(
            "has the force {force} at 0, must have 0 where it is mirrored: write odd = false, or points below 0"
        ))),
        _ => {
            let below = table.iter().skip(1).rev().map(|&(x, force)| (-x, -force));
            Ok(below.chain(table.iter().copied()).collect())
        }
    }
}

fn at(table: &[(f64, f64)], place: usize) -> f64 {
    table.get(place).map_or(f64::NAN, |point| point.0)
}

/// The field `odd`.
pub(super) fn odd(fields: &Fields<'_>) -> Result<Option<bool>, String> {
    let Some(node) = fields.get("odd") else { return Ok(None) };
    node.value().as_bool().map(Some).ok_or_else(|| node.wrong("must be true or false"))
}
