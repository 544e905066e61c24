//! The precision set for a computation: the bits are those of the type that has just as many limbs.

use core::fmt::Display;
use core::str::FromStr;
use std::panic::catch_unwind;
use std::thread;
use stickslip::float::{Mp, ParseError, ThreadPrecision, WithPrecision, with_precision};
use stickslip::motion::{LongRun, State};
use stickslip::{Float, Output, Ratios, Response};

/// Ω, α, ζ, η: below, beside and above resonance, with and without stops, overdamped.
const POINTS: [[f64; 4]; 7] = [
    [0.07, 3.0, 0.0, 1.0],
    [0.31, 1.7, 0.0, 1.2],
    [1.0 + f64::EPSILON, 9.0, 0.0, 1.0],
    [0.4, 6.0, 0.15, 1.0],
    [0.12, 1.2, 0.05, 1.1],
    [1.7, 1.4, 1.5, 1.0],
    [3.0, 40.0, 0.7, 1.0],
];

/// All digits of all answers.
struct Digits;

impl WithPrecision for Digits {
    type Output = String;

    fn run<F: Float + Display>(self) -> String {
        let mut text = String::new();
        for [omega, alpha, zeta, eta] in POINTS {
            let number = |x: f64| F::from_f64(x) * (F::int(1) + F::int(7) * F::epsilon());
            let ratios = Ratios::new(number(omega), number(alpha)).unwrap();
            let ratios = ratios.with_damping_ratio(number(zeta)).unwrap();
            let ratios = ratios.with_static_friction_ratio(F::from_f64(eta)).unwrap();
            let response = Response::guarded(ratios);
            text.extend(Output::ALL.iter().filter_map(|output| Some(format!("{} ", output.of(&response)?))));
            match LongRun::from_start(ratios, State::default()) {
                Ok(LongRun::Periodic(steady)) => text += &format!("{steady:?}\n"),
                other => text += &format!("{}\n", other.is_ok()),
            }
        }
        text
    }
}

#[test]
fn a_precision_that_is_set_gives_the_bits_of_the_type() {
    assert_eq!(with_precision(128, Digits), Ok(Digits.run::<Mp<2>>()));
    assert_eq!(with_precision(200, Digits), Ok(Digits.run::<Mp<4>>()));
    assert_eq!(with_precision(1024, Digits), Ok(Digits.run::<Mp<16>>()));
}

struct Third;

impl WithPrecision for Third {
    type Output = [String; 2];

    fn run<F: Float + Display>(self) -> [String; 2] {
        let third = || F::ratio(1, 3).to_string();
        let precision = ThreadPrecision::here();
        let there = thread::scope(|scope| scope.spawn(|| precision.run(third)).join().unwrap());
        [third(), there]
    }
}

#[test]
fn another_thread_takes_the_precision() {
    for bits in [128, 256, 1024, 4096, 8192] {
        let [here, there] = with_precision(bits, Third).unwrap();
        assert_eq!(here, there);
        assert!((here.len() as f64 - f64::from(bits) * 2f64.log10()).abs() < 4.0, "{here}");
    }
}

#[test]
fn the_precision_ends_with_the_computation() {
    struct Panic;
    impl WithPrecision for Panic {
        type Output = ();
        fn run<F: Float>(self) {
            panic!("{}", F::precision());
        }
    }
    let outside = Mp::<26>::from(1.0) / Mp::from(3.0);
    assert!(catch_unwind(|| with_precision(256, Panic)).is_err());
    assert_eq!(Mp::<26>::from(1.0) / Mp::from(3.0), outside);
    assert_eq!(<Mp<26> as Float>::precision(), 64 * 26);
}

/// Each integer beside its decimal text.
struct Integers;

impl WithPrecision for Integers {
    type Output = ();

    fn run<F: Float + FromStr<Err = ParseError> + Display>(self) {
        for n in [0, 1, -1, 3, -10, 1 << 30, i32::MAX, i32::MIN] {
            let (own, read) = (F::int(n), n.to_string().parse::<F>().unwrap());
            assert_eq!(own, read, "{n}");
            assert_eq!(own.to_string(), read.to_string());
            assert_eq!(own / F::int(7), read / F::int(7));
        }
    }
}

#[test]
fn integers_are_exact() {
    for bits in [128, 256, 1024, 4096, 8192] {
        with_precision(bits, Integers).unwrap();
    }
    Integers.run::<Mp<1>>();
    Integers.run::<Mp<4>>();
}
