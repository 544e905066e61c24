//! The command `stickslip` from the user's side.

#[path = "../command_line/mod.rs"]
mod command_line;
#[cfg(feature = "generators")]
#[path = "../drawn/mod.rs"]
mod drawn;
#[path = "../kept/mod.rs"]
mod kept;
#[path = "../place/mod.rs"]
mod place;

mod answers;
mod design;
#[cfg(feature = "mp")]
mod enclose;
mod figures;
mod files;
#[cfg(unix)]
mod interrupt;
mod messages;
mod motion;
mod options;
#[cfg(feature = "parquet")]
mod parquet;
mod points;
#[cfg(feature = "generators")]
mod round_trips;
mod shell;
mod starts;
mod static_friction;
mod sweep;
mod tasks;
mod units;
