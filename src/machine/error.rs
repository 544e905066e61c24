//! Errors of the input: the quantity, its value, and the condition that it violates.

mod number;
mod quantity;

use alloc::boxed::Box;
pub use number::Number;
pub(crate) use number::written;
pub use quantity::Quantity;

/// An enumeration of errors with the text of each variant, as `thiserror` has it: a procedural macro would be a fifth of the time in which the
/// smallest consumer compiles.
macro_rules! errors {
    ($(#[$attribute:meta])* pub enum $type:ident {
        $(
            $(#[doc = $meaning:literal])*
            #[error($($text:tt)+)]
            $variant:ident $({ $($(#[doc = $of_field:literal])* $field:ident: $kind:ty,)* })?,
        )+
    }) => {
        $(#[$attribute])*
        pub enum $type {
            $($(#[doc = $meaning])* $variant $({ $($(#[doc = $of_field])* $field: $kind,)* })?,)+
        }

        impl core::fmt::Display for $type {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                match self {
                    $(Self::$variant $({ $($field,)* })? => write!(f, $($text)+),)+
                }
            }
        }

        impl core::error::Error for $type {}
    };
}

errors! {
/// The reason why there is no answer. Values are printed with all the digits that identify them.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Error {
    /// NaN or an infinity where a finite number is required.
    #[error("{quantity} = {value} must be finite")]
    NotFinite {
        /// The quantity.
        quantity: Quantity,
        /// Its value.
        value: Number,
    },
    /// Zero or negative where only a positive number makes sense.
    #[error("{quantity} = {value} must be > 0")]
    NotPositive {
        /// The quantity.
        quantity: Quantity,
        /// Its value.
        value: Number,
    },
    /// Negative where only zero or a positive number makes sense.
    #[error("{quantity} = {value} must be ≥ 0")]
    Negative {
        /// The quantity.
        quantity: Quantity,
        /// Its value.
        value: Number,
    },
    /// A static friction below the kinetic one.
    #[error(
        "static friction ratio η = {static_friction_ratio} must be ≥ 1: static friction is not below the \
         kinetic one"
    )]
    BelowKineticFriction {
        /// Static friction ratio η = r_s/r_y.
        static_friction_ratio: Number,
    },
    /// A static friction above the kinetic one in a calculation that does not include it.
    #[error(
        "static friction ratio η = {static_friction_ratio} must be 1 here: this calculation does not \
         include static friction above the kinetic one"
    )]
    StaticFriction {
        /// Static friction ratio η = r_s/r_y.
        static_friction_ratio: Number,
    },
    /// A value so small or so large that a result could underflow or overflow in this number type, or a
    /// setting outside its range.
    #[error("{quantity} = {value} must be ≥ {least} and ≤ {greatest}")]
    OutOfRange {
        /// The quantity.
        quantity: Quantity,
        /// Its value.
        value: Number,
        /// Least admissible value.
        least: Number,
        /// Greatest admissible value.
        greatest: Number,
    },
    /// A range whose lower end is above its upper one.
    #[error("range of {quantity}: {low} must be ≤ {high}")]
    EmptyRange {
        /// The quantity.
        quantity: Quantity,
        /// Its lower end.
        low: Number,
        /// Its upper end.
        high: Number,
    },
    /// An interval of a parameter whose lower end is not below its upper one.
    #[error("interval: {low} must be ≤ {high}")]
    EmptyInterval {
        /// Its lower end.
        low: Number,
        /// Its upper end.
        high: Number,
    },
    /// No non-sticking cycle: the force ratio is below the border.
    #[error(
        "force ratio α = {alpha} must be ≥ {least}, the sticking threshold at Ω = {omega}: below it the body sticks"
    )]
    Sticks {
        /// Frequency ratio Ω.
        omega: Number,
        /// Force ratio α.
        alpha: Number,
        /// Least force ratio without sticking, α_min(Ω).
        least: Number,
    },
    /// No non-sticking cycle anywhere in a range of frequency ratios.
    #[error(
        "force ratio α = {alpha} must be ≥ {least}, the least sticking threshold for {low} ≤ Ω ≤ {high}: below \
         it the body sticks throughout"
    )]
    SticksThroughout {
        /// Force ratio α.
        alpha: Number,
        /// The minimum force ratio without sticking in the range.
        least: Number,
        /// Lower end of the range of Ω.
        low: Number,
        /// Upper end of the range of Ω.
        high: Number,
    },
    /// A target so small that the body would stick in a motion of that size.
    #[error("{quantity} = {value} must be ≥ {least} at Ω = {omega}: in a smaller motion the body sticks")]
    TargetSticks {
        /// The quantity.
        quantity: Quantity,
        /// The requested value.
        value: Number,
        /// The least value without sticking.
        least: Number,
        /// Frequency ratio Ω.
        omega: Number,
    },
    /// A force ratio too close to a minimum of the border for the arithmetic to decide.
    #[error(
        "force ratio α = {alpha} must differ more from {least}, the least sticking threshold near Ω = {omega}, \
         for this number type to decide on which side it is"
    )]
    Undecided {
        /// Force ratio α.
        alpha: Number,
        /// The minimum of the border.
        least: Number,
        /// The frequency ratio of that minimum.
        omega: Number,
    },
    /// No finite answer at Ω = 1, where the body either sticks or its motion grows without bound.
    #[error(
        "frequency ratio Ω = 1 must be excluded for {quantity} to have an answer: there the body sticks or \
         its motion grows without bound"
    )]
    AtResonance {
        /// The requested quantity.
        quantity: Quantity,
    },
    /// Slices of a batch whose lengths differ.
    #[error("{name} has {found} elements, but must have {expected}, as the others")]
    LengthMismatch {
        /// The name of the slice: that of an output, `alpha` or `regime`.
        name: &'static str,
        /// Its length.
        found: usize,
        /// The length of the first slice.
        expected: usize,
    },
    /// A measurement of a response curve that is wrong by itself.
    #[error("measurement {}: {error}", index.saturating_add(1))]
    InMeasurement {
        /// Its index.
        index: usize,
        /// The error.
        error: Box<Error>,
    },
    /// A response curve with too few measurements.
    #[error("response curve: the number of measurements = {count} must be ≥ 3")]
    TooFewMeasurements {
        /// The number of measurements.
        count: usize,
    },
    /// A measured free decay with too few turning points.
    #[error("free decay: the number of turning points = {count} must be ≥ {least}")]
    DecayTooShort {
        /// The number of turning points.
        count: usize,
        /// The least number.
        least: usize,
    },
    /// A measured free vibration that does not decay.
    #[error("free decay: the amplitude must fall from one turning point to the next")]
    NotADecay,
    /// Samples of which no free decay stands out of the noise.
    #[error("free decay: no decay exceeds the noise of the samples, whose standard deviation is {noise}")]
    NoDecay {
        /// The standard deviation of the samples.
        noise: Number,
    },
    /// A measured free decay that only a negative friction or damping would explain.
    #[error(
        "free decay: {quantity} = {value} would fit best and must be ≥ 0: no friction and damping explain this decay"
    )]
    NegativeFriction {
        /// The quantity.
        quantity: Quantity,
        /// Its value.
        value: Number,
    },
    /// A measured free decay that the model does not explain.
    #[error(
        "free decay: no friction and damping explain it: the best fit is off by {misfit} of the first amplitude, which \
         is more than noise"
    )]
    DecayUnexplained {
        /// The root mean square of the residuals, relative to the first amplitude.
        misfit: Number,
    },
    /// A response curve from which friction and damping do not follow.
    #[error(
        "response curve: friction and damping do not follow from it. It must have several frequencies, some \
         of them near resonance"
    )]
    NotIdentified,
    /// A response curve that no friction and damping of the range searched explain.
    #[error(
        "response curve: no friction and damping explain it. The best fit is at {quantity} = {value}, the end \
         of the range searched. The amplitudes must be those of this force and stiffness"
    )]
    Unexplained {
        /// The quantity.
        quantity: Quantity,
        /// Its greatest value.
        value: Number,
    },
    /// A response curve that no friction and damping explain better than one amplitude for all frequencies.
    #[error(
        "response curve: no friction and damping explain it. The best fit is off by {noise} of an amplitude, and one \
         amplitude for all frequencies fits equally well"
    )]
    CurveUnexplained {
        /// The standard error of one amplitude beside the best fit, relative to it.
        noise: Number,
    },
    /// A measured motion from which friction and damping do not follow.
    #[error(
        "motion: friction and damping do not follow from it. The body must slide, and turn or stop several times"
    )]
    MotionNotIdentified,
    /// A measured motion that no friction and damping explain.
    #[error(
        "motion: no friction and damping explain it. The best fit is off by {noise} of the spread of the displacements. The \
         load must be that of this body, and the mass and the stiffness its own"
    )]
    MotionUnexplained {
        /// The root mean square of the residuals, relative to that of the displacements from their mean.
        noise: Number,
    },
    /// A drive whose force changes with the frequency, in a question over a range of frequencies.
    #[error(
        "drive = {drive} must be a force or a motion of the spring's support: its force changes with the \
         frequency"
    )]
    ForceOfFrequency {
        /// The drive.
        drive: &'static str,
    },
    /// A displacement in space, without a base that carries the surface.
    #[error(
        "drive = {drive} must be a motion of the base that carries the surface: without one the displacement in \
         space is the displacement itself"
    )]
    SurfaceAtRest {
        /// The drive.
        drive: &'static str,
    },
    /// A motion of the spring's support, whose force k u_g0 depends on the unknown stiffness.
    #[error(
        "drive = motion of the spring's support must be a force or a motion of a base that carries the surface: the force \
         of a moving support, k u_g0, depends on the unknown stiffness"
    )]
    BaseMotion,
    /// A best friction over a band whose motions take too long to compute.
    #[error(
        "the best friction over this band is not known within {steps} steps: its motions take too many. Narrow the \
         band, raise its lower end, or give less damping"
    )]
    BandTooCostly {
        /// The steps.
        steps: u64,
    },
    /// A motion that did not settle within the permitted number of periods.
    #[error(
        "force ratio α = {alpha} must be followed for more periods at Ω = {omega}: the motion did not \
         settle within those allowed"
    )]
    NotSettled {
        /// Frequency ratio Ω.
        omega: Number,
        /// Force ratio α.
        alpha: Number,
    },
    /// A search that exceeded its proved bound without an answer. No input is known that causes it.
    #[error(
        "{search} from phase ω_d t = {phase} on at Ω = {omega}, α = {alpha} must be found within {bound}: \
         the search stopped at that bound"
    )]
    SearchBound {
        /// The object of the search.
        search: &'static str,
        /// Frequency ratio Ω.
        omega: Number,
        /// Force ratio α.
        alpha: Number,
        /// The phase ω_d t (radians) at which the search began.
        phase: Number,
        /// The bound.
        bound: &'static str,
    },
    /// A sample of a record that is wrong by itself.
    #[error("sample {}: {error}", index.saturating_add(1))]
    InSample {
        /// Its index.
        index: usize,
        /// The error.
        error: Box<Error>,
    },
    /// A record whose text cannot be read.
    #[error("record: the text must be readable, but {reason}")]
    Unreadable {
        /// The reason.
        reason: Box<str>,
    },
    /// A record with too few samples.
    #[error("record: the number of samples = {count} must be ≥ 2")]
    TooFewSamples {
        /// The number of samples.
        count: usize,
    },
    /// A record of a base motion from which the force does not follow as straight lines.
    #[error(
        "record = {excitation} must be a force, a base acceleration or a displacement of the spring's support"
    )]
    RecordOf {
        /// The excitation.
        excitation: &'static str,
    },
    /// A motion under a record whose numbers leave the range of their type.
    #[error("record: the motion leaves the range of this number type after the time {time}")]
    BeyondRange {
        /// The time.
        time: Number,
    },
    /// A motion under a record in which a sign stays uncertain, whatever the bits.
    #[error(
        "record: whether the body slides or turns after the time {time} is uncertain: the load equals the friction, or a velocity grazes zero"
    )]
    UncertainEvent {
        /// The time.
        time: Number,
    },
    /// A motion under a record with more stops than are followed.
    #[error(
        "record: the stops after the time {time} must be fewer than 10⁵, in one step or after the record"
    )]
    TooManyEvents {
        /// The time.
        time: Number,
    },
    /// The caller asked a long computation to stop.
    #[error("interrupted")]
    Interrupted,
    /// No bounded motion: Ω = 1 and α above 4/π.
    #[error(
        "frequency ratio Ω = 1 must be ≠ 1 for a bounded motion where α = {alpha} > 4/π: the amplitude \
         grows in every cycle"
    )]
    Unbounded {
        /// Force ratio α.
        alpha: Number,
    },
}
}

impl Error {
    /// The quantity whose value alone is wrong; `None` where two values conflict.
    #[must_use]
    pub const fn quantity(&self) -> Option<Quantity> {
        if let Self::NotFinite { quantity, .. }
        | Self::NotPositive { quantity, .. }
        | Self::Negative { quantity, .. }
        | Self::OutOfRange { quantity, .. }
        | Self::EmptyRange { quantity, .. } = self
        {
            return Some(*quantity);
        }
        let is_of_static_friction =
            matches!(self, Self::BelowKineticFriction { .. } | Self::StaticFriction { .. });
        if is_of_static_friction { Some(Quantity::StaticFrictionRatio) } else { None }
    }
}

#[cfg(test)]
mod tests {
    use super::written;

    #[test]
    fn a_power_of_ten_where_zeros_would_not_end() {
        for (x, text) in [
            (0.25, "0.25"),
            (0.0, "0"),
            (-1e300, "-1e300"),
            (1.25e-9, "1.25e-9"),
            (f64::NAN, "NaN"),
            (-f64::INFINITY, "-inf"),
        ] {
            assert_eq!((written(x).to_string(), written(x)), (text.to_owned(), written(x)));
            assert!(written(x).to_f64() == x || x.is_nan());
        }
        // The digits of the type itself, and the nearest f64.
        assert_eq!(
            (written(0.1f32).to_string().as_str(), written(0.1f32).to_f64()),
            ("0.1", f64::from(0.1f32))
        );
        assert_eq!(written(1e-9f32).to_string(), "1e-9");
        assert_ne!(written(0.1f32), written(0.1f64));
    }
}
