//! Batches against the library's own code for one point, at every level of instructions the processor has.

mod random;

use stickslip::batch::{Batch, Level, Triple};
use stickslip::{Border, Cycle, Ratios};
