"""Results of design questions, identification, and figures."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, NamedTuple, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._drive import Quantity, angular_of, in_system, of_kind, read, stand_in
from ._help import brief
from ._labels import Like, aligned, is_labelled
from ._native import Error
from ._record import Record
from ._quantity import parted
from ._result import Floats, of_type

#: Names of the figures that `figure` draws.
FIGURES: tuple[str, ...] = tuple(_native.FIGURES)


@brief
class Band(NamedTuple):
    """A band of frequency in which the body does not stick, both ends included, in the unit of the requested range."""

    low: float
    high: float
    #: Whether the lower end is that of the requested range, rather than a border.
    low_is_end_of_range: bool
    high_is_end_of_range: bool


@brief
class BestFriction(NamedTuple):
    """The friction force that dissipates most: numbers, or arrays for several machines or drives."""

    friction: Any
    #: The energy that friction dissipates in a cycle.
    energy: Any
    #: ``"interior"``, ``"border"`` where more friction would make the body stick, or ``"sticking"`` where the body stops.
    optimum: Any


@brief
class BestStiffness(NamedTuple):
    """The stiffness that dissipates most without sticking; see `Machine.best_stiffness`."""

    stiffness: float
    #: The energy that friction dissipates in a cycle.
    energy: float
    #: ``"interior"``, ``"border"`` where another stiffness would make the body stick, or ``"range-end"``.
    optimum: str


@brief
class TargetFriction(NamedTuple):
    """A friction force with which the steady motion has a given displacement; see `Machine.frictions_for_displacement`."""

    friction: float
    regime: str
    max_displacement: float


@brief
class BandFriction(NamedTuple):
    """The friction force whose greatest amplitude over a band is least; see `Machine.best_friction_over`."""

    friction: float
    #: The greatest amplitude over the band.
    greatest: float
    #: The ranges of frequency that have it, in the unit of the band; a single frequency has two equal ends.
    at: list[tuple[float, float]]
    #: ``"interior"``; ``"none"`` where less friction is always better; ``"rest"`` where the body had better rest.
    optimum: str
    #: The friction from which on the body rests in the whole band.
    rest_friction: float
    #: The greatest friction up to which every one is as good; at least `rest_friction` where every greater one is, too. None
    #: where the optimum is a single friction.
    up_to: Optional[float] = None


@brief
class Estimate(NamedTuple):
    """An estimate from measurements."""

    value: float
    standard_error: float
    #: The 95 % confidence interval.
    interval: tuple[float, float]


def _in_hertz(angular: Optional[Estimate]) -> Optional[Estimate]:
    if angular is None:
        return None
    value, error, (low, high) = (np.array(part) / (2 * np.pi) for part in angular)
    return Estimate(float(value), float(error), (float(low), float(high)))


@brief
class Identified(NamedTuple):
    """Friction and damping from a measured response curve; see `identify`."""

    friction: Estimate
    damping_ratio: Estimate
    #: Relative standard error of one amplitude, estimated from the residuals.
    noise: float
    #: Measured minus computed amplitude, relative to the measured one.
    residuals: Floats
    #: Standard error of one phase in radians; None without phases.
    phase_noise: Optional[float]
    #: Measured minus computed phase in radians; NaN where it was not measured.
    phase_residuals: Floats
    #: Whether the amplitude or the phase was left out because the other measurements contradict it.
    suspect: NDArray[np.bool_]
    #: Whether the body stops in each cycle of the computed motion.
    stops: NDArray[np.bool_]
    #: The kind of phase that the curve was read with; None without phases.
    phase_kind: Optional[str]
    #: The kind of amplitude that fits better by more than chance, if any.
    better_amplitude_kind: Optional[str]
    #: Natural angular frequency in radians per second, where no stiffness was given.
    natural_angular_frequency: Optional[Estimate] = None
    #: Amplitude of the force, where it was not given.
    force: Optional[Estimate] = None
    #: Whether the search for other minima came to its end.
    search_is_complete: bool = True

    @property
    def natural_frequency(self) -> Optional[Estimate]:
        """Natural frequency in hertz, where no stiffness was given."""
        return _in_hertz(self.natural_angular_frequency)


@brief
class DecayIdentified(NamedTuple):
    """Friction and damping from a free decay; see `identify_decay`."""

    #: Friction force over stiffness, in the unit of the displacements.
    friction_displacement: Estimate
    damping_ratio: Estimate
    #: The first amplitude.
    amplitude: Estimate
    #: Natural angular frequency in radians per second; None without times.
    natural_angular_frequency: Optional[Estimate]
    #: Standard error of one displacement, estimated from the residuals.
    noise: float
    #: The turning points from the rest of the spring, and their times; NaN without times.
    turning_points: Floats
    times: Floats
    #: Measured minus computed displacements.
    residuals: Floats

    @property
    def natural_frequency(self) -> Optional[Estimate]:
        """Natural frequency in hertz; None without times."""
        return _in_hertz(self.natural_angular_frequency)


@brief
class MotionIdentified(NamedTuple):
    """Friction and damping from a measured load and the motion under it; see `identify_motion`."""

    friction: Estimate
    damping_ratio: Estimate
    #: The constant of the damper.
    damping: Estimate
    #: Friction bound over stiffness.
    friction_displacement: Estimate
    #: The displacement, as it was measured, at which the spring is relaxed under no load.
    offset: Estimate
    start_displacement: Estimate
    #: None where the body starts at rest.
    start_velocity: Optional[Estimate]
    #: None where it was given.
    stiffness: Optional[Estimate]
    #: Standard error of one displacement, estimated from the residuals.
    noise: float
    #: Measured minus computed displacements.
    residuals: Floats


@brief
class Figure(NamedTuple):
    """A figure that a notebook displays."""

    title: str
    caption: str
    svg: str

    def _repr_svg_(self) -> str:
        return self.svg


def identify(
    mass: Quantity,
    stiffness: Optional[Quantity] = None,
    force: Optional[Quantity] = None,
    *,
    amplitude: ArrayLike,
    phase: Optional[ArrayLike] = None,
    frequency: Optional[ArrayLike] = None,
    angular_frequency: Optional[ArrayLike] = None,
    amplitude_kind: str = "peak",
    phase_kind: Optional[str] = None,
    units: Optional[str] = None,
) -> Identified:
    """Friction force and damping ratio from a measured response curve, by robust least squares.

    Motion with stops counts, too. Wrong values do not move the answer: they are left out and marked as suspect. Points that
    are NaN or masked are left out, and have NaN among the residuals.

    Parameters
    ----------
    mass, stiffness, force : float or str
        Mass and stiffness of the machine, and amplitude of the harmonic force, with or without units. Without the stiffness
        the natural frequency is found, too; without the force, its amplitude. A stiffness of 0 is a body without a spring, whose
        ``damping_ratio`` is c/(2 m ω), ω the lowest frequency of the curve.
    amplitude : array
        The amplitude of the displacement measured at each frequency.
    frequency, angular_frequency : array
        The frequencies, in hertz or in radians per second: one of the two. Series are aligned by their labels.
    phase : array, optional
        Phases in radians, from -2π to 2π; NaN where they were not measured.
    amplitude_kind : str
        ``"peak"`` (half of peak to peak), ``"peak-to-peak"`` or ``"rms"``.
    phase_kind : str, optional
        ``"peak"``, ω_d t of the peak displacement under the force p₀ sin ω_d t; ``"lag"``, of the fundamental of the
        displacement behind the force; ``"transfer-function"``, that lag with a minus sign. The default is the kind
        that fits best.
    units : str, optional
        The system of units of bare numbers, such as ``"kN,mm"``; it is required if other values have units.

    Returns
    -------
    Identified

    Examples
    --------
    >>> import numpy as np, stickslip as ss
    >>> machine = ss.Machine(mass=2.0, stiffness=800.0, friction=3.0, damping_ratio=0.05)
    >>> frequency = machine.natural_frequency * np.linspace(0.7, 1.4, 20)
    >>> measured = machine.response(ss.Drive(force=9.0, frequency=frequency)).max_displacement
    >>> found = ss.identify(2.0, 800.0, 9.0, frequency=frequency, amplitude=measured)
    >>> round(found.friction.value, 6), round(found.damping_ratio.value, 6)
    (3.0, 0.05)
    >>> found = ss.identify(2.0, force=9.0, frequency=frequency, amplitude=measured)
    >>> round(found.natural_frequency.value / machine.natural_frequency, 6), round(found.friction.value, 4)
    (1.0, 3.0)
    """
    if stiffness is None and force is None:
        raise Error("give the stiffness or the force: one of them can be found")
    angular = angular_of(frequency, angular_frequency)
    sizes, unit = parted("amplitude", amplitude)
    given = {"angular_frequency": angular, "amplitude": in_system("amplitude", sizes, unit, "length", units), "phase": of_kind("phase", phase, "angle")}
    columns, like = _curve({name: column for name, column in given.items() if column is not None})
    is_there = np.isfinite(columns["amplitude"]) & np.isfinite(columns["angular_frequency"])
    # The first amplitude stands for the columns when units are checked. The friction force is the unknown, so that
    # its value here has no effect.
    texts = {"mass": (mass, "mass"), "stiffness": (stiffness, "stiffness"), "force": (force, "force")}
    texts = {name: value for name, value in texts.items() if value[0] is not None}
    first = {"amplitude": (stand_in(unit, float(columns["amplitude"][is_there][0])), "length")} if is_there.any() else {}
    values, _ = read({**texts, **first}, units)
    body = (values["mass"], values.get("stiffness", math.nan), 1.0, math.nan, 0.0, 1.0)
    measured = [np.ascontiguousarray(column[is_there]) for column in columns.values()]
    angular, sizes, *phases = measured
    found = _native.identify(body, values.get("force"), angular, sizes, phases[0] if phases else None, amplitude_kind, phase_kind)

    def placed(values: Any, none: Any) -> Any:
        column = np.full(is_there.shape, none)
        column[is_there] = values
        return column if like is None else like.dressed("residuals", column, {})

    natural, fitted = found.get("natural_angular_frequency"), found.get("force")
    return Identified(
        friction=Estimate(*found["friction"]),
        damping_ratio=Estimate(*found["damping_ratio"]),
        noise=found["noise"],
        residuals=placed(found["residuals"], np.nan),
        phase_noise=found["phase_noise"],
        phase_residuals=placed(found["phase_residuals"], np.nan),
        suspect=placed(found["suspect"], False),
        stops=placed(found["stops"], False),
        phase_kind=found["phase_kind"],
        better_amplitude_kind=found["better_amplitude_kind"],
        search_is_complete=found["search_is_complete"],
        natural_angular_frequency=None if natural is None else Estimate(*natural),
        force=None if fitted is None else Estimate(*fitted),
    )


def _curve(given: Mapping[str, Any]) -> tuple[dict[str, Floats], Optional[Like]]:
    """The columns of a curve, aligned by their labels, and how columns of results are dressed."""
    columns, like = aligned(given)
    shapes = {name: column.shape for name, column in columns.items()}
    if any(len(shape) != 1 for shape in shapes.values()):
        name, shape = next((name, shape) for name, shape in shapes.items() if len(shape) != 1)
        raise Error(f"{name}: must be an array of one dimension, not of shape {shape}")
    if len(set(shapes.values())) != 1:
        raise Error(f"columns of the curve have different lengths: {', '.join(f'{name} {shape[0]}' for name, shape in shapes.items())}")
    return {name: np.ascontiguousarray(column) for name, column in columns.items()}, like


def identify_decay(
    displacement: ArrayLike, time: Optional[ArrayLike] = None, *, every: Optional[str] = None
) -> DecayIdentified:
    """Friction and damping from a free vibration that comes to rest, by least squares.

    A damper removes a fixed fraction per cycle, friction a fixed amount; four peaks tell them apart.

    Parameters
    ----------
    displacement : array
        The sampled displacement from any zero, or with ``every`` the turning points from the rest of the spring. One with a
        unit is converted to metres.
    time : array, optional
        The times in seconds, which samples need. Series are aligned by their labels; samples that are NaN or masked are left
        out.
    every : str, optional
        ``"cycle"`` for the peaks of one side, ``"half-cycle"`` for those of both sides, with their signs or without.

    Returns
    -------
    DecayIdentified

    Examples
    --------
    >>> import stickslip as ss
    >>> found = ss.identify_decay([40, 33.1, 26.5, 20.2, 14.1], every="cycle")
    >>> round(found.friction_displacement.value, 3), round(found.damping_ratio.value, 4)
    (1.337, 0.0067)
    """
    given = {"displacement": of_kind("displacement", displacement, "length")}
    columns, like = _curve({**given, **({} if time is None else {"time": of_kind("time", time, "time")})})
    if time is None and every is None:
        raise Error('give the times of samples, or every="cycle" or every="half-cycle" for turning points')
    is_there = np.all([np.isfinite(column) for column in columns.values()], axis=0)
    if every is not None and not is_there.all():
        raise Error("displacement: turning points that are NaN or masked cannot be left out, because they are counted")
    values, *times = (np.ascontiguousarray(column[is_there]) for column in columns.values())
    found = _native.identify_decay(values, times[0] if times else None, every)
    natural = found["natural_frequency"]
    residuals: Any = np.array(found["residuals"])
    if residuals.shape == values.shape:
        placed = np.full(is_there.shape, np.nan)
        placed[is_there] = residuals
        residuals = placed if like is None else like.dressed("residuals", placed, {})
    return DecayIdentified(
        friction_displacement=Estimate(*found["friction_displacement"]),
        damping_ratio=Estimate(*found["damping_ratio"]),
        amplitude=Estimate(*found["amplitude"]),
        natural_angular_frequency=None if natural is None else Estimate(*natural),
        noise=found["noise"],
        turning_points=np.array(found["turning_points"]),
        times=np.array(found["times"]),
        residuals=residuals,
    )


def identify_motion(
    mass: Quantity,
    stiffness: Optional[Quantity] = None,
    *,
    record: Record,
    displacement: ArrayLike,
    units: Optional[str] = None,
) -> MotionIdentified:
    """Friction bound and damping ratio from a measured load and the motion under it, by least squares.

    The motion may stop or not, and begin at rest or not. Friction is one, static and kinetic. The load counts as exact, and the
    errors of the displacements as normal; where neighbouring ones are alike, the intervals are wider.

    Parameters
    ----------
    mass, stiffness : float or str
        Mass and stiffness of the machine, with or without units. Without the stiffness it is found, too.
    record : Record
        The load: a force, the acceleration of the base, or the motion of the spring's support.
    displacement : array
        The displacement at the time of each sample of the record, from any zero; with a moving base in relation to it.
    units : str, optional
        The system of units of bare numbers, such as ``"kN,mm"``; it is required if other values have units.

    Returns
    -------
    MotionIdentified
        In the system of units.

    Examples
    --------
    >>> import numpy as np, stickslip as ss
    >>> machine = ss.Machine(mass=2.0, stiffness=800.0, friction=3.0, damping_ratio=0.03)
    >>> time = np.arange(0, 2, 0.02)
    >>> record = ss.Record(9 * np.sin(15 * time) + 5 * np.sin(23 * time), time_step=0.02, of="force")
    >>> motion = machine.motion(record)
    >>> measured = np.interp(time, motion.time, motion.displacement)
    >>> found = ss.identify_motion(2.0, 800.0, record=record, displacement=measured)
    >>> round(found.friction.value, 4), round(found.damping_ratio.value, 4)
    (3.0, 0.03)
    >>> round(ss.identify_motion(2.0, record=record, displacement=measured).stiffness.value, 1)
    800.0
    """
    of_type("record", record, Record)
    found, unit = parted("displacement", displacement)
    columns, like = _curve({"displacement": in_system("displacement", found, unit, "length", units)})
    values = columns["displacement"]
    if is_labelled(displacement) and hasattr(displacement, "index"):
        labelled: Any = displacement
        index = labelled.index
        if index.dtype.kind in "f" and index.name is not None and not np.array_equal(index, record.times):
            raise Error("displacement: its labels must be the times of the record")
    if not np.isfinite(values).all():
        raise Error("displacement: must have a number for each sample of the record; one is NaN, masked or infinite")
    if len(values) != len(record):
        raise Error(f"displacement: must have {len(record)} values, one for each sample of the record, not {len(values)}")
    # The greatest displacement stands for all when units are checked.
    texts = {"mass": (mass, "mass"), "displacement": (stand_in(unit, float(np.max(np.abs(values)))), "length")}
    if stiffness is not None:
        texts["stiffness"] = (stiffness, "stiffness")
    body, system = read(texts, units)
    of, times, samples = record._in(system, True, "the mass")
    found = _native.identify_motion(body["mass"], body.get("stiffness"), (of, times, samples), values)
    start, spring = found["start_velocity"], found["stiffness"]
    residuals: Any = np.array(found["residuals"])
    return MotionIdentified(
        **{name: Estimate(*found[name]) for name in ("friction", "damping_ratio", "damping", "friction_displacement", "offset")},
        start_displacement=Estimate(*found["start_displacement"]),
        start_velocity=None if start is None else Estimate(*start),
        stiffness=None if spring is None else Estimate(*spring),
        noise=found["noise"],
        residuals=residuals if like is None else like.dressed("residuals", residuals, {}),
    )


def figure(name: str) -> Figure:
    """A figure of the source paper or of this package, one of `FIGURES`.

    >>> import stickslip as ss
    >>> ss.figure("8").svg.startswith("<svg")
    True
    """
    return Figure(*_native.figure(str(name)))
