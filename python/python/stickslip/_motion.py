"""The exact motion from a start, and free vibration."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Generic, Optional, TypeVar, Union, overload

import numpy as np
from numpy.typing import ArrayLike

from . import _native
from ._labels import Like, Labelled, module
from ._native import Error
from ._physical import OF_SIMULATION, Driven, Scaled, names_of, related
from ._result import RATIOS, Codes, Floats, PhysicalResult, Points, Result, V, Words, of_number, one, points, shaped, whole_number
from ._start import REST, STATE, Start, Starts, state, three

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
    """The motion at evenly spaced phases; see `simulate`. Of several points the last axis of each value but the phase is that of the phases.

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


class Decay(Result, Generic[V]):
    """Free vibration to rest; see `decay`. Of several starts each value is an array.

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

    _rows = {
        "half_cycles": ("", "Half cycles of sliding until rest"),
        "first_turn": ("B", "Displacement at the first turning point"),
        "rest_position": ("B", "Displacement at rest"),
        "path": ("B", "Length of the path to rest"),
        "rest_time": ("√(m/k)", "Time until rest"),
    }
    half_cycles: V
    first_turn: V
    rest_position: V
    path: V
    rest_time: V


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
        "time": ("time", "Time"),
        "displacement": ("length", "Displacement"),
        "velocity": ("velocity", "Velocity"),
        "friction_force": ("force", "Friction, with the sign of the velocity"),
        "mean_displacement": ("length", "Displacement from which the others are measured"),
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
        stiffness: Any = self._driven.at.given["stiffness"]
        stiffness = stiffness[..., None] if stiffness.ndim else float(stiffness)
        force = self.friction_force
        return self.displacement, force + stiffness * self.displacement if spring else force


class MachineDecay(PhysicalResult, Generic[V]):
    """Free vibration of a machine to rest, in its units; see `Machine.decay` and `Decay`."""

    half_cycles: V
    first_turn: V
    rest_position: V
    path: V
    rest_time: V
    _ratios: Decay[V]

    @property
    def ratios(self) -> Decay[V]:
        """The same motion in ratios."""
        return self._ratios


_M = TypeVar("_M", bound=PhysicalResult)


def _in_units(kind: type[_M], found: Result, driven: Driven) -> _M:
    """A motion in the units of a machine."""
    sources = {own: name for name, (own, _, _) in OF_SIMULATION.items()}
    shape = driven.at.shape
    if shape is not None:
        # The last axis is that of the phases.
        given = {name: array[..., None] if array.ndim else array for name, array in driven.at.given.items()}
        found_in = driven._replace(at=Points((*shape, 1), given, None))
    else:
        found_in = driven
    scaled = Scaled(found, found_in, {**{name: name for name in kind._names}, **sources})
    kinds = {own: of for own, _, of in OF_SIMULATION.values() if own in kind._names}
    units = names_of(driven.units, {**kinds, "mean_displacement": "length"})
    values = {name: scaled.value(name) for name in kind._names if name not in ("kind", "ends_by")}
    if shape is not None:
        values["mean_displacement"] = values["mean_displacement"][..., 0]
    words: dict[str, Any] = {name: found._values[name] for name in ("kind", "ends_by") if name in kind._names}
    if units is not None:
        units |= {name: "rad" for name in kind._names if name.endswith("phase")}
    return related(kind({**words, **values}, units=units, like=found._like), found, driven)


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
    omega: Union[ArrayLike, Labelled],
    alpha: Union[ArrayLike, Labelled],
    damping_ratio: Union[ArrayLike, Labelled] = 0.0,
    static_friction_ratio: Union[ArrayLike, Labelled] = 1.0,
    *,
    start: Starts = REST,
    cycles: float = 1.0,
    samples: int,
) -> Samples: ...


def simulate(
    omega: Any,
    alpha: Any,
    damping_ratio: Any = 0.0,
    static_friction_ratio: Any = 1.0,
    *,
    start: Any = REST,
    cycles: float = 1.0,
    samples: Optional[int] = None,
) -> Union[Phases, Samples]:
    """The exact motion from a start.

    Parameters
    ----------
    omega, alpha, damping_ratio, static_friction_ratio : float or array
        Frequency ratio, force ratio, damping ratio, and ratio of static to kinetic friction. Arrays need ``samples``; a point outside the
        domain has NaN then.
    start : (phase, displacement, velocity)
        In radians of the drive, B and B w; at rest by default. The displacement and the velocity may be arrays.
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
    >>> ss.simulate([0.4, 0.7], 6, samples=4).displacement.shape
    (2, 5)
    """
    given = (omega, alpha, damping_ratio, static_friction_ratio)
    at = points(**dict(zip(RATIOS, given)), **dict(zip(STATE, three(start))))
    if at.shape is not None:
        return samples_of(at, cycles, samples)
    point = tuple(one(name, value) for name, value in zip(RATIOS, given))
    if samples is None:
        table: dict[str, Any] = _native.phases(point, state(start), of_number("cycles", cycles))
        table["kind"] = Codes(table["kind"], _KINDS)
        table["ends_by"] = Codes(table["ends_by"], _ENDS)
        return Phases(table)
    return sampled(point, state(start), of_number("cycles", cycles), whole_number("samples", samples))


def samples_of(at: Points, cycles: Any, samples: Any) -> Samples:
    """The samples of the motions at many points, with their starts."""
    if samples is None:
        raise Error("samples: must be given with arrays, because the phases of each motion are others")
    if at.given[STATE[0]].size != 1:
        raise Error(f"{STATE[0]}: must be one number with arrays, because the samples are at common phases")
    *ratios, phase, x, v = at.columns
    shape, like = at.shape or (), at.like
    start_phase = float(np.asarray(phase).reshape(-1)[0])
    found = _native.samples_of_each(ratios, at.size, start_phase, (x, v), of_number("cycles", cycles), whole_number("samples", samples))
    phases = found.pop("phase")
    whole = (*shape, phases.size)
    if like is not None and like.dims:
        like = Like(whole, dims=(*like.dims, "phase"), coords={**like.coords, "phase": phases})
    elif like is not None and like.axes and len(like.axes) == len(shape) == 1:
        like = Like(whole, axes=(*like.axes, module("pandas").Index(phases, name="phase")))
    else:
        like = Like(whole)
    return Samples({"phase": phases, **shaped(found, whole)}, like=like)


def sampled(point: Sequence[float], start: Start, cycles: float, per_cycle: int, whole_turns: bool = False) -> Samples:
    """The samples of a motion from its start, or from the next whole turn of the drive."""
    return Samples(_native.samples(point, start, cycles, per_cycle, whole_turns))


@overload
def decay(
    displacement: float, velocity: float = 0.0, damping_ratio: float = 0.0, static_friction_ratio: float = 1.0
) -> Decay[float]: ...


@overload
def decay(
    displacement: Union[ArrayLike, Labelled],
    velocity: Union[ArrayLike, Labelled] = 0.0,
    damping_ratio: Union[ArrayLike, Labelled] = 0.0,
    static_friction_ratio: Union[ArrayLike, Labelled] = 1.0,
) -> Decay[Any]: ...


def decay(
    displacement: Any,
    velocity: Any = 0.0,
    damping_ratio: Any = 0.0,
    static_friction_ratio: Any = 1.0,
) -> Decay[Any]:
    """Free vibration to rest, without a drive.

    Parameters
    ----------
    displacement : float or array
        At the start, in B.
    velocity : float or array
        At the start, in ``B sqrt(k/m)``.
    damping_ratio : float or array
        Damping ratio of a viscous damper, >= 0.
    static_friction_ratio : float or array
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
    >>> ss.decay([12, 20], damping_ratio=0.05).half_cycles
    array([4., 6.])
    """
    given = {
        "displacement": displacement,
        "velocity": velocity,
        "damping_ratio": damping_ratio,
        "static_friction_ratio": static_friction_ratio,
    }
    return decay_of(points(**given))


def decay_of(at: Points) -> Decay[Any]:
    """Free vibrations from displacements and velocities, with damping ratios and static friction ratios."""
    found: dict[str, Any] = _native.decays(at.columns, at.size, at.shape is None)
    if at.shape is None:
        found = {name: column.item() for name, column in found.items()}
        return Decay({**found, "half_cycles": int(found["half_cycles"])})
    return Decay(shaped(found, at.shape), like=at.like)
