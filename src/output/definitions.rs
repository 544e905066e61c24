//! The definitions of outputs that are no [`super::Output`]: counts, flags and texts, and the numbers of one
//! kind of answer alone.

use super::{Definition, Measure};

pub const REGIME: &Definition = &Definition::new(
    "regime",
    Measure::Plain,
    "what the body does: non-sticking, sticking, stuck or unbounded, or depends-on-start where static friction leaves it \
     to the start",
);
pub const MOTION_WITHOUT_STOP: &Definition = &Definition::new(
    "motion_without_stop",
    Measure::Plain,
    "whether a motion without a stop exists and attracts its neighbourhood, where static friction was given",
);
pub const MOVES_FROM_REST: &Definition = &Definition::new(
    "moves_from_rest",
    Measure::Plain,
    "whether a body at rest is released, α > η, where static friction was given",
);
pub const BEST_FORCE_RATIO_SLIDES: &Definition =
    &Definition::new("best_force_ratio_slides", Measure::Plain, "whether the body slides at α*")
        .title("sliding at the force ratio of the largest loop");
pub const DAMPER_WORK: &Definition = &Definition::new(
    "damper_work",
    Measure::Work,
    "energy that the damper dissipates in a cycle, where damping was given",
)
.title("energy dissipated by the damper in a cycle")
.unless_damped_foot("damper_energy_per_cycle");
pub const NO_STOP_FORCE_RATIOS: &Definition = &Definition::new(
    "no_stop_force_ratios",
    Measure::ForceRatio,
    "force ratios without any stop, as intervals (border --no-stop)",
)
.physical("no_stop_forces");
pub const REVERSALS_PER_CYCLE: &Definition = &Definition::new(
    "reversals_per_cycle",
    Measure::Plain,
    "reversals in a cycle: 2, or 6 close to Ω = 1/3, 1/5, …",
)
.title("reversals in a cycle");

pub const LIMIT: &Definition = &Definition::new(
    "limit",
    Measure::Plain,
    "periodic, family (one of many, by the start), rest, irregular, none or not-converged",
);
pub const STICKS_PER_CYCLE: &Definition =
    &Definition::new("sticks_per_cycle", Measure::Plain, "stops in a cycle").title("stops in a cycle");
pub const VELOCITY_ZEROS_PER_CYCLE: &Definition = &Definition::new(
    "velocity_zeros_per_cycle",
    Measure::Plain,
    "instants of zero velocity in a cycle, a stop being one",
)
.title("velocity zeros in a cycle");
pub const ERROR_1: &Definition = &Definition::new(
    "error_1",
    Measure::One,
    "|max x + min x|/max x: 0 for a symmetric motion, as are the other three",
)
.title("asymmetry of the displacements");
pub const ERROR_2: &Definition = &Definition::new(
    "error_2",
    Measure::One,
    "difference of the phases of max x and min x, less half a turn, in turns",
)
.title("asymmetry of the displacement phases");
pub const ERROR_3: &Definition = &Definition::new("error_3", Measure::One, "|max x′ + min x′|/max x′")
    .title("asymmetry of the velocities");
pub const ERROR_4: &Definition = &Definition::new("error_4", Measure::One, "error_2 of the velocities")
    .title("asymmetry of the velocity phases");
pub const MULTIPLIERS: &Definition = &Definition::new(
    "multipliers",
    Measure::One,
    "Floquet multipliers of a cycle, as pairs of real and imaginary part",
);
pub const REST_POSITION: &Definition =
    &Definition::new("rest_position", Measure::Length, "where the body comes to rest for good");
pub const PERIODS: &Definition =
    &Definition::new("periods", Measure::Turns, "periods of the drive that were followed")
        .title("periods of the drive followed")
        .physical("followed_for");
pub const TURNS_PER_CYCLE: &Definition = &Definition::new(
    "turns_per_cycle",
    Measure::Plain,
    "turns of the drive in a cycle (this and the next four outputs where static friction was given)",
);
pub const SYMMETRIC: &Definition = &Definition::new(
    "symmetric",
    Measure::Plain,
    "whether half a cycle is the mirror image of the other half: true or false",
);
pub const LYAPUNOV_EXPONENT: &Definition = &Definition::new(
    "lyapunov_exponent",
    Measure::One,
    "Lyapunov exponent of an irregular motion, per turn of the drive",
);
pub const LYAPUNOV_EXPONENT_ERROR: &Definition =
    &Definition::new("lyapunov_exponent_error", Measure::One, "its standard error");
pub const TURNS_OBSERVED: &Definition = &Definition::new(
    "turns_observed",
    Measure::Plain,
    "turns of the drive over which an irregular motion was observed",
);
