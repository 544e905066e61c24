//! The command `stickslip` as its users meet it.

#[path = "../command_line/mod.rs"]
mod command_line;
#[path = "../kept/mod.rs"]
mod kept;

mod answers;
mod design;
mod figures;
mod motion;
#[cfg(feature = "parquet")]
mod parquet;
#[cfg(feature = "generators")]
mod round_trips;
mod shell;
mod sweep;
