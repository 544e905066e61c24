use super::Output;
use crate::{Ratios, Response, Scales};

#[test]
fn each_is_read_by_its_name() {
    for output in Output::ALL {
        assert_eq!(output.to_string().parse(), Ok(output));
    }
    let error = "velocity".parse::<Output>().unwrap_err();
    assert_eq!(
        error.to_string(),
        "output `velocity` must be one of Output::ALL by its name, such as max_displacement"
    );
}

/// Each unit must have the dimension written out here by hand; no two dimensions share a scale.
#[test]
fn each_has_the_unit_of_its_dimension() {
    let scales = Scales::<f64> {
        length: 3.0,
        velocity: 5.0,
        time: 7.0,
        force: 11.0,
        energy_stiffness: 13.0,
        energy_inertia: 17.0,
        mean_displacement: 19.0,
        mean_friction: 23.0,
    };
    let expected = [
        ("max_displacement", 3.0),
        ("displacement_phase", 7.0),
        ("max_velocity", 5.0),
        ("velocity_phase", 7.0),
        ("deviation", 3.0),
        ("loop_size_stiffness", 13.0),
        ("loop_size_inertia", 17.0),
        ("contraction", 1.0),
        ("margin", 1.0),
        ("min_force_ratio", 11.0),
        ("min_force_ratio_turning_point", 11.0),
        ("least_displacement", 3.0),
        ("border_phase", 7.0),
        ("best_force_ratio", 11.0),
        ("best_loop_size", 13.0),
        ("dynamic_amplification", 1.0),
        ("max_acceleration", 5.0 / 7.0),
        ("transmitted_force", 11.0),
        ("transmissibility", 1.0),
        ("max_absolute_displacement", 3.0),
    ];
    assert_eq!(Output::ALL.map(|output| (output.name(), output.unit(&scales))), expected);
}

/// The margin uses the exact border, which exceeds eq. 61 at Ω = 0.4.
#[test]
fn the_margin_is_that_of_the_exact_border() {
    let response = Response::new(Ratios::new(0.4, 6.5).unwrap());
    let margin: f64 = Output::Margin.of(&response).unwrap();
    assert!((margin - 6.5 / 6.949_737_755_908_733).abs() < 1e-15, "{margin}");
}

#[test]
fn each_has_a_name_of_its_own() {
    let mut names = Output::ALL.map(Output::name);
    assert!(names.iter().all(|name| name.chars().all(|c| c.is_ascii_lowercase() || c == '_')));
    assert_eq!(
        (names[0], names[5], names[9]),
        ("max_displacement", "loop_size_stiffness", "min_force_ratio")
    );
    names.sort_unstable();
    assert!(names.windows(2).all(|pair| pair[0] != pair[1]), "{names:?}");
}
