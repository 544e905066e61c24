//! The definitions of results that are not outputs in the sense of [`super::Output`]: counts, flags and
//! texts, and the numbers of one kind of answer alone.

crate::define! {
    pub REGIME("regime", Plain,
        "kind of motion: non-sticking, sticking, stuck or unbounded, or depends-on-start where static friction leaves it to the start");
    pub MOTION_WITHOUT_STOP("motion_without_stop", Plain,
        "whether a motion without a stop exists and attracts its neighbourhood, where static friction was given");
    pub MOVES_FROM_REST("moves_from_rest", Plain,
        "whether a body at rest is released, α > η, where static friction was given");
    pub BEST_FORCE_RATIO_SLIDES("best_force_ratio_slides", Plain, "whether the body slides at α*")
        .title("sliding at the force ratio of the largest loop");
    pub DAMPER_WORK("damper_work", Work, "energy that the damper dissipates in a cycle, where damping was given")
        .title("energy dissipated by the damper in a cycle").physical("damper_energy_per_cycle");
    pub NO_STOP_FORCE_RATIOS("no_stop_force_ratios", ForceRatio,
        "force ratios without any stop, as intervals (border --no-stop)").physical("no_stop_forces");
    pub REVERSALS_PER_CYCLE("reversals_per_cycle", Plain, "reversals in a cycle: 2, or 6 close to Ω = 1/3, 1/5, …")
        .title("reversals in a cycle");
    pub LIMIT("limit", Plain, "periodic, family (one of many, by the start), rest, irregular, none or not-converged");
    pub STICKS_PER_CYCLE("sticks_per_cycle", Plain, "stops in a cycle").title("stops in a cycle");
    pub VELOCITY_ZEROS_PER_CYCLE("velocity_zeros_per_cycle", Plain,
        "instants of zero velocity in a cycle, a stop being one").title("velocity zeros in a cycle");
    pub ERROR_1("error_1", One, "|max x + min x|/max x: 0 for a symmetric motion, as are the other three")
        .title("asymmetry of the displacements");
    pub ERROR_2("error_2", One, "difference of the phases of max x and min x, less half a turn, in turns")
        .title("asymmetry of the displacement phases");
    pub ERROR_3("error_3", One, "|max x′ + min x′|/max x′").title("asymmetry of the velocities");
    pub ERROR_4("error_4", One, "error_2 of the velocities").title("asymmetry of the velocity phases");
    pub MULTIPLIERS("multipliers", One, "Floquet multipliers of a cycle, as pairs of real and imaginary part");
    pub REST_POSITION("rest_position", Length, "where the body comes to rest for good");
    pub PERIODS("periods", Turns, "periods of the drive that were followed")
        .title("periods of the drive followed").physical("followed_for");
    pub TURNS_PER_CYCLE("turns_per_cycle", Plain,
        "turns of the drive in a cycle (this and the next four outputs where static friction was given)");
    pub SYMMETRIC("symmetric", Plain, "whether half a cycle is the mirror image of the other half: true or false");
    pub LYAPUNOV_EXPONENT("lyapunov_exponent", One, "Lyapunov exponent of an irregular motion, per turn of the drive");
    pub LYAPUNOV_EXPONENT_ERROR("lyapunov_exponent_error", One, "standard error of the Lyapunov exponent");
    pub TURNS_OBSERVED("turns_observed", Plain, "turns of the drive over which an irregular motion was observed");
}
