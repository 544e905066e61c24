//! The body that a record moves: with or without a spring, a damper, friction in both directions or in one.

use super::number::Number;
use crate::float::Float;
use crate::machine::error::{Error, Quantity};
use crate::machine::oscillator::{Oscillator, critical_damping};
use crate::machine::ratios::{finite, non_negative, positive, valid_static_friction_ratio};

/// A body of mass m on a surface with dry friction, which may have a spring k, a damper c, and a constant force p̄:
/// `m x″ + c x′ + k x + friction = load + p̄`.
///
/// Any consistent system of units may be used. Unlike an [`Oscillator`], it need not have a spring, nor friction.
///
/// | | parameter | default |
/// |---|---|---|
/// | m > 0 | mass | |
/// | r ≥ 0 | friction while it slides | |
/// | k ≥ 0 | stiffness | 0 |
/// | c ≥ 0 | damping constant | 0 |
/// | η ≥ 1 | static friction ratio: the body at rest is released by a force of ηr | 1 |
/// | p̄ | constant force, such as the weight along a slope | 0 |
///
/// Friction that differs by direction is friction of the mean and a constant force, as for an [`Oscillator`]. A
/// body that moves **one way** resists every force backwards: a block on a slope, in Newmark's sense.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(
        try_from = "crate::serialized::BodyFields<F>",
        bound(deserialize = "F: Float + serde::Deserialize<'de>")
    )
)]
pub struct Body<F> {
    mass: F,
    friction: F,
    stiffness: F,
    damping: F,
    static_friction_ratio: F,
    mean_force: F,
    friction_offset: F,
    is_one_way: bool,
}

impl<F: Float> Body<F> {
    /// A body of mass m on a surface with friction r, without a spring and a damper.
    ///
    /// # Errors
    /// Where m is not finite or not > 0, or r is not finite or < 0.
    pub fn new(mass: F, friction: F) -> Result<Self, Error> {
        Ok(Self {
            mass: positive(Quantity::Mass, mass)?,
            friction: non_negative(Quantity::FrictionBound, friction)?,
            stiffness: F::int(0),
            damping: F::int(0),
            static_friction_ratio: F::int(1),
            mean_force: F::int(0),
            friction_offset: F::int(0),
            is_one_way: false,
        })
    }

    /// This body on a spring of stiffness k.
    ///
    /// # Errors
    /// Where k is not finite or < 0.
    pub fn with_stiffness(self, stiffness: F) -> Result<Self, Error> {
        Ok(Self { stiffness: non_negative(Quantity::Stiffness, stiffness)?, ..self })
    }

    /// This body with a viscous damper: the force −c x′ on the body.
    ///
    /// # Errors
    /// Where c is not finite or < 0.
    pub fn with_damping(self, damping: F) -> Result<Self, Error> {
        Ok(Self { damping: non_negative(Quantity::Damping, damping)?, ..self })
    }

    /// This body on its spring with a damper of damping ratio ζ: `c = 2ζ √(k m)`, as of an [`Oscillator`].
    ///
    /// # Errors
    /// Where the body has no spring, or ζ or c is not finite or < 0.
    pub fn with_damping_ratio(self, damping_ratio: F) -> Result<Self, Error> {
        let ratio = non_negative(Quantity::DampingRatio, damping_ratio)?;
        let stiffness = positive(Quantity::Stiffness, self.stiffness)?;
        self.with_damping(ratio * critical_damping(self.mass, stiffness))
    }

    /// This body with a static friction of η times the kinetic one.
    ///
    /// # Errors
    /// Where η is not finite, < 1 or outside the domain of [`crate::Ratios`].
    pub fn with_static_friction_ratio(self, static_friction_ratio: F) -> Result<Self, Error> {
        Ok(Self { static_friction_ratio: valid_static_friction_ratio(static_friction_ratio)?, ..self })
    }

    /// This body with friction r₊ against motion with x′ > 0 and r₋ against motion with x′ < 0: the friction
    /// `r = (r₊ + r₋)/2` and the constant force `−(r₊ − r₋)/2`.
    ///
    /// # Errors
    /// Where r₊ or r₋ is not finite or < 0, or their sum overflows.
    pub fn with_directional_friction(self, forward: F, backward: F) -> Result<Self, Error> {
        let forward = non_negative(Quantity::ForwardFriction, forward)?;
        let backward = non_negative(Quantity::BackwardFriction, backward)?;
        let half = F::ratio(1, 2);
        Ok(Self {
            friction: non_negative(Quantity::FrictionBound, forward * half + backward * half)?,
            friction_offset: (forward - backward) * half,
            ..self
        })
    }

    /// This body with friction that differs by direction by twice this force, `(r₊ − r₋)/2`.
    ///
    /// # Errors
    /// Where r₊ or r₋ is not finite or < 0.
    #[cfg(feature = "serde")]
    pub(crate) fn with_friction_offset(self, friction_offset: F) -> Result<Self, Error> {
        non_negative(Quantity::ForwardFriction, self.friction + friction_offset)?;
        non_negative(Quantity::BackwardFriction, self.friction - friction_offset)?;
        Ok(Self { friction_offset, ..self })
    }

    /// This body with a constant force p̄ in the direction of x.
    ///
    /// Displacements are from the unstretched spring, and the transmitted force includes p̄. Answers to a harmonic drive
    /// are about the mean ([`crate::Drive::with_mean_force`]).
    ///
    /// # Errors
    /// Where p̄ is not finite.
    pub fn with_mean_force(self, mean_force: F) -> Result<Self, Error> {
        Ok(Self { mean_force: finite(Quantity::MeanForce, mean_force)?, ..self })
    }

    /// This body, which never slides backwards: friction is as great as it needs to be there.
    #[must_use]
    pub fn one_way(self) -> Self {
        Self { is_one_way: true, ..self }
    }

    /// Mass m.
    pub const fn mass(&self) -> F {
        self.mass
    }

    /// Friction r while it slides; the mean of both directions where they differ.
    pub const fn friction(&self) -> F {
        self.friction
    }

    /// Stiffness k.
    pub const fn stiffness(&self) -> F {
        self.stiffness
    }

    /// Damping constant c.
    pub const fn damping(&self) -> F {
        self.damping
    }

    /// Static friction ratio η.
    pub const fn static_friction_ratio(&self) -> F {
        self.static_friction_ratio
    }

    /// Constant force p̄.
    pub const fn mean_force(&self) -> F {
        self.mean_force
    }

    /// Friction r₊ against motion with x′ > 0, and r₋ against motion with x′ < 0.
    pub fn directional_friction(&self) -> (F, F) {
        (self.friction + self.friction_offset, self.friction - self.friction_offset)
    }

    /// `(r₊ − r₋)/2`.
    pub(super) const fn friction_offset(&self) -> F {
        self.friction_offset
    }

    /// Whether the body never slides backwards.
    pub(crate) const fn is_one_way(&self) -> bool {
        self.is_one_way
    }
}

/// The body of an oscillator.
impl<F: Float> From<&Oscillator<F>> for Body<F> {
    fn from(oscillator: &Oscillator<F>) -> Self {
        Self {
            mass: oscillator.mass(),
            friction: oscillator.friction_bound(),
            stiffness: oscillator.stiffness(),
            damping: oscillator.damping(),
            static_friction_ratio: oscillator.static_friction_ratio(),
            mean_force: F::int(0),
            friction_offset: oscillator.friction_offset(),
            is_one_way: false,
        }
    }
}

/// The constants of a body per mass.
#[derive(Debug, Clone, Copy)]
pub(super) struct Constants<F> {
    /// 2β = c/m.
    pub(super) rate: F,
    /// ω² = k/m.
    pub(super) square: F,
    /// Friction per mass while it slides.
    pub(super) friction: F,
    /// Static friction per mass.
    pub(super) held: F,
    /// The acceleration of a body that the static friction no longer holds: `held − friction`, and exactly 0 where the
    /// two frictions are one.
    pub(super) excess: F,
    /// The constant force per mass, with that of friction by direction.
    pub(super) mean: F,
    pub(super) is_one_way: bool,
}

impl<F: Number> Constants<F> {
    /// Those of a body whose numbers are `known` as others.
    pub(super) fn of<G: Float>(body: &Body<G>, known: impl Fn(G) -> F) -> Self {
        let mass = known(body.mass());
        let friction = known(body.friction()) / mass;
        let eta = body.static_friction_ratio();
        let held = if eta == G::int(1) { friction } else { known(eta) * friction };
        let excess = if eta == G::int(1) { F::int(0) } else { held - friction };
        Self {
            rate: known(body.damping()) / mass,
            square: known(body.stiffness()) / mass,
            friction,
            held,
            excess,
            mean: (known(body.mean_force()) - known(body.friction_offset())) / mass,
            is_one_way: body.is_one_way(),
        }
    }
}
