//! A spring whose law is a table: displacements and forces, mirrored where they begin at 0.

use super::curve::mirrored;
use super::node::{Fields, Node, Number};

/// The points of a spring's table. `odd` says whether the points from 0 up hold below 0 with the opposite sign; where it is not given,
/// they do if they begin at 0.
pub(super) fn points<F: Number>(
    law: &Node<'_>,
    fields: &Fields<'_>,
    table: Vec<(F, F)>,
) -> Result<Vec<(F, F)>, String> {
    let (odd, zero) = (odd(fields)?, F::int(0));
    let (Some(&(first, force)), true) = (table.first(), table.len() >= 2) else {
        return Err(law.wrong(
            "must have two points or more, [displacement, force]; a straight spring has a stiffness",
        ));
    };
    let pairs = (2_usize..).zip(table.iter().zip(table.iter().skip(1)));
    if let Some((number, (before, own))) = pairs.map(|(i, (a, b))| (i, (a.0, b.0))).find(|(_, (a, b))| b <= a)
    {
        return Err(law.wrong(&format!("displacement {number} is {own}, must be > {before} before it")));
    }
    match odd {
        Some(false) => Ok(table),
        None if first < zero => Ok(table),
        Some(true) if first < zero => {
            Err(law.wrong("must begin at the displacement 0 where odd mirrors it: leave out odd, or the points below 0"))
        }
        _ if first > zero => Err(law.wrong(&format!(
            "begins at the displacement {first}, must begin at 0, from where it is mirrored, or below 0"
        ))),
        _ if force != zero => Err(law.wrong(&format!(
            "has the force {force} at 0, must have 0 where it is mirrored: write odd = false, or points below 0"
        ))),
        _ => Ok(mirrored(&table)),
    }
}

/// The field `odd`.
pub(super) fn odd(fields: &Fields<'_>) -> Result<Option<bool>, String> {
    let Some(node) = fields.get("odd") else { return Ok(None) };
    node.value().as_bool().map(Some).ok_or_else(|| node.wrong("must be true or false"))
}
