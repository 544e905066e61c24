"""The exact motion from a start, and free vibration."""

from __future__ import annotations

from typing import Any, ClassVar, Optional, Sequence, Union, overload

from numpy.typing import NDArray

from . import _native
from ._closed_forms import RATIOS
from ._result import Codes, Floats, Physical, Result, one
from ._start import REST, Start, state

_KINDS = ("slide-forward", "slide-backward", "stick")
_ENDS = ("reversal", "stop", "grazing", "release", "never")


class Phases(Result):
    """The motion segment by segment, one row for each slide and stop; see `simulate`.

    Attributes
    ----------
    kind : array of str
        ``"slide-forward"``, ``"slide-backward"`` or ``"stick"``.
    ends_by : array of str
        ``"reversal"``, ``"stop"``, ``"grazing"``, ``"release"`` or ``"never"``.
    start_phase, end_phase, duration : array
        In radians of the drive; NaN for a segment that never ends.
    start_displacement, start_velocity, end_displacement : array
        In B and B w.
    physical : Physical or None
        The times, displacements and velocities in the machine's units; None without a machine.
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
        "physical",
    )

    kind: NDArray[Any]
    ends_by: NDArray[Any]
    start_phase: Floats
    end_phase: Floats
    duration: Floats
    start_displacement: Floats
    start_velocity: Floats
    end_displacement: Floats
    physical: Optional[Physical]


class Samples(Result):
    """The motion at evenly spaced phases; see `simulate`.

    Attributes
    ----------
    phase : array
        Radians of the drive.
    displacement, velocity : array
        In B and B w.
    friction : array
        Friction force in units of the kinetic friction: -1 or 1 while the body slides.
    physical : Physical or None
        Time, displacement, velocity and friction force in the machine's units; None without a machine.
    """

    _names: ClassVar[Sequence[str]] = ("phase", "displacement", "velocity", "friction", "physical")

    phase: Floats
    displacement: Floats
    velocity: Floats
    friction: Floats
    physical: Optional[Physical]


class Decay(Result):
    """Free vibration to rest; see `decay`.

    Attributes
    ----------
    half_cycles : int
        Half cycles of sliding until rest, counted from the start.
    first_turn, rest_position : float
        Displacements at the first turning point and at rest (B).
    rest_time : float or None
        Time until rest, in units of ``sqrt(m/k)``; None if the body creeps for ever.
    physical : Physical or None
        The same outputs in the machine's units; None without a machine.
    """

    _names: ClassVar[Sequence[str]] = ("half_cycles", "first_turn", "rest_position", "rest_time", "physical")

    half_cycles: int
    first_turn: float
    rest_position: float
    rest_time: Optional[float]
    physical: Optional[Physical]


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
        Frequency ratio, force ratio, damping ratio, and ratio of static to kinetic friction.
    start : (phase, displacement, velocity)
        In radians of the drive, B and B w; at rest by default.
    cycles : float
        Drive cycles to follow, > 0.
    samples : int, optional
        Samples in a cycle. Without it, the segments of the motion are returned.

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
        Ratio of static to kinetic friction, >= 1. A larger ratio holds the body at rest at larger displacements.

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
