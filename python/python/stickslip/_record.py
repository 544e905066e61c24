"""The motion under a record: an earthquake, or any measured load."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Generic, Optional, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._drive import Quantity, read, texts
from ._native import Error
from ._physical import names_of
from ._result import Floats, Result, V, are_equal, numbers, of_type, one, points, shaped

#: The kind of the samples of each record.
_KINDS = {
    "base_acceleration": "acceleration",
    "force": "force",
    "foot_displacement": "length",
    "damped_foot_displacement": "length",
}
#: The kind of each answer; those without one are numbers.
_UNITS = {
    "max_displacement": "length",
    "max_displacement_time": "time",
    "min_displacement": "length",
    "min_displacement_time": "time",
    "peak_displacement": "length",
    "max_velocity": "velocity",
    "max_velocity_time": "time",
    "min_velocity": "velocity",
    "min_velocity_time": "time",
    "max_absolute_acceleration": "acceleration",
    "max_transmitted_force": "force",
    "end_displacement": "length",
    "end_velocity": "velocity",
    "residual_displacement": "length",
    "cut_time": "time",
    "path": "length",
    "stick_time": "time",
    "cycle_amplitude": "length",
    "equivalent_stiffness": "stiffness",
    "friction_work": "energy",
    "damper_work": "energy",
    "load_work": "energy",
}
#: Answers that do not depend on the mass, where friction is a coefficient and the damper a ratio.
_WITHOUT_MASS = tuple(name for name, kind in _UNITS.items() if kind not in ("force", "energy", "stiffness"))


@dataclass(frozen=True, init=False, eq=False)
class Record:
    """A measured load: samples, and straight lines between them.

    Parameters
    ----------
    samples : array
    time_step : float or str
        Time between the samples, the first of which is at the time 0.
    times : array
        In place of the time step: the times of the samples, in seconds, which increase.
    of : str
        ``"base_acceleration"`` of the surface that the body slides on, ``"force"`` on the body,
        ``"foot_displacement"`` of the spring's foot, or ``"damped_foot_displacement"`` if the damper stands on it, too.
    unit : str, optional
        Unit of the samples, such as ``"g"``. Without it they are in the system of units of the machine.
    after : str, optional
        The load after the last sample: ``"zero"``, ``"hold"`` (it stays at the last sample) or ``"free"`` (a foot lets go of
        the spring). By default a force or an acceleration is zero, and a foot stays.

    Examples
    --------
    >>> import stickslip as ss
    >>> ss.Record([0, -0.3, -0.3, 0], time_step=0.5, unit="g")
    Record(4 samples of base_acceleration in g, 1.5 s)
    """

    samples: Floats
    times: Floats
    of: str
    unit: Optional[str]
    after: str
    summary: Optional[dict[str, Any]] = field(default=None, compare=False)

    @classmethod
    def read(
        cls,
        file: Union[str, os.PathLike[str], bytes],
        *,
        time_step: Optional[Quantity] = None,
        column: Union[str, int, None] = None,
        skip: int = 0,
        record_units: Optional[str] = None,
        after: Optional[str] = None,
    ) -> "Record":
        """The record of a file, as ``stickslip record`` reads it: of PEER, K-NET, KiK-net, ESM, CWB, COSMOS or GeoNet, whose
        units are obeyed, or columns of text. Samples are then in SI units; ``summary`` says what was read.

        Parameters
        ----------
        file : path or bytes
        time_step : float or str, optional
            Time between samples in a file that does not state it.
        column : str or int, optional
            Column by its name or its number from 1, or the channel of an agency's file; ``"all"`` reads columns without
            names row by row.
        skip : int
            Lines before the columns to leave out.
        record_units : str, optional
            Unit of the samples in a file that does not state it, such as ``"g"``.
        after : str, optional
            The load after the last sample, as of `Record`.

        Examples
        --------
        >>> import stickslip as ss
        >>> record = ss.Record.read(b"time[s],acc[gal]\\n0,0\\n0.5,-200\\n1,100\\n")
        >>> record
        Record(3 samples of base_acceleration in m/s^2, 1 s)
        >>> record.summary["peak"], record.summary["unit"]
        (-200.0, 'cm/s²')
        """
        step = None if time_step is None else read({"time_step": (time_step, "time")}, None)[0]["time_step"]
        data = bytes(file) if isinstance(file, (bytes, bytearray, memoryview)) else None
        name = "record" if data is not None else os.fspath(file)
        named = None if column is None else str(column)
        found, summary = _native.record_read(str(name), data, step, named, skip, record_units)
        of, times, samples, unit = found
        new = object.__new__(cls)
        values = {"samples": np.array(samples), "times": np.array(times), "of": of, "unit": unit, "summary": summary}
        for name, value in values.items():
            object.__setattr__(new, name, value)
        object.__setattr__(new, "after", _native.record_check(of, new.times, new.samples, after))
        return new

    def __init__(
        self,
        samples: ArrayLike,
        *,
        time_step: Optional[Quantity] = None,
        times: Optional[ArrayLike] = None,
        of: str = "base_acceleration",
        unit: Optional[str] = None,
        after: Optional[str] = None,
    ) -> None:
        if (time_step is None) == (times is None):
            raise Error("a record needs either time_step or times")
        values = _column("samples", samples)
        if times is None:
            at = np.array([read({"time_step": (time_step, "time")}, None)[0]["time_step"]])
        else:
            at = _column("times", times)
            if len(at) == 1:
                raise Error("record: the number of samples = 1 must be >= 2")
        follows = _native.record_check(of, at, values, after)
        if unit is not None:
            _factor(of, unit, None)
        named = {"samples": values, "times": at, "of": of, "unit": unit, "after": follows, "summary": None}
        for name, value in named.items():
            object.__setattr__(self, name, value)

    def __repr__(self) -> str:
        end = self.times[0] * (len(self.samples) - 1) if len(self.times) == 1 else self.times[-1] - self.times[0]
        unit = "" if self.unit is None else f" in {self.unit}"
        return f"Record({len(self.samples)} samples of {self.of}{unit}, {end:.6g} s)"

    def __len__(self) -> int:
        return len(self.samples)

    def __eq__(self, other: object) -> bool:
        return are_equal(self, other)

    __hash__ = None  # type: ignore[assignment]

    def scaled(self, factor: float) -> "Record":
        """This record with every sample multiplied by a factor."""
        new = object.__new__(Record)
        for name in ("times", "of", "unit", "after", "summary"):
            object.__setattr__(new, name, getattr(self, name))
        object.__setattr__(new, "samples", self.samples * one("factor", factor))
        _native.record_check(new.of, new.times, new.samples, new.after)
        return new

    def _in(self, units: Optional[str]) -> tuple[str, Floats, Floats]:
        """The record for a body in a system of units."""
        factor = 1.0 if self.unit is None else _factor(self.of, self.unit, units)
        return self.of, self.times, self.samples * factor if factor != 1.0 else self.samples


def _column(name: str, values: ArrayLike) -> Floats:
    array = numbers(name, values)
    if array.ndim != 1:
        raise Error(f"{name}: must be an array of one dimension, not of shape {array.shape}")
    return np.ascontiguousarray(array)


def _factor(of: str, unit: str, units: Optional[str]) -> float:
    return read({"unit": (f"1 {unit}", _KINDS[of])}, units)[0]["unit"]


class Followed(Result):
    """The motion of a body under a record, to its rest; see `Machine.follow`.

    Attributes
    ----------
    max_displacement, max_displacement_time, min_displacement, min_displacement_time : float
    max_velocity, max_velocity_time, min_velocity, min_velocity_time : float
        Extremes and the times at which the motion has them first; NaN for one that it only tends to. With a moving
        surface, in relation to it. Displacements are from the position of the relaxed spring.
    peak_displacement : float
        Greatest displacement, regardless of sign.
    max_absolute_acceleration : float
        Greatest acceleration in space, regardless of sign.
    max_transmitted_force : float
        Greatest force of spring, damper and friction together on their support.
    end_displacement, end_velocity : float
        State at the end of the record.
    residual_displacement : float
        Displacement at rest after the record, or its limit; NaN if the body never rests.
    cut_time : float
        Time up to which a motion that never ends is followed; NaN if it ends.
    path : float
    slides, stops, reversals : int
        Slides, those that end with a rest, and those that a slide back follows at once.
    stick_time : float
        Time at rest during the record.
    cycle_amplitude, equivalent_stiffness, equivalent_damping_ratio : float
        Half the way of the longest swing from one turning point to the next, and the stiffness and the damping ratio of the
        oscillator with the forces at these points and the energy of the cycle; NaN without a swing.
    friction_work, damper_work, load_work : float
    units : dict of str to str, or None
        The unit of each value; None if the machine was given in numbers without units.
    """

    max_displacement: float
    max_displacement_time: float
    min_displacement: float
    min_displacement_time: float
    peak_displacement: float
    max_velocity: float
    max_velocity_time: float
    min_velocity: float
    min_velocity_time: float
    max_absolute_acceleration: float
    max_transmitted_force: float
    end_displacement: float
    end_velocity: float
    residual_displacement: float
    cut_time: float
    path: float
    slides: int
    stops: int
    reversals: int
    stick_time: float
    cycle_amplitude: float
    equivalent_stiffness: float
    equivalent_damping_ratio: float
    friction_work: float
    damper_work: float
    load_work: float
    units: Optional[Mapping[str, str]]


class Motion(Result):
    """States of a body under a record, and its events; see `Machine.motion`.

    Attributes
    ----------
    time, displacement, velocity, acceleration : array
        At the beginning, at each event, and between them.
    absolute_acceleration : array
        In space, where the surface moves.
    friction, transmitted_force, load : array
        Forces of friction on the body, of spring, damper and friction together on the support, and of the load on the body.
    direction : array of int
        1 or -1 while the body slides, 0 at rest.
    event_time, event_displacement : array
    event_direction : array of int
        1 or -1 for a release, 0 for a stop.
    answer : Followed
    """

    time: Floats
    displacement: Floats
    velocity: Floats
    acceleration: Floats
    absolute_acceleration: Floats
    friction: Floats
    transmitted_force: Floats
    load: Floats
    direction: NDArray[Any]
    event_time: Floats
    event_displacement: Floats
    event_direction: NDArray[Any]
    answer: Followed


class Polarities(Result):
    """The answers to a record and to its mirror image; see `Machine.polarities`.

    Attributes
    ----------
    recorded, mirrored : Followed
    polarity : str
        The record that moves the body further, by the peak displacement: ``"recorded"`` or ``"mirrored"``.
    """

    recorded: Followed
    mirrored: Followed
    polarity: str

    @property
    def greater(self) -> Followed:
        """The answers of the record that moves the body further."""
        return self.mirrored if self.polarity == "mirrored" else self.recorded


class FloorSpectrum(Result):
    """The greatest responses of linear oscillators that stand on a body; see `Machine.floor_spectrum`.

    Attributes
    ----------
    period : array
    max_displacement : array
        In relation to the body, regardless of sign.
    pseudo_acceleration : array
        ``(2*pi/period)**2`` times the displacement.
    max_absolute_acceleration : array
        Acceleration in space, regardless of sign.
    damping_ratio : float
    units : dict of str to str, or None
    """

    period: Floats
    max_displacement: Floats
    pseudo_acceleration: Floats
    max_absolute_acceleration: Floats
    damping_ratio: float
    units: Optional[Mapping[str, str]]


class Spectrum(Result, Generic[V]):
    """The answers of many bodies under a record; see `spectrum`. Each is an array, or a number for one body."""

    period: V
    friction_coefficient: V
    damping_ratio: V
    static_friction_ratio: V
    max_displacement: V
    max_displacement_time: V
    min_displacement: V
    min_displacement_time: V
    peak_displacement: V
    max_velocity: V
    max_velocity_time: V
    min_velocity: V
    min_velocity_time: V
    max_absolute_acceleration: V
    end_displacement: V
    end_velocity: V
    residual_displacement: V
    cut_time: V
    path: V
    slides: V
    stops: V
    reversals: V
    stick_time: V
    cycle_amplitude: V
    equivalent_damping_ratio: V


_Sliding = tuple[float, float, float, float, float, float, float, bool]


def _answer(found: Mapping[str, NDArray[Any]], units: Optional[str]) -> Followed:
    values: dict[str, Any] = {name: column.item() for name, column in found.items()}
    return Followed({**values, "units": names_of(units, _UNITS)})


def follow(of: _Sliding, units: Optional[str], record: Record, start: tuple[float, float]) -> Followed:
    of_type("record", record, Record)
    return _answer(_native.record_follow(of, *record._in(units), record.after, start), units)


def motion(
    of: _Sliding, units: Optional[str], record: Record, start: tuple[float, float], interval: Optional[float]
) -> Motion:
    of_type("record", record, Record)
    distance = float("nan") if interval is None else one("interval", interval)
    answer, states, events = _native.record_motion(of, *record._in(units), record.after, start, distance)
    named = {f"event_{name}": column for name, column in events.items()}
    return Motion({**states, **named, "answer": _answer(answer, units)})


def polarities(of: _Sliding, units: Optional[str], record: Record, start: tuple[float, float]) -> Polarities:
    of_type("record", record, Record)
    recorded, mirrored = (follow(of, units, load, start) for load in (record, record.scaled(-1.0)))
    is_further = mirrored.peak_displacement > recorded.peak_displacement
    polarity = "mirrored" if is_further else "recorded"
    return Polarities({"recorded": recorded, "mirrored": mirrored, "polarity": polarity})


def floor_spectrum(
    of: _Sliding,
    units: Optional[str],
    record: Record,
    start: tuple[float, float],
    period: ArrayLike,
    damping_ratio: float,
) -> FloorSpectrum:
    of_type("record", record, Record)
    periods = _column("period", np.atleast_1d(np.asarray(numbers("period", period))))
    ratio = one("damping_ratio", damping_ratio)
    found = _native.record_floor_spectrum(of, *record._in(units), record.after, start, periods, ratio)
    kinds = {
        "period": "time",
        "max_displacement": "length",
        "pseudo_acceleration": "acceleration",
        "max_absolute_acceleration": "acceleration",
    }
    return FloorSpectrum({**found, "damping_ratio": ratio, "units": names_of(units, kinds)})


@dataclass(frozen=True, init=False)
class Block:
    """A body without a spring on a surface, such as Newmark's sliding block.

    Parameters
    ----------
    mass, friction, friction_coefficient, gravity, friction_backward, damping, static_friction, static_friction_ratio
        As of a `Machine`.
    mean_force : float or str
        A constant force on the body.
    yield_acceleration : float or str
        In place of the friction, such as ``"0.1 g"``: the friction is the mass times it.
    slope : str or float
        Angle by which the surface falls in the direction of motion, such as ``"10 deg"``; a number is in radians.
    one_way : bool
        Whether the body never slides backwards.
    units : str, optional
        Units of force and length, such as ``"kN,mm"``.

    Examples
    --------
    A block under a pulse a = 0.3 g of 1 s with friction 0.1 g moves by a(a - r)t**2/(2r):

    >>> import stickslip as ss
    >>> block = ss.Block(mass="1 t", friction_coefficient=0.1)
    >>> found = block.follow(ss.Record([-0.3, -0.3], time_step="1 s", unit="g"))
    >>> round(found.residual_displacement / 9.80665, 12), found.units["residual_displacement"]
    (0.3, 'm')
    """

    units: Optional[str]
    _of: _Sliding

    def __init__(
        self,
        mass: Quantity,
        friction: Optional[Quantity] = None,
        *,
        friction_coefficient: Optional[Quantity] = None,
        yield_acceleration: Optional[Quantity] = None,
        gravity: Optional[Quantity] = None,
        friction_backward: Optional[Quantity] = None,
        damping: Optional[Quantity] = None,
        static_friction: Optional[Quantity] = None,
        static_friction_ratio: Optional[Quantity] = None,
        mean_force: Optional[Quantity] = None,
        slope: Optional[Quantity] = None,
        one_way: bool = False,
        units: Optional[str] = None,
    ) -> None:
        given = {
            "mass": mass,
            "friction": friction,
            "friction_coefficient": friction_coefficient,
            "yield_acceleration": yield_acceleration,
            "gravity": gravity,
            "friction_backward": friction_backward,
            "damping": damping,
            "static_friction": static_friction,
            "static_friction_ratio": static_friction_ratio,
            "mean_force": mean_force,
        }
        values = texts({name: value for name, value in given.items() if value is not None})
        angle = None if slope is None else texts({"slope": slope})[0][1]
        of, system = _native.block(values, units, angle, bool(one_way))
        object.__setattr__(self, "_of", of)
        object.__setattr__(self, "units", system)

    def __repr__(self) -> str:
        mass, _, damping, forward, backward, ratio, mean_force, one_way = self._of
        given = {
            "mass": mass,
            "friction": forward,
            "friction_backward": backward,
            "damping": damping,
            "static_friction_ratio": ratio,
            "mean_force": mean_force,
            "one_way": one_way,
            "units": self.units,
        }
        return f"Block({', '.join(f'{name}={value!r}' for name, value in given.items())})"

    def follow(self, record: Record, *, displacement: float = 0.0, velocity: float = 0.0) -> Followed:
        """The motion under a record from a start; see `Machine.follow`."""
        return follow(self._of, self.units, record, (one("displacement", displacement), one("velocity", velocity)))

    def motion(
        self, record: Record, *, displacement: float = 0.0, velocity: float = 0.0, interval: Optional[float] = None
    ) -> Motion:
        """The states and events of the motion under a record; see `Machine.motion`."""
        start = (one("displacement", displacement), one("velocity", velocity))
        return motion(self._of, self.units, record, start, interval)

    def polarities(self, record: Record, *, displacement: float = 0.0, velocity: float = 0.0) -> Polarities:
        """The answers to a record and to its mirror image; see `Machine.polarities`."""
        start = (one("displacement", displacement), one("velocity", velocity))
        return polarities(self._of, self.units, record, start)

    def floor_spectrum(
        self,
        record: Record,
        *,
        period: ArrayLike,
        damping_ratio: float = 0.05,
        displacement: float = 0.0,
        velocity: float = 0.0,
    ) -> FloorSpectrum:
        """The greatest responses of oscillators that stand on the block; see `Machine.floor_spectrum`."""
        start = (one("displacement", displacement), one("velocity", velocity))
        return floor_spectrum(self._of, self.units, record, start, period, damping_ratio)


@overload
def spectrum(
    record: Record,
    *,
    period: float,
    friction_coefficient: float,
    damping_ratio: float = 0.0,
    static_friction_ratio: float = 1.0,
    gravity: float = 9.80665,
) -> Spectrum[float]: ...


@overload
def spectrum(
    record: Record,
    *,
    period: ArrayLike,
    friction_coefficient: ArrayLike,
    damping_ratio: ArrayLike = 0.0,
    static_friction_ratio: ArrayLike = 1.0,
    gravity: float = 9.80665,
) -> Spectrum[Floats]: ...


def spectrum(
    record: Record,
    *,
    period: ArrayLike,
    friction_coefficient: ArrayLike,
    damping_ratio: ArrayLike = 0.0,
    static_friction_ratio: ArrayLike = 1.0,
    gravity: float = 9.80665,
) -> Spectrum[Any]:
    """The answers of many bodies on springs under a record, in SI, on all cores.

    Each body has the bits of `Machine.follow`. A record without a unit is in m/s**2 or m.

    Parameters
    ----------
    record : Record
        Of a base acceleration or of a displacement of the foot.
    period, friction_coefficient, damping_ratio, static_friction_ratio : float or array
        Natural periods in seconds and the others, broadcast to a common shape.
    gravity : float
        Of the coefficient of friction.

    Returns
    -------
    Spectrum

    Examples
    --------
    >>> import numpy as np, stickslip as ss
    >>> t = np.arange(0, 12, 0.01)
    >>> record = ss.Record(0.3 * np.exp(-(((t - 4) / 2) ** 2)) * np.sin(9 * t), time_step=0.01, unit="g")
    >>> found = ss.spectrum(record, period=np.linspace(0.5, 3, 6)[:, None], friction_coefficient=[0.02, 0.1])
    >>> found.max_displacement.shape
    (6, 2)
    """
    of_type("record", record, Record)
    if record.of == "force":
        raise Error("spectrum: a record of a force needs masses. Use Machine.follow")
    at = points(
        period=period,
        friction_coefficient=friction_coefficient,
        damping_ratio=damping_ratio,
        static_friction_ratio=static_friction_ratio,
    )
    size = at.size if at.shape is not None else 1
    # Without a body, one of any values has the names of the answers.
    given = at.columns if size else (1.0, 1.0, 0.0, 1.0)
    columns = [np.ascontiguousarray(np.broadcast_to(np.asarray(column), (max(size, 1),))) for column in given]
    periods, coefficients, zeta, eta = columns
    if not np.all((periods > 0) & np.isfinite(periods)):
        wrong = periods[~((periods > 0) & np.isfinite(periods))][0]
        raise Error(f"period = {wrong}: must be > 0 and finite")
    omega = 2 * np.pi / periods
    bodies = [np.ones_like(omega), omega**2, 2 * zeta * omega, coefficients * one("gravity", gravity), eta]
    found = {name: column[:size] for name, column in _native.record_spectrum(bodies, *record._in("N,m"), record.after).items()}
    values: dict[str, Any] = (
        {name: column.item() for name, column in found.items()} if at.shape is None else shaped(found, at.shape)
    )
    return Spectrum({**at.in_shape(), **values}, like=at.like)
