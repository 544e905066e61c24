//! How far searches go where nothing else is asked for, in the command and on the page alike.

/// The periods of the drive for which each of several starts is followed.
pub const PERIODS: u32 = 2000;

/// The most answers that the peaks of one coordinate of a system ask for.
pub const MOST_ADDED: usize = 500;

/// The most of them that may have no periodic motion or rest: those take longest, and tell nothing of a peak.
pub const MOST_SCATTERED: usize = 4;
