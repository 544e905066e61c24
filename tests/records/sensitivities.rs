//! Derivatives of the motion under a record by dual numbers, held against differences at high precision.

use crate::generator::Random;
use stickslip::float::{Dual, Field, Float, Mp};
use stickslip::motion::record::{Body, Record, RecordAnswer};
use stickslip::{Error, Excitation};

/// Mass, stiffness, damping constant, friction, static friction ratio, and the scale of the record.
type Parameters<F> = [F; 6];

fn follow<F: Float + From<f64>>(
    [mass, stiffness, damping, friction, eta, scale]: Parameters<F>,
    excitation: Excitation,
    samples: &[f64],
) -> Result<RecordAnswer<F>, Error> {
    let body = Body::new(mass, friction)?.with_stiffness(stiffness)?.with_damping(damping)?;
    let body = body.with_static_friction_ratio(eta)?;
    let samples = samples.iter().map(|&sample| F::from(sample) * scale).collect();
    body.follow(&Record::new(excitation, F::from(0.02), samples)?)
}

fn values<F: Float>(answer: &RecordAnswer<F>) -> [(&'static str, F); 12] {
    [
        ("max_displacement", answer.max_displacement),
        ("max_displacement_time", answer.max_displacement_time.unwrap_or(F::int(0))),
        ("min_displacement", answer.min_displacement),
        ("max_velocity", answer.max_velocity),
        ("max_velocity_time", answer.max_velocity_time.unwrap_or(F::int(0))),
        ("min_velocity", answer.min_velocity),
        ("max_absolute_acceleration", answer.max_absolute_acceleration),
        ("residual_displacement", answer.residual_displacement.unwrap_or(F::int(0))),
        ("path", answer.path),
        ("stick_time", answer.stick_time),
        ("friction_work", answer.friction_work),
        ("load_work", answer.load_work),
    ]
}

/// Differences over 2h = 2e-20 have an error of h² and of rounding over h, 1e-38 and 1e-56 here. The derivatives are at f64,
/// and a slide of a few degrees multiplies rounding by the inverse of its length: 1e-11 of the greatest of a quantity's
/// derivatives allows for it.
#[test]
fn derivatives_are_those_of_differences() {
    let mut random = Random(7);
    let (mut held, mut differ) = (0, 0);
    for round in 0..220 {
        let omega = 2.0 + 20.0 * random.next();
        let zeta = [0.0, 0.3 * random.next(), 1.0 + random.next()][round % 3];
        let mass = 0.5 + random.next();
        let samples: Vec<f64> = (0..80).map(|_| 2.0 * random.next() - 1.0).chain([0.0]).collect();
        let share = [0.1, 0.3, 0.6][round / 3 % 3] * (0.5 + random.next());
        let eta = 1.0 + [0.1, 0.3][round % 2] * random.next();
        let excitation = [Excitation::Force, Excitation::SurfaceAcceleration][round / 2 % 2];
        let parameters =
            [mass, mass * omega * omega, 2.0 * mass * zeta * omega, share * mass, eta, 1.0 + random.next()];
        let dual = follow(Dual::<6>::parameters(parameters), excitation, &samples).unwrap();
        let (h, wide) = (Mp::<4>::from(1e-20), parameters.map(Mp::<4>::from));
        let mut is_smooth = true;
        let mut differences = [[0.0; 6]; 12];
        for parameter in 0..6 {
            if parameters[parameter] == 0.0 {
                continue;
            }
            let at = |sign: i32| {
                let mut moved = wide;
                moved[parameter] *= Mp::int(1) + Mp::int(sign) * h;
                follow(moved, excitation, &samples).unwrap()
            };
            let (less, more) = (at(-1), at(1));
            is_smooth &= (less.slides, less.stops) == (more.slides, more.stops);
            for ((row, (_, less)), (_, more)) in differences.iter_mut().zip(values(&less)).zip(values(&more))
            {
                let slope = (more - less) / (Mp::int(2) * h * wide[parameter]);
                row[parameter] = slope.to_f64();
            }
        }
        if !is_smooth {
            // A number of stops that changes within 1e-20 is no derivative.
            differ += 1;
            continue;
        }
        held += 1;
        for ((name, value), expected) in values(&dual).into_iter().zip(differences) {
            let found = value.derivatives();
            let size: f64 = expected
                .iter()
                .zip(parameters)
                .map(|(slope, parameter)| (slope * parameter).abs())
                .fold(value.value().abs(), f64::max);
            for ((found, expected), parameter) in found.iter().zip(expected).zip(parameters) {
                if parameter != 0.0 && *found != expected {
                    let error = ((found - expected) * parameter).abs() / size;
                    assert!(error < 1e-11, "{round} {name}: {found} against {expected}, {error:e}");
                }
            }
        }
    }
    assert!(held >= 200 && differ == 0, "{held} {differ}");
}
