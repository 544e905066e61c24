"""Systems of several bodies: with contacts, laws of friction over speed, elastic contacts and stops."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._drive import is_array
from ._labels import numbers, unreadable
from ._native import Error
from ._quantity import parted
from ._record import Record
from ._result import Floats, Result, are_same, of_type

#: A number in the system's units, or a text with a unit.
Quantity = Union[float, str]
#: The values of an axis: a text such as "1Hz:5Hz:50", or a sequence of numbers or of texts with a unit.
Values = Union[str, float, Sequence[Quantity], NDArray[Any]]


class ElementMotion(Result):
    """The answers of a contact, an elastic contact or a stop; see `SystemMotion.elements`.

    Attributes
    ----------
    kind : str
        ``"contact"``, ``"elastic"`` or ``"stop"``.
    time_at_rest : float
        Time in which a contact sticks, an elastic contact holds, or a stop is open.
    stops : int
        How often such a time begins.
    work : float
        Work that the bodies do on it.
    """

    kind: str
    time_at_rest: float
    stops: int
    work: float


class SystemMotion(Result):
    """The motion of a system; see `System.simulate` and `System.follow`. Arrays have an entry for each coordinate.

    Attributes
    ----------
    kind : str
        ``"transient"``; of a steady motion ``"periodic"``, ``"rest"``, ``"growing"`` or ``"unsettled"``.
    coordinates : tuple of str
    duration : float
    start_displacement, start_velocity, end_displacement, end_velocity : array
        States at the beginning and at the end.
    max_displacement, min_displacement, max_velocity, min_velocity : array
        Extremes, those between events too.
    max_absolute_acceleration : array, or None
        Greatest size of the acceleration in space; None where the base does not move.
    elements : dict of str to ElementMotion
    event_time : array
    event_element, event_kind : array of str
        Name of the element, and stick, slip, reverse, touch, yield, lock, open or close.
    load_work, damper_work, stored_energy : float
        ``load_work = damper_work + stored_energy +`` the works of the elements.
    units : dict of str to str, or None
        The unit of each quantity; None for matrices.
    """

    kind: str
    coordinates: tuple[str, ...]
    duration: float
    start_displacement: Floats
    start_velocity: Floats
    end_displacement: Floats
    end_velocity: Floats
    max_displacement: Floats
    min_displacement: Floats
    max_velocity: Floats
    min_velocity: Floats
    max_absolute_acceleration: Optional[Floats]
    elements: Mapping[str, ElementMotion]
    event_time: Floats
    event_element: NDArray[np.str_]
    event_kind: NDArray[np.str_]
    load_work: float
    damper_work: float
    stored_energy: float
    units: Optional[Mapping[str, str]]

    def __repr__(self) -> str:
        events = f"{len(self.event_time)} events"
        return f"{type(self).__name__}({self.kind}, {self.duration:.6g} long, {events}: {_some(self.coordinates)})"


class SystemSteady(SystemMotion):
    """The motion that a system tends to; see `System.steady`. One period of it, with the values of a `SystemMotion`.

    Attributes
    ----------
    periods : int
        After how many periods of the loads the motion repeats itself.
    periods_followed : int
    drift : array
        Displacement of each coordinate in a period that no force notices; 0 where springs hold the system.
    mean_velocity : array
        Mean velocity of each coordinate.
    multipliers : array of complex
        Multipliers of a small disturbance over the period.
    change, decay : float
        Change of the motion over the last period that was followed, relative to its size, and the factor by which this change is
        multiplied in a period; ``decay`` is 0 where the motion has settled.
    """

    periods: int
    periods_followed: int
    drift: Floats
    mean_velocity: Floats
    multipliers: NDArray[np.complex128]
    change: float
    decay: float


class SystemStates(Result):
    """States of a system at times; see `System.states`.

    Attributes
    ----------
    time : array
    displacement, velocity : array
        A row for each time, a column for each coordinate.
    force : array
        A row for each time, a column for each element.
    absolute_acceleration : array, or None
        Acceleration in space, a row for each time, a column for each coordinate; of one side where it jumps, as at an event.
        None where the base does not move.
    coordinates, elements : tuple of str
        The names of the columns.
    units : dict of str to str, or None
        The unit of each quantity; None for matrices.
    """

    time: Floats
    displacement: Floats
    velocity: Floats
    force: Floats
    absolute_acceleration: Optional[Floats]
    coordinates: tuple[str, ...]
    elements: tuple[str, ...]
    units: Optional[Mapping[str, str]]

    def __repr__(self) -> str:
        return f"SystemStates({len(self.time)} times: {_some([*self.coordinates, *self.elements])})"


class SystemBorder(Result):
    """The least load that keeps a contact from sticking; see `System.border`.

    Attributes
    ----------
    least_load_factor : float
        The factor of the system's load.
    touching_time : float
        Time after a reversal at which the velocity of the contact touches zero under that load.
    least_load_factor_from_rest : float or None
        The factor from which on the contact leaves its rest; None where static and kinetic friction are equal.
    cycle : dict or None
        ``max_displacement``, ``displacement_time``, ``max_velocity``, ``velocity_time`` and ``work`` of the contact at the
        system's load; None where it sticks.
    """

    least_load_factor: float
    touching_time: float
    least_load_factor_from_rest: Optional[float]
    cycle: Optional[Mapping[str, float]]


class SystemGrid(dict[str, Any]):
    """The answers over a grid, in columns by name; see `System.grid`. ``pandas.DataFrame(grid)`` is a table of them.

    Attributes
    ----------
    errors : dict of int to str
        The rows without an answer, with the reasons; their numbers are NaN.
    """

    errors: Mapping[int, str]

    def __init__(self, columns: Mapping[str, Any], errors: Mapping[int, str]) -> None:
        super().__init__(columns)
        self.errors = dict(errors)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, SystemGrid) and are_same(dict(self), dict(other)) and self.errors == other.errors

    def __ne__(self, other: object) -> bool:
        return not self == other

    def __repr__(self) -> str:
        rows = len(next(iter(self.values()), ()))
        failed = f", {len(self.errors)} without an answer" if self.errors else ""
        return f"SystemGrid({rows} rows{failed}: {_some(list(self))})"


def _some(names: Sequence[str]) -> str:
    """Names in a line that fits a screen."""
    return ", ".join(names if len(names) <= 6 else [*names[:5], f"… {len(names) - 5} more"])


class System:
    """Several bodies with springs, contacts, elastic contacts, stops and loads, or matrices with elements.

    The keywords are the fields of the command's file (see its page of recipes). Values are numbers in ``units``, or texts
    with a unit.

    Parameters
    ----------
    masses : dict of str to a mass, or to a dict with mass, start and velocity, or with moves, its prescribed motion
    springs : list of dict
        ``between`` two bodies or ``"ground"``, ``stiffness``, ``damping``; in place of a stiffness ``law``, a list of pairs of a
        displacement and a force, with ``odd``, or a dict with ``formula`` of x and ``tolerance``.
    contacts : list of dict
        ``between``, and ``friction``, or ``coefficient`` and ``normal_load``, or ``law``, a list of pairs of a speed and a
        force, or a dict: ``kinetic``, ``static``, ``speed``, ``exponent`` and ``viscous``, or ``formula`` of v, and ``tolerance``. ``peak`` (static over kinetic friction), ``stiffness`` (of an elastic contact), ``moves`` (the motion of the
        other side) and ``name`` may be left out.
    stops : list of dict
        ``between``, ``gap``, ``stiffness``, ``damping``.
    forces : list of dict
        ``on`` a body: ``amplitude``, ``frequency``, ``phase`` and ``shape``, and ``constant``, and ``record``, a file that may
        have ``repeats``. A bare frequency is in
        hertz, and ``angular_frequency`` in its place in radians per second, here and wherever a dict has a frequency; in a file,
        which `System.read` reads, bare frequencies are in radians per second.
    base : dict
        ``acceleration`` or ``velocity``, a file or a dict with ``amplitude`` and ``frequency``.
    levels : list of dict
        ``on`` a body, or ``between`` two: ``displacement`` or ``velocity``, whose passage is an event.
    units : str
        Such as ``"N,mm"``.
    mass, damping, stiffness : matrix
        In place of bodies: matrices in ``units``, or without them in any consistent ones, with ``elements`` and ``harmonics`` as dicts, ``constant``,
        ``record`` and ``start``. Without units, frequencies are per unit of time.
    folder : path
        The folder of files that are named.

    Examples
    --------
    >>> import stickslip as ss
    >>> system = ss.System(
    ...     units="N,mm",
    ...     masses={"block": "1 t", "roof": "500 kg"},
    ...     springs=[
    ...         {"between": ["ground", "block"], "stiffness": "200 N/mm"},
    ...         {"between": ["block", "roof"], "stiffness": "300 N/mm"},
    ...     ],
    ...     contacts=[{"name": "bearing", "between": ["ground", "block"], "friction": "450 N"}],
    ...     forces=[{"on": "roof", "amplitude": "1.5 kN", "frequency": "3 Hz"}],
    ... )
    >>> system
    System(block, roof; bearing)
    >>> steady = system.steady()
    >>> steady.kind, steady.elements["bearing"].stops
    ('periodic', 0)
    >>> steady
    SystemSteady(periodic, 0.333333 long, 2 events: block, roof)
    >>> system.border().least_load_factor
    0.3022...
    """

    _handle: _native.NativeSystem
    #: The text, the name, the folder and the units of the description, and the changes made to it since.
    _made: tuple[tuple[str, str, str, Optional[str]], tuple[tuple[Any, ...], ...]]

    def __init__(
        self,
        *,
        masses: Optional[Mapping[str, Any]] = None,
        springs: Optional[Sequence[Mapping[str, Any]]] = None,
        contacts: Optional[Sequence[Mapping[str, Any]]] = None,
        stops: Optional[Sequence[Mapping[str, Any]]] = None,
        forces: Optional[Sequence[Mapping[str, Any]]] = None,
        base: Optional[Mapping[str, Any]] = None,
        levels: Optional[Sequence[Mapping[str, Any]]] = None,
        units: Optional[str] = None,
        mass: Optional[ArrayLike] = None,
        damping: Optional[ArrayLike] = None,
        stiffness: Optional[ArrayLike] = None,
        elements: Optional[Sequence[Mapping[str, Any]]] = None,
        constant: Optional[ArrayLike] = None,
        harmonics: Optional[Sequence[Mapping[str, Any]]] = None,
        record: Optional[Mapping[str, Any]] = None,
        start: Optional[Mapping[str, Any]] = None,
        folder: Union[str, os.PathLike[str]] = "",
    ) -> None:
        given = {
            "masses": masses,
            "springs": springs,
            "contacts": contacts,
            "stops": stops,
            "forces": forces,
            "base": base,
            "levels": levels,
            "units": units,
            "mass": mass,
            "damping": damping,
            "stiffness": stiffness,
            "elements": elements,
            "constant": constant,
            "harmonics": harmonics,
            "record": record,
            "start": start,
        }
        fields = {name: _plain(name, value) for name, value in given.items() if value is not None}
        described = (json.dumps(fields), "", os.fspath(folder), None)
        self._handle, self._made = _native.NativeSystem(*described), (described, ())

    @classmethod
    def read(cls, file: Union[str, os.PathLike[str]], *, units: Optional[str] = None) -> "System":
        """The system of a file in TOML or JSON, as ``stickslip system`` reads it."""
        name = os.fspath(file)
        try:
            with open(name, "rb") as opened:
                # Longer ones are refused.
                data = opened.read(1 << 24)
        except OSError as error:
            raise unreadable(name, error) from None
        return cls._of((_native.system_text(data, str(name)), str(name), os.path.dirname(name), units))

    @classmethod
    def _of(cls, described: tuple[str, str, str, Optional[str]], changes: tuple[tuple[Any, ...], ...] = ()) -> "System":
        new = object.__new__(cls)
        new._handle, new._made = _native.NativeSystem(*described), (described, ())
        for name, *arguments in changes:
            new = new._changed(name, *arguments)
        return new

    def _changed(self, name: str, *arguments: Any) -> "System":
        """This system after a method of the compiled part."""
        new = object.__new__(type(self))
        described, changes = self._made
        new._handle, new._made = getattr(self._handle, name)(*arguments), (described, (*changes, (name, *arguments)))
        return new

    def __reduce__(self) -> Any:
        return type(self)._of, self._made

    def __copy__(self) -> "System":
        return self

    def __deepcopy__(self, memo: Any) -> "System":
        # Neither a system nor its description can be changed.
        return self

    def __eq__(self, other: object) -> bool:
        """Whether another system has the same description, apart from the name of its file, and the same changes to it."""
        if not isinstance(other, System):
            return NotImplemented
        (text, _, *place), changes = self._made
        (other_text, _, *other_place), other_changes = other._made
        if (text, place) != (other_text, other_place) or len(changes) != len(other_changes):
            return False
        pairs = zip(changes, other_changes)
        return all(len(one) == len(two) and all(map(np.array_equal, one, two)) for one, two in pairs)

    def __hash__(self) -> int:
        return hash(self._made[0][0])

    def with_values(self, values: Mapping[str, Quantity]) -> "System":
        """This system with other values, such as ``{"bearing.friction": "600 N"}``."""
        typed = [(_path(path), _typed(path, value)) for path, value in values.items()]
        return self._changed("with_values", typed)

    @property
    def coordinates(self) -> tuple[str, ...]:
        """The names of the coordinates: those of the bodies, or q1, q2, …"""
        return tuple(self._handle.names()[0])

    @property
    def elements(self) -> tuple[str, ...]:
        """The names of contacts and stops."""
        return tuple(self._handle.names()[1])

    @property
    def units(self) -> Optional[str]:
        """The system of units; None for matrices."""
        return self._handle.names()[2]

    def natural_angular_frequencies(self, stuck: Union[bool, str] = False) -> Floats:
        """The natural frequencies without dampers, in rad/s or in radians per unit of time of matrices.

        Parameters
        ----------
        stuck : bool or str
            Whether all contacts are at rest, or the name of the one that is.
        """
        found = json.loads(self._handle.describe())
        if isinstance(stuck, str):
            for element in found["elements"]:
                if element["name"] == stuck:
                    return np.array(element["natural_frequencies_stuck"], dtype=float)
            raise Error(f"stuck = {stuck}: must be one of {', '.join(self.elements)}")
        return np.array(found["natural_frequencies_stuck" if stuck else "natural_frequencies"], dtype=float)

    def sliding(self) -> Optional[Mapping[str, Any]]:
        """The stability of steady sliding on sides that travel, such as belts; None where no contact has one.

        Returns
        -------
        dict
            ``growth``, the rate at which the worst disturbance grows, below 0 where all decay; its angular ``frequency``; and
            ``threshold``: the ``factor`` of the coefficients of friction from which on sliding is unstable, where the normal load
            depends on the displacement, with the ``coefficient`` of friction itself if it is one, the ``frequency``, and the
            ``kind``, ``"flutter"`` or ``"divergence"``.
        """
        found: Optional[Mapping[str, Any]] = json.loads(self._handle.describe())["sliding"]
        return found

    def steady(self) -> SystemSteady:
        """The motion that the start leads to, by its period map; exact stops, no time step."""
        found = json.loads(self._handle.steady())
        multipliers = np.array([complex(re, im) for re, im in found["multipliers"]], dtype=np.complex128)
        more = {name: found[name] for name in ("periods", "periods_followed", "change", "decay")}
        more.update({name: np.array(found[name], dtype=float) for name in ("drift", "mean_velocity")})
        more["multipliers"] = multipliers
        return SystemSteady({**_motion(found, found["period"]), **more})

    def simulate(self, until: Quantity) -> SystemMotion:
        """The motion from the start to a time."""
        found = json.loads(self._handle.simulate(self._time("until", until)))
        return SystemMotion(_motion(found, found["duration"]))

    def follow(self, record: Record, until: Optional[Quantity] = None) -> SystemMotion:
        """The motion from the start under a record of the base's acceleration, to its end or to a time."""
        under = self.under(record)
        end = under._handle.end_of_records() if until is None else self._time("until", until)
        found = json.loads(under._handle.simulate(end))
        return SystemMotion(_motion(found, found["duration"]))

    def under(self, record: Record) -> "System":
        """This system under a record of the base's acceleration, beside its loads."""
        of_type("record", record, Record)
        return self._changed("with_record", "record", *_load(record, self.units))

    def states(self, times: Union[ArrayLike, Sequence[Quantity]], *, steady: bool = False) -> SystemStates:
        """The states at increasing times, from the start, or from the phase 0 of the steady motion.

        The times are numbers in seconds, or in the unit of time of matrices, or texts such as ``"0.1 s"``; one time is one row.
        """
        array = self._times(times)
        if array.ndim != 1:
            raise Error(f"times: must be an array of one dimension, not of shape {array.shape}")
        back = np.flatnonzero(np.diff(array) < 0)
        if len(back):
            raise Error(f"times: must increase, but {array[back[0] + 1]} follows {array[back[0]]}")
        *found, absolute = self._handle.states(array, steady)
        coordinates, elements, _ = self._handle.names()
        names = (coordinates, coordinates, elements)
        shaped = [column.reshape(len(array), len(name)) for column, name in zip(found, names)]
        values = dict(zip(("displacement", "velocity", "force"), shaped))
        in_space = absolute.reshape(shaped[0].shape) if len(absolute) == shaped[0].size else None
        named = {"absolute_acceleration": in_space, "coordinates": tuple(coordinates), "elements": tuple(elements)}
        units = json.loads(self._handle.units_of_states())
        return SystemStates({"time": array, **values, **named, "units": units})

    def border(self) -> SystemBorder:
        """The minimum load that keeps the only contact from sticking, in closed form; one contact, one harmonic load."""
        found = json.loads(self._handle.border())
        return SystemBorder({"least_load_factor_from_rest": None, **found})

    def grid(
        self,
        values: Optional[Mapping[str, Values]] = None,
        *,
        frequency: Optional[Values] = None,
        angular_frequency: Optional[Values] = None,
        records: Optional[Mapping[str, Record]] = None,
        question: Optional[str] = None,
        until: Optional[Quantity] = None,
    ) -> SystemGrid:
        """The answers over a grid of values, of frequencies and of records, on all processors.

        Parameters
        ----------
        values : dict of str to values
            Paths with their values, such as ``{"bearing.friction": "100N:1kN:20"}``, or a sequence.
        frequency : values
            Lowest frequency of the loads, in hertz; all others change in proportion.
        angular_frequency : values
            The same in radians per second; give one of the two.
        records : dict of str to Record
            Records of the base's acceleration by name.
        question : str
            ``"steady"``, ``"simulate"`` (from the start to ``until``, or to the end of the record) or ``"border"``. With
            records the motion under each by default, otherwise the steady motion.

        Examples
        --------
        >>> import stickslip as ss
        >>> system = ss.System(
        ...     masses={"m": "1 kg"},
        ...     springs=[{"between": ["ground", "m"], "stiffness": "100 N/m"}],
        ...     contacts=[{"name": "c", "between": ["ground", "m"], "friction": "1 N"}],
        ...     forces=[{"on": "m", "amplitude": "3 N", "frequency": "1 Hz"}],
        ... )
        >>> grid = system.grid({"c.friction": ["1 N", "2 N"]}, frequency="1Hz:2Hz:3")
        >>> grid
        SystemGrid(6 rows: c.friction[N], frequency[Hz], kind, periods, m.max_displacement[m], … 8 more)
        >>> grid["frequency[Hz]"]
        array([1. , 1.5, 2. , 1. , 1.5, 2. ])
        """
        axes: list[tuple[Optional[str], list[str]]] = [
            (_path(path), _several(path, axis)) for path, axis in (values or {}).items()
        ]
        if frequency is not None and angular_frequency is not None:
            raise Error(_ONE_OF_TWO)
        for name, axis in (("frequency", frequency), ("angular_frequency", angular_frequency)):
            if axis is not None:
                axes.append((None, _several(name, axis)))
        named = []
        for name, record in (records or {}).items():
            of_type(f"records[{name!r}]", record, Record)
            named.append((str(name), *_load(record, self.units)))
        asked = question or ("simulate" if named else "steady")
        end = None if until is None else self._time("until", until)
        columns, failed = self._handle.grid(axes, named, asked, end)
        texts = {name: np.array(column) if isinstance(column, list) else column for name, column in columns.items()}
        return SystemGrid(texts, dict(failed))

    def curve(
        self,
        frequency: Optional[Values] = None,
        values: Optional[Mapping[str, Values]] = None,
        *,
        angular_frequency: Optional[Values] = None,
    ) -> SystemGrid:
        """The steady motion over the frequency of the loads, in hertz or such as ``"60rpm:600rpm:100"``, or over the angular frequency
        in radians per second."""
        if frequency is None and angular_frequency is None:
            raise Error(_ONE_OF_TWO)
        return self.grid(values, frequency=frequency, angular_frequency=angular_frequency)

    def _times(self, times: Any) -> Floats:
        if isinstance(times, str):
            return np.array([self._time("times", times)])
        if isinstance(times, Sequence) and any(isinstance(time, str) for time in times):
            return np.array([self._time("times", time) for time in times])
        return np.ascontiguousarray(np.atleast_1d(numbers("times", times, "time")))

    def _time(self, name: str, value: Quantity) -> float:
        return self._handle.time(name, _typed(name, value))

    def __repr__(self) -> str:
        elements = self.elements
        return f"System({_some(self.coordinates)}{'; ' if elements else ''}{_some(elements)})"


def _load(record: Record, units: Optional[str]) -> tuple[str, Floats, Floats]:
    """A record for the base of a system, after which the base rests or moves on at a constant velocity."""
    if record.after == "hold":
        raise Error("record: its load must end after it: after=\"zero\"")
    return record._in(units)


def _motion(found: Mapping[str, Any], duration: float) -> dict[str, Any]:
    """The values of a motion from the JSON of the command."""
    places = {
        f"{name}_{what}": np.array(found[name][what], dtype=float)
        for name in ("start", "end")
        if name in found
        for what in ("displacement", "velocity")
    }
    if "end" not in found:
        # A period ends where it begins.
        places |= {f"end_{what}": places[f"start_{what}"].copy() for what in ("displacement", "velocity")}
    extremes = {
        name: np.array(found[name], dtype=float)
        for name in ("max_displacement", "min_displacement", "max_velocity", "min_velocity")
    }
    absolute = found.get("max_absolute_acceleration")
    in_space = None if absolute is None else np.array(absolute, dtype=float)
    names = ("kind", "time_at_rest", "stops", "work")
    elements = {
        element["name"]: ElementMotion({name: element[name] for name in names}) for element in found["elements"]
    }
    events = found["events"]
    return {
        "kind": found["kind"],
        "coordinates": tuple(found["coordinates"]),
        "duration": duration,
        **places,
        **extremes,
        "max_absolute_acceleration": in_space,
        "elements": elements,
        "event_time": np.array([event["time"] for event in events], dtype=float),
        "event_element": np.array([event["name"] for event in events], dtype=np.str_),
        "event_kind": np.array([event["kind"] for event in events], dtype=np.str_),
        "load_work": found["load_work"],
        "damper_work": found["damper_work"],
        "stored_energy": found["stored_energy"],
        "units": found.get("units"),
    }


#: The units of bare frequencies, by the name of the keyword, field or axis.
_BARE = {"frequency": "Hz", "angular_frequency": "rad/s"}
_ONE_OF_TWO = "give one of frequency (in Hz) and angular_frequency (in rad/s)"


def _bare(name: str) -> str:
    """The unit of bare numbers in a place, if they have one of their own. A body may have any name."""
    place, _, last = name.rpartition(".")
    if last in ("from", "to") and place.endswith(".sweep"):
        return "Hz"
    return "" if place == "masses" else _BARE.get(last, "")


def _path(path: str) -> str:
    """A path in the words of the file, which has one frequency."""
    is_frequency = path.rpartition(".")[2] in _BARE and _bare(path)
    return path.removesuffix("frequency").removesuffix("angular_") + "frequency" if is_frequency else path


def _typed(name: str, value: Any) -> str:
    """A number or a text as it would be typed."""
    if isinstance(value, str):
        return _with_unit(value, _bare(name))
    value, unit = parted(name, value)
    if isinstance(value, (bool, np.bool_)) or not np.isscalar(value) and np.ndim(value) != 0:
        raise Error(f"{name} = {value}: must be a number, or a text with a unit")
    try:
        return f"{float(value)!r} {unit or _bare(name)}".rstrip()
    except (TypeError, ValueError):
        raise Error(f"{name} = {value}: must be a number, or a text with a unit") from None


def _with_unit(text: str, unit: str) -> str:
    """A text, each bare number of which has a unit: one value, a list A,B,C or a range FROM:TO:COUNT."""
    if not unit or not text.strip():
        return text
    if ":" in text:
        first, last, *rest = text.split(":")
        return ":".join((_with_unit(first, unit), _with_unit(last, unit), *rest))
    return ",".join(part if _native.has_unit(part) or not part.strip() else f"{part.strip()} {unit}" for part in text.split(","))


def _several(name: str, values: Any) -> list[str]:
    if isinstance(values, str) or not is_array(values):
        return [_typed(name, values)]
    values, unit = parted(name, values)
    typed = [_typed(name, f"{float(value)!r} {unit}" if unit else value) for value in values]
    if not typed:
        raise Error(f"{name}: must have at least one value")
    return typed


def _plain(name: str, value: Any) -> Any:
    """A value for JSON."""
    if isinstance(value, Mapping):
        places = {key: f"{name}.{key}" for key in value}
        if all(_bare(places.get(key, "")) for key in _BARE):
            raise Error(f"{name}: {_ONE_OF_TWO}")
        return {_path(places[key]).removeprefix(f"{name}."): _plain(places[key], inner) for key, inner in value.items()}
    if value is not None and _bare(name) and not is_array(value):
        return _typed(name, value)
    value, unit = parted(name, value)
    if unit:
        number = numbers(name, value)
        return _plain(name, np.array([f"{x!r} {unit}" for x in number.reshape(-1).tolist()]).reshape(number.shape))
    if isinstance(value, (str, bool, int)) or value is None:
        return value
    if isinstance(value, (float, np.floating)):
        if not np.isfinite(value):
            raise Error(f"{name} = {value}: must be finite")
        return float(value)
    if isinstance(value, np.integer):
        return int(value)
    if isinstance(value, np.ndarray):
        return _plain(name, value.tolist())
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, Sequence):
        return [_plain(f"{name}[{place}]", inner) for place, inner in enumerate(value, 1)]
    raise Error(f"{name} = {value!r}: must be a number, a text, a list or a dict")
