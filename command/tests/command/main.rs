//! The command `stickslip` from the user's side.

#[path = "../command_line/mod.rs"]
mod command_line;
#[path = "../../../tests/compared/mod.rs"]
mod compared;
#[path = "../../../tests/drawn/mod.rs"]
mod drawn;
#[path = "../../../tests/kept/mod.rs"]
mod kept;
#[path = "../../../tests/evidence/machines.rs"]
mod machines;
#[path = "../../../tests/place/mod.rs"]
mod place;
#[path = "../../../tests/random/mod.rs"]
mod random;
#[path = "../../../tests/evidence/sampled.rs"]
mod sampled;
mod stepped;
#[path = "../../../tests/text_boxes/mod.rs"]
mod text_boxes;

mod answers;
mod bounds;
mod curves;
mod design;
#[cfg(feature = "mp")]
mod enclose;
mod evidence;
mod exercises;
mod figures;
mod files;
mod gallery;
mod identify;
#[cfg(unix)]
mod interrupt;
mod laws;
#[cfg(unix)]
mod limits;
mod messages;
mod motion;
mod options;
#[cfg(feature = "parquet")]
mod parquet;
mod points;
mod records;
mod repeats;
mod round_trips;
mod shapes;
mod shell;
mod springless;
mod starts;
mod static_friction;
mod sweep;
mod systems;
mod tasks;
mod units;
mod wrong;
