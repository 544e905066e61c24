//! The range of a function over a box, from enclosures over its parts.

pub(super) use crate::enclosed::split::Ends;
use crate::enclosed::split::{halves, widest};
use crate::machine::error::Error;

/// The values of a function over a part of the box.
#[derive(Debug, Clone)]
pub(super) enum Over {
    /// All values lie within this interval.
    Values(Ends),
    /// The function has no value anywhere in the part.
    Nowhere,
    /// The part is too large to decide.
    Undecided,
}

impl Over {
    const fn values(&self) -> Option<&Ends> {
        match self {
            Self::Values(ends) => Some(ends),
            Self::Nowhere | Self::Undecided => None,
        }
    }
}

/// The range over the whole box, cut into at most `most` parts; `None` where the function has no value
/// somewhere, or where that remains undecided.
///
/// The next part to be cut is an undecided one if there is any, otherwise one that contains an end of the
/// range. It is cut across its relatively widest parameter.
pub(super) fn range(
    whole: Vec<Ends>,
    most: u32,
    over: impl Fn(&[Ends]) -> Result<Over, Error>,
) -> Result<Option<Ends>, Error> {
    let mut parts = vec![(over(&whole)?, whole)];
    loop {
        if parts.iter().any(|(found, _)| matches!(found, Over::Nowhere)) {
            return Ok(None);
        }
        let next = if parts.len() < most as usize { next(&parts) } else { None };
        let Some((index, side)) = next else { return Ok(hull(&parts)) };
        let (_, part) = parts.swap_remove(index);
        for half in halves(&part, side) {
            parts.push((over(&half)?, half));
        }
    }
}

/// The part to be cut, and the parameter to cut; `None` where no cut would help.
fn next(parts: &[(Over, Vec<Ends>)]) -> Option<(usize, usize)> {
    let undecided = parts.iter().position(|(found, _)| matches!(found, Over::Undecided));
    let values = || parts.iter().map(|(found, _)| found.values()).enumerate();
    let lowest = || values().min_by_key(|(_, ends)| ends.map(|(low, _)| low)).map(|(index, _)| index);
    let highest = || values().max_by_key(|(_, ends)| ends.map(|(_, high)| high)).map(|(index, _)| index);
    // The two ends of the range take turns.
    let index = undecided.or_else(|| if parts.len() & 1 == 1 { highest() } else { lowest() })?;
    let (_, part) = parts.get(index)?;
    Some((index, widest(part)?))
}

/// Whether the function is above 1 over the whole box (true) or below 1 (false); `None` where it is on both
/// sides, or where `most` parts do not decide.
///
/// Only undecided parts are cut.
pub(super) fn is_above_one(
    whole: Vec<Ends>,
    most: u32,
    over: impl Fn(&[Ends]) -> Result<Over, Error>,
) -> Result<Option<bool>, Error> {
    let (mut left, mut known) = (vec![whole], None);
    for _ in 0..most {
        let Some(part) = left.pop() else { return Ok(known) };
        let is_above = match over(&part)? {
            Over::Values((low, _)) if low > 1 => true,
            Over::Values((_, high)) if high < 1 => false,
            Over::Nowhere => return Ok(None),
            Over::Values(_) | Over::Undecided => {
                let Some(side) = widest(&part) else { return Ok(None) };
                left.extend(halves(&part, side));
                continue;
            }
        };
        if *known.get_or_insert(is_above) != is_above {
            return Ok(None);
        }
    }
    Ok(known.filter(|_| left.is_empty()))
}

/// The range from the least to the greatest value over all parts, if each has values.
fn hull(parts: &[(Over, Vec<Ends>)]) -> Option<Ends> {
    let all: Option<Vec<_>> = parts.iter().map(|(found, _)| found.values()).collect();
    let all = all?;
    let (low, high) = (all.iter().map(|(low, _)| low).min()?, all.iter().map(|(_, high)| high).max()?);
    Some((low.clone(), high.clone()))
}

#[cfg(test)]
mod tests {
    use super::{Ends, Over, is_above_one, range};
    use rug::Rational;
    use std::cell::Cell;

    fn ends(low: i32, high: i32) -> Ends {
        (Rational::from(low), Rational::from(high))
    }

    /// y − x from the ends of the part.
    fn difference(part: &[Ends]) -> Over {
        let [(x1, x2), (y1, y2)] = part else { panic!("two sides") };
        Over::Values((Rational::from(y1 - x2), Rational::from(y2 - x1)))
    }

    #[test]
    fn the_ends_close_in_as_the_box_is_cut() {
        // x² − x by interval arithmetic on [1, 3]: the range is 0 to 6, and a single part gives −2 to 8.
        let over = |part: &[Ends]| {
            let (low, high) = &part[0];
            Ok(Over::Values((Rational::from(low * low) - high, Rational::from(high * high) - low)))
        };
        let one = range(vec![ends(1, 3)], 1, over).unwrap().unwrap();
        assert_eq!(one, ends(-2, 8));
        let (low, high) = range(vec![ends(1, 3)], 40, over).unwrap().unwrap();
        assert!(low > -0.001 && low <= 0 && high >= 6 && high < 6.02, "{low} {high}");
    }

    #[test]
    fn a_part_without_a_value_ends_it_and_an_undecided_one_is_cut() {
        let square = vec![ends(1, 2), ends(5, 7)];
        let nowhere = |part: &[Ends]| Ok(if part[0].1 < 2 { Over::Nowhere } else { Over::Undecided });
        assert_eq!(range(square.clone(), 100, nowhere).unwrap(), None);
        let narrow = |part: &[Ends]| {
            let is_wide = Rational::from(&part[1].1 - &part[1].0) > 0.5;
            Ok(if is_wide { Over::Undecided } else { difference(part) })
        };
        assert_eq!(range(square.clone(), 3, narrow).unwrap(), None);
        assert_eq!(range(square.clone(), 100, narrow).unwrap(), Some(ends(3, 6)));
        // A box of a single point needs one part.
        let exact = range(vec![ends(1, 1), ends(2, 2)], 50, |part| Ok(difference(part)));
        assert_eq!(exact.unwrap(), Some(ends(1, 1)));
    }

    #[test]
    fn only_a_part_on_neither_side_is_cut() {
        let looked = Cell::new(0);
        let level = |from: i32, to: i32, most| {
            looked.set(0);
            let over = |part: &[Ends]| {
                looked.set(looked.get() + 1);
                Ok(difference(part))
            };
            // y − x for x within [0, 1].
            is_above_one(vec![ends(0, 1), ends(from, to)], most, over).unwrap()
        };
        assert_eq!((level(3, 4, 1), looked.get()), (Some(true), 1));
        assert_eq!((level(-1, 0, 1), looked.get()), (Some(false), 1));
        // The values run from 0 to 2, and 1 is attained at a corner.
        assert_eq!(level(1, 2, 100), None);
        assert_eq!(level(2, 3, 100), None);
        // The bounds are wider than the values: x (2 − x) + 3/4 on [1/2, 3/2] takes three parts.
        let whole = || vec![(Rational::from((1, 2)), Rational::from((3, 2)))];
        let over = |part: &[Ends]| {
            looked.set(looked.get() + 1);
            let (low, high) = &part[0];
            let rest = Rational::from((3, 4));
            let value = |x: &Rational, y: &Rational| x * (2 - y.clone()) + &rest;
            Ok(Over::Values((value(low, high), value(high, low))))
        };
        looked.set(0);
        assert_eq!((is_above_one(whole(), 3, over).unwrap(), looked.get()), (Some(true), 3));
        assert_eq!(is_above_one(whole(), 2, over).unwrap(), None);
    }
}
