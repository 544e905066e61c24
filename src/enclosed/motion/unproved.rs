//! Why a motion is not proved.

use core::fmt::{self, Display, Formatter};

/// What cannot be told of one event of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum Event {
    /// Whether the velocity keeps its sign throughout the slide that begins there.
    Slide,
    /// When the slide that begins there ends.
    End,
    /// Whether the body slides back at once, or stops.
    Reversal,
    /// Whether the force stays below the static friction throughout the stop that begins there.
    Stop,
    /// When the stop before it is over.
    Release,
}

/// Why a motion is not proved.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum Unproved {
    /// The motion from rest does not become periodic: it comes to rest, grows without bound, is irregular, or
    /// has not settled in the periods followed.
    NotPeriodic,
    /// It is one of a family of periodic motions.
    Family,
    /// It has more than 512 slides in the part that repeats.
    TooManySlides,
    /// It touches, or nearly touches, what decides on its order of events.
    Undecided {
        /// The event.
        event: Event,
        /// The phase ω_d t of the drive there, in rad.
        phase: f64,
        /// The bits computed with.
        bits: u32,
    },
    /// Balls of so many bits are too wide to show that it is the only one around, as where a multiplier is
    /// nearly 1.
    NotAlone {
        /// The bits computed with.
        bits: u32,
    },
}

impl Display for Unproved {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotPeriodic => f.write_str("the motion from rest does not become periodic"),
            Self::Family => f.write_str("the motion is one of a family of periodic motions"),
            Self::TooManySlides => f.write_str("the motion has more than 512 slides before it repeats"),
            Self::Undecided { event, phase, bits } => {
                let question = match event {
                    Event::Slide => "whether the body keeps moving throughout the slide that begins",
                    Event::End => "when the slide ends that begins",
                    Event::Reversal => "whether the body turns round or stops",
                    Event::Stop => "whether the body stays at rest throughout the stop that begins",
                    Event::Release => "when the stop is over that begins",
                };
                write!(f, "{bits} bits do not decide {question} at ω_d t = {phase:.6} rad")
            }
            Self::NotAlone { bits } => {
                write!(f, "{bits} bits do not show that the motion is the only one around")
            }
        }
    }
}
