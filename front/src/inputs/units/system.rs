//! A consistent system of units: a force, a length, the second.

use super::InputError;
use super::factor::Factor;
use super::table::{mass_of, symbol};
use std::fmt;
use std::str::FromStr;
use stickslip::Float;
use stickslip::internal::{Dimension, Kind};

/// A consistent system of units: one of force, one of length, and the second. Its mass is force · s²/length.
/// The default is SI; others are read from a text such as `kN,mm`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct System {
    force: &'static str,
    length: &'static str,
    force_factor: Factor,
    length_factor: Factor,
    /// Whether accelerations are shown in g, and bare ones read in it.
    is_in_g: bool,
}

impl Default for System {
    fn default() -> Self {
        Self {
            force: "N",
            length: "m",
            force_factor: Factor::ONE,
            length_factor: Factor::ONE,
            is_in_g: false,
        }
    }
}

impl FromStr for System {
    type Err = InputError;

    fn from_str(text: &str) -> Result<Self, InputError> {
        let due = "must be a unit of force and one of length separated by a comma, such as kN,mm";
        let (force, length) = text.split_once(',').ok_or_else(|| InputError(due.to_owned()))?;
        let unit = |name: &str, kind: Kind| {
            symbol(name.trim(), kind.dimension()).ok_or_else(|| {
                InputError(format!("{due}, but “{}” is not a unit of {}", name.trim(), kind.name()))
            })
        };
        let (force, length) = (unit(force, Kind::Force)?, unit(length, Kind::Length)?);
        Ok(Self {
            force: force.0,
            length: length.0,
            force_factor: force.1.factor,
            length_factor: length.1.factor,
            is_in_g: false,
        })
    }
}

/// Displays the two units in the form in which they are read.
impl fmt::Display for System {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let g = if self.is_in_g { ",g" } else { "" };
        write!(f, "{},{}{g}", self.force, self.length)
    }
}

impl System {
    /// A system of a force and a length, as it is read, or with `,g` after them.
    ///
    /// # Errors
    /// Where the text names no system.
    pub fn perhaps_in_g(text: &str) -> Result<Self, InputError> {
        match text.trim_end().strip_suffix('g').and_then(|rest| rest.trim_end().strip_suffix(',')) {
            Some(rest) => Ok(Self { is_in_g: true, ..rest.parse()? }),
            None => text.parse(),
        }
    }

    /// The factor of a bare value, and of one that is shown, to the consistent system; none for most.
    #[must_use]
    pub fn scale(&self, kind: Kind) -> Option<Factor> {
        let is_scaled = self.is_in_g && kind == Kind::Acceleration;
        is_scaled.then(|| Factor::new(980_665, 100_000, 0).over(self.factor(kind.dimension())))
    }

    /// A value of the consistent system in the unit of [`System::name`].
    pub fn shown<F: Float + FromStr>(&self, kind: Kind, value: F) -> F {
        self.scale(kind).map_or(value, |factor| Factor::ONE.over(factor).times(value))
    }

    /// The symbol of its unit of force.
    #[must_use]
    pub const fn force(&self) -> &'static str {
        self.force
    }

    /// The symbol of its unit of length.
    #[must_use]
    pub const fn length(&self) -> &'static str {
        self.length
    }

    /// The system's own unit of a dimension, in SI: force^a · length^(b−a) · s^(c+2a).
    pub(super) fn factor(&self, [mass, length, ..]: Dimension) -> Factor {
        let force = self.force_factor.power(mass);
        let length = length.checked_sub(mass).and_then(|n| self.length_factor.power(n));
        force.zip(length).and_then(|(f, l)| f.and(l)).unwrap_or(Factor::ONE)
    }

    /// Whether a mass has a name of its own in this system, such as the tonne with kN and m.
    #[must_use]
    pub fn mass(&self) -> Option<&'static str> {
        mass_of(self.factor(Kind::Mass.dimension()))
    }

    /// The unit of mass for a reader, with the factor to it: the system's own if it has a name, otherwise the
    /// pound with lengths in feet, inches and mils, and the kilogram.
    #[must_use]
    pub fn mass_for_reading(&self) -> (&'static str, Factor) {
        let (own, length) = (self.factor(Kind::Mass.dimension()), self.length);
        let other = if matches!(length, "in" | "ft" | "mil") { "lb" } else { "kg" };
        let of = |name| symbol(name, Kind::Mass.dimension()).map_or(Factor::ONE, |(_, unit)| unit.factor);
        match self.mass() {
            Some(name) => (name, Factor::ONE),
            None => (other, own.over(of(other))),
        }
    }

    /// The unit of a quantity for a reader, with the factor to it: as [`System::mass_for_reading`], and an unbalance in
    /// kg·m with metric lengths, where the system's own is neither that nor t·m.
    #[must_use]
    pub fn for_reading(&self, kind: Kind) -> (String, Factor) {
        let own = self.name(kind);
        match kind {
            Kind::Mass => {
                let (name, factor) = self.mass_for_reading();
                (name.to_owned(), factor)
            }
            Kind::Unbalance if own != "t·m" && !matches!(self.length, "in" | "ft" | "mil") => {
                ("kg·m".to_owned(), self.factor(kind.dimension()))
            }
            _ => (own, Factor::ONE),
        }
    }

    /// The name of its unit for a kind of quantity.
    #[must_use]
    pub fn name(&self, kind: Kind) -> String {
        let (force, length) = (self.force, self.length);
        match kind {
            Kind::Ratio => "1".to_owned(),
            Kind::Mass => self.mass().map_or_else(|| format!("{force}·s²/{length}"), str::to_owned),
            Kind::Length => length.to_owned(),
            Kind::Time => "s".to_owned(),
            Kind::Angle => "rad".to_owned(),
            Kind::Frequency => "rad/s".to_owned(),
            Kind::Hertz => "Hz".to_owned(),
            Kind::Velocity => format!("{length}/s"),
            Kind::Acceleration if self.is_in_g => "g".to_owned(),
            Kind::Acceleration => format!("{length}/s²"),
            Kind::Force => force.to_owned(),
            Kind::Stiffness => format!("{force}/{length}"),
            Kind::Damping => format!("{force}·s/{length}"),
            Kind::Energy => format!("{force}·{length}"),
            Kind::Unbalance => {
                self.mass().map_or_else(|| format!("{force}·s²"), |mass| format!("{mass}·{length}"))
            }
        }
    }

    /// Standard gravity, 9.80665 m/s², in this system.
    #[must_use]
    pub fn gravity<F: Float + FromStr>(&self) -> F {
        let g = Factor::new(980_665, 100_000, 0);
        g.over(self.factor(Kind::Acceleration.dimension())).times(F::int(1))
    }
}

#[cfg(test)]
mod tests {
    use super::{Kind, System};

    fn system(text: &str) -> System {
        text.parse().unwrap()
    }

    #[test]
    fn a_system_names_all_its_units() {
        let own = system("kN,mm");
        assert_eq!(own.name(Kind::Stiffness), "kN/mm");
        assert_eq!(own.name(Kind::Mass), "kN·s²/mm");
        assert_eq!(own.name(Kind::Acceleration), "mm/s²");
        let (unit, factor) = own.mass_for_reading();
        assert_eq!((unit, factor.times(0.0012)), ("kg", 1200.0));
        let (unit, factor) = system("kip,in").mass_for_reading();
        assert_eq!((unit, (factor.times(1.0f64) - 386_088.6).abs() < 0.1), ("lb", true));
        assert_eq!(system("kN,m").mass_for_reading().0, "t");
        assert_eq!(own.gravity::<f64>(), 9806.65);
        for (text, name, due) in [
            ("kN,mm", "kg·m", 205.3807),
            ("N,mm", "kg·m", 0.2053807),
            ("N,m", "kg·m", 0.2053807),
            ("kN,m", "t·m", 0.2053807),
            ("lbf,in", "lbf·s²", 0.2053807),
        ] {
            let (unit, factor) = system(text).for_reading(Kind::Unbalance);
            assert_eq!((unit.as_str(), factor.times(0.2053807)), (name, due), "{text}");
        }
        assert_eq!(own.for_reading(Kind::Mass).0, "kg");
        assert_eq!(own.for_reading(Kind::Stiffness).0, "kN/mm");
        assert_eq!(system("kN,m").name(Kind::Mass), "t");
        assert_eq!(system("N,mm").name(Kind::Mass), "t");
        assert_eq!(system("lbf,ft").name(Kind::Mass), "slug");
        assert_eq!(System::default().name(Kind::Mass), "kg");
    }

    #[test]
    fn accelerations_may_be_in_g() {
        let own = System::perhaps_in_g("kN,mm,g").unwrap();
        assert_eq!((own.name(Kind::Acceleration), own.name(Kind::Velocity)), ("g".into(), "mm/s".into()));
        assert_eq!(own.shown(Kind::Acceleration, 9806.65), 1.0);
        assert_eq!((own.shown(Kind::Length, 3.0), own.to_string()), (3.0, "kN,mm,g".to_owned()));
        assert_eq!(own.gravity::<f64>(), 9806.65);
        let reader = crate::inputs::units::Reader::new(Some(&own), "units");
        let read = |text| reader.value::<f64>("a", text, Kind::Acceleration).unwrap();
        assert_eq!((read("0.5"), read("0.5g"), read("2mm/s^2")), (4903.325, 4903.325, 2.0));
        assert_eq!(System::perhaps_in_g("kN,mm").unwrap(), system("kN,mm"));
        assert!("kN,mm,g".parse::<System>().is_err() && System::perhaps_in_g("kN,g").is_err());
    }

    #[test]
    fn what_is_no_system_is_refused() {
        for (text, part) in [
            ("kN", "separated by a comma"),
            ("m,kN", "“m” is not a unit of force"),
            ("N,s", "“s” is not a unit of length"),
        ] {
            let error = text.parse::<System>().unwrap_err().to_string();
            assert!(error.contains(part), "{error}");
        }
    }
}
