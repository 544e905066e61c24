//! Balls are compared with the same functions at eight times the bits, and with those of Arb.

mod random;

use super::faults::{self, Fault};
use super::{Ball, Radius};
use crate::float::mp::Mp;
use crate::float::{Field, Real};
use random::{Narrow, Random, Wide};

/// Whether the ball contains the exact value, to the digits of that value.
fn holds(ball: &Narrow, exact: Wide) -> bool {
    ball.is_entire() || {
        let slack = exact.abs().scale2(-400) + Wide::of_int(1).scale2(-2000);
        (exact - Wide::rounded(ball.mid())).abs() <= ball.rad().value::<8>() + slack
    }
}

/// `cosh √x` and `sinh √x/√x` by exponentials, and below 0 by the circular functions.
fn hyperbolic(x: Wide) -> [Wide; 2] {
    let root = x.abs().sqrt();
    let (up, down) = (root.exp(), (-root).exp());
    if x.is_zero() {
        [Wide::of_int(1); 2]
    } else if x < Wide::ZERO {
        [root.cos(), root.sin() / root]
    } else {
        [(up + down).scale2(-1), (up - down).scale2(-1) / root]
    }
}

type Unary = (&'static str, fn(Narrow) -> Narrow, fn(Wide) -> Wide);
type Binary = (&'static str, fn(Narrow, Narrow) -> Narrow, fn(Wide, Wide) -> Wide);

const UNARY: [Unary; 13] = [
    ("sqrt", Field::sqrt, Mp::sqrt),
    ("abs", Field::abs, Mp::abs),
    ("square", Field::square, Mp::square),
    ("sin", Real::sin, Mp::sin),
    ("cos", Real::cos, Mp::cos),
    ("sin of both", |x| x.sin_cos().0, Mp::sin),
    ("cos of both", |x| x.sin_cos().1, Mp::cos),
    ("tan", Real::tan, Mp::tan),
    ("exp", Ball::exp, Mp::exp),
    ("cosh of the root", |x| x.hyperbolic()[0], |x| hyperbolic(x)[0]),
    ("sinh of the root by it", |x| x.hyperbolic()[1], |x| hyperbolic(x)[1]),
    ("wider", |x| x.at_width::<3>().at_width(), |x| x),
    ("times 3", |x| x.times(3), |x| x * Mp::of_int(3)),
];

const BINARY: [Binary; 9] = [
    ("add", |x, y| x + y, |x, y| x + y),
    ("sub", |x, y| x - y, |x, y| x - y),
    ("mul", |x, y| x * y, |x, y| x * y),
    ("div", |x, y| x / y, |x, y| x / y),
    ("hypot", Field::hypot, Mp::hypot),
    ("leg", Field::leg, |x, y| ((x - y) * (x + y)).sqrt()),
    ("atan2", Real::atan2, Mp::atan2),
    ("larger", |x, y| x.larger(&y), |x, y| if x > y { x } else { y }),
    ("hull", |x, y| x.hull(&y), |x, _| x),
];

/// The first function whose value lies outside its ball, among `cases` random balls.
fn escaped(seed: u64, cases: usize) -> Option<String> {
    let mut random = Random(seed);
    for _ in 0..cases {
        let (x, y, z) = (random.ball(), random.ball(), random.ball());
        let points = [random.points(&x), random.points(&y), random.points(&z)];
        for (name, ball, exact) in UNARY {
            let enclosure = ball(x);
            // Where a value does not exist (√ of a negative number), the ball is the whole line.
            if let Some(at) = points[0].iter().find(|&&x| !holds(&enclosure, exact(x))) {
                return Some(format!("{name} at {at} of {x:?}: {enclosure:?}"));
            }
        }
        for (name, ball, exact) in BINARY {
            let enclosure = ball(x, y);
            let pairs = points[0].iter().flat_map(|x| points[1].iter().map(move |y| (*x, *y)));
            for (a, b) in pairs {
                if !holds(&enclosure, exact(a, b)) {
                    return Some(format!("{name} at {a} {b} of {x:?} {y:?}: {enclosure:?}"));
                }
            }
        }
        let fused = x.mul_add(y, z);
        let exact = |i: usize, j: usize, k: usize| points[0][i].mul_add(points[1][j], points[2][k]);
        if (0..125).any(|i| !holds(&fused, exact(i % 5, i / 5 % 5, i / 25))) {
            return Some(format!("mul_add of {x:?} {y:?} {z:?}: {fused:?}"));
        }
    }
    fn pi_is_in_its_ball<const LIMBS: usize>() -> bool {
        let pi = Ball::<LIMBS>::pi();
        (Mp::<24>::pi() - Mp::rounded(pi.mid())).abs() <= pi.rad().value()
    }
    let of_pi = pi_is_in_its_ball::<1>() && pi_is_in_its_ball::<4>();
    // These are widths at which π is nearly half a unit from its midpoint.
    let of_pi = of_pi && pi_is_in_its_ball::<15>() && pi_is_in_its_ball::<17>();
    (!of_pi).then(|| "pi".to_owned())
}

#[test]
fn every_value_is_in_its_ball() {
    assert_eq!(escaped(1, 10_000), None);
}

/// Leaving out or halving any part of any error bound lets a value escape.
#[test]
fn every_part_of_every_bound_is_needed() {
    let run = || escaped(2, 1000);
    let parts = faults::parts_of(|| assert_eq!(run(), None));
    let mutants: Vec<_> =
        parts.iter().flat_map(|&part| [(part, Fault::LeftOut), (part, Fault::Halved)]).collect();
    assert!(mutants.len() >= 50, "{}", mutants.len());
    let unnoticed: Vec<_> =
        mutants.iter().filter(|&&(part, fault)| faults::with_fault(part, fault, run).is_none()).collect();
    assert!(unnoticed.is_empty(), "of {}: {unnoticed:?}", mutants.len());
}

#[test]
fn where_there_is_no_ball_it_is_the_whole_line() {
    let about = |x: f64, r: f64| Narrow::between(Mp::of_f64(x - r), Mp::of_f64(x + r));
    let one = Narrow::int(1);
    assert!((one / about(0.0, 1e-9)).is_entire() && (one / Narrow::int(0)).is_entire());
    assert!((one / about(0.5, 0.5)).is_entire() && !(one / about(0.5, 0.49)).is_entire());
    assert!(about(0.0, 1e-9).sqrt().is_entire() && Narrow::int(-1).sqrt().is_entire());
    assert!(!about(0.5, 0.5).sqrt().is_entire() && Narrow::int(0).sqrt().rad().is_zero());
    let quarter = Narrow::pi() / Narrow::int(2);
    assert!(
        quarter.tan().is_entire() && about(1.5, 0.1).tan().is_entire() && !about(1.4, 0.1).tan().is_entire()
    );
    assert!(about(0.0, 4.0).tan().is_entire());
    // Operations on the whole line give the whole line.
    let all = Narrow::entire();
    for ball in [
        all + one,
        all * Narrow::int(0),
        one / all,
        all.sqrt(),
        all.tan(),
        all.square(),
        all.mul_add(one, one),
    ] {
        assert!(ball.is_entire());
    }
    // Sine, cosine and angle have bounded ranges.
    assert_eq!((all.sin().upper(), all.cos().lower()), (Mp::of_int(1), Mp::of_int(-1)));
    let angle = all.atan2(one);
    assert!(angle.contains(Mp::pi().scale2(-1)) && !angle.is_entire());
    // The angle near the cut, and on it.
    assert!(about(0.0, 1e-9).atan2(-one).contains(-Mp::of_int(3)));
    assert!(Narrow::int(0).atan2(-one).contains(Mp::pi()) && Narrow::int(0).atan2(-one).is_positive());
    assert!(!about(0.0, 1e-9).atan2(one).contains(Mp::of_f64(1e-3)));
    let huge = Narrow::exact(Mp::largest());
    assert!((huge + huge).is_entire() && (huge * huge).is_entire());
    // An underflow does not count as zero.
    let tiny = one / huge;
    assert!((tiny * tiny).contains_zero() && (tiny * tiny).sign().is_none());
}

#[test]
fn decisions_are_made_where_they_are_certain() {
    use core::cmp::Ordering::{Equal, Greater, Less};
    let about = |x: f64, r: f64| Narrow::between(Mp::of_f64(x - r), Mp::of_f64(x + r));
    assert_eq!(about(1.0, 0.5).sign(), Some(Greater));
    assert_eq!(about(-1.0, 0.5).sign(), Some(Less));
    assert_eq!(about(1.0, 1.0).sign(), None);
    assert_eq!(Narrow::int(0).sign(), Some(Equal));
    assert!(about(1.0, 0.25).is_below(&about(2.0, 0.5)) && !about(1.0, 0.5).is_below(&about(2.0, 0.5)));
    assert!(about(1.0, 0.25).is_inside(&about(1.0, 0.5)) && !about(1.0, 0.5).is_inside(&about(1.0, 0.5)));
    let common = about(1.0, 0.5).intersection(&about(1.75, 0.5)).unwrap();
    assert_eq!((common.lower(), common.upper()), (Mp::of_f64(1.25), Mp::of_f64(1.5)));
    assert!(about(1.0, 0.25).intersection(&about(2.0, 0.25)).is_none());
}

/// Balls of Arb at the same bits (`tests/data/balls.py`): the balls overlap, and ours are not much wider.
#[test]
fn as_arb_has_them() {
    fn ball(mid: &str, rad: &str) -> Ball<2> {
        let number = |text: &str| Mp::<2>::from_rational(&text.parse().unwrap());
        Ball::new(number(mid), Radius::above(number(rad)))
    }
    let data = include_str!("../../../tests/data/balls.csv");
    let mut compared = 0;
    for line in data.lines().skip(1) {
        let fields: Vec<&str> = line.split(',').collect();
        let [name, xm, xr, ym, yr, mid, rad] = fields[..] else { panic!("{line}") };
        let (x, y) = (ball(xm, xr), ball(ym, yr));
        let found = match name {
            "add" => x + y,
            "sub" => x - y,
            "mul" => x * y,
            "div" => x / y,
            "sqrt" => x.sqrt(),
            "sin" => x.sin_cos().0,
            "cos" => x.sin_cos().1,
            "tan" => x.tan(),
            "atan2" => x.atan2(y),
            "exp" => x.exp(),
            _ => panic!("{name}"),
        };
        if mid == "nan" {
            assert!(found.is_entire(), "{line}: {found}");
            continue;
        }
        let theirs = ball(mid, rad);
        // Arb has tighter results for balls as large as a full turn.
        if found.is_entire() && x.rad() > Radius::power_of_two(-2) {
            continue;
        }
        assert!(!found.is_entire() && found.intersection(&theirs).is_some(), "{line}: {found} {theirs}");
        if x.rad().max(y.rad()) > Radius::power_of_two(-20) {
            continue;
        }
        let allowed = theirs.rad().scaled(2).plus(super::half_unit(theirs.mid()).scaled(1));
        assert!(found.rad() <= allowed, "{line}: {found} {theirs}");
        compared += 1;
    }
    assert!(compared > 200, "{compared}");
}

#[test]
fn bounds_are_rounded_in_their_direction() {
    let mut random = Random(3);
    for _ in 0..200_000 {
        let mut bound =
            || Radius::above(Mp::<1>::from(random.bits() >> 32 | 1)).scaled(random.below(70) as i64 - 35);
        let (a, b) = (bound(), bound());
        let (x, y): (Wide, Wide) = (a.value(), b.value());
        // The result is within 2⁻³⁰ of the exact one, and on the right side of it.
        let above = |r: Radius, exact: Wide| {
            let r = r.value::<8>();
            assert!(
                r >= exact && r <= exact * (Wide::of_int(1) + Wide::of_int(1).scale2(-30)),
                "{r} {exact}"
            );
        };
        above(a.plus(b), x + y);
        above(a.times(b), x * y);
        let quotient = a.over(b).value::<8>();
        assert!(quotient * y >= x && quotient * y <= x * (Wide::of_int(1) + Wide::of_int(1).scale2(-30)));
        let product = a.times_down(b).value::<8>();
        assert!(product <= x * y && product >= x * y * (Wide::of_int(1) - Wide::of_int(1).scale2(-30)));
        let difference = a.minus_down(b).value::<8>();
        let exact = if x > y { x - y } else { Wide::ZERO };
        assert!(difference <= exact && difference >= exact - x.scale2(-30), "{x} {y} {difference}");
        assert_eq!(a < b, x < y);
    }
    let ball = Mp::<3>::from(1.0) / Mp::of_int(3);
    let (low, high) = (Radius::below(ball).value::<3>(), Radius::above(ball).value::<3>());
    assert!(low < ball && ball < high && high - low < Mp::of_f64(1e-9));
    assert!(Radius::ONE.over(Radius::ZERO).is_infinite() && Radius::above(Mp::<2>::NAN).is_infinite());
    assert!(
        Radius::INFINITE.times(Radius::ZERO).is_zero() && Radius::INFINITE.plus(Radius::ONE).is_infinite()
    );
}

#[test]
fn an_identity_and_a_divisor_that_may_be_zero() {
    let third = Ball::<4>::int(1) / Ball::int(3);
    let one = (third * Real::pi()).sin().square() + (third * Real::pi()).cos().square();
    assert!(one.contains(Mp::of_int(1)) && one.upper() - one.lower() < Mp::of_f64(1e-70));
    assert!((Ball::<4>::int(1) / (one - one)).is_entire());
}
