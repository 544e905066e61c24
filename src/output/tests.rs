use super::{Measure, Output, definitions};
use crate::output::Kind;
use crate::{Excitation, Ratios, Response, Scales};

#[test]
fn each_is_read_by_its_name() {
    for output in Output::ALL {
        assert_eq!(output.to_string().parse(), Ok(output));
    }
    let error = "velocity".parse::<Output>().unwrap_err();
    let names = Output::ALL.map(|output| output.to_string()).join(", ");
    assert_eq!(error.to_string(), format!("name = velocity must be one of {names}"));
}

/// Other names are read as they are displayed.
#[test]
fn each_regime_end_and_aim_is_read_by_its_name() {
    use crate::design::Aim;
    use crate::motion::{End, Kind};
    use crate::{Excitation, Regime};
    assert_eq!("depends-on-start".parse(), Ok(Regime::DependsOnStart));
    assert_eq!(Excitation::Force.to_string().parse(), Ok(Excitation::Force));
    assert!(Aim::ALL.into_iter().all(|aim| aim.to_string().parse() == Ok(aim)));
    assert_eq!((End::Grazing.to_string(), "grazing".parse()), ("grazing".into(), Ok(End::Grazing)));
    assert_eq!("slide-backward".parse(), Ok(Kind::SlideBackward));
    let error = "sliding".parse::<Kind>().unwrap_err();
    assert_eq!(error.to_string(), "name = sliding must be one of slide-forward, slide-backward, stick");
}

/// A unit in ratios and its physical size agree: 3 m, 5 m/s, 7 s, 11 N; no two dimensions share a scale.
#[test]
fn each_measure_has_the_size_of_its_unit() {
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
    for (measure, unit, kind, size) in [
        (Measure::Plain, "", Kind::Ratio, 1.0),
        (Measure::One, "1", Kind::Ratio, 1.0),
        (Measure::Angle, "rad", Kind::Time, 7.0),
        (Measure::Turns, "2π/ω_d", Kind::Time, 14.0 * std::f64::consts::PI),
        (Measure::Length, "B", Kind::Length, 3.0),
        (Measure::Velocity, "B ω_d", Kind::Velocity, 5.0),
        (Measure::Acceleration, "B ω_d²", Kind::Acceleration, 5.0 / 7.0),
        (Measure::Force, "r_y", Kind::Force, 11.0),
        (Measure::ForceRatio, "1", Kind::Force, 11.0),
        (Measure::Work, "r_y B", Kind::Energy, 33.0),
        (Measure::EnergyStiffness, "1", Kind::Energy, 13.0),
        (Measure::EnergyInertia, "1", Kind::Energy, 17.0),
        (Measure::EnergyOfLargestLoop, "1", Kind::Energy, 13.0),
    ] {
        assert_eq!((measure.unit(), measure.kind()), (unit, kind), "{measure:?}");
        assert!((measure.size(&scales) / size - 1.0_f64).abs() < 1e-15, "{measure:?}");
    }
    assert_eq!(Output::MaxAcceleration.unit(&scales), 5.0 / 7.0);
}

/// A value in physical units has a name by the excitation; a plain number has none.
#[test]
fn each_quantity_has_a_physical_name() {
    let under = |output: Output, excitation| output.definition().physical_name(excitation);
    for output in Output::ALL {
        let is_quantity = output.definition().measure.kind() != Kind::Ratio;
        // Both loop sizes are the same energy.
        let expected = is_quantity && output != Output::LoopSizeInertia;
        assert_eq!(under(output, Excitation::SurfaceMotion).is_some(), expected, "{output}");
    }
    assert_eq!(under(Output::MinForceRatio, Excitation::Force), Some("min_force"));
    assert_eq!(under(Output::MaxAbsoluteDisplacement, Excitation::Force), None);
    let work = |excitation| definitions::DAMPER_WORK.physical_name(excitation);
    assert_eq!(work(Excitation::FootMotion), Some("damper_energy_per_cycle"));
    assert_eq!(work(Excitation::DampedFootMotion), Some("damper_energy_per_cycle"));
    assert_eq!(
        under(Output::MaxAbsoluteDisplacement, Excitation::FootMotion),
        Some("max_absolute_displacement")
    );
}

#[test]
fn the_equation_is_named_once() {
    assert_eq!(Output::MaxDisplacement.definition().text(), "peak displacement Δ₀ (eq. 44)");
    let turning_point = Output::MinForceRatioTurningPoint.definition();
    assert_eq!((turning_point.equation, turning_point.text()), (Some(61), turning_point.meaning.to_owned()));
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
