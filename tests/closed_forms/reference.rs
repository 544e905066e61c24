//! The closed forms compared with values computed independently at 90 digits, from the doubles of Ω and α.

use stickslip::{Float, Ratios, Response};

/// One row of `tests/data/points.csv`: 40 digits per value, empty where the value is infinite.
struct Point {
    omega: f64,
    alpha: f64,
    values: Vec<(String, Option<f64>)>,
}

fn points() -> Vec<Point> {
    let text = include_str!("../data/points.csv");
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    lines
        .map(|line| {
            let cells: Vec<Option<f64>> = line.split(',').map(|c| c.parse().ok()).collect();
            assert_eq!(cells.len(), names.len());
            Point {
                omega: cells[0].unwrap(),
                alpha: cells[1].unwrap(),
                values: names.iter().map(|n| (*n).to_owned()).zip(cells).skip(2).collect(),
            }
        })
        .collect()
}

/// Every output of the table, by name; the body must not stick.
pub(crate) fn outputs<F: Float>(response: &Response<F>) -> Vec<(&'static str, Option<F>)> {
    let cycle = response.cycle.as_ref().expect("every point is non-sticking");
    let border = response.border;
    vec![
        ("max_displacement", Some(cycle.max_displacement)),
        ("displacement_phase", Some(cycle.displacement_phase)),
        ("max_velocity", Some(cycle.max_velocity)),
        ("velocity_phase", Some(cycle.velocity_phase)),
        ("deviation", Some(cycle.deviation())),
        ("min_force_ratio", Some(border.min_force_ratio)),
        ("min_force_ratio_turning_point", Some(border.min_force_ratio_turning_point)),
        ("border_phase", Some(border.border_phase)),
        ("loop_size_stiffness", response.loop_size_stiffness),
        ("loop_size_inertia", response.loop_size_inertia),
        ("best_force_ratio", Some(response.best_force_ratio)),
        ("best_loop_size", response.best_loop_size),
        ("contraction", Some(cycle.contraction())),
    ]
}

#[test]
fn every_output_at_every_point_to_1e_13() {
    let points = points();
    assert_eq!(points.len(), 17);
    for Point { omega, alpha, values } in &points {
        let response = Response::new(Ratios::new(*omega, *alpha).unwrap());
        let cycle = response.cycle.unwrap();
        let loops = [cycle.loop_size_stiffness(), cycle.loop_size_inertia()].map(Some);
        assert_eq!(loops, [response.loop_size_stiffness, response.loop_size_inertia]);
        let answers = outputs(&response);
        assert_eq!(answers.len(), values.len(), "every column has its answer");
        for ((name, answer), (column, expected)) in answers.iter().zip(values) {
            assert_eq!(name, column);
            let (Some(answer), Some(expected)) = (answer, expected) else {
                assert_eq!(answer, expected, "{name} at ({omega}, {alpha})");
                continue;
            };
            let absolute = name.ends_with("phase") || *name == "deviation" || *expected == 0.0;
            let scale = if absolute { 1.0 } else { expected.abs() };
            let error = (answer - expected).abs() / scale;
            assert!(error <= 1e-13, "{name} at ({omega}, {alpha}): {answer:e} for {expected:e}, {error:e}");
        }
    }
}

#[test]
fn limits_of_the_border() {
    let border = |omega: f64| stickslip::Border::new(omega).unwrap().min_force_ratio;
    let pi = std::f64::consts::PI;
    assert!((border(1.0) - 4.0 / pi).abs() < 1e-15);
    assert!((border(1e8) - (1.0 + pi * pi / 4.0).sqrt()).abs() < 1e-14);
    // The minimum on Ω > 1/2.
    let (at, least) = (0.849_158_848_834_442, 1.209_998_436_338_07);
    assert!((border(at) - least).abs() < 1e-14);
    for step in [1e-3, 1e-5] {
        assert!(border(at - step) > border(at) && border(at + step) > border(at));
    }
}

#[test]
fn exact_border_below_one_half() {
    for (omega, exact, digits) in [
        (0.4, 6.949737755908733, 15),
        (0.45, 4.140195114985661, 15),
        (0.35, 26.1017541143, 12),
        (0.3, 11.573099220763208, 15),
        (0.22, 27.4743498163, 12),
    ] {
        let border = stickslip::Border::new(omega).unwrap();
        let error: f64 = border.min_force_ratio / exact - 1.0;
        assert!(error.abs() < 5.0 * 10f64.powi(-digits), "{omega}: {error:e}");
        assert!(border.min_force_ratio_turning_point < border.min_force_ratio);
    }
}
