//! How far searches go where nothing else is asked for, in the command and on the page alike.

/// The periods of the drive for which each of several starts is followed.
pub const PERIODS: u32 = 2000;

/// The most answers that the peaks of one coordinate of a system ask for.
pub const MOST_ADDED: usize = 500;
