"""Systems of several bodies: with contacts, laws of friction over speed, elastic contacts and stops."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._drive import is_array
from ._labels import WrongType, is_labelled, is_pandas, numbers, unreadable
from ._native import Error
from ._quantity import parted
from ._record import Record
from ._result import Floats, of_type
from ._system_results import ElementMotion, Elements, GridAxis, SystemBorder, SystemGrid, SystemMotion, SystemStates, SystemSteady, some

#: A number in the system's units, or a text with a unit.
Quantity = Union[float, str]
#: The values of an axis: a text such as "1Hz:5Hz:50", or a sequence of numbers or of texts with a unit.
Values = Union[str, float, Sequence[Quantity], NDArray[Any]]
#: One path, or several whose values change together.
Paths = Union[str, tuple[str, ...]]


class System:
    """Several bodies with springs, contacts, elastic contacts, stops and loads, or matrices with elements.

    The keywords are the fields of the command's file (see its page of recipes). Values are numbers in ``units``, or texts
    with a unit. A system may also be made step by step, by `mass`, `spring`, `contact`, `stop`, `force`, `base` and `level`, each of which
    returns a further system; it is checked when it is first asked.

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
        ``between``, ``gap``, and ``stiffness`` and ``damping``, or a ``restitution`` from 0 to 1.
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
        ``record`` and ``start``. Without units, frequencies are per unit of time. Frames of pandas and data arrays of xarray are put in the
        order of the labels of the first, and a series of constant forces, too; sparse matrices of SciPy are taken as they are. A matrix may be the
        name of a file of Matrix Market (``.mtx``).
    damping : dict
        Of bodies, too: damping by the modes of the structure without contacts, beside its dampers. ``ratio``, such as ``"2 %"``, of each elastic mode, or
        a list by mode whose last one holds for all further modes; ``rayleigh``, the numbers a and b of a M + b K; and of matrices ``matrix``.
    coordinates : list of str
        The names of the coordinates of matrices: by default the labels of the first, or q1, q2 and so on.
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

    _built: Optional[_native.NativeSystem]
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
        damping: Optional[Union[ArrayLike, Mapping[str, Any]]] = None,
        stiffness: Optional[ArrayLike] = None,
        coordinates: Optional[Sequence[str]] = None,
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
            "coordinates": coordinates,
            "elements": elements,
            "constant": constant,
            "harmonics": harmonics,
            "record": record,
            "start": start,
        }
        _aligned(given)
        fields = {name: _plain(name, value) for name, value in given.items() if value is not None}
        self._built, self._made = None, ((json.dumps(fields), "", os.fspath(folder), None), ())
        if masses is not None or mass is not None:
            # What is complete is checked at once.
            _ = self._handle

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
        found = cls._of((_native.system_text(data, str(name)), str(name), os.path.dirname(name), units))
        _ = found._handle
        return found

    @classmethod
    def _of(cls, described: tuple[str, str, str, Optional[str]], changes: tuple[tuple[Any, ...], ...] = ()) -> "System":
        new = object.__new__(cls)
        new._built, new._made = None, (described, changes)
        return new

    @property
    def _handle(self) -> _native.NativeSystem:
        """The system in the compiled part, which is made when it is first asked."""
        if self._built is None:
            described, changes = self._made
            built = _opening(_native.NativeSystem, *described)
            for name, *arguments in changes:
                built = _opening(getattr(built, name), *arguments)
            self._built = built
        return self._built

    def _changed(self, name: str, *arguments: Any) -> "System":
        """This system after a method of the compiled part."""
        new = object.__new__(type(self))
        described, changes = self._made
        new._built, new._made = _opening(getattr(self._handle, name), *arguments), (described, (*changes, (name, *arguments)))
        return new

    def _with(self, field: str, added: Any, **others: Any) -> "System":
        """This system with a further entry in a field of its description, and the changes made to it."""
        (text, name, folder, units), changes = self._made
        value = json.loads(text if text.lstrip().startswith("{") else _opening(_native.NativeSystem, text, name, folder, units).value())
        added = {key: _plain(f"{field}.{key}", own) for key, own in {**added, **others}.items() if own is not None}
        if field in ("masses", "base", "damping"):
            own = value.get(field, {})
            value[field] = {**({"matrix": own} if isinstance(own, (list, str)) else own), **added}
        else:
            place = f"{field}[{len(value.setdefault(field, [])) + 1}]"
            plain = {_path(f"{place}.{key}").removeprefix(f"{place}."): own for key, own in added.items()}
            value[field] = [*value[field], plain]
        return self._of((json.dumps(value), "", folder, units), changes)

    def mass(
        self,
        name: str,
        mass: Optional[Quantity] = None,
        *,
        start: Optional[Quantity] = None,
        velocity: Optional[Quantity] = None,
        moves: Optional[Mapping[str, Any]] = None,
        **others: Any,
    ) -> "System":
        """This system with a further body: its mass, its displacement and velocity at the start, or its prescribed motion.

        Here and in the other steps, further keywords are those of the file.

        >>> import stickslip as ss
        >>> frame = (
        ...     ss.System(units="N,mm")
        ...     .mass("block", "1 t")
        ...     .mass("roof", "500 kg", start="3 mm")
        ...     .spring("ground", "block", "200 N/mm", damping="0.3 N*s/mm")
        ...     .spring("block", "roof", "300 N/mm")
        ...     .contact("ground", "block", "450 N", name="bearing")
        ...     .force("roof", "1.5 kN", frequency="3 Hz")
        ... )
        >>> frame
        System(block, roof; bearing)
        >>> frame.steady().to_frame()["max_displacement"].round(3).to_dict()
        {'block': 6.057, 'roof': 3.432}
        """
        fields = {"mass": mass, "start": start, "velocity": velocity, "moves": moves, **others}
        return self._with("masses", {name: {key: value for key, value in fields.items() if value is not None}})

    def spring(
        self, first: str, second: str, stiffness: Optional[Quantity] = None, *, damping: Optional[Quantity] = None, name: Optional[str] = None, **others: Any
    ) -> "System":
        """This system with a spring, a damper or both between two bodies, or ``"ground"`` and a body."""
        return self._with("springs", {"name": name, "between": [first, second], "stiffness": stiffness, "damping": damping}, **others)

    def contact(
        self,
        first: str,
        second: str,
        friction: Optional[Quantity] = None,
        *,
        coefficient: Optional[Quantity] = None,
        normal_load: Any = None,
        law: Any = None,
        peak: Optional[float] = None,
        stiffness: Optional[Quantity] = None,
        moves: Any = None,
        name: Optional[str] = None,
        **others: Any,
    ) -> "System":
        """This system with a contact: its friction force, or a coefficient with the normal load, or a law."""
        fields = {"name": name, "between": [first, second], "friction": friction, "coefficient": coefficient, "normal_load": normal_load}
        return self._with("contacts", {**fields, "law": law, "peak": peak, "stiffness": stiffness, "moves": moves}, **others)

    def stop(
        self, first: str, second: str, *, gap: Quantity, stiffness: Optional[Quantity] = None, damping: Optional[Quantity] = None, name: Optional[str] = None, **others: Any
    ) -> "System":
        """This system with an end stop, which the second body meets after the gap."""
        fields = {"name": name, "between": [first, second], "gap": gap, "stiffness": stiffness, "damping": damping}
        return self._with("stops", fields, **others)

    def force(
        self,
        on: str,
        amplitude: Optional[Quantity] = None,
        *,
        frequency: Optional[Quantity] = None,
        angular_frequency: Optional[Quantity] = None,
        constant: Optional[Quantity] = None,
        name: Optional[str] = None,
        **others: Any,
    ) -> "System":
        """This system with a force on a body. A bare frequency is in hertz, an angular one in radians per second."""
        if frequency is not None and angular_frequency is not None:
            raise Error(f"force: {_ONE_OF_TWO}")
        fields = {"name": name, "on": on, "amplitude": amplitude, "frequency": frequency, "angular_frequency": angular_frequency, "constant": constant}
        return self._with("forces", fields, **others)

    def base(self, **motion: Any) -> "System":
        """This system on a base that moves: ``acceleration``, ``velocity`` or ``displacement``, as in the file."""
        return self._with("base", motion)

    def damping(self, *, ratio: Any = None, rayleigh: Optional[Sequence[Quantity]] = None) -> "System":
        """This system with damping by modes: the damping ratio of each elastic mode, or of one after the other, and Rayleigh's a and b.

        >>> import stickslip as ss
        >>> one = ss.System(units="N,m").mass("block", 4, start=1).spring("ground", "block", 100).damping(ratio="25 %")
        >>> one.simulate(1).end_displacement.round(6).tolist()
        [-0.036551]
        """
        return self._with("damping", {"ratio": ratio, "rayleigh": rayleigh})

    def level(self, on: Optional[str] = None, *, between: Optional[Sequence[str]] = None, **others: Any) -> "System":
        """This system with a value whose passage is an event: ``displacement`` or ``velocity`` of a body, or between two."""
        return self._with("levels", {"on": on, "between": None if between is None else list(between)}, **others)

    def to_json(self) -> str:
        """The file of this system, as `read` and the command read it."""
        if any(name == "with_record" for name, *_ in self._made[1]):
            raise Error("a record in memory has no place in a file: name its file in base or forces")
        return json.dumps(json.loads(self._handle.value()), indent=1)

    def write(self, file: Union[str, os.PathLike[str]]) -> None:
        """Writes the file of this system, as `read` and the command read it."""
        text = self.to_json()
        try:
            with open(file, "w", encoding="utf-8") as opened:
                opened.write(text + "\n")
        except OSError as error:
            raise unreadable(os.fspath(file), error) from None

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
        more = {name: found[name] for name in ("periods", "periods_followed", "disturbance_growth", "change", "decay")}
        more.update({name: np.array(found[name], dtype=float) for name in ("drift", "mean_velocity")})
        more["multipliers"] = multipliers
        steady: SystemSteady = SystemSteady({**_motion(found, found["period"]), **more}).of_system(self)
        return steady

    def simulate(self, until: Quantity) -> SystemMotion:
        """The motion from the start to a time."""
        found = json.loads(self._handle.simulate(self._time("until", until)))
        motion: SystemMotion = SystemMotion(_motion(found, found["duration"])).of_system(self)
        return motion

    def follow(self, record: Record, until: Optional[Quantity] = None) -> SystemMotion:
        """The motion from the start under a record of the base's acceleration, to its end or to a time."""
        under = self.under(record)
        end = under._handle.end_of_records() if until is None else self._time("until", until)
        found = json.loads(under._handle.simulate(end))
        motion: SystemMotion = SystemMotion(_motion(found, found["duration"])).of_system(under)
        return motion

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
        values: Union[Mapping[Any, Any], Any, None] = None,
        *,
        frequency: Optional[Values] = None,
        angular_frequency: Optional[Values] = None,
        records: Union[Mapping[str, Record], Sequence[Record], None] = None,
        question: Optional[str] = None,
        until: Optional[Quantity] = None,
    ) -> SystemGrid:
        """The answers over a grid of values, of frequencies and of records, on all processors.

        Parameters
        ----------
        values : dict of str to values, or a frame of pandas
            Paths with their values, such as ``{"bearing.friction": "100N:900N:17"}``, or a sequence: each is an axis. Series with the same
            labels, and data arrays with the same dim, lie along one axis and change together; so do the columns of an array under
            a tuple of paths, and those of a frame, whose columns are paths and whose index labels the rows.
        frequency : values
            Lowest frequency of the loads, in hertz; all others change in proportion.
        angular_frequency : values
            The same in radians per second; give one of the two.
        records : dict of str to Record, or a list
            Records of the base's acceleration by name, or by their numbers from 1.
        question : str
            ``"steady"``, ``"simulate"`` (from the start to ``until``, or to the end of the record) or ``"border"``. With
            records the motion under each by default, otherwise the steady motion.

        Returns
        -------
        SystemGrid
            With a column for each value and answer, whose name has its unit in brackets, however the values were typed.

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
        SystemGrid(6 rows: c.friction[N], frequency[Hz], kind, periods, m.max_displacement[m], ... 8 more)
        >>> grid["frequency[Hz]"], grid["frequency"].size, grid.shape
        (array([1. , 1.5, 2. , 1. , 1.5, 2. ]), 6, (2, 3))
        >>> grid.to_xarray()["max_displacement"].sel({"c.friction": 2, "body": "m"}).round(4).values
        array([0.0431, 0.1529, 0.0197])
        """
        axes = _axes_of(values)
        if frequency is not None and angular_frequency is not None:
            raise Error(_ONE_OF_TWO)
        for name, axis in (("frequency", frequency), ("angular_frequency", angular_frequency)):
            if axis is not None:
                axes.append(_Axis("frequency", _labels_of(axis)[1], [(None, _several(name, axis))]))
        named = []
        given = records if hasattr(records, "items") else {str(place): record for place, record in enumerate(records or (), 1)}
        for name, record in given.items():  # type: ignore[union-attr]
            of_type(f"records[{name!r}]", record, Record)
            named.append((str(name), *_load(record, self.units)))
        asked = question or ("simulate" if named else "steady")
        end = None if until is None else self._time("until", until)
        flat = [(path, typed, place > 0) for axis in axes for place, (path, typed) in enumerate(axis.values)]
        columns, failed, lengths = self._handle.grid(flat, named, asked, end)
        texts = {name: np.array(column) if isinstance(column, list) else column for name, column in columns.items()}
        shown, sizes = iter(texts), iter(lengths)
        known = [GridAxis("record", (next(shown),), None, next(sizes))] if named else []
        for own in axes:
            of = tuple(next(shown) for _ in own.values)
            length = [next(sizes) for _ in own.values][0]
            known.append(GridAxis(own.name, of, own.labels, length))
        coordinates, elements, _ = self._handle.names()
        return SystemGrid(texts, dict(failed), known, (tuple(coordinates), tuple(elements)))

    def curve(
        self,
        frequency: Optional[Values] = None,
        values: Union[Mapping[Any, Any], Any, None] = None,
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
        try:
            elements = self.elements
        except Error as error:
            return f"System(not complete: {error})"
        return f"System({some(self.coordinates)}{'; ' if elements else ''}{some(elements)})"


def _opening(make: Callable[..., _native.NativeSystem], *arguments: Any) -> _native.NativeSystem:
    """A system of the compiled part, which opens the files that the description names."""
    try:
        return make(*arguments)
    except OSError as error:
        raise unreadable("", error) from None


class _Axis(NamedTuple):
    """An axis of a grid: its name, its labels if it has any, and the paths and values that change along it."""

    name: str
    labels: Optional[list[Any]]
    values: list[tuple[Optional[str], list[str]]]


def _labels_of(values: Any) -> tuple[Optional[str], Optional[list[Any]]]:
    """The name of the axis that values with labels lie on, and the labels, where they have some of their own."""
    if is_pandas(values):
        index = values.index
        is_counted = type(index).__name__ == "RangeIndex" and index.name is None
        return None if index.name is None else str(index.name), None if is_counted else list(index)
    if is_labelled(values) and values.ndim == 1:
        dim = values.dims[0]
        return str(dim), list(values.indexes[dim]) if dim in values.indexes else None
    return None, None


def _axes_of(values: Any) -> list[_Axis]:
    """The axes of a grid: values with the same labels, or under one tuple of paths, lie along one of them."""
    axes: list[_Axis] = []
    if is_pandas(values) and hasattr(values, "columns"):
        name, labels = _labels_of(values)
        columns: list[tuple[Optional[str], list[str]]] = [(_path(str(path)), _several(str(path), values[path])) for path in values.columns]
        return [_Axis(name or "row", labels, columns)] if columns else []
    if values is not None and not hasattr(values, "items"):
        raise WrongType(f"values: must be a dict of paths with their values, or a frame whose columns are paths, not {type(values).__name__}")
    for paths, axis in (values or {}).items():
        if isinstance(paths, tuple):
            array = np.asarray(axis, dtype=object if any(isinstance(x, str) for x in np.ravel(np.asarray(axis, dtype=object))) else None)
            if array.ndim != 2 or array.shape[1] != len(paths):
                raise Error(f"{paths}: must have a column for each of the {len(paths)} paths, not the shape {array.shape}")
            axes.append(_Axis("row", None, [(_path(path), _several(path, column.tolist())) for path, column in zip(paths, array.T)]))
            continue
        name, labels = _labels_of(axis)
        of_path: tuple[Optional[str], list[str]] = (_path(paths), _several(paths, axis))
        beside = next((own for own in axes if is_labelled(axis) and (own.name, own.labels) == (name or "row", labels) and (name or labels)), None)
        if beside is not None:
            beside.values.append(of_path)
        else:
            axes.append(_Axis(name or ("row" if labels else str(of_path[0])), labels, [of_path]))
    names = [axis.name for axis in axes]
    # Several axes of rows without a name are told apart by their numbers.
    return [axis._replace(name=f"{axis.name} {place}") if names.count(axis.name) > 1 else axis for place, axis in enumerate(axes, 1)]


def _aligned(given: dict[str, Any]) -> None:
    """Puts labelled matrices and constant forces in the order of the labels of the first, which name the coordinates, and makes sparse ones
    dense."""
    first: Optional[tuple[str, Any]] = None
    table = given["damping"]
    if isinstance(table, Mapping):
        given["damping"] = table.get("matrix")
    for name in ("mass", "damping", "stiffness", "constant"):
        matrix = given[name]
        if hasattr(matrix, "toarray"):
            given[name] = matrix.toarray()
            continue
        if not is_labelled(matrix) or np.ndim(matrix) != (1 if name == "constant" else 2):
            continue
        frame = matrix if is_pandas(matrix) else matrix.to_pandas()
        axes = [frame.index] if name == "constant" else [frame.index, frame.columns]
        if all(type(axis).__name__ == "RangeIndex" for axis in axes):
            given[name] = frame.to_numpy()
            continue
        first = first or (name, axes[0])
        of, labels = first
        if not (labels.is_unique and all(len(axis) == len(labels) and set(axis) == set(labels) for axis in axes)):
            raise Error(f"{name}: its {'values' if name == 'constant' else 'rows and columns'} must have the labels of {of}")
        order = list(labels)
        given[name] = (frame.loc[order] if name == "constant" else frame.loc[order, order]).to_numpy()
    if isinstance(table, Mapping):
        given["damping"] = {**table, **({} if given["damping"] is None else {"matrix": given["damping"]})}
    if first is not None and given["coordinates"] is None:
        given["coordinates"] = [str(label) for label in first[1]]


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
    names = ("kind", "time_at_rest", "stops", "blows", "work")
    elements = {
        element["name"]: ElementMotion({name: element.get(name, 0) for name in names})
        for element in found["elements"]
    }
    events = found["events"]
    return {
        "kind": found["kind"],
        "coordinates": tuple(found["coordinates"]),
        "duration": duration,
        **places,
        **extremes,
        "max_absolute_acceleration": in_space,
        "elements": Elements(elements, found.get("units")),
        "event_time": np.array([event["time"] for event in events], dtype=float),
        "event_element": np.array([event["name"] for event in events], dtype=np.str_),
        "event_kind": np.array([event["kind"] for event in events], dtype=np.str_),
        **{
            f"event_{name}": np.array([event.get(name, np.nan) for event in events], dtype=float)
            for name in ("velocity_before", "velocity_after")
        },
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
    if isinstance(value, (bool, np.bool_, bytes)) or not np.isscalar(value) and np.ndim(value) != 0:
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
    raise Error(f"{name} = {' '.join(repr(value).split())}: must be a number, a text, a list or a dict")
