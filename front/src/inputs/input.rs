//! The table of inputs.

use super::units::Kind;
use stickslip::{Excitation, Quantity};

/// The part of an input in a machine. The inputs of one role determine each other, so that one of them is given; only
/// those of the body itself stand beside each other. A spring is given twice, by its stiffness and by the period or the
/// frequency, where these take the place of the mass.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// Gravity, and the friction of backward motion.
    Body,
    /// The mass: directly or by the weight.
    Mass,
    /// The spring: by its stiffness or by the natural period.
    Spring,
    /// The friction: by its bound or by the coefficient.
    Friction,
    /// The damper: by its ratio or by its constant.
    Damper,
    /// Static friction above the kinetic one: by its ratio or by the force.
    StaticFriction,
    /// The constant force.
    MeanForce,
    /// The frequency: by its ratio or in units.
    Frequency,
    /// The amplitude of the excitation: of a force, a rotating unbalance or a base motion, or the force ratio.
    Drive,
    /// The mass that rotates at an eccentricity.
    RotatingMass,
    /// The start of a motion.
    Start,
}

/// How a program writes the names of inputs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Naming {
    /// As options: `--damping-ratio`.
    Option,
    /// As keywords: `damping_ratio`. Ω and α are keywords of functions that take no machine, and an unbalance has one
    /// keyword.
    Keyword,
    /// As fields of a form: `damping ratio`.
    Field,
}

impl Naming {
    /// The name of an input.
    #[must_use]
    pub fn of(self, input: Input) -> String {
        match self {
            Self::Option => input.option().to_owned(),
            Self::Keyword => input.column(),
            Self::Field => input.name().replace('-', " "),
        }
    }

    /// The names of inputs of which one is missing: the first, and the others in brackets.
    pub(super) fn of_several(self, inputs: &[Input]) -> String {
        let is_option = |input: &Input| matches!(input, Input::Omega | Input::Alpha | Input::Eccentricity);
        let is_known = |input: &Input| self != Self::Keyword || !is_option(input);
        let names: Vec<_> = inputs.iter().copied().filter(is_known).map(|input| self.of(input)).collect();
        match names.split_first() {
            Some((first, [])) => first.clone(),
            Some((first, others)) => {
                let between = if others.len() > 2 { ", " } else { ", or " };
                format!("{first} (or {})", others.join(between))
            }
            None => String::new(),
        }
    }
}

/// Defines a row of the table, with a function of [`Input`] for each of its fields.
macro_rules! row {
    ($($(#[$doc:meta])+ $field:ident: $type:ty;)*) => {
        #[derive(Clone, Copy)]
        struct Row {
            $($field: $type,)*
        }

        impl Input {
            $(
                $(#[$doc])+
                #[must_use]
                pub const fn $field(self) -> $type {
                    self.row().$field
                }
            )*
        }
    };
}

row! {
    /// The description of the input, for help.
    help: &'static str;
    /// The option.
    option: &'static str;
    /// The placeholder of the value in help.
    placeholder: &'static str;
    /// The kind of the values.
    kind: Kind;
    /// The role of the input in a machine.
    role: Role;
    /// The quantity of the input.
    quantity: Quantity;
    /// Further quantities that the input determines.
    also: &'static [Quantity];
    /// The excitation whose amplitude the input is.
    excitation: Option<Excitation>;
    /// The quantity in words, with its symbol.
    symbol: &'static str;
    /// The letter in Latin script, which a column of a file may have as its name.
    letter: Option<&'static str>;
    /// Another name of the option and the column.
    alias: Option<&'static str>;
    /// The former name of the option, which help does not show.
    former: Option<&'static str>;
    /// The units in which a file of ratios may state it.
    ratio_units: &'static [&'static str];
}

/// Defines the inputs from one row each: the description, the option, the placeholder of its value, the kind of its
/// values, its role, its quantity, and the further quantities that it determines, which an error may be about. Fields
/// that most inputs do not have follow in braces.
macro_rules! inputs {
    ($(
        $(#[doc = $help:literal])+
        $input:ident $option:literal $placeholder:literal: $kind:ident, $role:ident, $quantity:ident [$($also:ident)*]
        $({$($field:ident: $value:expr),+})?;
    )*) => {
        /// An input of a machine or of its ratios.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
        pub enum Input {
            $($(#[doc = $help])+ $input,)*
        }

        impl Input {
            /// All inputs, in order.
            pub const ALL: [Self; [$($option),*].len()] = [$(Self::$input),*];

            const fn row(self) -> &'static Row {
                match self {
                    $(Self::$input => {
                        const ROW: Row = Row {
                            help: concat!($($help),+).trim_ascii(),
                            option: $option,
                            placeholder: $placeholder,
                            kind: Kind::$kind,
                            role: Role::$role,
                            quantity: Quantity::$quantity,
                            also: &[$(Quantity::$also),*],
                            excitation: None,
                            symbol: Quantity::$quantity.name(),
                            letter: None,
                            alias: None,
                            former: None,
                            ratio_units: &["1"],
                        };
                        const { &Row { $($($field: $value,)+)? ..ROW } }
                    })*
                }
            }
        }
    };
}

inputs! {
    /// Frequency ratio Ω = ω_d/ω_n
    Omega "--omega" "Ω": Ratio, Frequency, FrequencyRatio [Stiffness];
    /// Mass m, such as 800kg
    Mass "--mass" "M": Mass, Mass, Mass [FrequencyRatio PseudoStiffness];
    /// Weight W = m g, such as 500kip, in place of the mass
    Weight "--weight" "W": Force, Mass, Weight [Mass FrequencyRatio PseudoStiffness];
    /// Stiffness k, such as 12kN/mm, or in its place a period, or Ω and a frequency
    Stiffness "--stiffness" "K": Stiffness, Spring, Stiffness [FrequencyRatio FrictionDisplacement];
    /// Natural period of the body on its spring, such as 2.2s, in place of the stiffness: k = m (2π/T)²
    Period "--period" "T": Time, Spring, NaturalPeriod [Stiffness FrequencyRatio FrictionDisplacement];
    /// Natural frequency of the body on its spring, such as 1.5Hz, in place of the stiffness, where a bare number is in rad/s
    NaturalFrequency "--natural-frequency" "WN": Frequency, Spring, NaturalFrequency
        [Stiffness FrequencyRatio FrictionDisplacement];
    /// Radius of a friction pendulum, such as 2m, in place of the stiffness: k = m g/R, for displacements far below R
    PendulumRadius "--pendulum-radius" "R": Length, Spring, PendulumRadius
        [Stiffness FrequencyRatio FrictionDisplacement];
    /// Friction force r_y, such as 5kN
    Friction "--friction" "RY": Force, Friction, FrictionBound [ForwardFriction ForceRatio FrictionDisplacement];
    /// Coefficient of friction µ of a body that rests on its surface, in place of the bound: r_y = µ m g
    FrictionCoefficient "--friction-coefficient" "µ": Ratio, Friction, FrictionCoefficient
        [FrictionBound ForwardFriction ForceRatio FrictionDisplacement] {letter: Some("mu")};
    /// Gravity g for the coefficient of friction, the weight and the pendulum [default: 9.80665 m/s²]
    Gravity "--gravity" "G": Acceleration, Body, Gravity [FrictionBound ForwardFriction Stiffness];
    /// Friction force of backward motion, such as 4kN, where it differs from that of forward motion (r_y and
    /// r_s are the means of both directions, and at rest the bounds are η r_y ± (r₊ − r₋)/2)
    FrictionBackward "--friction-backward" "R": Force, Body, BackwardFriction [];
    /// Acceleration of the surface at which a block yields, such as 0.1g, in place of the friction: r_y = m a_y
    YieldAcceleration "--yield-acceleration" "AY": Acceleration, Body, YieldAcceleration
        [FrictionBound ForwardFriction];
    /// Viscous damping ratio ζ = c/(2√(k m)), such as 0.05 or 5% (a bare 5 is 500 %)
    DampingRatio "--damping-ratio" "ζ": Ratio, Damper, DampingRatio [] {letter: Some("zeta")};
    /// Damping constant c of a viscous damper, such as 20kN*s/m, in place of the ratio
    Damping "--damping" "C": Damping, Damper, Damping [DampingRatio];
    /// Static friction ratio η = r_s/r_y, such as 1.3: a body at rest stays until the force exceeds η r_y
    /// [default: 1]
    StaticFrictionRatio "--static-friction-ratio" "η": Ratio, StaticFriction, StaticFrictionRatio []
        {letter: Some("eta"), alias: Some("static-ratio")};
    /// Static friction r_s, such as 6.5kN, in place of the ratio
    StaticFriction "--static-friction" "RS": Force, StaticFriction, StaticFriction [StaticFrictionRatio];
    /// Constant force on the body, such as a preload of 2kN. It shifts the motion by P/k, and displacements are
    /// measured from the mean displacement. Under a record they are measured from the relaxed spring
    MeanForce "--mean-force" "P": Force, MeanForce, MeanForce [MeanDisplacement];
    /// Frequency of the drive, such as 2Hz, 120rpm or 12.5rad/s, where a bare number is ω_d in rad/s
    Frequency "--frequency" "WD": Frequency, Frequency, AngularFrequency
        [FrequencyRatio VelocityScale TimeScale PseudoStiffness];
    /// Force ratio α = p₀/r_y
    Alpha "--alpha" "α": Ratio, Drive, ForceRatio [ForceAmplitude];
    /// Amplitude p₀ of a force on the body, such as 12kN
    Force "--force" "P0": Force, Drive, ForceAmplitude [ForceRatio StaticEnergy PseudoStaticEnergy]
        {excitation: Some(Excitation::Force)};
    /// Unbalance m_e e of a mass that rotates on the body, such as 0.35kg*m: p₀ = m_e e ω_d²
    Unbalance "--unbalance" "ME": Unbalance, Drive, Unbalance
        [ForceAmplitude ForceRatio StaticEnergy PseudoStaticEnergy]
        {excitation: Some(Excitation::Unbalance)};
    /// Eccentricity e of a mass that rotates on the body, such as 120mm, with --eccentric-mass: p₀ = m_e e ω_d²
    Eccentricity "--eccentricity" "E": Length, Drive, Eccentricity
        [Unbalance ForceAmplitude ForceRatio StaticEnergy PseudoStaticEnergy]
        {excitation: Some(Excitation::Unbalance)};
    /// Mass m_e that rotates on the body, such as 3kg, a part of the mass m
    EccentricMass "--eccentric-mass" "ME": Mass, RotatingMass, EccentricMass
        [Unbalance ForceAmplitude ForceRatio StaticEnergy PseudoStaticEnergy];
    /// Acceleration amplitude of a base that carries the surface, such as 0.15g: p₀ = m a₀, x relative to the
    /// base
    BaseAcceleration "--base-acceleration" "A0": Acceleration, Drive, BaseAcceleration
        [ForceAmplitude ForceRatio StaticEnergy PseudoStaticEnergy]
        {excitation: Some(Excitation::SurfaceAcceleration)};
    /// Velocity amplitude of a base that carries the surface, such as 30mm/s: p₀ = m ω_d v₀
    BaseVelocity "--base-velocity" "V0": Velocity, Drive, BaseVelocity
        [ForceAmplitude ForceRatio StaticEnergy PseudoStaticEnergy]
        {excitation: Some(Excitation::SurfaceVelocity)};
    /// Displacement amplitude of a base that carries the surface, such as 9mm: p₀ = m ω_d² u₀
    BaseDisplacement "--base-displacement" "U0": Length, Drive, BaseAmplitude
        [ForceAmplitude ForceRatio StaticEnergy PseudoStaticEnergy]
        {excitation: Some(Excitation::SurfaceMotion), symbol: "base amplitude"};
    /// Displacement amplitude of the spring's support over a fixed surface, such as 9mm: p₀ = k u₀
    FootDisplacement "--foot-displacement" "U0": Length, Drive, BaseAmplitude
        [ForceAmplitude ForceRatio StaticEnergy PseudoStaticEnergy]
        {excitation: Some(Excitation::FootMotion), symbol: "amplitude of the support", former: Some("base-motion")};
    /// The same with the damper on the moving support, too: p₀ = √(k² + c²ω_d²) u₀
    DampedFootDisplacement "--damped-foot-displacement" "U0": Length, Drive, BaseAmplitude
        [ForceAmplitude ForceRatio StaticEnergy PseudoStaticEnergy]
        {excitation: Some(Excitation::DampedFootMotion), symbol: "amplitude of the support"};
    /// Displacement at the start: in units of B = r_y/k, or of length where there is a machine. It counts from the mean displacement, and with --shape from the relaxed spring [default: 0]
    X0 "--x0" "X": Length, Start, Displacement [] {ratio_units: &["B"]};
    /// Velocity at the start: in units of B ω_d, or of length per time [default: 0]
    V0 "--v0" "V": Velocity, Start, Velocity [] {ratio_units: &["B ω_d", "B wd"]};
}

impl Input {
    /// The input of this name, as an option without its dashes, or as a column.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|input| input.name() == name || input.column() == name)
    }

    /// The inputs of a role, in order; Ω and α are the last of theirs.
    #[must_use]
    pub fn of_role(role: Role) -> Vec<Self> {
        let mut inputs: Vec<_> = Self::ALL.into_iter().filter(|input| input.role() == role).collect();
        inputs.sort_by_key(|input| matches!(input, Self::Omega | Self::Alpha));
        inputs
    }

    /// The name of the option without its dashes.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.option().trim_start_matches('-')
    }

    /// The name of the input's column, and its keyword in Python.
    #[must_use]
    pub fn column(self) -> String {
        self.name().replace('-', "_")
    }

    /// Whether a column has the name of this input or its alias.
    #[must_use]
    pub fn is_column(self, name: &str) -> bool {
        self.column() == name || self.alias().is_some_and(|alias| alias.replace('-', "_") == name)
    }

    /// Whether the input is a quantity of a machine in physical units.
    #[must_use]
    pub const fn is_physical(self) -> bool {
        // The coefficient of friction is a ratio, but a friction only with mass and gravity.
        let is_ratio = matches!(self.kind(), Kind::Ratio) && !matches!(self, Self::FrictionCoefficient);
        !is_ratio && !matches!(self.role(), Role::Start)
    }

    /// Whether an error about a quantity can have its cause in this input.
    pub(super) fn determines(self, quantity: Quantity) -> bool {
        self.quantity() == quantity || self.also().contains(&quantity)
    }
}
