//! The quantities of a machine under its drive: those that its inputs give, and those that follow from them. The command, the
//! page and the Python package answer with them.

use crate::inputs::units::Kind;
use crate::inputs::{Driven, Given, Input, Role};
use std::str::FromStr;
use stickslip::{Excitation, Float};

/// A quantity of a machine: its name, its kind and its meaning.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Quantity {
    /// The key in JSON.
    pub name: &'static str,
    /// The kind, which determines the unit.
    pub kind: Kind,
    /// The meaning, in a few words.
    pub meaning: &'static str,
}

/// What the quantities follow from.
struct Machine<'a, F> {
    given: &'a Given<F>,
    driven: &'a Driven<F>,
    /// Friction against forward and against backward motion, where they are given apart.
    directions: Option<(F, F)>,
    /// 2π.
    turn: F,
    /// The amplitude p₀, 0 where it is given as 0.
    force: F,
    has_spring: bool,
}

impl<F: Float + FromStr> Machine<'_, F> {
    /// A value that exists with a spring alone.
    fn of_spring(&self, value: impl FnOnce(&Self) -> F) -> Option<F> {
        self.has_spring.then(|| value(self))
    }

    /// The amplitude as it was given, for this excitation.
    fn amplitude(&self, of: Excitation) -> Option<F> {
        let drive = &self.driven.drive;
        (drive.excitation() == of).then(|| self.given.drive_as_given(drive.amplitude()))
    }

    /// The acceleration p₀/m of a base that carries the surface.
    fn of_base(&self, scale: impl FnOnce(F) -> F) -> Option<F> {
        let is_base = self.driven.drive.excitation().carries_surface();
        is_base.then(|| scale(self.force / self.driven.oscillator.mass()))
    }
}

/// Defines the quantities from one row each, in the order of the answers: the name, the kind, the meaning, and the value, which may
/// not exist.
macro_rules! quantities {
    ($($name:literal $kind:ident $meaning:literal: $of:ident => $value:expr;)*) => {
        /// All quantities, in the order of the answers.
        pub const ALL: [Quantity; [$($name),*].len()] =
            [$(Quantity { name: $name, kind: Kind::$kind, meaning: $meaning }),*];

        fn values<F: Float + FromStr>(machine: &Machine<'_, F>) -> [Option<F>; ALL.len()] {
            [$({
                let $of = machine;
                $value
            }),*]
        }
    };
}

quantities! {
    "frequency" Hertz "frequency of the drive in Hz":
        m => Some(m.driven.drive.angular_frequency() / m.turn);
    "angular_frequency" Frequency "angular frequency ω_d of the drive":
        m => Some(m.driven.drive.angular_frequency());
    "natural_frequency" Frequency "natural angular frequency ω_n = √(k/m)":
        m => m.of_spring(|m| m.driven.oscillator.natural_frequency());
    "period" Time "natural period 2π/ω_n":
        m => m.of_spring(|m| m.turn / m.driven.oscillator.natural_frequency());
    "mass" Mass "mass m":
        m => Some(m.driven.oscillator.mass());
    "stiffness" Stiffness "stiffness k":
        m => Some(if m.has_spring { m.driven.oscillator.stiffness() } else { F::int(0) });
    "friction" Force "friction r_y while the body slides, or r₊ where it differs by direction":
        m => Some(match m.directions {
            Some((forward, _)) => forward,
            None => m.given.friction_as_given(m.driven.oscillator.friction_bound()),
        });
    "friction_backward" Force "r₋, where it was given (friction is then r₊)":
        m => m.directions.map(|(_, backward)| backward);
    "friction_bound" Force "r_y = (r₊ + r₋)/2, where friction differs by direction":
        m => m.directions.map(|_| m.driven.oscillator.friction_bound());
    "friction_coefficient" Ratio "µ = r_y/(m g), where it was given":
        m => m.given.get(Input::FrictionCoefficient);
    "damping" Damping "damping constant c, where a damper was given":
        m => m.given.has_role(Role::Damper).then(|| m.driven.oscillator.damping());
    "static_friction" Force "r_s = η r_y, where it was given, or η r_y ± (r₊ − r₋)/2 where friction differs by direction":
        m => m.given.has_role(Role::StaticFriction).then(|| {
            m.driven.oscillator.static_friction_ratio() * m.driven.oscillator.friction_bound()
        });
    "force_amplitude" Force "amplitude p₀ of the force on the body":
        m => Some(m.force);
    "unbalance" Unbalance "unbalance m_e e of the rotating mass":
        m => m.amplitude(Excitation::Unbalance);
    "foot_displacement" Length "amplitude of the spring's support":
        m => m.amplitude(Excitation::FootMotion);
    "damped_foot_displacement" Length "amplitude of the support of spring and damper":
        m => m.amplitude(Excitation::DampedFootMotion);
    "lead_time" Time "the time by which the force on the body is ahead of that support, atan(c ω_d/k)/ω_d":
        m => {
            let Driven { oscillator, drive, scales, .. } = m.driven;
            m.amplitude(Excitation::DampedFootMotion).map(|_| drive.phase_lead(oscillator) * scales.time)
        };
    "base_displacement" Length "displacement amplitude of a base that carries the surface":
        m => m.of_base(|acceleration| acceleration * m.driven.scales.time.square());
    "base_velocity" Velocity "its velocity amplitude":
        m => m.of_base(|acceleration| acceleration * m.driven.scales.time);
    "base_acceleration" Acceleration "its acceleration amplitude":
        m => m.of_base(|acceleration| acceleration);
    "friction_displacement" Length "B = r_y/k, the unit of length of the ratios":
        m => m.of_spring(|m| m.given.friction_as_given(m.driven.scales.length));
    "mean_force" Force "constant force p̄ on the body, where it was given (transmitted_force does not include it)":
        m => m.given.get(Input::MeanForce);
    "mean_displacement" Length
        "(p̄ − (r₊ − r₋)/2)/k, from which displacements are measured, where p̄ or r₋ was given":
        m => m.of_spring(|m| m.driven.scales.mean_displacement).filter(|_| m.given.is_shifted());
}

/// The quantities of a machine that exist, each with its value. A friction or a drive that is given as 0 is 0 here.
pub fn of_machine<F: Float + FromStr>(given: &Given<F>, driven: &Driven<F>) -> Vec<(&'static Quantity, F)> {
    let machine = Machine {
        given,
        driven,
        directions: given.directional_friction().ok().flatten(),
        turn: F::int(2) * F::pi(),
        force: given.drive_as_given(driven.drive.force_amplitude(&driven.oscillator)),
        has_spring: !given.is_without_spring(),
    };
    const { &ALL }
        .iter()
        .zip(values(&machine))
        .filter_map(|(quantity, value)| Some((quantity, value?)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{ALL, of_machine};
    use crate::inputs::units::Reader;
    use crate::inputs::{Given, Input, Naming};
    use std::collections::BTreeMap;

    fn quantities(typed: &[(Input, &str)]) -> BTreeMap<&'static str, f64> {
        let reader = Reader::new(None, "units");
        let mut given = Given::empty(&reader, Naming::Keyword);
        for (input, text) in typed {
            given.read(*input, text, &reader).unwrap();
        }
        let driven = given.point().unwrap().machine.unwrap();
        of_machine(&given, &driven).into_iter().map(|(own, value)| (own.name, value)).collect()
    }

    const BODY: [(Input, &str); 3] =
        [(Input::Mass, "2 kg"), (Input::Stiffness, "8 N/m"), (Input::Frequency, "3 rad/s")];

    #[test]
    fn each_quantity_follows_from_the_inputs() {
        let directions = [
            (Input::Friction, "4 N"),
            (Input::FrictionBackward, "2 N"),
            (Input::Force, "9 N"),
            (Input::MeanForce, "5 N"),
            (Input::Damping, "1 N*s/m"),
            (Input::StaticFrictionRatio, "1.5"),
        ];
        let found = quantities(&[&BODY[..], &directions].concat());
        for (name, value) in [
            ("friction", 4.0),
            ("friction_backward", 2.0),
            ("friction_bound", 3.0),
            ("static_friction", 4.5),
            ("natural_frequency", 2.0),
            ("period", std::f64::consts::PI),
            ("friction_displacement", 3.0 / 8.0),
            ("mean_displacement", (5.0 - 1.0) / 8.0),
            ("damping", 1.0),
            ("force_amplitude", 9.0),
        ] {
            assert_eq!(found[name], value, "{name}");
        }
        let base = quantities(
            &[&BODY[..], &[(Input::FrictionCoefficient, "0.1"), (Input::BaseVelocity, "6 m/s")]].concat(),
        );
        assert_eq!(
            [base["base_displacement"], base["base_velocity"], base["base_acceleration"]],
            [2.0, 6.0, 18.0]
        );
        assert_eq!((base["friction_coefficient"], base["force_amplitude"]), (0.1, 36.0));
        assert!(!base.contains_key("friction_backward") && !base.contains_key("foot_displacement"));
        let others =
            [Input::Unbalance, Input::FootDisplacement, Input::DampedFootDisplacement].map(|input| {
                let unit = if input == Input::Unbalance { "2 kg*m" } else { "2 m" };
                quantities(
                    &[&BODY[..], &[(Input::Friction, "1 N"), (Input::Damping, "1 N*s/m"), (input, unit)]]
                        .concat(),
                )
            });
        // ω_d c/k = 3/8
        assert!((others[2]["lead_time"] - 0.375f64.atan() / 3.0).abs() < 1e-15);
        let all = [found, base].into_iter().chain(others);
        let names: std::collections::BTreeSet<_> = all.flat_map(BTreeMap::into_keys).collect();
        assert_eq!(names, ALL.iter().map(|own| own.name).collect());
    }

    #[test]
    fn what_is_given_as_zero_is_zero_and_what_needs_a_spring_needs_one() {
        let free = [(Input::Friction, "0 N"), (Input::Damping, "1 N*s/m"), (Input::Force, "9 N")];
        let found = quantities(&[&BODY[..], &free].concat());
        assert_eq!((found["friction"], found["friction_displacement"]), (0.0, 0.0));
        let loose = [
            (Input::Mass, "2 kg"),
            (Input::Stiffness, "0"),
            (Input::Friction, "4 N"),
            (Input::Force, "9 N"),
            BODY[2],
        ];
        let found = quantities(&loose);
        assert_eq!(found["stiffness"], 0.0);
        assert!(
            ["natural_frequency", "period", "friction_displacement"]
                .iter()
                .all(|name| !found.contains_key(name))
        );
    }
}
