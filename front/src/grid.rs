//! Evenly spaced values, or values in equal ratios, in place of one value: `FROM:TO:COUNT` and `FROM:TO:COUNT:log`.

use std::str::FromStr;
use stickslip::Float;
use stickslip::dependencies::num_traits::Pow;

/// The values from one end to the other, both included: numbers, or as they are typed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range<T> {
    /// The first value.
    pub from: T,
    /// The last value.
    pub to: T,
    /// The number of values.
    pub count: u64,
    /// Whether their ratios are equal, and not their distances.
    pub is_logarithmic: bool,
}

impl<'t> Range<&'t str> {
    /// The range that a text is, of at most so many values; `None` for one value and for a list `A,B,C`.
    ///
    /// # Errors
    /// The condition that the text breaks.
    pub fn typed(text: &'t str, most: u64) -> Result<Option<Self>, String> {
        let parts: Vec<&str> = text.split(':').collect();
        let (from, to, count, is_logarithmic) = match parts.as_slice() {
            [list] if list.split(',').any(|part| part.trim().is_empty()) => {
                return Err("a value is missing".to_owned());
            }
            [_] => return Ok(None),
            [from, to, count] => (*from, *to, *count, false),
            [from, to, count, "log"] => (*from, *to, *count, true),
            _ => {
                return Err("must be FROM:TO:COUNT, FROM:TO:COUNT:log or A,B,C, each number with a decimal \
                            point"
                    .to_owned());
            }
        };
        let whole = count.trim().parse().ok().filter(|count| (1..=most).contains(count));
        let count = whole.ok_or_else(|| format!("count {count}: must be a whole number ≥ 1 and ≤ {most}"))?;
        Ok(Some(Self { from, to, count, is_logarithmic }))
    }

    /// The range between these numbers, which the typed ends are.
    ///
    /// # Errors
    /// The condition that they break.
    pub fn between<F: Float>(&self, from: F, to: F) -> Result<Range<F>, &'static str> {
        let &Self { count, is_logarithmic, .. } = self;
        if !(from.is_finite() && to.is_finite()) {
            return Err("each value must be finite");
        }
        if count == 1 && from != to {
            return Err("the count must be ≥ 2 where FROM and TO differ");
        }
        if is_logarithmic && !(from > F::int(0) && to > F::int(0)) {
            return Err("FROM and TO must be > 0 for equal ratios");
        }
        Ok(Range { from, to, count, is_logarithmic })
    }
}

impl<F: Float + FromStr + Pow<F, Output = F>> Range<F> {
    /// The value at a place below the count, which depends on the place alone.
    pub fn value(&self, place: u64) -> F {
        let last = self.count.saturating_sub(1);
        if place == 0 {
            return self.from;
        }
        if place >= last {
            return self.to;
        }
        let (place, last) = (F::from_f64(place as f64), F::from_f64(last as f64));
        as_typed(if self.is_logarithmic {
            self.from * (self.to / self.from).pow(place / last)
        } else {
            self.from + (self.to - self.from) * place / last
        })
    }
}

/// A double beside a decimal of up to twelve digits as that decimal, which a hand would have typed: 0.15 for
/// 0.15000000000000002.
fn as_typed<F: Float + FromStr>(value: F) -> F {
    if F::PRECISION != f64::MANTISSA_DIGITS {
        return value;
    }
    let near = format!("{value:.11e}").parse().unwrap_or(value);
    if (near - value).abs() <= F::int(2) * F::epsilon() * value.abs() { near } else { value }
}
