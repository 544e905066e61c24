//! Single numbers.

use arbitrary::{Arbitrary, Result, Unstructured};

/// Any double: infinities, NaN and subnormal numbers occur as often as their bits.
///
/// # Errors
/// As for [`Unstructured`]; none with the standard kinds.
pub(crate) fn any_bits(u: &mut Unstructured<'_>) -> Result<f64> {
    u64::arbitrary(u).map(f64::from_bits)
}

/// A number uniformly distributed in `low ≤ x ≤ high`.
///
/// # Errors
/// As for [`any_bits`].
pub(crate) fn ordinary(u: &mut Unstructured<'_>, low: f64, high: f64) -> Result<f64> {
    let part = f64::from(u32::arbitrary(u)?) / f64::from(u32::MAX);
    Ok(low + (high - low) * part)
}

/// `x` itself, up to 127 floats from it, or a relative distance 2⁻¹ … 2⁻⁶⁴ away.
///
/// # Errors
/// As for [`any_bits`].
pub(crate) fn beside(u: &mut Unstructured<'_>, x: f64) -> Result<f64> {
    let kind = u.int_in_range(0..=2)?;
    let by = i8::arbitrary(u)?;
    Ok(match kind {
        0 => x,
        1 => moved(x, by),
        _ => {
            let exponent = -1.0 - f64::from(by).rem_euclid(64.0);
            let part = exponent.exp2();
            x * if by < 0 { 1.0 - part } else { 1.0 + part }
        }
    })
}

/// A number of any sign and size: ordinary (half of them), of any magnitude from subnormal to huge, or any
/// bits.
///
/// # Errors
/// As for [`any_bits`].
pub(crate) fn magnitude(u: &mut Unstructured<'_>) -> Result<f64> {
    match u.int_in_range(0..=7)? {
        0 => any_bits(u),
        1 => Ok(-ordinary(u, -1.0, 1024.0)?),
        2..=3 => ordinary(u, -1074.0, 1024.0).map(f64::exp2),
        4 => ordinary(u, -300.0, 300.0).map(f64::exp2),
        _ => ordinary(u, -10.0, 10.0).map(f64::exp2),
    }
}

/// `x` and the `n` floats on either side of it, from the least to the greatest; fewer where the floats end.
#[cfg(test)]
pub(crate) fn neighbours(x: f64, n: u32) -> impl Iterator<Item = f64> {
    let first = (0..n).fold(x, |at, _| at.next_down());
    std::iter::successors(Some(first), |at| Some(at.next_up()))
        .take((n as usize).saturating_mul(2).saturating_add(1))
}

/// `x` moved by some floats.
fn moved(x: f64, by: i8) -> f64 {
    let step = if by < 0 { f64::next_down } else { f64::next_up };
    (0..by.unsigned_abs()).fold(x, |at, _| step(at))
}

#[cfg(test)]
mod tests {
    use super::neighbours;

    #[test]
    fn the_floats_on_either_side() {
        let three: Vec<f64> = neighbours(1.0, 1).collect();
        assert_eq!(three, [1.0 - f64::EPSILON / 2.0, 1.0, 1.0 + f64::EPSILON]);
    }
}
