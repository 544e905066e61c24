//! Three numbers of every kind: `Mp<LIMBS>` compared with `rug::Float`.
#[macro_use]
#[path = "../../tests/invariants/multiple.rs"]
mod multiple;

use arbitrary::{Arbitrary, Result, Unstructured};
use multiple::{END, Recipe, binary, ternary, text, unary};

/// A number that is special, an integer or one with any significand, with an ordinary, large or extreme
/// exponent.
struct Number(Recipe);

impl<'a> Arbitrary<'a> for Number {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        let kind = u.int_in_range(0..=7)?;
        if kind == 0 {
            return Ok(Self(Recipe::Special(u.int_in_range(0..=4)?)));
        }
        if kind == 1 {
            return i64::arbitrary(u).map(|n| Self(Recipe::Whole(n)));
        }
        let exponent = i32::from(i8::arbitrary(u)?);
        let exponent = match kind {
            2 => END - exponent.abs() / 16,
            3 => exponent.abs() / 16 - END + 1,
            4 => exponent * 16,
            _ => exponent / 16,
        };
        // Words of zeros or ones only cause long carries and ties.
        let mut words = Vec::new();
        for _ in 0..u.int_in_range(1..=3)? {
            words.push(match u.int_in_range(0..=3)? {
                0 => 0,
                1 => u64::MAX,
                _ => u64::arbitrary(u)?,
            });
        }
        Ok(Self(Recipe::Regular { negative: bool::arbitrary(u)?, words, exponent }))
    }
}

fn at<const L: usize>(a: &Recipe, b: &Recipe, c: &Recipe) {
    unary::<L>(a);
    binary::<L>(a, b);
    ternary::<L>(a, b, c);
    text::<L>(a);
}

/// Three numbers of every kind: `Mp<LIMBS>` compared with `rug::Float`.
pub fn multiple(input: (u8, [u8; 96])) {
    let (width, bytes) = input;
    let mut u = Unstructured::new(&bytes);
    let Ok([Number(a), Number(b), Number(c)]) = <[Number; 3]>::arbitrary(&mut u) else { return };
    match width % 4 {
        0 => at::<1>(&a, &b, &c),
        1 => at::<2>(&a, &b, &c),
        2 => at::<4>(&a, &b, &c),
        _ => at::<16>(&a, &b, &c),
    }
}
