//! A measured curve, how it is read, and what follows from it.

use crate::named::named;
use crate::uncertainty::Estimate;
use alloc::vec::Vec;

/// One point of a measured response curve.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Measurement {
    /// Angular frequency ω_d.
    pub angular_frequency: f64,
    /// The amplitude of the displacement, as [`Reading::amplitude`] says.
    pub amplitude: f64,
    /// The phase in radians, as [`Reading::phase`] says, if it was measured; from −2π to 2π.
    pub phase: Option<f64>,
}

named! {
    /// The amplitude that was measured.
    #[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "kebab-case"))]
    pub enum AmplitudeKind [name] {
        /// The peak displacement, half of peak to peak.
        #[default]
        Peak = "peak",
        /// From the minimum to the peak displacement.
        PeakToPeak = "peak-to-peak",
        /// The root mean square of the displacement over a cycle.
        #[cfg_attr(feature = "serde", serde(rename = "rms"))]
        RootMeanSquare = "rms",
    }
}

named! {
    /// The phase that was measured, the force being p₀ sin ω_d t.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "kebab-case"))]
    pub enum PhaseKind [name] {
        /// ω_d t₂, at which the body arrives at its peak displacement: about π/2 far below
        /// resonance.
        Peak = "peak",
        /// The lag of the fundamental of the displacement behind the force: between 0 and π.
        Lag = "lag",
        /// The phase of the transfer function from force to displacement: the lag with a minus sign.
        TransferFunction = "transfer-function",
    }
}

/// How the values of a curve are read.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Reading {
    /// The kind of the amplitudes.
    pub amplitude: AmplitudeKind,
    /// The kind of the phases; `None` tries each and chooses the one that explains the curve best,
    /// [`PhaseKind::Peak`] unless another one does better by more than chance.
    pub phase: Option<PhaseKind>,
}

/// A measurement beside the motion computed with the parameters found.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Residual {
    /// Measured minus computed amplitude, relative to the measured one.
    pub amplitude: f64,
    /// Measured minus computed phase in radians, within half a turn.
    pub phase: Option<f64>,
    /// Whether the amplitude is so far from the computed one that it was left out.
    pub amplitude_is_suspect: bool,
    /// Whether the phase is so far from the computed one that it was left out.
    pub phase_is_suspect: bool,
    /// Whether the body stops in each cycle of the computed motion.
    pub stops: bool,
}

impl Residual {
    /// Whether the amplitude or the phase was left out.
    #[must_use]
    pub const fn is_suspect(&self) -> bool {
        self.amplitude_is_suspect || self.phase_is_suspect
    }
}

/// Friction and damping estimated from a measured response curve.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
#[must_use]
pub struct Identified {
    /// The friction force r_y, between 0 and p₀.
    pub friction_bound: Estimate,
    /// The damping ratio ζ ≥ 0; `c = 2ζ√(k m)`.
    pub damping_ratio: Estimate,
    /// The damping constant c of ζ = 1, in units of mass × angular frequency: 2√(k m), and without a spring 2 m ω₁.
    pub critical_damping: f64,
    /// The natural angular frequency ω_n where the stiffness was not known.
    pub natural_frequency: Option<Estimate>,
    /// The amplitude p₀ of the force where it was not known.
    pub force: Option<Estimate>,
    /// The standard error of one amplitude, relative to it, estimated from the residuals.
    pub noise: f64,
    /// The standard error of one phase in radians, estimated from the residuals.
    pub phase_noise: Option<f64>,
    /// The residuals of each measurement, in their order.
    pub residuals: Vec<Residual>,
    /// The kind of phase that the curve was read with, if it has phases.
    pub phase: Option<PhaseKind>,
    /// Another kind of phase that explains the curve better by more than chance than the one asked for.
    pub better_phase: Option<PhaseKind>,
    /// Another kind of amplitude that fits better than expected by chance, with the standard error of an amplitude
    /// read so: the amplitudes were probably of that kind.
    pub better: Option<(AmplitudeKind, f64)>,
    /// Whether the search for other minima came to its end. Otherwise the least sum of squares within the bound on its work is
    /// answered.
    pub search_is_complete: bool,
}
