//! The reasons why a system has no answer.

use crate::machine::error::Number;
use alloc::string::String;

/// The reason why there is no answer: it names the part of the system, its value and the condition.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// NaN or an infinity.
    #[error("{name} = {value} must be finite")]
    NotFinite {
        /// The name of the number.
        name: String,
        /// Its value.
        value: Number,
    },
    /// Zero or negative where only a positive number makes sense.
    #[error("{name} = {value} must be > 0")]
    NotPositive {
        /// The name of the number.
        name: String,
        /// Its value.
        value: Number,
    },
    /// A number below its least value.
    #[error("{name} = {value} must be ≥ {least}")]
    Below {
        /// The name of the number.
        name: String,
        /// Its value.
        value: Number,
        /// The least value.
        least: Number,
    },
    /// A list of the wrong length.
    #[error("{name} has {found} entries, but must have {expected}")]
    Length {
        /// The name of the list.
        name: String,
        /// Its length.
        found: usize,
        /// The right length.
        expected: usize,
    },
    /// A list that is too long.
    #[error("{name}: {found} of them, must be ≤ {most}")]
    TooMany {
        /// The name of the list.
        name: String,
        /// Its length.
        found: usize,
        /// The greatest length.
        most: usize,
    },
    /// A matrix that must be symmetric.
    #[error("{name}: entry ({row}, {column}) = {value} must equal entry ({column}, {row}) = {mirrored}")]
    NotSymmetric {
        /// The name of the matrix.
        name: String,
        /// The row, from 1.
        row: usize,
        /// The column, from 1.
        column: usize,
        /// The entry.
        value: Number,
        /// The entry across the diagonal.
        mirrored: Number,
    },
    /// A mass matrix that gives a motion no inertia.
    #[error("mass must be positive definite: pivot {row} is {value}")]
    NotDefinite {
        /// The pivot, from 1.
        row: usize,
        /// Its value.
        value: Number,
    },
    /// A list that must increase.
    #[error("{name}: {next} must be > {value} before it")]
    NotIncreasing {
        /// The name of the list.
        name: String,
        /// An entry.
        value: Number,
        /// The one after it.
        next: Number,
    },
    /// What does not go together.
    #[error("{name} {condition}")]
    Unsupported {
        /// The part of the system.
        name: String,
        /// The condition.
        condition: &'static str,
    },
    /// No sign that rounding leaves certain: events follow each other without end.
    #[error("{name} at time {time}: its events must be further apart than rounding errors")]
    Undecided {
        /// The element.
        name: String,
        /// The time.
        time: Number,
    },
    /// A motion whose proof stops short: at the greatest number of bits a sign is still not certain.
    #[error("{name} at time {time}: {reason}, even at {bits} bits")]
    Unproved {
        /// The element, or the system.
        name: String,
        /// The time.
        time: Number,
        /// What is not certain.
        reason: &'static str,
        /// The bits of the last trial.
        bits: u32,
    },
    /// More events or steps than any answer is worth.
    #[error("the motion must take ≤ {limit} steps, which end at time {time}")]
    TooLong {
        /// The time reached.
        time: Number,
        /// The number of steps.
        limit: u64,
    },
    /// A motion that was not followed to its end, because [`System::while_allowed`](super::System::while_allowed) said so.
    #[error("interrupted")]
    Interrupted,
    /// A motion that left the law of an element, as [`System::stopping_beyond`](super::System::stopping_beyond) bounds it.
    #[error("{name}: the motion leaves its law, which ends at {limit}, at time {time}")]
    LeavesLaw {
        /// The place of the element.
        element: usize,
        /// Its name.
        name: String,
        /// The end of the law.
        limit: Number,
        /// The time reached.
        time: Number,
    },
    /// A motion that left the range of numbers.
    #[error("the motion must stay finite, but does not after time {time}")]
    Unbounded {
        /// The time reached.
        time: Number,
    },
}
