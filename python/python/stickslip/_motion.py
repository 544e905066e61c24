"""The exact motion from a start, and free vibration."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Optional, TypeVar, Union, overload

from . import _native
from ._physical import OF_SIMULATION, Driven, Scaled, names_of, related
from ._result import RATIOS, Codes, Floats, PhysicalResult, Result, Words, of_number, one, whole_number
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
    """

    _along = "start_phase"
    kind: Words
    ends_by: Words
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
        Friction force in units of the kinetic friction: -1 or 1 while the body slides.
    """

    _along = "phase"
    _rows = {
        "phase": ("rad", "Phase of the drive"),
        "displacement": ("B", "Displacement"),
        "velocity": ("B ω_d", "Velocity"),
        "friction": ("r_y", "Friction, with the sign of the velocity"),
    }
    phase: Floats
    displacement: Floats
    velocity: Floats
    friction: Floats

    def loop(self, *, spring: bool = False) -> tuple[Floats, Floats]:
        """The hysteresis loop: displacements, and the force against friction, with that of the spring if asked.

        >>> import stickslip as ss
        >>> x, force = ss.steady(0.7, 3).waveform(1000).loop()
        >>> area = ((force[1:] + force[:-1]) / 2 * (x[1:] - x[:-1])).sum()
        >>> round(float(area), 1), round(ss.steady(0.7, 3).energy_out, 1)
        (22.4, 22.4)
        """
        force = self.friction
        return self.displacement, force + self.displacement if spring else force


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
    """

    half_cycles: int
    first_turn: float
    rest_position: float
    path: float
    rest_time: float


class MachinePhases(PhysicalResult):
    """The motion of a machine segment by segment; see `Machine.simulate` and `Phases`."""

    _along = "start_time"
    kind: Words
    ends_by: Words
    start_phase: Floats
    start_time: Floats
    end_phase: Floats
    end_time: Floats
    duration: Floats
    start_displacement: Floats
    start_velocity: Floats
    end_displacement: Floats
    mean_displacement: float
    _ratios: Phases

    @property
    def ratios(self) -> Phases:
        """The same motion in ratios."""
        return self._ratios

    @classmethod
    def of(cls, found: Phases, driven: Driven) -> "MachinePhases":
        return _in_units(cls, found, driven)


class MachineSamples(PhysicalResult):
    """The motion of a machine at equal distances of time; see `Machine.simulate` and `MachineSteady.waveform`.

    Displacements are measured from ``mean_displacement``, the shift due to a mean force or to friction that depends on the
    direction.
    """

    _along = "time"
    _rows = {
        "phase": ("rad", "Phase of the drive"),
        "time": ("", "Time"),
        "displacement": ("", "Displacement"),
        "velocity": ("", "Velocity"),
        "friction_force": ("", "Friction, with the sign of the velocity"),
        "mean_displacement": ("", "Displacement from which the others are measured"),
    }
    time: Floats
    phase: Floats
    displacement: Floats
    velocity: Floats
    friction_force: Floats
    mean_displacement: float
    _ratios: Samples
    _driven: Driven

    @property
    def ratios(self) -> Samples:
        """The same samples in ratios."""
        return self._ratios

    @classmethod
    def of(cls, found: Samples, driven: Driven) -> "MachineSamples":
        return _in_units(cls, found, driven)

    def loop(self, *, spring: bool = False) -> tuple[Floats, Floats]:
        """The hysteresis loop: displacements, and the force against friction, with that of the spring if asked."""
        stiffness = float(self._driven.at.given["stiffness"])
        force = self.friction_force
        return self.displacement, force + stiffness * self.displacement if spring else force


class MachineDecay(PhysicalResult):
    """Free vibration of a machine to rest, in its units; see `Machine.decay` and `Decay`."""

    half_cycles: int
    first_turn: float
    rest_position: float
    path: float
    rest_time: float
    _ratios: Decay

    @property
    def ratios(self) -> Decay:
        """The same motion in ratios."""
        return self._ratios


_M = TypeVar("_M", bound=PhysicalResult)


def _in_units(kind: type[_M], found: Result, driven: Driven) -> _M:
    """A motion in the units of a machine."""
    sources = {own: name for name, (own, _, _) in OF_SIMULATION.items()}
    scaled = Scaled(found, driven, {**{name: name for name in kind._names}, **sources})
    kinds = {own: of for own, _, of in OF_SIMULATION.values() if own in kind._names}
    units = names_of(driven.units, {**kinds, "mean_displacement": "length"})
    values = {name: scaled.value(name) for name in kind._names if name not in ("kind", "ends_by")}
    words: dict[str, Any] = {name: found._values[name] for name in ("kind", "ends_by") if name in kind._names}
    if units is not None:
        units |= {name: "rad" for name in kind._names if name.endswith("phase")}
    return related(kind({**words, **values}, units=units), found, driven)


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
        table: dict[str, Any] = _native.phases(point, state(start), of_number("cycles", cycles))
        table["kind"] = Codes(table["kind"], _KINDS)
        table["ends_by"] = Codes(table["ends_by"], _ENDS)
        return Phases(table)
    return sampled(point, state(start), of_number("cycles", cycles), whole_number("samples", samples))


def sampled(point: Sequence[float], start: Start, cycles: float, per_cycle: int, whole_turns: bool = False) -> Samples:
    """The samples of a motion from its start, or from the next whole turn of the drive."""
    return Samples(_native.samples(point, start, cycles, per_cycle, whole_turns))


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
