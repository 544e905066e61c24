//! The border's minima and slope, the verdict and the inverse problems at any precision.

use stickslip::design::{bands, force_ratio_for_velocity, most_dissipating_frequency_ratio};
use stickslip::float::Mp;
use stickslip::{Border, Cycle, Field, Float, PhaseFunction, Ratios, Regime, Verdict};

type Wide = Mp<4>;

/// Whether a value agrees to within `ulps` units in the last place of 256 bits; the reference has 62 digits.
fn close(found: Wide, exact: &str, ulps: i32) {
    let exact: Wide = exact.parse().unwrap();
    let slack = Wide::int(ulps) * Wide::epsilon() + "1e-61".parse::<Wide>().unwrap();
    assert!((found - exact).abs() <= slack * exact.abs(), "{found} against {exact}");
}

#[test]
fn minima_and_ends_of_bands_at_sixty_digits() {
    for (n, omega, force_ratio) in [
        (
            0,
            "0.84915884883444218073510220327737299959398767316530654350688503",
            "1.2099984363380715852113688422181844785902331830623401401976352",
        ),
        (
            1,
            "0.29712866086765242727575565936164298241412258342474248358340976",
            "11.364104719970087413691022496028596886867839144839484785891083",
        ),
        (
            2,
            "0.18682822550613929643341650271261484303448842626423792520790728",
            "28.884281620560037361262290663638121371053318092099890601900626",
        ),
        (
            9,
            "0.05165216271353845337093011691442501056646098765661247157153278",
            "375.05398526049162781299751300348352006393392386424868658221894",
        ),
    ] {
        let found = Border::<Wide>::minimum(n);
        close(found.omega, omega, 16);
        close(found.force_ratio, force_ratio, 16);
    }
    for (n, low) in [
        (1, "0.29950514756796729766552903784204280048943109441830291134596019"),
        (2, "0.18682822550613929643341650271261484303448842626423792520790728"),
        (9, "0.05165216271353845337093011691442501056646098765661247157153278"),
    ] {
        close(Border::<Wide>::shortfall(n).unwrap().low, low, 16);
    }
}

#[test]
fn what_f64_leaves_open_a_wider_type_decides() {
    for omega in [0.052, 0.22, 0.3, 0.333, 0.4, 0.7, 0.999, 1.5, 20.0] {
        let border: f64 = Border::new(omega).unwrap().min_force_ratio;
        for alpha in [border, border.next_up(), border.next_down()] {
            let verdict = Verdict::new(Ratios::new(omega, alpha).unwrap());
            assert_eq!(verdict, Verdict::Undecided(Regime::Sticking, Regime::NonSticking));
            let wide = Verdict::new(Ratios::new(Wide::from(omega), Wide::from(alpha)).unwrap());
            let least = Border::new(Mp::<8>::from(omega)).unwrap().min_force_ratio;
            let slides = Mp::<8>::from(alpha) >= least;
            assert_eq!(wide.regime() == Some(Regime::NonSticking), slides, "{omega} {alpha}");
            assert!(wide.regime().is_some());
        }
    }
}

/// At 512 bits, eighth-order differences with a step of 2⁻⁴⁰ are accurate to 60 digits.
#[test]
fn the_slope_against_differences_at_512_bits() {
    let real = |p, q| Mp::<8>::ratio(p, q);
    let h = Mp::<8>::exp2i(-40);
    let border = |omega: Mp<8>| Border::new(omega).unwrap().min_force_ratio;
    for omega in
        [0.07, 0.13, 0.21, 0.24, 0.26, 0.2994, 0.31, 0.35, 0.45, 0.499, 0.51, 0.7, 0.85, 1.0, 1.4, 2.5, 50.0]
    {
        let omega = Mp::<8>::from(omega);
        let pair = |n: i32| border(omega + Mp::int(n) * h) - border(omega - Mp::int(n) * h);
        let difference = (real(4, 5) * pair(1) - real(1, 5) * pair(2) + real(4, 105) * pair(3)
            - real(1, 280) * pair(4))
            / h;
        let slope = Border::slope(&PhaseFunction::new(omega).unwrap());
        let error = ((slope - difference) / difference).abs().to_f64();
        assert!(error < 1e-60, "{omega}: {error:e}");
        let at_f64 = Border::slope(&PhaseFunction::new(omega.to_f64()).unwrap());
        // Near a minimum the error is absolute.
        let error = ((Mp::<8>::from(at_f64) - slope) / (slope.abs() + Mp::int(1))).abs().to_f64();
        assert!(error < 5e-15, "{omega}: {error:e} at f64");
    }
}

#[test]
fn the_inverse_questions_at_256_bits() {
    let number = |text: &str| text.parse::<Wide>().unwrap();
    let alpha = number("12");
    let found: Vec<_> =
        bands(alpha, number("0"), number("0.1")..=number("2")).unwrap().map(Result::unwrap).collect();
    assert_eq!(found.len(), 2);
    for end in [found[0].low, found[0].high, found[1].low] {
        let border = Border::new(end).unwrap().min_force_ratio;
        let slack = Wide::epsilon() * Wide::int(1000);
        assert!(border <= alpha && border > alpha * (Wide::int(1) - slack), "{end}: {border}");
    }
    for (omega, force) in [("0.3", "20"), ("0.4", "9"), ("0.7", "2"), ("1.5", "2.5")] {
        let (omega, force) = (number(omega), number(force));
        let speed = Cycle::new(Ratios::new(omega, force).unwrap()).unwrap().max_velocity;
        let again = force_ratio_for_velocity(omega, number("0"), speed).unwrap();
        assert!(((again - force) / force).abs() < Wide::epsilon() * Wide::int(64), "{omega}: {again}");
    }
    let best = most_dissipating_frequency_ratio(number("1.25"), number("0.1")..=number("9")).unwrap();
    assert!((best.at.to_f64() / 0.934_679_833_045_693_5 - 1.0).abs() < 1e-15);
}
