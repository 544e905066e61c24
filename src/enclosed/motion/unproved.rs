//! Reasons why a motion is not proved.

use core::fmt::{self, Display, Formatter};

/// The property of one event that is undecided.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum Event {
    /// Whether the velocity keeps its sign throughout the slide that begins there.
    Slide,
    /// The time at which the slide that begins there ends.
    End,
    /// Whether the body slides back immediately or stops.
    Reversal,
    /// Whether the force stays below the static friction throughout the stop that begins there.
    Stop,
    /// The time at which the preceding stop ends.
    Release,
}

/// The reason why a motion is not proved.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum Unproved {
    /// The motion from rest does not become periodic: it comes to rest, grows without bound, is irregular, or
    /// has not settled within the periods computed.
    NotPeriodic,
    /// The motion is one of a family of periodic motions.
    Family,
    /// The part that repeats has more than 512 slides.
    TooManySlides,
    /// The motion touches, or nearly touches, a limit that decides its order of events.
    Undecided {
        /// The event.
        event: Event,
        /// The phase ω_d t of the event, in rad.
        phase: f64,
        /// The number of bits used.
        bits: u32,
    },
    /// Balls of this precision are too wide to prove uniqueness, for example where a multiplier is nearly 1.
    NotAlone {
        /// The number of bits used.
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
