"""The exact motion from a start, and free vibration."""

from __future__ import annotations

from typing import Any, Optional, Union, overload

from . import _native
from ._result import RATIOS, Codes, Floats, Physical, PhysicalResult, Result, Words, one, whole_number
from ._start import REST, Start, state

_KINDS = ("slide-forward", "slide-backward", "stick")
_ENDS = ("reversal", "stop", "grazing", "release", "never")


class PhysicalPhases(Physical[float]):
    """The segments of a motion in the machine's units."""

    start_time: Floats
    end_time: Floats
    duration: Floats
    start_displacement: Floats
    start_velocity: Floats
    end_displacement: Floats


class PhysicalSamples(Physical[float]):
    """The samples of a motion in the machine's units."""

    time: Floats
    displacement: Floats
    velocity: Floats
    friction_force: Floats


class PhysicalDecay(PhysicalResult):
    """Free vibration to rest in the machine's units."""

    first_turn: float
    rest_position: float
    path: float
    rest_time: float


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
    physical : of a machine alone
        The same in the machine's units.
    """

    kind: Words
    ends_by: Words
    start_phase: Floats
    end_phase: Floats
    duration: Floats
    start_displacement: Floats
    start_velocity: Floats
    end_displacement: Floats
    _physical: Optional[PhysicalPhases]

    @property
    def physical(self) -> PhysicalPhases:
        if self._physical is None:
            raise AttributeError("physical")
        return self._physical


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
    physical : of a machine alone
        The same in the machine's units.
    """

    phase: Floats
    displacement: Floats
    velocity: Floats
    friction: Floats
    _physical: Optional[PhysicalSamples]

    @property
    def physical(self) -> PhysicalSamples:
        if self._physical is None:
            raise AttributeError("physical")
        return self._physical


class Decay(Result):
    """Free vibration to rest; see `decay`.

    Attributes
    ----------
    half_cycles : int
        Half cycles of sliding until rest, counted from the start.
    first_turn, rest_position : float
        Displacements at the first turning point and at rest (B).
    path : float
        Length of the path to rest (B).
    rest_time : float
        Time until rest, in units of ``sqrt(m/k)``; NaN if the body creeps for ever.
    physical : of a machine alone
        The same in the machine's units.
    """

    half_cycles: int
    first_turn: float
    rest_position: float
    path: float
    rest_time: float
    _physical: Optional[PhysicalDecay]

    @property
    def physical(self) -> PhysicalDecay:
        if self._physical is None:
            raise AttributeError("physical")
        return self._physical


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
    number = whole_number("samples", samples)
    return Samples(_native.samples(point, state(start), one("cycles", cycles), number))


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
