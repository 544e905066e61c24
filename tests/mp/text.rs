//! Numbers as text.

use num_traits::Num;
use num_traits::real::Real as _;
use stickslip::Float as _;
use stickslip::float::Mp;

#[test]
fn text_as_people_write_it() {
    let x = |text: &str| text.parse::<Mp<2>>();
    for (text, value) in
        [("1.5", 1.5), ("-2e-3", -0.002), ("0", 0.0), (".25", 0.25), ("1E3", 1000.0), ("+7", 7.0)]
    {
        assert!((x(text).unwrap().to_f64() - value).abs() <= 1e-18, "{text}");
    }
    assert!(x("nan").unwrap().is_nan());
    assert_eq!(x("-inf").unwrap(), -Mp::INFINITY);
    for text in ["", "1.5.2", "one", "1e", "--1", "0x10"] {
        let error = x(text).unwrap_err();
        assert_eq!(error.text, text);
        assert!(error.to_string().contains(&format!("`{text}`")));
    }
    assert_eq!(Mp::<1>::from_str_radix("-ff", 16).unwrap(), Mp::from(-255));
    assert!(Mp::<1>::from_str_radix("1", 1).is_err() && Mp::<1>::from_str_radix("1", 37).is_err());
    // Below the least number and above the greatest.
    assert_eq!(x("1e-999999999999").unwrap(), Mp::ZERO);
    assert_eq!(x("1e999999999999").unwrap(), Mp::INFINITY);
}

#[test]
fn text_as_f64_writes_it() {
    for value in
        [0.0, -0.0, 1.0, 0.5, -1.5, 1024.0, 1e20, 0.001953125, f64::INFINITY, f64::NEG_INFINITY, f64::NAN]
    {
        let x = Mp::<1>::from(value);
        assert_eq!(x.to_string(), value.to_string());
        assert_eq!(format!("{x:e}"), format!("{value:e}"));
        assert_eq!(format!("{x:.3}"), format!("{value:.3}"));
        assert_eq!(format!("{x:.0}"), format!("{value:.0}"));
        assert_eq!(format!("{x:.2e}"), format!("{value:.2e}"));
        if value.is_nan() {
            continue;
        }
        assert_eq!(format!("{x:12.3}|{x:<12.1}|{x:+.1}"), format!("{value:>12.3}|{value:<12.1}|{value:+.1}"));
    }
    for value in [9.996, 0.0996, 0.5, 1.5, 0.05, 0.004, 999.9, 1e-9] {
        let x = Mp::<1>::from(value);
        for places in 0..6 {
            assert_eq!(format!("{x:.places$}"), format!("{value:.places$}"));
            assert_eq!(format!("{x:.places$e}"), format!("{value:.places$e}"));
        }
    }
    // The text has no more digits than needed.
    for text in ["0.1", "0.7", "123.456", "9.999999999999999e-12", "1e-400"] {
        assert_eq!(text.parse::<Mp<1>>().unwrap().to_string(), text);
        assert_eq!(text.parse::<Mp<16>>().unwrap().to_string(), text);
    }
    assert_eq!(Mp::<1>::from(10).powi(30).to_string(), "1e30");
    assert_eq!(Mp::<1>::from(10).powi(20).to_string(), "100000000000000000000");
    // Numbers just below a power of ten that they round to.
    assert_eq!(format!("{:.1}", Mp::<1>::from(10).powi(30)), "1000000000000000000024696061952.0");
    assert_eq!(format!("{:.1}", Mp::<1>::from(10).powi(29)), "99999999999999999997315645440.0");
    assert_eq!(format!("{}", Mp::<1>::from(2f64.powi(-30))), "9.313225746154785156e-10");
}

#[cfg(feature = "serde")]
mod serialised {
    use super::Mp;
    use crate::drawn::cases;
    use crate::multiple::{Recipe, same};
    use crate::recipe;
    use proptest::prelude::*;

    fn round_trip<const L: usize>(recipe: &Recipe) {
        let theirs = recipe.cook(64 * L as u32);
        let json = serde_json::to_string(&Mp::<L>::from(&theirs)).unwrap();
        assert!(json.starts_with('"') && json.ends_with('"'));
        let back: Mp<L> = serde_json::from_str(&json).unwrap();
        assert!(same(back, &theirs), "{json}");
    }

    proptest! {
        #![proptest_config(cases(256))]

        #[test]
        fn json_reads_back(x in recipe()) {
            at_widths!(round_trip(&x));
        }
    }

    #[test]
    fn only_text_is_a_number() {
        assert!(serde_json::from_str::<Mp<1>>("1.5").unwrap_err().to_string().contains("decimal number"));
        assert!(serde_json::from_str::<Mp<1>>("\"x\"").unwrap_err().to_string().contains("`x`"));
    }
}

/// Text is a number exactly where `f64` accepts it.
#[test]
fn the_grammar_is_that_of_f64() {
    let pieces = ["", "1", "-", "+", ".", "5", "e", "E", "3", " ", "_", "@", "inf", "NaN", "x", "0", "\n"];
    let mut read = 0;
    for a in pieces {
        for b in pieces {
            for c in pieces {
                for d in pieces {
                    let text = [a, b, c, d].concat();
                    let (number, double) = (text.parse::<Mp<2>>(), text.parse::<f64>());
                    assert_eq!(number.is_ok(), double.is_ok(), "{text:?}");
                    if let (Ok(number), Ok(double)) = (number, double) {
                        assert!(number.to_f64() == double || double.is_nan() && number.is_nan(), "{text:?}");
                        read += 1;
                    }
                }
            }
        }
    }
    assert!(read > 1000, "{read}");
}
