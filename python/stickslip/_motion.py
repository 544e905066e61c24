"""The exact motion: its limit, the motion itself, and free vibration."""

from __future__ import annotations

from decimal import Decimal
from typing import Any, ClassVar, Optional, Sequence, Union, overload

from numpy.typing import ArrayLike, NDArray

from . import _native
from ._closed_forms import RATIOS, wide_ratios
from ._result import Codes, Floats, Physical, Result, Value, decimals, digits, numbers, points, precision, shaped

_KINDS = ("slide-forward", "slide-backward", "stick")
_ENDS = ("reversal", "stop", "grazing", "release", "never")
#: Displacement and velocity at a phase of the drive, as (phase, displacement, velocity).
Start = tuple[float, float, float]
REST: Start = (0.0, 0.0, 0.0)


class Steady(Result):
    """The long run of the motion from a start; see `steady`.

    Attributes
    ----------
    regime : str or array of str
        What the motion shows: ``"stuck"``, ``"sticking"``, ``"non-sticking"`` or ``"unbounded"``.
    limit : str or array of str
        ``"periodic"``, ``"family"``, ``"rest"``, ``"irregular"``, ``"none"`` or ``"not-converged"``.
    max_displacement, min_displacement, max_velocity, min_velocity : float or array
        Extremes of a cycle (B, B w), and their phases (rad) under the same names with ``_phase``. Of an irregular
        motion the displacements of the turns observed.
    sticks_per_cycle, velocity_zeros_per_cycle, reversals_per_cycle : int or array
        Counts; -1 in an array where there is none.
    stick_fraction : float or array
        Share of the cycle at rest.
    energy_in, energy_out : float or array
        Work of the drive, and work against friction in a cycle (r B).
    damper_work : float or array
        Work against the damper in a cycle (r B): the rest of ``energy_in``.
    multipliers : list of (float, float)
        Multipliers of a whole cycle, real and imaginary parts (a single point only).
    contraction : float or array
        Share of a disturbance that a cycle leaves.
    distance : float or array
        Bound of the displacement's distance from the limit (B).
    periods : float or array
        Periods of the drive that were followed.
    rest_position : float or array
        Where a stuck body rests (B).
    error_1, error_2, error_3, error_4 : float
        Measures of asymmetry of the source paper (a single point only).
    turns_per_cycle : int or array
        Turns of the drive in a cycle; above 1 with a static friction above the kinetic one only.
    symmetric : bool or array
        Whether half a cycle later the motion is the same upside down; in an array 1, 0, or -1 where there is no cycle.
    lyapunov_exponent, lyapunov_exponent_error, turns_observed : float, float and int, or arrays
        Of an irregular motion, per turn of the drive.
    dynamic_amplification, max_acceleration, transmitted_force, transmissibility, max_absolute_displacement : float
        As for `response` (a single point only).
    physical : Physical or None
        The same names in the units of the machine, where there is one.
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


class Phases(Result):
    """The motion phase by phase, one row for each slide and stop; see `simulate`.

    Attributes
    ----------
    kind : array of str
        ``"slide-forward"``, ``"slide-backward"`` or ``"stick"``.
    ends_by : array of str
        ``"reversal"``, ``"stop"``, ``"grazing"``, ``"release"`` or ``"never"``.
    start_phase, end_phase, duration : array
        Radians of the drive; NaN where it never ends.
    start_displacement, start_velocity, end_displacement : array
        In B and B w.
    """

    _names: ClassVar[Sequence[str]] = (
        "kind",
        "ends_by",
        "start_phase",
        "end_phase",
        "duration",
        "start_displacement",
        "start_velocity",
        "end_displacement",
    )

    kind: NDArray[Any]
    ends_by: NDArray[Any]
    start_phase: Floats
    end_phase: Floats
    duration: Floats
    start_displacement: Floats
    start_velocity: Floats
    end_displacement: Floats


class Samples(Result):
    """The motion at evenly spaced phases; see `simulate`.

    Attributes
    ----------
    phase : array
        Radians of the drive.
    displacement, velocity : array
        In B and B w.
    friction : array
        Force of friction in units of the kinetic one: -1 or 1 while it slides.
    """

    _names: ClassVar[Sequence[str]] = ("phase", "displacement", "velocity", "friction")

    phase: Floats
    displacement: Floats
    velocity: Floats
    friction: Floats


class Decay(Result):
    """Free vibration to rest; see `decay`.

    Attributes
    ----------
    half_cycles : int
        Half cycles after the first turn.
    first_turn, rest_position : float
        Displacements (B).
    rest_time : float or None
        Time until rest, in units of ``sqrt(m/k)``; None where it creeps there for ever.
    physical : Physical or None
        The same names in the units of the machine, where there is one.
    """

    _names: ClassVar[Sequence[str]] = ("half_cycles", "first_turn", "rest_position", "rest_time", "physical")

    half_cycles: int
    first_turn: float
    rest_position: float
    rest_time: Optional[float]
    physical: Optional[Physical]


def steady(
    omega: ArrayLike,
    alpha: ArrayLike,
    damping_ratio: ArrayLike = 0.0,
    static_friction_ratio: ArrayLike = 1.0,
    *,
    start: Start = REST,
    max_periods: int = _native.MAX_PERIODS,
    bits: Optional[int] = None,
) -> Steady:
    """The motion in the long run, by the exact motion from a start, stops included.

    Parameters
    ----------
    omega : float or array
        Frequency ratio, from 2**-20 to 2**20.
    alpha : float or array
        Force ratio, > 0.
    damping_ratio : float or array
        Damping ratio of a viscous damper, >= 0.
    static_friction_ratio : float or array
        Static friction over the kinetic one, >= 1. Above 1 the limit is that of this start: others may lead to
        another (`attractors`).
    start : (phase, displacement, velocity)
        In radians of the drive, B and B w; rest unless given.
    max_periods : int
        Periods of the drive after which a motion that has not settled is ``"not-converged"``.
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
    """
    periods, begin = periods_of(max_periods), start
    if bits is not None:
        texts = wide_ratios(omega, alpha, damping_ratio, static_friction_ratio)
        state_digits = tuple(digits(name, value) for name, value in zip(_STATE, _three(begin)))
        wide = decimals(_native.wide_steady(precision(bits), texts, state_digits, periods))
        return Steady({**wide, **dict(zip(RATIOS, map(Decimal, texts)))})
    at = points(
        omega=omega, alpha=alpha, damping_ratio=damping_ratio, static_friction_ratio=static_friction_ratio
    )
    if at.shape is None:
        return Steady({**at.in_shape(), **_native.steady_at(at.columns, state(begin), periods)})
    table = shaped(_native.steady_columns(at.columns, at.size, state(begin), periods), at.shape)
    table["regime"] = Codes(table["regime"], _native.REGIMES)
    table["limit"] = Codes(table["limit"], _native.LIMITS)
    return Steady({**at.in_shape(), **table})


@overload
def simulate(
    omega: float,
    alpha: float,
    damping_ratio: float = 0.0,
    static_friction_ratio: float = 1.0,
    *,
    start: Start = REST,
    cycles: float = 1.0,
    samples: None = None,
) -> Phases: ...


@overload
def simulate(
    omega: float,
    alpha: float,
    damping_ratio: float = 0.0,
    static_friction_ratio: float = 1.0,
    *,
    start: Start = REST,
    cycles: float = 1.0,
    samples: int,
) -> Samples: ...


def simulate(
    omega: float,
    alpha: float,
    damping_ratio: float = 0.0,
    static_friction_ratio: float = 1.0,
    *,
    start: Start = REST,
    cycles: float = 1.0,
    samples: Optional[int] = None,
) -> Union[Phases, Samples]:
    """The exact motion from a start.

    Parameters
    ----------
    omega, alpha, damping_ratio, static_friction_ratio : float
        Frequency ratio, force ratio, damping ratio, and static friction over the kinetic one.
    start : (phase, displacement, velocity)
        In radians of the drive, B and B w; rest unless given.
    cycles : float
        Drive cycles to follow, > 0.
    samples : int, optional
        Samples in a cycle. Without it, the phases of the motion are returned.

    Returns
    -------
    Phases or Samples

    Examples
    --------
    >>> import stickslip as ss
    >>> ss.simulate(0.4, 6).kind
    array(['stick', 'slide-forward', 'slide-backward', 'stick',
           'slide-forward'], dtype='<U14')
    >>> ss.simulate(0.4, 6, cycles=2, samples=4).displacement.round(3)
    array([ 0.   ,  7.331,  0.348, -5.143, -3.211,  7.996,  1.502, -6.712,
           -2.082])
    """
    given = (omega, alpha, damping_ratio, static_friction_ratio)
    point = tuple(one(name, value) for name, value in zip(RATIOS, given))
    if samples is None:
        table: dict[str, Any] = _native.phases(point, state(start), one("cycles", cycles))
        table["kind"] = Codes(table["kind"], _KINDS)
        table["ends_by"] = Codes(table["ends_by"], _ENDS)
        return Phases(table)
    if samples < 1:
        raise _native.Error(f"samples = {samples} must be >= 1")
    return Samples(_native.samples(point, state(start), one("cycles", cycles), int(samples)))


def decay(
    displacement: float,
    velocity: float = 0.0,
    damping_ratio: float = 0.0,
    static_friction_ratio: float = 1.0,
) -> Decay:
    """Free vibration to rest, without a drive.

    Parameters
    ----------
    displacement : float
        At the start, in B.
    velocity : float
        At the start, in ``B sqrt(k/m)``.
    damping_ratio : float
        Damping ratio of a viscous damper, >= 0.
    static_friction_ratio : float
        Static friction over the kinetic one, >= 1: the body stays at rest from a larger displacement.

    Returns
    -------
    Decay

    Examples
    --------
    >>> import stickslip as ss
    >>> ss.decay(12, 6).half_cycles
    8
    >>> ss.decay(12, 6, damping_ratio=0.05).half_cycles
    6
    """
    given = {
        "displacement": displacement,
        "velocity": velocity,
        "damping_ratio": damping_ratio,
        "static_friction_ratio": static_friction_ratio,
    }
    return Decay(_native.decay_at(*(one(name, value) for name, value in given.items())))


def periods_of(max_periods: int) -> int:
    if not 1 <= max_periods < 2**32:
        raise _native.Error(f"max_periods = {max_periods} must be >= 1 and < 2**32")
    return int(max_periods)


_STATE = ("phase", "displacement", "velocity")


def one(name: str, value: Any) -> float:
    """A single number."""
    array = numbers(name, value)
    if array.ndim != 0:
        raise _native.Error(f"{name}: must be one number, not an array of shape {array.shape}")
    return float(array)


def _three(start: Any) -> tuple[Any, Any, Any]:
    try:
        phase, displacement, velocity = start
    except (TypeError, ValueError):
        raise _native.Error(f"start = {start!r}: must be (phase, displacement, velocity)") from None
    return phase, displacement, velocity


def state(start: Any) -> Start:
    """A start as the compiled part takes it."""
    phase, displacement, velocity = (one(f"start: {name}", value) for name, value in zip(_STATE, _three(start)))
    return phase, displacement, velocity
