//! Machines drawn at random, for the library and for the samples.

#![allow(dead_code, reason = "each test takes what it needs")]

use crate::random::Random;
use crate::sampled::{Harmonic, Load, Machine};
use std::f64::consts::TAU;
use stickslip::{Drive, Excitation, Oscillator, Ratios};

/// A machine and its harmonic drive in any consistent units.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Driven {
    pub(crate) mass: f64,
    pub(crate) stiffness: f64,
    pub(crate) damping: f64,
    pub(crate) friction: f64,
    /// Half the difference of friction by direction.
    pub(crate) offset: f64,
    pub(crate) eta: f64,
    pub(crate) mean: f64,
    pub(crate) excitation: Excitation,
    pub(crate) amplitude: f64,
    pub(crate) frequency: f64,
}

impl Driven {
    /// A machine at Ω, α, ζ and η under a drive of this kind.
    pub(crate) fn at(
        random: &mut Random,
        [omega, alpha, zeta, eta]: [f64; 4],
        excitation: Excitation,
    ) -> Self {
        let (mass, friction) = (random.scale(0.01, 100.0), random.scale(0.1, 1e3));
        let natural = random.scale(0.3, 300.0);
        let (stiffness, frequency) = (mass * natural * natural, omega * natural);
        let damping = 2.0 * zeta * mass * natural;
        let force = alpha * friction;
        let inertia = mass * frequency * frequency;
        let amplitude = match excitation {
            Excitation::Force => force,
            Excitation::Unbalance => force / (frequency * frequency),
            Excitation::FootMotion => force / stiffness,
            Excitation::DampedFootMotion => force / stiffness.hypot(damping * frequency),
            Excitation::SurfaceMotion => force / inertia,
            Excitation::SurfaceVelocity => force * frequency / inertia,
            Excitation::SurfaceAcceleration => force * frequency * frequency / inertia,
            _ => panic!("{excitation:?} is not one of Excitation::ALL"),
        };
        let offset = if random.next() < 0.3 { friction * random.between(-0.6, 0.6) } else { 0.0 };
        let mean = if random.next() < 0.3 { friction * random.between(-5.0, 5.0) } else { 0.0 };
        Self { mass, stiffness, damping, friction, offset, eta, mean, excitation, amplitude, frequency }
    }

    /// Any of them, with static friction or without.
    pub(crate) fn any(random: &mut Random, excitation: Excitation) -> Self {
        let omega = random.scale(0.12, 3.0);
        let zeta = match (random.next() * 4.0) as u32 {
            0 => 0.0,
            1 => random.scale(0.3, 3.0),
            _ => random.scale(1e-3, 0.3),
        };
        let eta = if random.next() < 0.3 { random.between(1.01, 2.2) } else { 1.0 };
        let alpha = eta * random.scale(1.05, 12.0);
        Self::at(random, [omega, alpha, zeta, eta], excitation)
    }

    pub(crate) fn oscillator(&self) -> Oscillator<f64> {
        let body = Oscillator::new(self.mass, self.stiffness, self.friction).unwrap();
        let body = body.with_damping(self.damping).unwrap();
        let body = if self.offset == 0.0 {
            body
        } else {
            body.with_directional_friction(self.friction + self.offset, self.friction - self.offset).unwrap()
        };
        if self.eta == 1.0 { body } else { body.with_static_friction_ratio(self.eta).unwrap() }
    }

    pub(crate) fn drive(&self) -> Drive<f64> {
        let drive = Drive::new(self.excitation, self.amplitude, self.frequency).unwrap();
        if self.mean == 0.0 { drive } else { drive.with_mean_force(self.mean).unwrap() }
    }

    pub(crate) fn ratios(&self) -> Ratios<f64> {
        self.drive().ratios(&self.oscillator()).unwrap()
    }

    pub(crate) fn machine(&self) -> Machine {
        let rows = [self.mass, self.stiffness, self.damping];
        Machine::new(rows, [self.friction, self.offset, self.eta], self.mean)
    }

    pub(crate) fn is_foot(&self) -> bool {
        matches!(self.excitation, Excitation::FootMotion | Excitation::DampedFootMotion)
    }

    pub(crate) fn is_surface(&self) -> bool {
        !self.is_foot() && !matches!(self.excitation, Excitation::Force | Excitation::Unbalance)
    }

    /// The machine of the samples: a surface at u = u₀ sin ωt has the acceleration −ω²u₀ sin ωt.
    pub(crate) fn harmonic(&self) -> Harmonic {
        let w = self.frequency;
        let (load, amplitude) = match self.excitation {
            Excitation::Force => (Load::Force, self.amplitude),
            Excitation::Unbalance => (Load::Force, self.amplitude * w * w),
            Excitation::FootMotion => (Load::Foot, self.amplitude),
            Excitation::DampedFootMotion => (Load::DampedFoot, self.amplitude),
            Excitation::SurfaceMotion => (Load::Surface, -self.amplitude * w * w),
            Excitation::SurfaceVelocity => (Load::Surface, -self.amplitude * w),
            _ => (Load::Surface, -self.amplitude),
        };
        Harmonic { machine: self.machine(), load, amplitude, frequency: w }
    }

    /// The amplitude of the force on the body.
    pub(crate) fn force(&self) -> f64 {
        let w = self.frequency;
        match self.excitation {
            Excitation::Force => self.amplitude,
            Excitation::Unbalance => self.amplitude * w * w,
            Excitation::FootMotion => self.amplitude * self.stiffness,
            Excitation::DampedFootMotion => self.amplitude * self.stiffness.hypot(self.damping * w),
            Excitation::SurfaceMotion => self.amplitude * self.mass * w * w,
            Excitation::SurfaceVelocity => self.amplitude * self.mass * w,
            _ => self.amplitude * self.mass,
        }
    }

    /// The phase by which the force on the body is ahead of the support's motion.
    pub(crate) fn lead(&self) -> f64 {
        if self.excitation == Excitation::DampedFootMotion {
            (self.damping * self.frequency / self.stiffness).atan()
        } else {
            0.0
        }
    }

    /// The phase of the force at a time of the samples, in [0, 2π).
    pub(crate) fn phase(&self, time: f64) -> f64 {
        (self.frequency * time + self.lead()).rem_euclid(TAU)
    }
}
