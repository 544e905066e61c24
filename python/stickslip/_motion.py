"""The exact motion: its limit, the motion itself, and free vibration."""

from __future__ import annotations

from decimal import Decimal
from typing import Any, ClassVar, Optional, Sequence, Union, overload

from numpy.typing import ArrayLike, NDArray

from . import _native
from ._closed_forms import _ratios
from ._result import Floats, Physical, Result, Value, broadcast, decimals, digits, named, precision, shaped

_KINDS = ("slide-forward", "slide-backward", "stick")
_ENDS = ("reversal", "stop", "grazing", "release", "never")
#: Displacement and velocity at a phase of the drive, as (phase, displacement, velocity).
Start = tuple[float, float, float]
_REST: Start = (0.0, 0.0, 0.0)


class Steady(Result):
    """The long run of the motion from a start; see `steady`.

    Attributes
    ----------
    regime : str or array of str
        What the motion shows: ``"stuck"``, ``"sticking"``, ``"non-sticking"`` or ``"unbounded"``.
    limit : str or array of str
        ``"periodic"``, ``"family"``, ``"rest"``, ``"none"`` or ``"not-converged"``.
    max_displacement, min_displacement, max_velocity, min_velocity : float or array
        Extremes of a cycle (B, B w), and their phases (rad) under the same names with ``_phase``.
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
    physical : Physical or None
        The same names in the units of the machine, where there is one.
    """

    _names: ClassVar[Sequence[str]] = (
        "omega",
        "alpha",
        "damping_ratio",
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
        "physical",
    )

    omega: Value
    alpha: Value
    damping_ratio: Value
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
        Force of friction in units of the friction bound, between -1 and 1.
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
    rest_time : float
        Time until rest, in units of ``sqrt(m/k)``.
    """

    _names: ClassVar[Sequence[str]] = ("half_cycles", "first_turn", "rest_position", "rest_time")

    half_cycles: int
    first_turn: float
    rest_position: float
    rest_time: float


def steady(
    omega: ArrayLike,
    alpha: ArrayLike,
    damping_ratio: ArrayLike = 0.0,
    *,
    start: Start = _REST,
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
    periods = _periods(max_periods)
    if bits is not None:
        texts = (digits("omega", omega), digits("alpha", alpha), digits("damping_ratio", damping_ratio))
        begin = (digits("phase", start[0]), digits("displacement", start[1]), digits("velocity", start[2]))
        wide = decimals(_native.wide_steady(precision(bits), texts, begin, periods))
        return Steady({**wide, **dict(zip(("omega", "alpha", "damping_ratio"), map(Decimal, texts)))})
    shape, columns = broadcast(omega, alpha, damping_ratio)
    if shape is None:
        point = (columns[0].item(), columns[1].item(), columns[2].item())
        found = _native.steady_at(point, start, periods)
        return Steady({"omega": point[0], "alpha": point[1], "damping_ratio": point[2], **found})
    table = shaped(_native.steady_columns(columns[0], columns[1], columns[2], start, periods), shape)
    table["regime"] = named(table["regime"], _native.REGIMES)
    table["limit"] = named(table["limit"], _native.LIMITS)
    return Steady({**_ratios(shape, columns), **table})


@overload
def simulate(
    omega: float,
    alpha: float,
    damping_ratio: float = 0.0,
    *,
    start: Start = _REST,
    cycles: float = 1.0,
    samples: None = None,
) -> Phases: ...


@overload
def simulate(
    omega: float,
    alpha: float,
    damping_ratio: float = 0.0,
    *,
    start: Start = _REST,
    cycles: float = 1.0,
    samples: int,
) -> Samples: ...


def simulate(
    omega: float,
    alpha: float,
    damping_ratio: float = 0.0,
    *,
    start: Start = _REST,
    cycles: float = 1.0,
    samples: Optional[int] = None,
) -> Union[Phases, Samples]:
    """The exact motion from a start.

    Parameters
    ----------
    omega, alpha, damping_ratio : float
        Frequency ratio, force ratio and damping ratio.
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
    point = (float(omega), float(alpha), float(damping_ratio))
    if samples is None:
        table = _native.phases(point, start, float(cycles))
        table["kind"] = named(table["kind"], _KINDS)
        table["ends_by"] = named(table["ends_by"], _ENDS)
        return Phases(table)
    if samples < 1:
        raise _native.Error(f"samples = {samples} must be >= 1")
    return Samples(_native.samples(point, start, float(cycles), int(samples)))


def decay(displacement: float, velocity: float = 0.0) -> Decay:
    """Free vibration to rest, without a drive and without a damper.

    Parameters
    ----------
    displacement : float
        At the start, in B.
    velocity : float
        At the start, in ``B sqrt(k/m)``.

    Returns
    -------
    Decay

    Examples
    --------
    >>> import stickslip as ss
    >>> ss.decay(12, 6).half_cycles
    8
    """
    return Decay(_native.decay_at(float(displacement), float(velocity)))


def _periods(max_periods: int) -> int:
    if not 1 <= max_periods < 2**32:
        raise _native.Error(f"max_periods = {max_periods} must be >= 1 and < 2**32")
    return int(max_periods)
