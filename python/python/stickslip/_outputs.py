"""The outputs of results by name, with their types and meanings.

Written by `tests/outputs.py` from the library's table; the tests compare the two.
"""

from __future__ import annotations

from typing import Generic, Literal, Optional

import numpy as np
from numpy.typing import NDArray

from . import _rows
from ._result import PhysicalResult, Result, V, W


#: The names of the outputs of `response`.
ResponseOutput = Literal[
    "regime",
    "motion_without_stop",
    "moves_from_rest",
    "reversals_per_cycle",
    "best_force_ratio_slides",
    "damper_work",
    "max_displacement",
    "displacement_phase",
    "max_velocity",
    "velocity_phase",
    "deviation",
    "loop_size_stiffness",
    "loop_size_inertia",
    "contraction",
    "margin",
    "min_force_ratio",
    "min_force_ratio_turning_point",
    "least_displacement",
    "border_phase",
    "best_force_ratio",
    "best_loop_size",
    "dynamic_amplification",
    "max_acceleration",
    "transmitted_force",
    "transmissibility",
    "max_absolute_displacement",
    "max_spring_force",
    "equivalent_damping",
    "equivalent_damping_ratio",
    "equivalent_stiffness",
    "effective_damping_ratio",
]

#: The names of the outputs of `steady`.
SteadyOutput = Literal[
    "regime",
    "limit",
    "max_displacement",
    "max_displacement_phase",
    "min_displacement",
    "min_displacement_phase",
    "max_velocity",
    "max_velocity_phase",
    "min_velocity",
    "min_velocity_phase",
    "sticks_per_cycle",
    "velocity_zeros_per_cycle",
    "stick_fraction",
    "error_1",
    "error_2",
    "error_3",
    "error_4",
    "energy_in",
    "energy_out",
    "multipliers",
    "distance",
    "rest_position",
    "periods",
    "reversals_per_cycle",
    "dynamic_amplification",
    "max_acceleration",
    "transmitted_force",
    "transmissibility",
    "max_absolute_displacement",
    "max_spring_force",
    "equivalent_damping",
    "equivalent_damping_ratio",
    "equivalent_stiffness",
    "effective_damping_ratio",
    "damper_work",
    "turns_per_cycle",
    "symmetric",
    "lyapunov_exponent",
    "lyapunov_exponent_error",
    "turns_observed",
    "contraction",
]

#: The names of the values of `Machine.response`.
MachineResponseOutput = Literal[
    "angular_frequency",
    "force_amplitude",
    "friction_displacement",
    "mean_displacement",
    "regime",
    "motion_without_stop",
    "moves_from_rest",
    "reversals_per_cycle",
    "best_force_ratio_slides",
    "damper_energy_per_cycle",
    "max_displacement",
    "displacement_phase",
    "displacement_time",
    "max_velocity",
    "velocity_phase",
    "velocity_time",
    "deviation",
    "loop_size_stiffness",
    "energy_per_cycle",
    "loop_size_inertia",
    "contraction",
    "margin",
    "min_force_ratio",
    "min_force",
    "min_force_ratio_turning_point",
    "min_force_turning_point",
    "least_displacement",
    "border_phase",
    "border_time",
    "best_force_ratio",
    "best_force",
    "best_loop_size",
    "best_force_energy",
    "dynamic_amplification",
    "max_acceleration",
    "transmitted_force",
    "transmissibility",
    "max_absolute_displacement",
    "max_spring_force",
    "equivalent_damping",
    "equivalent_damping_ratio",
    "equivalent_stiffness",
    "effective_damping_ratio",
    "omega",
    "alpha",
    "damping_ratio",
    "static_friction_ratio",
]

#: The names of the values of `Machine.steady`.
MachineSteadyOutput = Literal[
    "angular_frequency",
    "force_amplitude",
    "friction_displacement",
    "mean_displacement",
    "regime",
    "limit",
    "max_displacement",
    "max_displacement_phase",
    "max_displacement_time",
    "min_displacement",
    "min_displacement_phase",
    "min_displacement_time",
    "max_velocity",
    "max_velocity_phase",
    "max_velocity_time",
    "min_velocity",
    "min_velocity_phase",
    "min_velocity_time",
    "sticks_per_cycle",
    "velocity_zeros_per_cycle",
    "stick_fraction",
    "error_1",
    "error_2",
    "error_3",
    "error_4",
    "energy_in",
    "energy_out",
    "multipliers",
    "distance",
    "rest_position",
    "periods",
    "followed_for",
    "reversals_per_cycle",
    "dynamic_amplification",
    "max_acceleration",
    "transmitted_force",
    "transmissibility",
    "max_absolute_displacement",
    "max_spring_force",
    "equivalent_damping",
    "equivalent_damping_ratio",
    "equivalent_stiffness",
    "effective_damping_ratio",
    "damper_energy_per_cycle",
    "turns_per_cycle",
    "symmetric",
    "lyapunov_exponent",
    "lyapunov_exponent_error",
    "turns_observed",
    "contraction",
    "omega",
    "alpha",
    "damping_ratio",
    "static_friction_ratio",
]

class ResponseOutputs(Result, Generic[V, W]):
    """The ratios and outputs of `response`."""

    _rows = _rows.RESPONSE
    omega: V
    """Frequency ratio Ω = ω_d/ω_n."""
    alpha: V
    """Force ratio α = p₀/r_y."""
    damping_ratio: V
    """Damping ratio ζ of the viscous damper, c/(2√(k m))."""
    static_friction_ratio: V
    """Ratio η of static to kinetic friction."""
    regime: W
    """Kind of motion: non-sticking, sticking, stuck or unbounded, or depends-on-start where static friction leaves
    it to the start."""
    motion_without_stop: V
    """Whether a motion without a stop exists and attracts its neighbourhood, where static friction was given (True
    or False; 1 or 0 in an array)."""
    moves_from_rest: V
    """Whether a body at rest is released, α > η, where static friction was given (True or False; 1 or 0 in an
    array)."""
    reversals_per_cycle: V
    """Reversals in a cycle: 2, or 6 close to Ω = 1/3, 1/5, … (a count)."""
    best_force_ratio_slides: V
    """Whether the body slides at α* (True or False; 1 or 0 in an array)."""
    damper_work: V
    """Energy that the damper dissipates in a cycle, where damping was given (r_y B)."""
    max_displacement: V
    """Peak displacement Δ₀ (eq. 44): a − G (B)."""
    displacement_phase: V
    """Phase ω_d t₂ of the peak displacement (eq. 43): δ + atan2(q a, K) (rad)."""
    max_velocity: V
    """Peak velocity V₀ (eq. 49) (B ω_d)."""
    velocity_phase: V
    """Phase ω_d t₁ of the peak velocity (eq. 46) (rad)."""
    deviation: V
    """Displacement Δ₁ at the peak velocity (eq. 47) (B)."""
    loop_size_stiffness: V
    """Friction's energy in a cycle per p₀²/(2k), A₁ (eq. 64): 8 (Δ₀/B)/α²."""
    loop_size_inertia: V
    """Friction's energy in a cycle per p₀²/(2 m ω_d²), A₂ (eq. 67): Ω² A₁."""
    contraction: V
    """Fraction of a disturbance that remains after half a cycle."""
    margin: V
    """Force over the minimum force without sticking, α/α_min."""
    min_force_ratio: V
    """Minimum force ratio α_min without sticking: q hypot(S, H)."""
    min_force_ratio_turning_point: V
    """Minimum force ratio by eq. 61, which falls short below Ω = 1/2."""
    least_displacement: V
    """Peak displacement on the border (B)."""
    border_phase: V
    """Phase after the peak displacement at which the velocity first touches zero, on the border (rad)."""
    best_force_ratio: V
    """Force ratio α* of the largest A₁ (eq. 65): √(2 Q (Q + q G)), and not below α_min."""
    best_loop_size: V
    """Largest A₁ at this Ω (eq. 66)."""
    dynamic_amplification: V
    """Peak displacement over p₀/k: compares machines of different friction: (Δ₀/B)/α."""
    max_acceleration: V
    """Peak acceleration |x″| (B ω_d²)."""
    transmitted_force: V
    """Maximum force of spring, damper and friction on their support, or m x″ with a moving support, without the
    mean force (r_y)."""
    transmissibility: V
    """Force on the support over p₀, or with a moving support or base the body's absolute acceleration over that of
    the support or base."""
    max_absolute_displacement: V
    """Maximum absolute displacement of the body, where its support or a base that carries the surface moves (B)."""
    max_spring_force: V
    """Maximum force in the spring k |x − u|, u the motion of its support, without that of the mean displacement
    (r_y)."""
    equivalent_damping: V
    """Equivalent viscous damping W/(π ω_d X²) of friction and damper together, X the amplitude (k/ω_d)."""
    equivalent_damping_ratio: V
    """Equivalent damping ratio c_eq/(2√(k m)): c_eq/(2√(k m))."""
    equivalent_stiffness: V
    """Stiffness of the loop of spring and friction from end to end, k + r_y/X (k)."""
    effective_damping_ratio: V
    """Damping ratio as isolation codes state it, W/(2π k_eff X²)."""


class BorderOutputs(Result, Generic[V]):
    """The ratios and outputs of `border`."""

    _rows = _rows.BORDER
    omega: V
    """Frequency ratio Ω = ω_d/ω_n."""
    damping_ratio: V
    """Damping ratio ζ of the viscous damper, c/(2√(k m))."""
    static_friction_ratio: V
    """Ratio η of static to kinetic friction."""
    min_force_ratio: V
    """Minimum force ratio α_min without sticking: q hypot(S, H)."""
    min_force_ratio_turning_point: V
    """Minimum force ratio by eq. 61, which falls short below Ω = 1/2."""
    least_displacement: V
    """Peak displacement on the border (B)."""
    border_phase: V
    """Phase after the peak displacement at which the velocity first touches zero, on the border (rad)."""
    best_force_ratio: V
    """Force ratio α* of the largest A₁ (eq. 65): √(2 Q (Q + q G)), and not below α_min."""
    no_stop_force_ratios: Optional[list[tuple[V, Optional[V]]]]
    """The intervals of the force ratio without any stop, for a single omega with one friction."""


class SteadyOutputs(Result, Generic[V, W]):
    """The ratios and outputs of `steady`."""

    _rows = _rows.STEADY
    omega: V
    """Frequency ratio Ω = ω_d/ω_n."""
    alpha: V
    """Force ratio α = p₀/r_y."""
    damping_ratio: V
    """Damping ratio ζ of the viscous damper, c/(2√(k m))."""
    static_friction_ratio: V
    """Ratio η of static to kinetic friction."""
    regime: W
    """Kind of motion: non-sticking, sticking, stuck or unbounded, or depends-on-start where static friction leaves
    it to the start."""
    limit: W
    """Periodic, family (one of many, by the start), rest, irregular, none or not-converged."""
    max_displacement: V
    """Peak displacement Δ₀ (eq. 44): a − G (B)."""
    max_displacement_phase: V
    """Phase ω_d t of the maximum displacement (rad)."""
    min_displacement: V
    """Minimum displacement (B)."""
    min_displacement_phase: V
    """Phase of the minimum displacement (rad)."""
    max_velocity: V
    """Peak velocity V₀ (eq. 49) (B ω_d)."""
    max_velocity_phase: V
    """Phase of the maximum velocity (rad)."""
    min_velocity: V
    """Minimum velocity (B ω_d)."""
    min_velocity_phase: V
    """Phase of the minimum velocity (rad)."""
    sticks_per_cycle: V
    """Stops in a cycle (a count)."""
    velocity_zeros_per_cycle: V
    """Instants of zero velocity in a cycle, a stop being one (a count)."""
    stick_fraction: V
    """Fraction of time at rest."""
    error_1: V
    """|max x + min x|/max x: 0 for a symmetric motion, as are the other three."""
    error_2: V
    """Difference of the phases of max x and min x, less half a turn, in turns."""
    error_3: V
    """|max x′ + min x′|/max x′."""
    error_4: V
    """Error_2 of the velocities."""
    energy_in: V
    """Work of the drive in a cycle (r_y B)."""
    energy_out: V
    """Work against friction in a cycle, without damper_work where damping was given (r_y B)."""
    multipliers: NDArray[np.complex128]
    """Floquet multipliers of a cycle, as pairs of real and imaginary part."""
    distance: V
    """Estimated distance of the motion found from the limit (B)."""
    rest_position: V
    """Where the body comes to rest for good (B)."""
    periods: V
    """Periods of the drive that were followed (2π/ω_d)."""
    reversals_per_cycle: V
    """Reversals in a cycle: 2, or 6 close to Ω = 1/3, 1/5, … (a count)."""
    dynamic_amplification: V
    """Peak displacement over p₀/k: compares machines of different friction: (Δ₀/B)/α."""
    max_acceleration: V
    """Peak acceleration |x″| (B ω_d²)."""
    transmitted_force: V
    """Maximum force of spring, damper and friction on their support, or m x″ with a moving support, without the
    mean force (r_y)."""
    transmissibility: V
    """Force on the support over p₀, or with a moving support or base the body's absolute acceleration over that of
    the support or base."""
    max_absolute_displacement: V
    """Maximum absolute displacement of the body, where its support or a base that carries the surface moves (B)."""
    max_spring_force: V
    """Maximum force in the spring k |x − u|, u the motion of its support, without that of the mean displacement
    (r_y)."""
    equivalent_damping: V
    """Equivalent viscous damping W/(π ω_d X²) of friction and damper together, X the amplitude (k/ω_d)."""
    equivalent_damping_ratio: V
    """Equivalent damping ratio c_eq/(2√(k m)): c_eq/(2√(k m))."""
    equivalent_stiffness: V
    """Stiffness of the loop of spring and friction from end to end, k + r_y/X (k)."""
    effective_damping_ratio: V
    """Damping ratio as isolation codes state it, W/(2π k_eff X²)."""
    damper_work: V
    """Energy that the damper dissipates in a cycle, where damping was given (r_y B)."""
    turns_per_cycle: V
    """Turns of the drive in a cycle (this and the next four outputs where static friction was given) (a count)."""
    symmetric: V
    """Whether half a cycle is the mirror image of the other half: true or false (True or False; 1 or 0 in an
    array)."""
    lyapunov_exponent: V
    """Lyapunov exponent of an irregular motion, per turn of the drive."""
    lyapunov_exponent_error: V
    """Standard error of the Lyapunov exponent."""
    turns_observed: V
    """Turns of the drive over which an irregular motion was observed (a count)."""
    contraction: V
    """Fraction of a disturbance that remains after a cycle."""


class MachineResponseOutputs(PhysicalResult, Generic[V, W]):
    """The outputs of `Machine.response`, in its units."""

    _rows = _rows.MACHINE_RESPONSE
    angular_frequency: V
    """Angular frequency ω_d of the drive."""
    force_amplitude: V
    """Amplitude of the drive as a force, p₀."""
    friction_displacement: V
    """Friction force over stiffness, B = r_y/k."""
    mean_displacement: V
    """The shift due to a mean force or to friction that depends on the direction."""
    regime: W
    """Kind of motion: non-sticking, sticking, stuck or unbounded, or depends-on-start where static friction leaves
    it to the start."""
    motion_without_stop: V
    """Whether a motion without a stop exists and attracts its neighbourhood, where static friction was given (True
    or False; 1 or 0 in an array)."""
    moves_from_rest: V
    """Whether a body at rest is released, α > η, where static friction was given (True or False; 1 or 0 in an
    array)."""
    reversals_per_cycle: V
    """Reversals in a cycle: 2, or 6 close to Ω = 1/3, 1/5, … (a count)."""
    best_force_ratio_slides: V
    """Whether the body slides at α* (True or False; 1 or 0 in an array)."""
    damper_energy_per_cycle: V
    """Energy that the damper dissipates in a cycle, where damping was given, as an energy."""
    max_displacement: V
    """Peak displacement Δ₀ (eq. 44), as a length."""
    displacement_phase: V
    """Phase ω_d t₂ of the peak displacement (eq. 43): δ + atan2(q a, K) (rad)."""
    displacement_time: V
    """Phase ω_d t₂ of the peak displacement (eq. 43), as a time."""
    max_velocity: V
    """Peak velocity V₀ (eq. 49), as a velocity."""
    velocity_phase: V
    """Phase ω_d t₁ of the peak velocity (eq. 46) (rad)."""
    velocity_time: V
    """Phase ω_d t₁ of the peak velocity (eq. 46), as a time."""
    deviation: V
    """Displacement Δ₁ at the peak velocity (eq. 47), as a length."""
    loop_size_stiffness: V
    """Friction's energy in a cycle per p₀²/(2k), A₁ (eq. 64): 8 (Δ₀/B)/α²."""
    energy_per_cycle: V
    """Friction's energy in a cycle per p₀²/(2k), A₁ (eq. 64), as an energy."""
    loop_size_inertia: V
    """Friction's energy in a cycle per p₀²/(2 m ω_d²), A₂ (eq. 67): Ω² A₁."""
    contraction: V
    """Fraction of a disturbance that remains after half a cycle."""
    margin: V
    """Force over the minimum force without sticking, α/α_min."""
    min_force_ratio: V
    """Minimum force ratio α_min without sticking: q hypot(S, H)."""
    min_force: V
    """Minimum force ratio α_min without sticking, as a force."""
    min_force_ratio_turning_point: V
    """Minimum force ratio by eq. 61, which falls short below Ω = 1/2."""
    min_force_turning_point: V
    """Minimum force ratio by eq. 61, which falls short below Ω = 1/2, as a force."""
    least_displacement: V
    """Peak displacement on the border, as a length."""
    border_phase: V
    """Phase after the peak displacement at which the velocity first touches zero, on the border (rad)."""
    border_time: V
    """Phase after the peak displacement at which the velocity first touches zero, on the border, as a time."""
    best_force_ratio: V
    """Force ratio α* of the largest A₁ (eq. 65): √(2 Q (Q + q G)), and not below α_min."""
    best_force: V
    """Force ratio α* of the largest A₁ (eq. 65), as a force."""
    best_loop_size: V
    """Largest A₁ at this Ω (eq. 66)."""
    best_force_energy: V
    """Largest A₁ at this Ω (eq. 66), as an energy."""
    dynamic_amplification: V
    """Peak displacement over p₀/k: compares machines of different friction: (Δ₀/B)/α."""
    max_acceleration: V
    """Peak acceleration |x″|, as an acceleration."""
    transmitted_force: V
    """Maximum force of spring, damper and friction on their support, or m x″ with a moving support, without the
    mean force, as a force."""
    transmissibility: V
    """Force on the support over p₀, or with a moving support or base the body's absolute acceleration over that of
    the support or base."""
    max_absolute_displacement: V
    """Maximum absolute displacement of the body, where its support or a base that carries the surface moves, as a
    length."""
    max_spring_force: V
    """Maximum force in the spring k |x − u|, u the motion of its support, without that of the mean displacement, as
    a force."""
    equivalent_damping: V
    """Equivalent viscous damping W/(π ω_d X²) of friction and damper together, X the amplitude, as a damping
    constant."""
    equivalent_damping_ratio: V
    """Equivalent damping ratio c_eq/(2√(k m)): c_eq/(2√(k m))."""
    equivalent_stiffness: V
    """Stiffness of the loop of spring and friction from end to end, k + r_y/X, as a stiffness."""
    effective_damping_ratio: V
    """Damping ratio as isolation codes state it, W/(2π k_eff X²)."""
    omega: V
    """Frequency ratio Ω = ω_d/ω_n."""
    alpha: V
    """Force ratio α = p₀/r_y."""
    damping_ratio: V
    """Damping ratio ζ of the viscous damper, c/(2√(k m))."""
    static_friction_ratio: V
    """Ratio η of static to kinetic friction."""


class MachineSteadyOutputs(PhysicalResult, Generic[V, W]):
    """The outputs of `Machine.steady`, in its units."""

    _rows = _rows.MACHINE_STEADY
    angular_frequency: V
    """Angular frequency ω_d of the drive."""
    force_amplitude: V
    """Amplitude of the drive as a force, p₀."""
    friction_displacement: V
    """Friction force over stiffness, B = r_y/k."""
    mean_displacement: V
    """The shift due to a mean force or to friction that depends on the direction."""
    regime: W
    """Kind of motion: non-sticking, sticking, stuck or unbounded, or depends-on-start where static friction leaves
    it to the start."""
    limit: W
    """Periodic, family (one of many, by the start), rest, irregular, none or not-converged."""
    max_displacement: V
    """Peak displacement Δ₀ (eq. 44), as a length."""
    max_displacement_phase: V
    """Phase ω_d t of the maximum displacement (rad)."""
    max_displacement_time: V
    """Phase ω_d t of the maximum displacement, as a time."""
    min_displacement: V
    """Minimum displacement, as a length."""
    min_displacement_phase: V
    """Phase of the minimum displacement (rad)."""
    min_displacement_time: V
    """Phase of the minimum displacement, as a time."""
    max_velocity: V
    """Peak velocity V₀ (eq. 49), as a velocity."""
    max_velocity_phase: V
    """Phase of the maximum velocity (rad)."""
    max_velocity_time: V
    """Phase of the maximum velocity, as a time."""
    min_velocity: V
    """Minimum velocity, as a velocity."""
    min_velocity_phase: V
    """Phase of the minimum velocity (rad)."""
    min_velocity_time: V
    """Phase of the minimum velocity, as a time."""
    sticks_per_cycle: V
    """Stops in a cycle (a count)."""
    velocity_zeros_per_cycle: V
    """Instants of zero velocity in a cycle, a stop being one (a count)."""
    stick_fraction: V
    """Fraction of time at rest."""
    error_1: V
    """|max x + min x|/max x: 0 for a symmetric motion, as are the other three."""
    error_2: V
    """Difference of the phases of max x and min x, less half a turn, in turns."""
    error_3: V
    """|max x′ + min x′|/max x′."""
    error_4: V
    """Error_2 of the velocities."""
    energy_in: V
    """Work of the drive in a cycle, as an energy."""
    energy_out: V
    """Work against friction in a cycle, without damper_work where damping was given, as an energy."""
    multipliers: NDArray[np.complex128]
    """Floquet multipliers of a cycle, as pairs of real and imaginary part."""
    distance: V
    """Estimated distance of the motion found from the limit, as a length."""
    rest_position: V
    """Where the body comes to rest for good, as a length."""
    periods: V
    """Periods of the drive that were followed (2π/ω_d)."""
    followed_for: V
    """Periods of the drive that were followed, as a time."""
    reversals_per_cycle: V
    """Reversals in a cycle: 2, or 6 close to Ω = 1/3, 1/5, … (a count)."""
    dynamic_amplification: V
    """Peak displacement over p₀/k: compares machines of different friction: (Δ₀/B)/α."""
    max_acceleration: V
    """Peak acceleration |x″|, as an acceleration."""
    transmitted_force: V
    """Maximum force of spring, damper and friction on their support, or m x″ with a moving support, without the
    mean force, as a force."""
    transmissibility: V
    """Force on the support over p₀, or with a moving support or base the body's absolute acceleration over that of
    the support or base."""
    max_absolute_displacement: V
    """Maximum absolute displacement of the body, where its support or a base that carries the surface moves, as a
    length."""
    max_spring_force: V
    """Maximum force in the spring k |x − u|, u the motion of its support, without that of the mean displacement, as
    a force."""
    equivalent_damping: V
    """Equivalent viscous damping W/(π ω_d X²) of friction and damper together, X the amplitude, as a damping
    constant."""
    equivalent_damping_ratio: V
    """Equivalent damping ratio c_eq/(2√(k m)): c_eq/(2√(k m))."""
    equivalent_stiffness: V
    """Stiffness of the loop of spring and friction from end to end, k + r_y/X, as a stiffness."""
    effective_damping_ratio: V
    """Damping ratio as isolation codes state it, W/(2π k_eff X²)."""
    damper_energy_per_cycle: V
    """Energy that the damper dissipates in a cycle, where damping was given, as an energy."""
    turns_per_cycle: V
    """Turns of the drive in a cycle (this and the next four outputs where static friction was given) (a count)."""
    symmetric: V
    """Whether half a cycle is the mirror image of the other half: true or false (True or False; 1 or 0 in an
    array)."""
    lyapunov_exponent: V
    """Lyapunov exponent of an irregular motion, per turn of the drive."""
    lyapunov_exponent_error: V
    """Standard error of the Lyapunov exponent."""
    turns_observed: V
    """Turns of the drive over which an irregular motion was observed (a count)."""
    contraction: V
    """Fraction of a disturbance that remains after a cycle."""
    omega: V
    """Frequency ratio Ω = ω_d/ω_n."""
    alpha: V
    """Force ratio α = p₀/r_y."""
    damping_ratio: V
    """Damping ratio ζ of the viscous damper, c/(2√(k m))."""
    static_friction_ratio: V
    """Ratio η of static to kinetic friction."""
