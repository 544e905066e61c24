"""The steady state of the exact motion."""

from __future__ import annotations

from decimal import Decimal
from typing import Any, ClassVar, Iterable, Optional, Sequence

from numpy.typing import ArrayLike

from . import _native
from ._closed_forms import RATIOS, wide_ratios
from ._result import Codes, Physical, Result, Value, decimals, digits, points, precision, shaped
from ._start import REST, STATE, Start, periods_of, state, three
from ._wide import wide


#: The outputs that need a search for the peaks of a cycle.
OF_PEAKS = (
    "dynamic_amplification",
    "max_acceleration",
    "transmitted_force",
    "transmissibility",
    "max_absolute_displacement",
)


class Steady(Result):
    """The steady state of the motion from a start; see `steady`.

    Attributes
    ----------
    regime : str or array of str
        The regime of the motion: ``"stuck"``, ``"sticking"``, ``"non-sticking"`` or ``"unbounded"``.
    limit : str or array of str
        ``"periodic"``, ``"family"``, ``"rest"``, ``"irregular"``, ``"none"`` or ``"not-converged"``.
    max_displacement, min_displacement, max_velocity, min_velocity : float or array
        Extremes of a cycle (B, B w), and their phases (rad) under the same names with ``_phase``. For an irregular
        motion, the displacements are the extremes over the turns observed.
    sticks_per_cycle, velocity_zeros_per_cycle, reversals_per_cycle : int or array
        Counts; -1 in an array where a count does not exist.
    stick_fraction : float or array
        Share of the cycle at rest.
    energy_in, energy_out : float or array
        Work of the drive, and work against friction in a cycle (r B).
    damper_work : float or array
        Work against the damper in a cycle (r B), the remainder of ``energy_in``.
    multipliers : list of (float, float)
        Floquet multipliers of a cycle, as real and imaginary parts (a single point only).
    contraction : float or array
        Share of a disturbance that remains after a cycle.
    distance : float or array
        Estimated distance of the displacement from the limit (B).
    periods : float or array
        Number of drive periods followed.
    rest_position : float or array
        Rest position of a stuck body (B).
    error_1, error_2, error_3, error_4 : float
        The source paper's measures of asymmetry (a single point only).
    turns_per_cycle : int or array
        Turns of the drive in a cycle; above 1 only if static friction exceeds kinetic friction.
    symmetric : bool or array
        Whether each half of a cycle is the mirror image of the other; in an array 1, 0, or -1 where there is no cycle.
    lyapunov_exponent, lyapunov_exponent_error, turns_observed : float, float and int, or arrays
        Lyapunov exponent of an irregular motion per turn of the drive, its standard error, and the turns observed.
    dynamic_amplification, max_acceleration, transmitted_force, transmissibility, max_absolute_displacement : float or array
        As for `response`; in arrays where ``outputs`` names them.
    physical : Physical or None
        The same outputs in the machine's units; None without a machine.
    """

    _names: ClassVar[Sequence[str]] = (
        *RATIOS,
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
        "reversals_per_cycle",
        "stick_fraction",
        "energy_in",
        "energy_out",
        "damper_work",
        "contraction",
        "multipliers",
        "distance",
        "rest_position",
        "periods",
        "error_1",
        "error_2",
        "error_3",
        "error_4",
        "turns_per_cycle",
        "symmetric",
        "lyapunov_exponent",
        "lyapunov_exponent_error",
        "turns_observed",
        "dynamic_amplification",
        "max_acceleration",
        "transmitted_force",
        "transmissibility",
        "max_absolute_displacement",
        "physical",
    )

    _counts: ClassVar[frozenset[str]] = frozenset(
        (
            "sticks_per_cycle",
            "velocity_zeros_per_cycle",
            "reversals_per_cycle",
            "turns_per_cycle",
            "turns_observed",
        )
    )
    _numbers: ClassVar[frozenset[str]] = frozenset(_names) - _counts - {*RATIOS, "regime", "limit", "multipliers", "symmetric", "physical"}
    _optional: ClassVar[frozenset[str]] = frozenset(_names) - {*RATIOS, "physical"}

    omega: Value
    alpha: Value
    damping_ratio: Value
    static_friction_ratio: Value
    regime: Any
    limit: Any
    max_displacement: Any
    max_displacement_phase: Any
    min_displacement: Any
    min_displacement_phase: Any
    max_velocity: Any
    max_velocity_phase: Any
    min_velocity: Any
    min_velocity_phase: Any
    sticks_per_cycle: Any
    velocity_zeros_per_cycle: Any
    reversals_per_cycle: Any
    stick_fraction: Any
    energy_in: Any
    energy_out: Any
    damper_work: Any
    contraction: Any
    multipliers: Any
    distance: Any
    rest_position: Any
    periods: Any
    error_1: Optional[float]
    error_2: Optional[float]
    error_3: Optional[float]
    error_4: Optional[float]
    turns_per_cycle: Any
    symmetric: Any
    lyapunov_exponent: Any
    lyapunov_exponent_error: Any
    turns_observed: Any
    dynamic_amplification: Optional[float]
    max_acceleration: Optional[float]
    transmitted_force: Optional[float]
    transmissibility: Optional[float]
    max_absolute_displacement: Optional[float]
    physical: Optional[Physical]


def steady(
    omega: ArrayLike,
    alpha: ArrayLike,
    damping_ratio: ArrayLike = 0.0,
    static_friction_ratio: ArrayLike = 1.0,
    *,
    start: Start = REST,
    max_periods: int = _native.MAX_PERIODS,
    outputs: Optional[Iterable[str]] = None,
    bits: Optional[int] = None,
) -> Steady:
    """The steady state of the exact motion from a start, stops included.

    Parameters
    ----------
    omega : float or array
        Frequency ratio, from 2**-20 to 2**20.
    alpha : float or array
        Force ratio, > 0.
    damping_ratio : float or array
        Damping ratio of a viscous damper, >= 0.
    static_friction_ratio : float or array
        Ratio of static to kinetic friction, >= 1. Above 1 the steady state may depend on the start; see `attractors`.
    start : (phase, displacement, velocity)
        In radians of the drive, B and B w; at rest by default.
    max_periods : int
        Periods of the drive to follow; a motion that has not settled by then is ``"not-converged"``.
    outputs : names, optional
        The outputs to keep. For arrays those that need a search for the peaks of a cycle, such as
        ``"transmissibility"``, are computed only where they are named.
    bits : int, optional
        For a single point: the precision, as for `response`.

    Returns
    -------
    Steady

    Examples
    --------
    >>> import stickslip as ss
    >>> found = ss.steady(0.4, 6)
    >>> found.regime, found.sticks_per_cycle, round(found.max_displacement, 6)
    ('sticking', 2, 6.793822)
    >>> ss.steady([0.4, 0.7, 1.5], 6).sticks_per_cycle
    array([2, 0, 0])
    >>> ss.steady([0.4, 0.7, 1.5], 6, outputs=["transmissibility"]).transmissibility.round(4)
    array([1.299 , 2.1046, 0.9432])
    """
    chosen = None if outputs is None else known(outputs)
    periods, begin = periods_of(max_periods), start
    if bits is not None:
        texts = wide_ratios(omega, alpha, damping_ratio, static_friction_ratio)
        state_digits = tuple(digits(name, value) for name, value in zip(STATE, three(begin)))
        found = decimals(wide("wide_steady", precision(bits), texts, state_digits, periods))
        return Steady({**kept(found, chosen), **dict(zip(RATIOS, map(Decimal, texts)))})
    at = points(
        omega=omega, alpha=alpha, damping_ratio=damping_ratio, static_friction_ratio=static_friction_ratio
    )
    if at.shape is None:
        return Steady({**at.in_shape(), **kept(_native.steady_at(at.columns, state(begin), periods), chosen)})
    with_peaks = chosen is not None and any(name in OF_PEAKS for name in chosen)
    table: dict[str, Any] = shaped(
        _native.steady_columns(at.columns, at.size, state(begin), periods, with_peaks), at.shape
    )
    table["regime"] = Codes(table["regime"], _native.REGIMES)
    table["limit"] = Codes(table["limit"], _native.LIMITS)
    if chosen is not None and (missing := [name for name in chosen if name not in table]):
        raise _native.Error(f"outputs: {', '.join(missing)} exist for a single point only, or with static friction")
    return Steady({**at.in_shape(), **kept(table, chosen)})


def known(outputs: Iterable[str]) -> tuple[str, ...]:
    chosen = (outputs,) if isinstance(outputs, str) else tuple(outputs)
    names = [name for name in Steady._names if name in Steady._optional]
    for name in chosen:
        if name not in names:
            raise _native.Error(f"output {name!r} is none of {', '.join(names)}")
    return chosen


def kept(values: dict[str, Any], chosen: Optional[tuple[str, ...]]) -> dict[str, Any]:
    """The chosen values; all of them by default."""
    return values if chosen is None else {name: values[name] for name in chosen}
