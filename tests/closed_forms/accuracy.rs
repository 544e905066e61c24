//! Every output at f64 and at f32 is within its allowance in the table of ulp bounds (`tests/ulps`), compared
//! with 128 bits and with f64.

use crate::ulps::damped::{self, Worst};
use crate::ulps::points::{ALPHAS, OMEGAS, Random};
use crate::ulps::reference::{Narrow, answers, difference_in_ulp, errors, widened};
use crate::ulps::worst::{Survey, hex};
use crate::ulps::{COUNT, OUTPUTS};
use stickslip::{Border, Float, Ratios};

fn no_error_exceeds_its_allowance_and_no_allowance_is_stale<F: Narrow>() {
    let survey = Survey::of::<F>(20, 200).merge(&Survey::of::<F>(21, 200));
    assert!(survey.points > 20_000);
    for (output, worst) in OUTPUTS.iter().zip(survey.worst) {
        let (omega, alpha) = (OMEGAS[worst.measures.0], ALPHAS[worst.measures.1]);
        let place = format!("at Ω = {} ({omega}), α = {} ({alpha})", hex(worst.omega), hex(worst.alpha));
        assert!(worst.error <= output.allowed, "{}: {} ulp {place}", output.symbol, worst.error);
        // Some points must come within a third of the allowance; otherwise the allowance is too generous.
        assert!(
            output.allowed.is_infinite() || worst.error * 3.0 >= output.allowed,
            "{}: {} ulp at worst",
            output.name,
            worst.error
        );
    }
}

#[test]
fn double_precision() {
    no_error_exceeds_its_allowance_and_no_allowance_is_stale::<f64>();
}

#[test]
fn single_precision() {
    no_error_exceeds_its_allowance_and_no_allowance_is_stale::<f32>();
}

/// The greatest error at any point of harness or test, in ulp per 1 + κ. It is infinite where half of the digits can
/// be lost: at the flat maximum that τ* is the place of just below Ω = 1/2, and at the contraction's double root.
const ALLOWED: [f64; damped::DAMPED] =
    [0.5, 1.5, 2.0, 4.0, 4.5, 2.0, 1.0, f64::INFINITY, 1.0, 1.0, 1.0, 1.0, f64::INFINITY];

/// With a damper and static friction: every output per condition number.
#[test]
fn double_precision_with_a_damper() {
    let survey = damped::Survey::of(22, 6).merge(&damped::Survey::of(23, 6));
    assert!(survey.points > 2000);
    for ((output, [_, worst]), allowed) in OUTPUTS.iter().zip(survey.worst).zip(ALLOWED) {
        let Worst { error, ratios } = worst;
        assert!(error <= allowed, "{}: {error} ulp per condition number at {ratios:?}", output.symbol);
        // Some points must come within a fifth of the allowance; otherwise the allowance is too generous.
        assert!(allowed.is_infinite() || error * 5.0 >= allowed, "{}: {error} at worst", output.name);
    }
}

/// ω_d t₁ and Δ₁ by the text without a damper, and by that with one at ζ = 10⁻³⁰, beside one number of 128 bits: both are
/// within the goals of their units, so that neither is off. They are many units of their own apart where t₁ is small and
/// Δ₁ is beside its zero.
#[test]
fn the_time_of_the_peak_velocity_is_as_accurate_by_both_texts() {
    let mut random = Random(29);
    let mut apart = [0.0_f64; 2];
    for (low, high) in [(0.01, 0.2), (0.2, 0.5), (0.5, 2.0)] {
        let (mut worst, mut compared) = ([[0.0_f64; 2]; 2], 0);
        for _ in 0..400 {
            let (omega, over) = (random.between(low, high), random.between(1.0001, 8.0));
            let least: f64 = Border::new(omega).unwrap().min_force_ratio;
            let undamped = Ratios::new(omega, least * over).unwrap();
            let exact = answers(widened(&undamped).unwrap()).unwrap();
            let both = [undamped, undamped.with_damping_ratio(1e-30).unwrap()].map(|r| answers(r).unwrap());
            let speed = exact[2].unwrap();
            // Of two maxima that are equal up to rounding either may be found.
            let is_same =
                |found: &[Option<f64>; COUNT]| (found[3].unwrap() - exact[3].unwrap().to_f64()).abs() < 0.01;
            if !both.iter().all(is_same) {
                continue;
            }
            compared += 1;
            for (i, output) in [3, 4].into_iter().enumerate() {
                let (right, values) = (exact[output].unwrap(), both.map(|found| found[output].unwrap()));
                for (worst, value) in worst.iter_mut().zip(values) {
                    let wide = value.widened();
                    let off = difference_in_ulp::<f64>(OUTPUTS[output].unit, wide, right, speed);
                    worst[i] = worst[i].max(off);
                }
                let [one, other] = values;
                apart[i] = apart[i].max((one - other).abs() / (f64::EPSILON / 2.0 * one.abs()));
            }
        }
        assert!(compared > 350, "{compared}");
        for (text, [time, place]) in ["without a damper", "with one"].into_iter().zip(worst) {
            assert!(time <= 4.0 && place <= 4.0, "{text}, Ω from {low} to {high}: {time} {place} ulp");
        }
    }
    assert!(apart.iter().all(|apart| *apart > 20.0), "{apart:?}");
}

/// The worst two of ten million points before cos Ωψ − 1 replaced cos Ωψ, and a pair replaced sin β: 4.71 ulp
/// of V₀ and 4.25 of Δ₁.
#[test]
fn the_worst_of_ten_million_points_are_within_the_goals() {
    for (output, omega, alpha) in
        [(2, "0x1.248aba3de6d67p4", "0x1.dc1afce1937f4p0"), (4, "0x1.e4f5ac579a965p0", "0x1.a830de92b37a5p0")]
    {
        let error = errors::<f64>(of_hex(omega), of_hex(alpha)).unwrap()[output];
        assert!(error <= 3.0, "{}: {error} ulp at Ω = {omega}, α = {alpha}", OUTPUTS[output].symbol);
    }
}

/// The worst of ten million points with a damper while they were computed in the type's own arithmetic, in ulp per
/// condition number: ω_d t₁ had 817 and 4.2, Δ₁ 1134 and 25, α_min 6.0, and the contraction 25 and 39.
#[test]
fn the_worst_with_a_damper_are_within_the_goals() {
    for (output, allowed, [omega, alpha, zeta, eta]) in [
        (3, 4.0, ["0x1.a0c35b92ecdf3p-10", "0x1.1b256167153bep43", "0x1.bd058a8ab57c5p-26", "0x1p0"]),
        (3, 4.0, ["0x1.9999999999996p-3", "0x1.8cd9a23a5621bp5", "0x1.d2b415c162bfcp-3", "0x1p0"]),
        (
            4,
            4.0,
            ["0x1.c71c71c71c724p-4", "0x1.60f2ef455742ap30", "0x1.27a5d6434d7adp-25", "0x1.00a13b2c25449p0"],
        ),
        (
            4,
            4.0,
            ["0x1.57f6d5b22aaddp3", "0x1.0033d3c9b15ebp1", "0x1.c12fd80286de7p-1", "0x1.0000000000055p0"],
        ),
        (5, 2.0, ["0x1.1111110fff84ep-7", "0x1.c1f8004d75263p13", "0x1.c906b9c76145p-35", "0x1p0"]),
        (12, 8.0, ["0x1.4afd6a052bf5bp-8", "0x1.32483573d9809p16", "0x1.7c771b74c1f01p-1", "0x1p0"]),
        (12, 8.0, ["0x1.920fb49d0e229p-8", "0x1.7eb2154b0d79cp17", "0x1.91968f54a5f7ep-1", "0x1p0"]),
    ] {
        let ratios = Ratios::new(of_hex(omega), of_hex(alpha)).unwrap();
        let ratios = ratios.with_damping_ratio(of_hex(zeta)).unwrap();
        let [_, error] =
            damped::errors(ratios.with_static_friction_ratio(of_hex(eta)).unwrap()).unwrap()[output];
        assert!(
            error <= allowed,
            "{}: {error} ulp per condition number at {ratios:?}",
            OUTPUTS[output].symbol
        );
    }
}

#[test]
fn the_allowances_meet_the_goals() {
    for output in OUTPUTS {
        assert!(output.goal.is_none_or(|goal| output.allowed <= goal), "{}", output.name);
    }
}

/// Reads a hexadecimal float such as `0x1.8p-3`.
fn of_hex(text: &str) -> f64 {
    let (digits, exponent) = text.strip_prefix("0x1").unwrap().split_once('p').unwrap();
    let digits = digits.trim_start_matches('.');
    let fraction = u64::from_str_radix(&format!("{digits:0<13}"), 16).unwrap();
    f64::from_bits(fraction | (1023 << 52)) * 2f64.powi(exponent.parse().unwrap())
}

/// The errors in `docs/development/accuracy.md` are those at the points that it names.
#[test]
fn the_page_has_the_errors_at_its_points() {
    let page = include_str!("../../docs/development/accuracy.md");
    let (page, damped_rows) = page.split_once("<!-- damped -->").unwrap();
    let (f64_rows, f32_rows) = page.split_once("\nf32, ").unwrap();
    let mut compared = 0;
    let mut check = |rows: &str, errors_at: &dyn Fn(f64, f64) -> f64, output: usize| {
        let name = format!("`{}`", OUTPUTS[output].name);
        let row = rows.lines().find(|line| line.contains(&name)).unwrap_or_else(|| panic!("{name}"));
        let cells: Vec<&str> =
            row.trim_matches('|').split('|').map(|cell| cell.trim().trim_matches('`')).collect();
        let (printed, omega, alpha) = (cells[2].parse::<f64>().unwrap(), of_hex(cells[3]), of_hex(cells[4]));
        let found = errors_at(omega, alpha);
        // To the number of digits printed.
        let last = if printed < 1e4 { 0.005_001 } else { 0.06 * printed };
        assert!(
            (found - printed).abs() <= last,
            "{row}: now {found} ulp; `cargo bench --features mp --bench accuracy -- 10000000 1 --write` \
             renews the page"
        );
        compared += 1;
    };
    for output in 0..OUTPUTS.len() {
        check(f64_rows, &|omega, alpha| errors::<f64>(omega, alpha).unwrap()[output], output);
        check(f32_rows, &|omega, alpha| errors::<f32>(omega as f32, alpha as f32).unwrap()[output], output);
    }
    assert_eq!(compared, 2 * OUTPUTS.len());
    for (i, output) in OUTPUTS.iter().enumerate().take(damped::DAMPED) {
        let name = format!("`{}`", output.name);
        let row = damped_rows.lines().find(|line| line.contains(&name)).unwrap_or_else(|| panic!("{name}"));
        let cells: Vec<&str> =
            row.trim_matches('|').split('|').map(|cell| cell.trim().trim_matches('`')).collect();
        let [omega, alpha, zeta, eta] = [3, 4, 5, 6].map(|i| of_hex(cells[i]));
        let ratios = Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
        let [_, found] = damped::errors(ratios.with_static_friction_ratio(eta).unwrap()).unwrap()[i];
        let printed: f64 = cells[2].parse().unwrap();
        let last = if printed < 1e4 { 0.005_001 } else { 0.06 * printed };
        assert!(
            (found - printed).abs() <= last,
            "{row}: now {found} ulp; `--damped --write` renews the page"
        );
    }
}
