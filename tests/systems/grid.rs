//! Grids on all cores.

use crate::cases::{cases, list};
use crate::closed_form::one_body;
use crate::compared::{Origin::AnotherProgram, compared};
use stickslip::system::{Error, State, System, solve_each};

/// The steady motions of another program, all at once: their greatest displacements and velocities.
#[test]
fn all_at_once_have_the_answers_of_others() {
    let cases: Vec<_> = cases().into_iter().filter(|case| case.run["kind"] == "steady").collect();
    let models: Vec<_> = cases.iter().map(|case| case.model.clone()).collect();
    let found = solve_each(&models, |system| system.steady(&State::rest(system.coordinates())));
    assert_eq!(found.len(), 33);
    for (case, found) in cases.iter().zip(found) {
        let motion = found.expect(&case.name).motion;
        let due = list(&case.answer["max"]);
        let size = due.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        for (ours, other) in motion.max_displacement.iter().chain(&motion.max_velocity).zip(due) {
            compared("fn system::solve_each", *ours, other, AnotherProgram, 1e-8 * size);
        }
    }
}

/// The answers of one core, in their order; a bad model has its error, and its neighbours have their answers.
#[test]
fn all_cores_have_the_answers_of_one() {
    let mut models: Vec<_> = (1..40).map(|i| one_body(0.1 * f64::from(i), 2.0, 0.05, 1.2)).collect();
    models[7].mass[0][0] = -1.0;
    let found = solve_each(&models, |system| system.steady(&State::rest(1)));
    assert_eq!(found.len(), models.len());
    for (i, (model, found)) in models.iter().zip(&found).enumerate() {
        let alone = System::new(model).and_then(|s| s.steady(&State::rest(1)));
        assert_eq!(&alone, found, "{i}");
        assert_eq!(matches!(found, Err(Error::NotDefinite { .. })), i == 7, "{i}: {found:?}");
    }
}
