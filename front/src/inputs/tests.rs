//! The rules of input, and the names of the inputs.

use super::units::Reader;
use super::{Driven, Given, Input, Naming, Role};
use stickslip::motion::record::Body;

fn given(naming: Naming, typed: &[(Input, &str)]) -> Given<f64> {
    let reader = Reader::new(None, "units");
    let mut given = Given::empty(&reader, naming);
    for (input, text) in typed {
        given.read(*input, text, &reader).unwrap();
    }
    given
}

const BODY: [(Input, &str); 3] =
    [(Input::Mass, "1 kg"), (Input::Stiffness, "4 N/m"), (Input::Friction, "4 N")];

fn given_with(more: &[(Input, &str)]) -> Given<f64> {
    given(Naming::Keyword, &[&BODY, more].concat())
}

/// k = 4, m = 1, r_y = 4: ω_n = 2, 2√(k m) = 4.
#[test]
fn each_input_of_a_role_gives_the_same_machine() {
    let plain = given_with(&[]).oscillator().unwrap();
    let period = format!("{} s", std::f64::consts::PI);
    let tuned = [BODY[0], BODY[2], (Input::Omega, "2"), (Input::Frequency, "4 rad/s")];
    assert_eq!(given(Naming::Keyword, &tuned).oscillator().unwrap(), plain);
    let by_period = [BODY[0], BODY[2], (Input::Period, &period)];
    assert_eq!(given(Naming::Keyword, &by_period).oscillator().unwrap(), plain);
    let by_frequency = [BODY[0], BODY[2], (Input::NaturalFrequency, "2 rad/s")];
    assert_eq!(given(Naming::Keyword, &by_frequency).oscillator().unwrap(), plain);
    let by_weight = [(Input::Weight, "8 N"), (Input::Gravity, "8 m/s²"), BODY[1], BODY[2]];
    assert_eq!(given(Naming::Keyword, &by_weight).oscillator().unwrap(), plain);
    // The stiffness with the natural period or frequency is a mass.
    for natural in [(Input::Period, &*period), (Input::NaturalFrequency, "2 rad/s")] {
        let found = given(Naming::Keyword, &[BODY[1], BODY[2], natural]).oscillator().unwrap();
        assert!((found.mass() - 1.0).abs() < 1e-15 && found.stiffness() == 4.0);
    }
    let twice = [BODY[1], BODY[2], (Input::Period, &*period), (Input::NaturalFrequency, "2 rad/s")];
    assert!(given(Naming::Keyword, &twice).oscillator().is_err());
    assert!(given_with(&[(Input::Weight, "8 N")]).oscillator().is_err());
    let by_coefficient = [BODY[0], BODY[1], (Input::FrictionCoefficient, "0.5"), (Input::Gravity, "8 m/s²")];
    assert_eq!(given(Naming::Keyword, &by_coefficient).oscillator().unwrap(), plain);
    for (a, b) in [
        ((Input::DampingRatio, "0.5"), (Input::Damping, "2 N*s/m")),
        ((Input::StaticFrictionRatio, "1.5"), (Input::StaticFriction, "6 N")),
    ] {
        assert_eq!(given_with(&[a]).oscillator().unwrap(), given_with(&[b]).oscillator().unwrap());
    }
    for drive in [(Input::Force, "12 N"), (Input::Alpha, "3"), (Input::FootDisplacement, "3 m")] {
        for frequency in [(Input::Omega, "2"), (Input::Frequency, "4 rad/s")] {
            let Driven { ratios, drive, .. } = given_with(&[drive, frequency]).driven().unwrap();
            assert_eq!((ratios.omega(), ratios.alpha()), (2.0, 3.0));
            assert_eq!((drive.force_amplitude(&plain), drive.angular_frequency()), (12.0, 4.0));
        }
    }
    let border = given_with(&[(Input::Omega, "2")]).on_border().unwrap();
    assert_eq!((border.ratios.alpha(), border.drive.amplitude()), (1.0, 4.0));
}

#[test]
fn a_body_of_a_record_has_the_damper_of_the_oscillator() {
    // A mass whose root has no few digits, and one whose product with the stiffness is no number.
    for (mass, period) in [("2 t", "0.7 s"), ("2 t", "1.9 s"), ("1e200 kg", "0.01 s"), ("1e-200 kg", "9 s")] {
        for zeta in 1..40 {
            let ratio = format!("{}", f64::from(zeta) / 64.0 + 0.01);
            let typed = [
                (Input::Mass, mass),
                (Input::Period, period),
                (Input::Friction, "3 N"),
                (Input::DampingRatio, &ratio),
            ];
            let given = given(Naming::Keyword, &typed);
            let (body, oscillator) = (given.body(None).unwrap(), given.oscillator().unwrap());
            assert_eq!(body, Body::from(&oscillator));
            let own = oscillator.damping_ratio() / ratio.parse::<f64>().unwrap();
            // c and its quotient have a rounding each.
            assert!((own - 1.0).abs() <= f64::EPSILON, "{own}");
        }
    }
}

#[test]
fn a_given_ratio_is_used_without_a_rounding() {
    let driven = given_with(&[(Input::Omega, "0.1"), (Input::Alpha, "0.3")]).driven().unwrap();
    assert_eq!((driven.ratios.omega(), driven.ratios.alpha()), (0.1, 0.3));
}

#[test]
fn the_words_are_the_same_with_the_names_of_each_program() {
    let two = [(Input::DampingRatio, "5%"), (Input::Damping, "3 N*s/m")];
    for (naming, words) in [
        (
            Naming::Option,
            "--damping-ratio and --damping: give one of the two, because it determines the other",
        ),
        (Naming::Keyword, "damping_ratio and damping: give one of the two, because it determines the other"),
    ] {
        let given = given(naming, &[&BODY[..], &two].concat());
        assert_eq!(given.oscillator().unwrap_err().to_string(), words);
    }
    let missing =
        |naming, typed: &[(Input, &str)]| given(naming, typed).oscillator().unwrap_err().to_string();
    let without = [BODY[0], BODY[2]];
    assert_eq!(
        missing(Naming::Option, &without),
        "--stiffness (or --period, --natural-frequency, --pendulum-radius, --omega) is missing"
    );
    assert_eq!(
        missing(Naming::Keyword, &without),
        "stiffness (or period, natural_frequency, pendulum_radius) is missing"
    );
    assert_eq!(
        missing(Naming::Field, &without),
        "stiffness (or period, natural frequency, pendulum radius, omega) is missing"
    );
    assert_eq!(missing(Naming::Keyword, &[BODY[1], (Input::Damping, "3 N*s/m")]), "mass is missing");
    assert_eq!(
        missing(Naming::Keyword, &[(Input::Damping, "3 N*s/m")]),
        "damping 3 N*s/m: the damping constant c needs a machine in units, and mass is missing. With ratios give \
         damping_ratio"
    );
}

#[test]
fn a_wrong_value_is_named_as_it_was_typed() {
    let error = |more: &[(Input, &str)]| given_with(more).driven().unwrap_err().to_string();
    let drive = (Input::Frequency, "2 Hz");
    let words = [
        (
            vec![(Input::StaticFriction, "3 N"), drive],
            "static_friction 3 N: static friction ratio η = 0.75 must be ≥ 1",
        ),
        (vec![(Input::Gravity, "9 m/s²"), drive], "gravity: must be left out without friction_coefficient"),
        (vec![(Input::Force, "-1 N"), drive], "force -1 N: force amplitude p₀ = -1 must be > 0"),
        (
            vec![(Input::Force, "1 N"), (Input::Frequency, "0 Hz")],
            "frequency 0 Hz: the frequency must be > 0",
        ),
        (vec![(Input::Force, "1 N"), (Input::Omega, "-2")], "omega -2: frequency ratio Ω = -2 must be > 0"),
        (
            vec![(Input::Force, "1 N"), (Input::BaseVelocity, "1 m/s"), drive],
            "force and base_velocity: give one",
        ),
        (vec![drive, (Input::Omega, "2")], "omega, frequency and stiffness: give two of the three"),
    ];
    for (more, words) in words {
        assert!(error(&more).starts_with(words), "{} for {words}", error(&more));
    }
}

#[test]
fn the_names_are_those_of_one_input_each() {
    for input in Input::ALL {
        assert_eq!(Input::named(input.name()), Some(input));
        assert_eq!(Input::named(&input.column()), Some(input));
        assert!(!input.help().is_empty() && Input::of_role(input.role()).contains(&input));
        assert!(input.excitation().is_none() || input.role() == Role::Drive);
    }
}
