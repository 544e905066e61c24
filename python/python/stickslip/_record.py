"""The motion under a record: an earthquake, or any measured load."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Generic, NamedTuple, NoReturn, Optional, TypeVar, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._drive import INPUTS, Quantity, in_system, is_array, kept, of_kind, read, stand_in, system_of, text, texts, values_of
from ._labels import WrongType, aligned, is_labelled, module, numbers, shape_of, unreadable
from ._native import Error
from ._physical import names_of
from ._quantity import parted
from ._result import (
    Floats,
    Frozen,
    Meaning,
    PhysicalResult,
    Points,
    Result,
    V,
    Value,
    are_equal,
    of_number,
    of_type,
    one,
    points,
    read_only,
    short,
)

if TYPE_CHECKING:
    from ._system import System

#: The kind of the samples of each record.
_KINDS = {
    "base_acceleration": "acceleration",
    "force": "force",
    "foot_displacement": "length",
    "damped_foot_displacement": "length",
}
#: The kind of each answer; those without one are numbers.
UNITS_OF_ANSWERS = {
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
#: The kinds of the states of a motion.
_OF_STATES = {
    "time": "time",
    "displacement": "length",
    "velocity": "velocity",
    "acceleration": "acceleration",
    "absolute_acceleration": "acceleration",
    "friction": "force",
    "transmitted_force": "force",
    "load": "force",
    "event_time": "time",
    "event_displacement": "length",
}
_ANSWERS = {
    "max_displacement": "Greatest displacement from the position of the relaxed spring, and over the surface where that moves",
    "min_displacement": "Least displacement",
    "peak_displacement": "Greatest displacement, regardless of sign",
    "max_velocity": "Greatest velocity, over the surface where that moves",
    "min_velocity": "Least velocity",
    "max_absolute_acceleration": "Greatest acceleration in space, regardless of sign",
    "max_transmitted_force": "Greatest force of spring, damper and friction together on their support",
    "end_displacement": "Displacement at the end of the record",
    "end_velocity": "Velocity at the end of the record",
    "residual_displacement": "Displacement at rest after the record, or its limit",
    "path": "Length of the way to rest",
    "slides": "Slides",
    "stops": "Slides that end with a rest",
    "reversals": "Slides that a slide back follows at once",
    "stick_time": "Time at rest during the record",
    "cycle_amplitude": "Half the distance between the turning points of the longest swing",
    "friction_work": "Work against friction",
    "damper_work": "Work against the damper",
    "load_work": "Work of the load",
}


def _meanings(texts: Mapping[str, str]) -> dict[str, Meaning]:
    kinds = {**UNITS_OF_ANSWERS, **_OF_STATES}
    return {name: (kinds.get(name, ""), text) for name, text in texts.items()}


@dataclass(frozen=True, init=False, eq=False, repr=False)
class Record(Frozen):
    """A measured load: samples, and straight lines between them. It cannot be changed.

    ``record * 2``, ``-record``, ``record / 9.81``, and sums and differences of records of the same times are records. So is a slice such
    as ``record[100:]``, whose samples keep their times.

    Parameters
    ----------
    samples : array
        A series of pandas or a data array of xarray has the times as its labels, if neither ``time_step`` nor ``times`` is given.
    time_step : float or str
        Time between the samples, the first of which is at the time 0.
    times : array
        In place of the time step: the times of the samples, in seconds, which increase.
    of : str
        ``"base_acceleration"`` of the surface that the body slides on, ``"force"`` on the body,
        ``"foot_displacement"`` of the spring's support, or ``"damped_foot_displacement"`` if the damper stands on it, too.
    unit : str, optional
        Unit of the samples, such as ``"g"``. Without it they are in the system of units that the machine names.
    after : str, optional
        The load after the last sample: ``"zero"``, ``"hold"`` (it stays at the last sample) or ``"free"`` (a support lets go of
        the spring). By default a force or an acceleration is zero, and a support stays.

    Examples
    --------
    >>> import stickslip as ss
    >>> record = ss.Record([0, -0.3, -0.3, 0], time_step=0.5, unit="g")
    >>> record
    Record(4 samples of base_acceleration in g, 1.5 s)
    >>> record.times, record.duration, (record * 2).peak
    (array([0. , 0.5, 1. , 1.5]), 1.5, 0.6)
    >>> record[1:]
    Record(3 samples of base_acceleration in g, 1 s)
    """

    samples: Floats
    of: str
    unit: Optional[str]
    after: str
    #: The times, or one number, the step.
    _times: Floats
    summary: Optional[dict[str, Any]] = field(default=None, compare=False)
    #: Numbers of NumPy leave ``2.0 * record`` to the record.
    __array_ufunc__ = None

    @classmethod
    def read(
        cls,
        file: Union[str, os.PathLike[str], bytes],
        *,
        time_step: Optional[Quantity] = None,
        column: Union[str, int, None] = None,
        skip: int = 0,
        record_units: Optional[str] = None,
        time_column: Union[str, int, None] = None,
        scale: Optional[str] = None,
        remove_mean: Optional[str] = None,
        resample: Optional[Quantity] = None,
        after: Optional[str] = None,
    ) -> "Record":
        """The record of a file, as ``stickslip record`` reads it: of an agency (PEER, COSMOS, CSMIP, SMC, K-NET, ESM, GeoNet,
        SAC, …), whose layout is known by its content and whose units are read from it, or columns of text. Samples are then
        in SI units; ``summary`` describes the file, and its ``notes`` say what was done with the samples.

        Parameters
        ----------
        file : path or bytes
        time_step : float or str, optional
            Time between samples in a file that does not state it.
        column : str or int, optional
            Column by its name or its number from 1, or the channel of an agency's file; ``"all"`` reads columns without
            names row by row.
        skip : int
            Number of lines to skip before the columns.
        record_units : str, optional
            Unit of the samples in a file that does not state it, such as ``"g"``.
        time_column : str or int, optional
            Column of the time by its name or its number from 1, where its name does not say so.
        scale : str, optional
            What a signal is, such as ``"2.5 N/V"``: the record is then of forces.
        remove_mean : str, optional
            Take off the mean of ``"all"`` samples, of those ``"before"`` the motion, or of a window such as ``"0s:2s"``.
        resample : float or str, optional
            Step at which the record is read off its straight lines.
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
        step = None if time_step is None else _step(time_step)
        data = bytes(file) if isinstance(file, (bytes, bytearray, memoryview)) else None
        name = "record" if data is not None else os.fspath(file)
        named = None if column is None else str(column)
        try:
            new_step = None if resample is None else f"{float(_step(resample, 'resample'))!r} s"
            of_time = None if time_column is None else str(time_column)
            wanted = [of_time, scale, remove_mean, new_step]
            found, summary = _native.record_read(str(name), data, step, named, skip, record_units, wanted)
        except OSError as error:
            raise unreadable(name, error) from None
        of, times, samples, unit = found
        return cls._of(np.array(samples), np.array(times), of, unit, after, summary)

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
        if time_step is None and times is None and is_labelled(samples) and np.ndim(samples) == 1:
            times = _labels(samples)
        samples, own = parted("samples", samples)
        if own:
            if unit is not None and unit != own:
                raise Error(f"unit = {unit}: must be left out, because the samples are in {own}")
            unit = own
        if (time_step is None) == (times is None):
            raise Error("a record needs either time_step or times; or samples whose labels are times, as the index with a name")
        if times is None:
            values = _column("samples", samples)
            at = np.array([_step(time_step)])
        else:
            columns, _ = aligned({"times": of_kind("times", times, "time"), "samples": samples})
            values, at = _column("samples", columns["samples"]), _column("times", columns["times"])
            if len(at) == 1:
                raise Error("record: the number of samples = 1 must be >= 2")
        for name, word in (("of", of), ("unit", unit), ("after", after)):
            if not isinstance(word, (str, type(None))):
                raise WrongType(f"{name} = {word!r}: must be a text")
        if unit is not None:
            if not unit.strip():
                raise Error('unit: must be a unit such as "g", but is empty')
            _factor(of, unit, None)
        wrong = np.flatnonzero(~np.isfinite(values))
        if wrong.size:
            raise Error(f"samples: sample {wrong[0] + 1} = {values[wrong[0]]} must be finite")
        new = self._of(values, at, of, unit, after, None)
        for name, value in vars(new).items():
            object.__setattr__(self, name, value)

    @classmethod
    def _of(
        cls,
        samples: Floats,
        times: Floats,
        of: str,
        unit: Optional[str],
        after: Optional[str],
        summary: Optional[dict[str, Any]],
    ) -> "Record":
        new = object.__new__(cls)
        after = _native.record_check(of, times, samples, after)
        for array in (samples, times):
            array.flags.writeable = False
        values = {"samples": samples, "_times": times, "of": of, "unit": unit, "after": after, "summary": summary}
        for name, value in values.items():
            object.__setattr__(new, name, value)
        return new

    @property
    def time_step(self) -> Optional[float]:
        """The time between the samples; None where they are at times of their own."""
        return float(self._times[0]) if len(self._times) == 1 else None

    @property
    def times(self) -> Floats:
        """The time of each sample, in seconds."""
        step = self.time_step
        found: Floats = self._times if step is None else np.arange(len(self.samples), dtype=np.float64) * step
        return found

    @property
    def duration(self) -> float:
        """The time from the first sample to the last, in seconds."""
        step = self.time_step
        return float(self._times[-1] - self._times[0]) if step is None else step * (len(self.samples) - 1)

    @property
    def peak(self) -> float:
        """The greatest sample, regardless of sign."""
        return float(np.max(np.abs(self.samples)))

    def describe(self) -> dict[str, Any]:
        """What the record holds, without a machine: its samples, steps and times in seconds, its peak and its mean over time in
        its unit, the frequency in Hz at which its Fourier amplitude is greatest, and its gaps: the beginnings and the ends
        of steps longer than half again their median. Of a file also its ``kind``, its ``channel`` and ``notes``.

        Examples
        --------
        >>> import numpy as np
        >>> import stickslip as ss
        >>> record = ss.Record(np.sin(2 * np.pi * 1.25 * np.arange(400) / 50), time_step=0.02, unit="g")
        >>> about = record.describe()
        >>> about["samples"], about["unit"], round(about["peak_frequency"], 2), about["gaps"]
        (400, 'g', 1.25, [])
        """
        times, samples = self.times, self.samples
        frequency, gaps = _native.record_described(self.of, self._times, samples)
        steps = np.diff(times)
        steps = steps[steps > 0]
        place = int(np.argmax(np.abs(samples)))
        area = float(np.sum(np.diff(times) * (samples[1:] + samples[:-1]) / 2))
        of_file = {name: (self.summary or {}).get(name) for name in ("kind", "channel", "notes")}
        return {
            **of_file,
            "of": self.of,
            "unit": self.unit,
            "samples": len(samples),
            "time_step": self.time_step,
            "steps": (float(steps.min()), float(steps.max())),
            "duration": self.duration,
            "peak": float(samples[place]),
            "peak_at": float(times[place]),
            "mean": area / self.duration,
            "peak_frequency": frequency,
            "gaps": [tuple(gap) for gap in gaps],
        }

    def to_frame(self) -> Any:
        """A frame of pandas with the samples over the time."""
        pandas = module("pandas")
        frame = pandas.DataFrame({self.of: self.samples}, index=pandas.Index(self.times, name="time"))
        frame.attrs["units"] = {"time": "s", **({} if self.unit is None else {self.of: self.unit})}
        return frame

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Draws the samples over the time with matplotlib, and returns the axes."""
        from ._plot import lines

        unit = "" if self.unit is None else f" ({self.unit})"
        return lines(ax, self.times, {self.of: self.samples}, "time (s)", f"{self.of.replace('_', ' ')}{unit}", style)

    def __repr__(self) -> str:
        unit = "" if self.unit is None else f" in {self.unit}"
        return f"Record({len(self.samples)} samples of {self.of}{unit}, {self.duration:.6g} s)"

    def __getitem__(self, part: slice) -> "Record":
        if not isinstance(part, slice):
            raise WrongType(f"record[{part!r}]: takes a slice; samples[{part!r}] is a sample")
        return self._of(self.samples[part].copy(), np.ascontiguousarray(self.times[part]), self.of, self.unit, self.after, self.summary)

    def between(self, start: float, end: float) -> "Record":
        """The samples from one time to another, both included, in seconds."""
        within = of_number("start", start, "time"), of_number("end", end, "time")
        return self[slice(*_native.record_between(self.of, self._times, self.samples, within))]

    def __mul__(self, factor: float) -> "Record":
        return self.scaled(factor)

    __rmul__ = __mul__

    def __truediv__(self, divisor: float) -> "Record":
        number = of_number("divisor", divisor)
        if number == 0:
            raise Error(f"record / {divisor}: must be other than 0")
        return self._of(self.samples / number, self._times, self.of, self.unit, self.after, self.summary)

    def __neg__(self) -> "Record":
        return self.scaled(-1.0)

    def __add__(self, other: "Record") -> "Record":
        return self._beside(other, np.add)

    def __radd__(self, other: Any) -> "Record":
        # The sum of several records begins with 0.
        return self if isinstance(other, int) and not isinstance(other, bool) and other == 0 else self._beside(other, np.add)

    def __sub__(self, other: "Record") -> "Record":
        return self._beside(other, np.subtract)

    def _beside(self, other: Any, of: Callable[[Floats, Floats], Floats]) -> "Record":
        """A record made of the samples of this one and another of its kind, unit and times."""
        of_type("other record", other, Record)
        if (self.of, self.unit) != (other.of, other.unit) or not np.array_equal(self.times, other.times):
            raise Error("records can be added and subtracted if they are of one kind, in one unit and at the same times")
        return self._of(of(self.samples, other.samples), self._times, self.of, self.unit, self.after, None)

    def __len__(self) -> int:
        return len(self.samples)

    def __array__(self, *_: Any, **__: Any) -> NoReturn:
        raise WrongType("record: has times and a unit, which an array has not. Take record.samples and record.times")

    def __eq__(self, other: object) -> bool:
        return are_equal(self, other)

    __hash__ = None  # type: ignore[assignment]

    def scaled(self, factor: float) -> "Record":
        """This record with every sample multiplied by a factor."""
        return self._of(self.samples * of_number("factor", factor), self._times, self.of, self.unit, self.after, self.summary)

    def _in(self, units: Optional[str], is_named: bool = True, machine: str = "the machine") -> tuple[str, Floats, Floats]:
        """The record for a body in a system of units."""
        system_of("the record", units, is_named, None if self.unit is None else "N,m", True, machine)
        factor = 1.0 if self.unit is None else _factor(self.of, self.unit, units)
        return self.of, self._times, self.samples * factor if factor != 1.0 else self.samples


def _step(time_step: Any, name: str = "time_step") -> float:
    step = read({name: (time_step, "time")}, None)[0][name]
    if not 0 < step < np.inf:
        raise Error(f"{name} {text(name, time_step)}: must be > 0 and finite")
    return step


def _labels(samples: Any) -> Any:
    """The labels of samples in seconds, if they are numbers with a name: times."""
    if hasattr(samples, "index"):
        labels = samples.index if samples.index.name is not None else None
        units = samples.attrs.get("units")
        # Attributes of a frame have the units of its columns, and of the index.
        if labels is not None and isinstance(units, Mapping) and labels.name in units:
            labels = in_system("times", labels.to_numpy(), units[labels.name], "time", None)
    else:
        labels = samples.coords.get(samples.dims[0])
    if labels is None or labels.dtype.kind not in "iuf":
        return None
    labels = of_kind("times", labels, "time")
    return labels if isinstance(labels, np.ndarray) else labels.to_numpy()


def _column(name: str, values: ArrayLike) -> Floats:
    array = numbers(name, values)
    if array.ndim != 1:
        raise Error(f"{name}: must be an array of one dimension, not of shape {array.shape}")
    return np.ascontiguousarray(array)


def _factor(of: str, unit: str, units: Optional[str]) -> float:
    return read({"unit": (f"1 {unit}", _KINDS[of])}, units)[0]["unit"]


class Followed(PhysicalResult, Generic[V]):
    """The motion of a body under a record, to its rest; see `Machine.follow`. Of several bodies each value is an array.

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
        Half the distance between the turning points of the longest swing. The oscillator with the forces at these points and
        the energy of the cycle has this stiffness and this damping ratio; NaN without a swing.
    friction_work, damper_work, load_work : V
    errors : dict of int to str
        Of several bodies: the places without an answer, counted in the order of NumPy, and the reasons; their values are NaN.
    """

    _rows = _meanings(_ANSWERS)
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
    max_transmitted_force: V
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
    equivalent_stiffness: V
    equivalent_damping_ratio: V
    friction_work: V
    damper_work: V
    load_work: V
    _errors: Mapping[int, str]

    @property
    def errors(self) -> Mapping[int, str]:
        return self._errors


class Motion(PhysicalResult):
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

    _along = "time"
    _rows = _meanings(
        {
            "time": "Time",
            "displacement": "Displacement",
            "velocity": "Velocity",
            "acceleration": "Acceleration",
            "absolute_acceleration": "Acceleration in space",
            "friction": "Force of friction on the body",
            "transmitted_force": "Force of spring, damper and friction on the support",
            "load": "Force of the load on the body",
            "direction": "1 or -1 while the body slides, 0 at rest",
        }
    )
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
    answer: Followed[float]

    def events(self) -> Any:
        """The events as a frame of pandas: time, displacement, and the direction of a release or 0 of a stop."""
        names = ("event_time", "event_displacement", "event_direction")
        return module("pandas").DataFrame({name.removeprefix("event_"): self[name] for name in names})

    def loop(self) -> tuple[Floats, Floats]:
        """The hysteresis loop: displacements, and the force against friction."""
        return self.displacement, -self.friction


class Polarities(Result):
    """The answers to a record and to its mirror image; see `Machine.polarities`.

    Attributes
    ----------
    recorded, mirrored : Followed
    polarity : str
        The record that moves the body further, by the peak displacement: ``"recorded"`` or ``"mirrored"``.
    """

    recorded: Followed[float]
    mirrored: Followed[float]
    polarity: str

    @property
    def greater(self) -> Followed[float]:
        """The answers of the record that moves the body further."""
        return self.mirrored if self.polarity == "mirrored" else self.recorded


class FloorSpectrum(PhysicalResult):
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
    """

    _along = "period"
    _rows = _meanings({"period": "Natural period", "max_displacement": "Greatest displacement in relation to the body", "max_absolute_acceleration": "Greatest acceleration in space"})
    period: Floats
    max_displacement: Floats
    pseudo_acceleration: Floats
    max_absolute_acceleration: Floats
    damping_ratio: float


class Spectrum(Followed[V]):
    """The answers of many bodies under a record; see `spectrum`. Each is an array, or a number for one body."""

    period: V
    friction_coefficient: V
    damping_ratio: V
    static_friction_ratio: V


_F = TypeVar("_F", bound=Followed[Any])


class Sliding(NamedTuple):
    """A body or several under a record."""

    #: The mass, the stiffness, the damping constant, the friction forward and backward, the static friction ratio and the mean force.
    values: Mapping[str, Any]
    one_way: bool
    units: Optional[str]
    #: Whether bare numbers are in the system of units, which is named.
    is_named: bool
    #: The places in the array of bodies that have none, with the reasons.
    failed: Mapping[int, str]

    def one(self) -> tuple[Any, ...]:
        """One body, for the compiled part."""
        if any(is_array(value) for value in self.values.values()):
            raise Error("this takes one body, not an array of bodies")
        values = dict(self.values)
        if np.isnan(values["friction_backward"]):
            values["friction_backward"] = values["friction"]
        return (*values.values(), self.one_way)

    def load(self, record: Record) -> tuple[str, Floats, Floats, str]:
        of_type("record", record, Record)
        return (*record._in(self.units, self.is_named), record.after)


def _answer(found: Mapping[str, NDArray[Any]], units: Optional[str]) -> Followed[float]:
    values: dict[str, Any] = {name: column.item() for name, column in found.items()}
    return _with_errors(Followed(values, units=names_of(units, UNITS_OF_ANSWERS)), {})


def _with_errors(found: _F, errors: Mapping[int, str]) -> _F:
    object.__setattr__(found, "_errors", errors)
    return found


def follow(of: Sliding, record: Record, start: tuple[Any, Any]) -> Followed[Any]:
    load = of.load(record)
    given = {**of.values, "displacement": start[0], "velocity": start[1]}
    at = points(**given)
    if at.shape is None:
        x, v = (float(at.given[name]) for name in ("displacement", "velocity"))
        return _answer(_native.record_follow(of.one(), *load, (x, v)), of.units)
    bodies = np.broadcast_shapes(*map(np.shape, of.values.values()))
    found, errors = each(at, of.one_way, load, of.failed if bodies == at.shape else {})
    return _with_errors(Followed(found, units=names_of(of.units, UNITS_OF_ANSWERS), like=at.like), errors)


def each(
    at: Points, one_way: bool, load: tuple[str, Floats, Floats, str], none: Mapping[int, str]
) -> tuple[dict[str, Any], dict[int, str]]:
    """The answers of many bodies from their starts in the shape of the bodies, and the places without one, of which some have no
    body for these reasons."""
    size = at.size
    columns = at.columns
    if size == 0:
        # Without a body, one of any values has the names of the answers.
        some = (1.0, 1.0, 0.0, 1.0, 1.0, 1.0, 0.0)
        names, _ = _native.record_follow_each(some, one_way, *load, (0.0, 0.0), 1)
        return {name: column[:0].reshape(at.shape or ()) for name, column in names.items()}, {}
    found, failed = _native.record_follow_each(columns[:7], one_way, *load, columns[7:], size)
    if failed:
        failed = [(place, none.get(place, reason)) for place, reason in failed]
        if len(failed) == size:
            raise Error(failed[0][1])
        there = np.ones(size, dtype=bool)
        there[[place for place, _ in failed]] = False
        for name, column in found.items():
            whole = np.full(size, np.nan)
            whole[there] = column
            found[name] = whole
    return {name: column.reshape(at.shape or ()) for name, column in found.items()}, dict(failed)


def motion(of: Sliding, record: Record, start: tuple[Any, Any], interval: Optional[Quantity]) -> Motion:
    if interval is None:
        distance = float("nan")
    else:
        distance = read({"interval": (interval, "time")}, None)[0]["interval"]
        if not distance > 0:
            raise Error(f"interval = {interval}: must be > 0")
    load = of.load(record)
    answer, states, events = _native.record_motion(of.one(), *load, (one("displacement", start[0]), one("velocity", start[1])), distance)
    named = {f"event_{name}": column for name, column in events.items()}
    found = Motion({**states, **named, "answer": _answer(answer, of.units)}, units=names_of(of.units, _OF_STATES))
    return found


def polarities(of: Sliding, record: Record, start: tuple[Any, Any]) -> Polarities:
    of_type("record", record, Record)
    of.one()
    recorded, mirrored = (follow(of, load, start) for load in (record, -record))
    is_further = mirrored.peak_displacement > recorded.peak_displacement
    polarity = "mirrored" if is_further else "recorded"
    return Polarities({"recorded": recorded, "mirrored": mirrored, "polarity": polarity})


def floor_spectrum(of: Sliding, record: Record, start: tuple[Any, Any], period: ArrayLike, damping_ratio: float) -> FloorSpectrum:
    period = of_kind("period", period, "time")
    given = points(period=period)
    periods = np.atleast_1d(given.given["period"])
    if periods.ndim != 1:
        raise Error(f"period: must be an array of one dimension, not of shape {periods.shape}")
    ratio = one("damping_ratio", damping_ratio)
    x, v = one("displacement", start[0]), one("velocity", start[1])
    is_there = np.isfinite(periods) & (periods > 0)
    if not is_there.any() and periods.size:
        raise Error(f"period = {periods[0]}: must be > 0 and finite")
    found = _native.record_floor_spectrum(of.one(), *of.load(record), (x, v), np.ascontiguousarray(periods[is_there]), ratio)
    for name, column in found.items():
        whole = np.full(periods.shape, np.nan)
        whole[is_there] = column
        found[name] = whole
    kinds = {
        "period": "time",
        "max_displacement": "length",
        "pseudo_acceleration": "acceleration",
        "max_absolute_acceleration": "acceleration",
    }
    found["period"] = periods
    return FloorSpectrum({**found, "damping_ratio": ratio}, units=names_of(of.units, kinds), like=given.like)


@dataclass(frozen=True, init=False, eq=False, repr=False)
class Block(Frozen):
    """A body without a spring on a surface, such as Newmark's sliding block, or several by arrays that broadcast.

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

    mass: Value
    friction: Value
    friction_backward: Value
    damping: Value
    static_friction_ratio: Value
    mean_force: Value
    one_way: bool
    units: Optional[str]

    def __init__(
        self,
        mass: ArrayLike,
        friction: Optional[ArrayLike] = None,
        *,
        friction_coefficient: Optional[ArrayLike] = None,
        yield_acceleration: Optional[ArrayLike] = None,
        gravity: Optional[ArrayLike] = None,
        friction_backward: Optional[ArrayLike] = None,
        damping: Optional[ArrayLike] = None,
        static_friction: Optional[ArrayLike] = None,
        static_friction_ratio: Optional[ArrayLike] = None,
        mean_force: Optional[ArrayLike] = None,
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
        given = {name: value for name, value in given.items() if value is not None}
        angle = None if slope is None else text("slope", slope)
        if not isinstance(one_way, (bool, np.bool_)):
            raise WrongType(f"one_way = {one_way!r}: must be True or False")
        parts = {name: parted(name, value) for name, value in given.items() if is_array(value)}
        columns, like = aligned({name: in_system(name, *part, INPUTS[name], units) for name, part in parts.items()})
        values: dict[str, Any]
        if columns:
            shape = shape_of(columns)
            single = {name: stand_in(parts[name][1]) if name in columns else value for name, value in given.items()}
            flat = [(name, np.ascontiguousarray(np.broadcast_to(array, shape)).reshape(-1)) for name, array in columns.items()]
            found, failed, system = _native.blocks(texts(single), flat, int(np.prod(shape)), units, angle)
            arrays = {name: column.reshape(shape) for name, column in found.items()}
            values = {name: array if like is None else like.dressed(name, array, {}) for name, array in arrays.items()}
        else:
            body, system = _native.block(texts(given), units, angle, bool(one_way))
            failed = []
            values = dict(zip(_OF_BLOCK, body))
        keywords = {**kept(given, values), "slope": slope, "one_way": one_way}
        hidden = {"_keywords": keywords, "_named": units is not None, "_stiffness": 0.0, "_failed": dict(failed)}
        shown = {name: value for name, value in values.items() if name != "stiffness"}
        for name, value in {**shown, "one_way": bool(one_way), "units": system, **hidden}.items():
            object.__setattr__(self, name, read_only(value))

    def replace(self, **changes: Any) -> "Block":
        """This block with other values, by the keywords of `Block`; see `Machine.replace`.

        >>> import stickslip as ss
        >>> ss.Block(mass="1 t", friction_coefficient=0.1).replace(yield_acceleration="0.2 g")
        Block(mass=1000.0, friction=1961.33, units='N,m')
        """
        own = dict(vars(self)["_keywords"])
        for group in (("friction", "friction_coefficient", "yield_acceleration"), ("static_friction", "static_friction_ratio")):
            if any(name in changes for name in group):
                own = {name: value for name, value in own.items() if name not in group}
        if vars(self)["_named"]:
            own["units"] = self.units
        return Block(**{**own, **changes})

    __replace__ = replace

    def __repr__(self) -> str:
        none: dict[str, Any] = {"damping": 0.0, "static_friction_ratio": 1.0, "mean_force": 0.0, "one_way": False}
        if not is_array(self.friction) and self.friction_backward == self.friction:
            none["friction_backward"] = self.friction
        shown = {name: getattr(self, name) for name in (*_OF_BLOCK, "one_way") if name != "stiffness"}
        told = [f"{name}={short(value)}" for name, value in shown.items() if is_array(value) or name not in none or value != none[name]]
        return f"Block({', '.join(told)}, units={self.units!r})"

    def __eq__(self, other: object) -> bool:
        return are_equal(self, other)

    def __hash__(self) -> int:
        return hash((self.mass, self.friction, self.friction_backward, self.units))

    def _sliding(self) -> Sliding:
        values = {name: 0.0 if name == "stiffness" else getattr(self, name) for name in _OF_BLOCK}
        return Sliding(values, self.one_way, self.units, vars(self)["_named"], vars(self)["_failed"])

    def _start(self, displacement: ArrayLike, velocity: ArrayLike) -> tuple[Any, Any]:
        units, is_named = self.units, vars(self)["_named"]
        return values_of("displacement", displacement, "length", units, is_named), values_of("velocity", velocity, "velocity", units, is_named)

    def system(self, record: Record, *, displacement: Quantity = 0.0, velocity: Quantity = 0.0) -> System:
        """This block as a `System` under a record that repeats itself; see `Machine.system`.

        A conveyor that jerks carries its part in each cycle:

        >>> import stickslip as ss
        >>> part = ss.Block(mass="1 kg", friction_coefficient=0.5, units="N,mm")
        >>> cycle = ss.Record([0.3, 0.3, -0.9, -0.9], times=[0, 0.06, 0.06, 0.08], unit="g")
        >>> round(float(part.system(cycle).steady().drift[0]), 6)
        1.176798
        """
        from ._one_body import one_body

        of_type("record", record, Record)
        return one_body(self._sliding(), record, self._start(displacement, velocity), {})

    def follow(self, record: Record, *, displacement: ArrayLike = 0.0, velocity: ArrayLike = 0.0) -> Followed[Any]:
        """The motion under a record from a start; see `Machine.follow`."""
        return follow(self._sliding(), record, self._start(displacement, velocity))

    def motion(
        self, record: Record, *, displacement: Quantity = 0.0, velocity: Quantity = 0.0, interval: Optional[Quantity] = None
    ) -> Motion:
        """The states and events of the motion under a record; see `Machine.motion`."""
        return motion(self._sliding(), record, self._start(displacement, velocity), interval)

    def polarities(self, record: Record, *, displacement: Quantity = 0.0, velocity: Quantity = 0.0) -> Polarities:
        """The answers to a record and to its mirror image; see `Machine.polarities`."""
        return polarities(self._sliding(), record, self._start(displacement, velocity))

    def floor_spectrum(
        self,
        record: Record,
        *,
        period: ArrayLike,
        damping_ratio: float = 0.05,
        displacement: Quantity = 0.0,
        velocity: Quantity = 0.0,
    ) -> FloorSpectrum:
        """The greatest responses of oscillators that stand on the block; see `Machine.floor_spectrum`."""
        return floor_spectrum(self._sliding(), record, self._start(displacement, velocity), period, damping_ratio)


#: The values of a block, in the order of the compiled part.
_OF_BLOCK = ("mass", "stiffness", "damping", "friction", "friction_backward", "static_friction_ratio", "mean_force")


@overload
def spectrum(  # type: ignore[overload-overlap]
    record: Record,
    *,
    period: Quantity,
    friction_coefficient: Quantity,
    damping_ratio: Quantity = 0.0,
    static_friction_ratio: Quantity = 1.0,
    mass: Optional[Quantity] = None,
    gravity: Optional[Quantity] = None,
    units: Optional[str] = None,
) -> Spectrum[float]: ...


@overload
def spectrum(
    record: Record,
    *,
    period: ArrayLike,
    friction_coefficient: ArrayLike,
    damping_ratio: ArrayLike = 0.0,
    static_friction_ratio: ArrayLike = 1.0,
    mass: Optional[Quantity] = None,
    gravity: Optional[Quantity] = None,
    units: Optional[str] = None,
) -> Spectrum[Floats]: ...


def spectrum(
    record: Record,
    *,
    period: ArrayLike,
    friction_coefficient: ArrayLike,
    damping_ratio: ArrayLike = 0.0,
    static_friction_ratio: ArrayLike = 1.0,
    mass: Optional[Quantity] = None,
    gravity: Optional[Quantity] = None,
    units: Optional[str] = None,
) -> Spectrum[Any]:
    """The answers of many bodies on springs under a record, on all cores.

    Each body has the bits of `Machine.follow`. Bodies outside the domain, and masked ones, have NaN; ``errors`` says why.

    Parameters
    ----------
    record : Record
        Of a base acceleration or of a displacement of the support; with a mass also of a force.
    period, friction_coefficient, damping_ratio, static_friction_ratio : float or array
        Natural periods in seconds and the others, aligned by their labels and broadcast to a common shape; one value may be text,
        such as ``"5%"``.
    mass : float or str, optional
        The mass of each body. It is needed for ``max_transmitted_force``, for the equivalent stiffness and for the works, which
        are left out without it.
    gravity : float or str, optional
        Of the coefficient of friction, by default 9.80665 m/s**2.
    units : str, optional
        The system of units of the answers and of bare numbers, such as ``"kN,mm"``; SI by default.

    Returns
    -------
    Spectrum

    Examples
    --------
    >>> import numpy as np, stickslip as ss
    >>> t = np.arange(0, 12, 0.01)
    >>> record = ss.Record(0.3 * np.exp(-(((t - 4) / 2) ** 2)) * np.sin(9 * t), time_step=0.01, unit="g")
    >>> found = ss.spectrum(record, period=np.linspace(0.5, 3, 6)[:, None], friction_coefficient=[0.02, 0.1], mass="2 t", units="kN,mm")
    >>> found.max_displacement.shape, found.units["max_transmitted_force"]
    ((6, 2), 'kN')
    """
    of_type("record", record, Record)
    if record.of == "force" and mass is None:
        raise Error("spectrum: a record of a force needs the mass of the bodies")
    system = "N,m" if units is None else units
    period = of_kind("period", period, "time")
    ratios = {"friction_coefficient": friction_coefficient, "damping_ratio": damping_ratio, "static_friction_ratio": static_friction_ratio}
    plain = {name: of_kind(name, value, "ratio") for name, value in ratios.items()}
    at = points(period=period, **plain)
    shared = texts({"mass": 1.0 if mass is None else mass, **({} if gravity is None else {"gravity": gravity})})
    load = (*record._in(system, True, "the spectrum"), record.after)
    if at.shape is None:
        given = [*shared, *texts({name: float(value) for name, value in at.given.items()})]
        (m, k, friction, _, damping, eta), _, _ = _native.machine(given, system)
        columns = _native.record_follow((m, k, damping, friction, friction, eta, 0.0, False), *load, (0.0, 0.0))
        found: dict[str, Any] = {name: column.item() for name, column in columns.items()}
        errors: dict[int, str] = {}
    else:
        numbers = [(name, np.ascontiguousarray(np.broadcast_to(array, at.shape)).reshape(-1)) for name, array in at.given.items()]
        bodies, places, _ = _native.machines(shared, numbers, at.size, system)
        failed = dict(places)
        if failed and len(failed) == at.size:
            raise Error(failed[0])
        own = {**bodies, "friction_backward": bodies["friction"]}
        own = {name: own.get(name, np.zeros(1)) for name in (*_OF_BLOCK, "displacement", "velocity")}
        found, errors = each(Points((at.size,), own, None), False, load, failed)
        found = {name: column.reshape(at.shape) for name, column in found.items()}
        errors |= failed
    kinds = {"period": "time", **UNITS_OF_ANSWERS}
    if mass is None:
        found = {name: value for name, value in found.items() if UNITS_OF_ANSWERS.get(name) not in ("force", "energy", "stiffness")}
        kinds = {name: kind for name, kind in kinds.items() if name in found or name == "period"}
    answer: Spectrum[Any] = Spectrum({**at.in_shape(), **found}, units=names_of(system, kinds), like=at.like)
    return _with_errors(answer, errors)
