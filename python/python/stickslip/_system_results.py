"""The results of systems, and their tables: bodies, elements and times by name, with units."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._labels import module
from ._native import Error
from ._result import Floats, PhysicalResult, Result, are_same, unknown, whole_number

if TYPE_CHECKING:
    from ._system import System

#: The quantity, by whose unit a value of a body is measured, from the last word of its name.
_OF_LAST = {"displacement": "displacement", "velocity": "velocity", "acceleration": "acceleration", "drift": "displacement"}
#: The unit of a value of an element, or of a whole motion.
_OF_WHOLE = {"time_at_rest": "time", "work": "work", "load_work": "work", "damper_work": "work", "stored_energy": "work", "duration": "time"}


def _unit(units: Optional[Mapping[str, str]], name: str) -> str:
    """The unit of a value by its name."""
    quantity = _OF_WHOLE.get(name) or _OF_LAST.get(name.rpartition("_")[2], name)
    return (units or {}).get(quantity, "")


def _units(units: Optional[Mapping[str, str]], names: Sequence[str]) -> dict[str, str]:
    return {name: unit for name in names if (unit := _unit(units, name))}


def _variable(dims: Any, array: Any, unit: str = "") -> tuple[Any, ...]:
    """A variable or a coordinate of xarray with its unit."""
    return (dims, array, {"units": unit} if unit else {})


class ElementMotion(Result):
    """The answers of a contact, an elastic contact or a stop; see `SystemMotion.elements`.

    Attributes
    ----------
    kind : str
        ``"contact"``, ``"elastic"`` or ``"stop"``.
    time_at_rest : float
        Time in which a contact sticks, an elastic contact holds, or a stop is open, in the unit ``time``.
    stops : int
        How often such a time begins.
    blows : int
        How many blows a stop with a restitution gets; 0 of other elements.
    work : float
        Work that the bodies do on it, in the unit ``work``.
    """

    kind: str
    time_at_rest: float
    stops: int
    blows: int
    work: float


class Elements(dict[str, ElementMotion]):
    """The answers of each element by its name; see `SystemMotion.elements`."""

    units: Optional[Mapping[str, str]]

    def __init__(self, found: Mapping[str, ElementMotion], units: Optional[Mapping[str, str]]) -> None:
        super().__init__(found)
        self.units = units

    def to_frame(self) -> Any:
        """A frame of pandas with a row for each element: its kind, ``time_at_rest``, ``stops``, ``blows`` and ``work``. ``attrs["units"]`` has the units."""
        pandas = module("pandas")
        names = ("kind", "time_at_rest", "stops", "blows", "work")
        columns = {name: [element[name] for element in self.values()] for name in names}
        frame = pandas.DataFrame(columns, index=pandas.Index(list(self), name="element", dtype=object))
        frame.attrs["units"] = _units(self.units, names)
        return frame


class SystemEvents(PhysicalResult):
    """The events of a motion; see `SystemMotion.events`. ``pandas.DataFrame(events)`` is a table of them.

    Attributes
    ----------
    time : array
    element, kind : array of str
        Name of the element or level, and stick, slip, reverse, touch, yield, lock, open, close or blow, rise or fall.
    velocity_before, velocity_after : array
        Velocity along a stop with a restitution before and after a blow; NaN of other events.
    """

    _along = "time"
    time: Floats
    element: NDArray[np.str_]
    kind: NDArray[np.str_]
    velocity_before: Floats
    velocity_after: Floats

    def to_frame(self) -> Any:
        """A frame of pandas over the time, with the element and the kind of each event, and the velocities of blows."""
        pandas = module("pandas")
        columns = {name: self[name].astype(object) for name in ("element", "kind")}
        columns |= {name: self[name] for name in ("velocity_before", "velocity_after")}
        frame = pandas.DataFrame(columns, index=pandas.Index(self.time, name="time"))
        frame.attrs["units"] = dict(self.units or {})
        return frame


class SystemMotion(Result):
    """The motion of a system; see `System.simulate` and `System.follow`. Arrays have an entry for each coordinate.

    ``to_frame()`` has a row for each coordinate, ``events.to_frame()`` one for each event, ``elements.to_frame()`` one for each
    element. ``states()`` samples the motion, and ``plot()`` draws it.

    Attributes
    ----------
    kind : str
        ``"transient"``; of a steady motion ``"periodic"``, ``"rest"``, ``"growing"`` or ``"unsettled"``.
    coordinates : tuple of str
    duration : float
        In the unit ``time`` of ``units``.
    start_displacement, start_velocity, end_displacement, end_velocity : array
        States at the beginning and at the end.
    max_displacement, min_displacement, max_velocity, min_velocity : array
        Extremes, those between events too.
    max_absolute_acceleration : array, or None
        Greatest size of the acceleration in space; None where the base does not move.
    elements : dict of str to ElementMotion
    event_time : array
    event_element, event_kind : array of str
        Name of the element, and stick, slip, reverse, touch, yield, lock, open, close or blow.
    event_velocity_before, event_velocity_after : array
        Velocity along a stop with a restitution before and after a blow; NaN of other events.
    load_work, damper_work, stored_energy : float
        ``load_work = damper_work + stored_energy +`` the works of the elements, in the unit ``work``.
    units : dict of str to str, or None
        The unit of each quantity: ``time``, ``displacement``, ``velocity``, ``acceleration`` and ``work``; None for matrices without
        units.
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
    elements: Elements
    event_time: Floats
    event_element: NDArray[np.str_]
    event_kind: NDArray[np.str_]
    event_velocity_before: Floats
    event_velocity_after: Floats
    load_work: float
    damper_work: float
    stored_energy: float
    units: Optional[Mapping[str, str]]
    _system: System

    def of_system(self, system: System) -> Any:
        """This motion with the system that makes it, which samples it."""
        object.__setattr__(self, "_system", system)
        return self

    def __repr__(self) -> str:
        events = f"{len(self.event_time)} events"
        return f"{type(self).__name__}({self.kind}, {self.duration:.6g} long, {events}: {some(self.coordinates)})"

    @property
    def events(self) -> SystemEvents:
        """The events by their times."""
        names = ("time", "element", "kind", "velocity_before", "velocity_after")
        units = None if self.units is None else {"time": self.units["time"]}
        if units is not None and self.units is not None:
            units |= {name: self.units["velocity"] for name in names[3:]}
        return SystemEvents({name: self[f"event_{name}"] for name in names}, units=units)

    def _of_bodies(self) -> list[str]:
        """The values with an entry for each coordinate."""
        return [name for name in self._names if name.rpartition("_")[2] in _OF_LAST and self[name] is not None]

    def _of_motion(self) -> list[str]:
        """The values that are one number each."""
        return [name for name in self._names if isinstance(self[name], (int, float))]

    def to_frame(self) -> Any:
        """A frame of pandas with a row for each coordinate, and a column for each of its values. ``attrs["units"]`` has their units."""
        pandas = module("pandas")
        names = self._of_bodies()
        frame = pandas.DataFrame({name: self[name] for name in names}, index=pandas.Index(self.coordinates, name="body", dtype=object))
        frame.attrs["units"] = _units(self.units, names)
        return frame

    def to_xarray(self) -> Any:
        """A data set of xarray with the dimensions ``body``, ``element`` and ``event``, and the unit of each value."""
        elements, names = self.elements, ("kind", "time_at_rest", "stops", "blows", "work")
        variables: dict[str, Any] = {name: _variable("body", self[name], _unit(self.units, name)) for name in self._of_bodies()}
        for name in names:
            column = np.array([element[name] for element in elements.values()])
            variables[f"element_{name}"] = _variable("element", column, _unit(self.units, name))
        of_events = {"event_time": "time", "event_velocity_before": "velocity", "event_velocity_after": "velocity"}
        for name in ("event_element", "event_kind", *of_events):
            variables[name] = _variable("event", self[name], _unit(self.units, of_events.get(name, "")))
        for name in self._of_motion():
            variables[name] = _variable((), self[name], _unit(self.units, name))
        coords = {"body": list(self.coordinates), "element": list(elements)}
        return module("xarray").Dataset(variables, coords=coords, attrs={"kind": self.kind})

    def states(self, times: Union[int, ArrayLike] = 500) -> SystemStates:
        """The states of this motion at times, or at so many equal steps from its beginning to its end. A steady motion begins at the phase 0."""
        system = self.__dict__.get("_system")
        if system is None:
            raise Error("states: the system of this motion is not known")
        if isinstance(times, (int, np.integer)) and not isinstance(times, bool):
            steps = whole_number("times", times)
            times = np.linspace(0.0, self.duration, steps + 1)
        found: SystemStates = system.states(times, steady=isinstance(self, SystemSteady))
        return found

    def plot(self, *names: str, over: Optional[str] = None, ax: Any = None, samples: int = 500, **style: Any) -> Any:
        """Draws the motion over the time with matplotlib: displacements, or the quantities and columns that are named, as
        `SystemStates.plot` does. Returns the axes."""
        return self.states(samples).plot(*names, over=over, ax=ax, **style)


class SystemSteady(SystemMotion):
    """The motion that a system tends to; see `System.steady`. One period of it, with the values of a `SystemMotion`.

    Attributes
    ----------
    periods : int
        After how many periods of the loads the motion repeats itself.
    periods_followed : int
    disturbance_growth : float
        Greatest factor by which a small disturbance grew on the way to this motion; from about 1e12 on rounding may have chosen
        between several motions to which the start leads.
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
    disturbance_growth: float
    drift: Floats
    mean_velocity: Floats
    multipliers: NDArray[np.complex128]
    change: float
    decay: float


#: The quantities of states: of the bodies, and of the elements.
_OF_STATES = ("displacement", "velocity", "force", "absolute_acceleration")


class SystemStates(Result):
    """States of a system at times; see `System.states`.

    As a table it has the time and a column for each body and element, such as ``block.displacement``: ``pandas.DataFrame(states)``,
    ``dict(states)`` and ``states["block.displacement"]``.

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

    _along = "time"
    time: Floats
    displacement: Floats
    velocity: Floats
    force: Floats
    absolute_acceleration: Optional[Floats]
    coordinates: tuple[str, ...]
    elements: tuple[str, ...]
    units: Optional[Mapping[str, str]]

    def __init__(self, values: Mapping[str, Any]) -> None:
        bodies, elements = values["coordinates"], values["elements"]
        named = ((name, elements if name == "force" else bodies) for name in _OF_STATES if values[name] is not None)
        columns = [f"{own}.{name}" for name, names in named for own in names]
        super().__init__(values, chosen=("time", *columns))

    def _names_of(self, quantity: str) -> tuple[str, ...]:
        return self.elements if quantity == "force" else self.coordinates

    def __getitem__(self, name: str) -> Any:
        own, dot, quantity = str(name).rpartition(".")
        if dot and quantity in _OF_STATES and own in self._names_of(quantity) and self._values[quantity] is not None:
            return getattr(self, quantity)[:, self._names_of(quantity).index(own)]
        return super().__getitem__(name)

    def __contains__(self, name: object) -> bool:
        return super().__contains__(name) or name in self._names

    def _is_at_hand(self, name: str) -> bool:
        return True

    def _attributes(self, name: str) -> dict[str, str]:
        unit = _unit(self.units, name.rpartition(".")[2])
        return {"units": unit} if unit else {}

    def to_dict(self) -> dict[str, Any]:
        """All values by name, a list of rows for each quantity, for ``json.dumps`` as well."""
        from ._result import _plain

        return {name: _plain(self[name]) for name in self._names}

    def to_frame(self) -> Any:
        """A frame of pandas over the time, with a column for each body and element. ``attrs["units"]`` has the units."""
        pandas = module("pandas")
        columns = [name for name in self if name != "time"]
        frame = pandas.DataFrame({name: self[name] for name in columns}, index=pandas.Index(self.time, name="time"))
        frame.attrs["units"] = {name: unit for name in self if (unit := self._attributes(name).get("units"))}
        return frame

    def to_xarray(self) -> Any:
        """A data set of xarray with the dimensions ``time`` and ``body``, the forces with ``time`` and ``element``, and their units."""
        coords: dict[str, Any] = {"time": _variable("time", self.time, _unit(self.units, "time"))}
        coords |= {"body": list(self.coordinates), "element": list(self.elements)}
        variables = {
            name: _variable(("time", "element" if name == "force" else "body"), self[name], _unit(self.units, name))
            for name in _OF_STATES
            if self[name] is not None
        }
        return module("xarray").Dataset(variables, coords=coords)

    def plot(self, *names: str, over: Optional[str] = None, ax: Any = None, **style: Any) -> Any:
        """Draws columns over the time, or over another column, with matplotlib, and returns its axes.

        Parameters
        ----------
        names : str
            Columns such as ``"block.displacement"``, or quantities such as ``"force"``, which stand for all their columns; by default
            the displacements.
        over : str, optional
            A column, such as ``"block.displacement"`` for the loop of a contact's force.
        """
        from ._plot import lines, titled

        curves: dict[str, Any] = {}
        for name in names or ("displacement",):
            if name in _OF_STATES and self[name] is not None:
                curves |= {f"{own}.{name}": self[f"{own}.{name}"] for own in self._names_of(name)}
            elif name in self._chosen:
                curves[name] = self[name]
            else:
                raise unknown(repr(name), name, [*_OF_STATES, *self])
        along = over or "time"
        if along not in self._chosen:
            raise unknown(f"over = {along!r}", along, list(self))
        quantities = {name.rpartition(".")[2] for name in curves}
        label = titled(quantity := next(iter(quantities)), _unit(self.units, quantity)) if len(quantities) == 1 else ""
        shown = curves if len(quantities) > 1 else {name.rpartition(".")[0]: curve for name, curve in curves.items()}
        return lines(ax, self[along], shown, titled(along, self._attributes(along).get("units", "")), label, style)

    def __repr__(self) -> str:
        return f"SystemStates({len(self.time)} times: {some([*self.coordinates, *self.elements])})"


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


class GridAxis(NamedTuple):
    """An axis of a `SystemGrid`."""

    #: Its name: that of its labels, or of its only value.
    name: str
    #: The columns whose values change along it.
    columns: tuple[str, ...]
    #: Its labels, if it has others than the values.
    labels: Optional[Sequence[Any]]
    #: The number of places on it.
    length: int


def _bare(column: str) -> str:
    """The name of a column without its unit."""
    name, bracket, _ = column.rpartition("[")
    return name if bracket and column.endswith("]") else column


class SystemGrid(dict[str, Any]):
    """The answers over a grid, in columns by name and unit; see `System.grid`. ``pandas.DataFrame(grid)`` is a table of them, and
    ``to_frame()`` one over its axes.

    Attributes
    ----------
    axes : tuple of GridAxis
        The axes, of which the last varies fastest: the records, if there are any, then the values and the frequency.
    errors : dict of int to str
        The rows without an answer, with the reasons; their numbers are NaN.
    """

    axes: tuple[GridAxis, ...]
    errors: Mapping[int, str]
    _names: tuple[tuple[str, ...], tuple[str, ...]]

    def __init__(
        self,
        columns: Mapping[str, Any],
        errors: Mapping[int, str],
        axes: Sequence[GridAxis] = (),
        names: tuple[tuple[str, ...], tuple[str, ...]] = ((), ()),
    ) -> None:
        super().__init__(columns)
        self.errors, self.axes, self._names = dict(errors), tuple(axes), names

    def __missing__(self, name: str) -> Any:
        """A column by its name without the unit."""
        found = [own for own in self if _bare(own) == name]
        if len(found) != 1:
            raise KeyError(name)
        return self[found[0]]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, SystemGrid) and are_same(dict(self), dict(other)) and self.errors == other.errors

    def __ne__(self, other: object) -> bool:
        return not self == other

    def __repr__(self) -> str:
        rows = len(next(iter(self.values()), ()))
        failed = f", {len(self.errors)} without an answer" if self.errors else ""
        return f"SystemGrid({rows} rows{failed}: {some(list(self))})"

    @property
    def shape(self) -> tuple[int, ...]:
        """The number of places on each axis."""
        return tuple(axis.length for axis in self.axes)

    @property
    def units(self) -> Mapping[str, str]:
        """The unit of each column that has one, by the name of the column without it."""
        return {_bare(name): name[len(_bare(name)) + 1 : -1] for name in self if _bare(name) != name}

    def _answers(self) -> Iterator[str]:
        """The columns of answers."""
        given = {column for axis in self.axes for column in axis.columns}
        return (name for name in self if name not in given)

    def to_frame(self) -> Any:
        """A frame of pandas over the axes, with a column for each answer by its name without the unit. The index has the labels of the
        axes, or else their values, and ``attrs["units"]`` the units."""
        pandas = module("pandas")
        columns = {_bare(name): self[name] for name in self}
        index = []
        for place, axis in enumerate(self.axes):
            if axis.labels is None:
                index.append(columns.pop(_bare(axis.columns[0])))
            else:
                step = int(np.prod(self.shape[place + 1 :]))
                labels = np.repeat(np.asarray(axis.labels, dtype=object), step)
                index.append(np.tile(labels, int(np.prod(self.shape[:place]))))
        names = [axis.name for axis in self.axes]
        many = pandas.MultiIndex.from_arrays(index, names=names) if len(index) > 1 else pandas.Index(index[0], name=names[0]) if index else None
        frame = pandas.DataFrame(columns, index=many)
        frame.attrs["units"] = dict(self.units)
        return frame

    def to_xarray(self) -> Any:
        """A data set of xarray over the axes by their names, with ``body`` and ``element`` as further dimensions, and the unit of each
        variable. The values along an axis with labels are coordinates of it."""
        dims = [axis.name for axis in self.axes]
        coords: dict[str, Any] = {}
        for place, axis in enumerate(self.axes):
            if axis.labels is not None:
                coords[axis.name] = list(axis.labels)
            at = tuple(slice(None) if own == place else 0 for own in range(len(self.axes)))
            for column in axis.columns:
                coords[_bare(column)] = _variable(axis.name, self[column].reshape(self.shape)[at], self.units.get(_bare(column), ""))
        variables: dict[str, Any] = {}
        gathered: dict[tuple[str, str], dict[str, Any]] = {}
        for column in self._answers():
            name, unit = _bare(column), self.units.get(_bare(column), "")
            own, _, quantity = name.rpartition(".")
            of = next((dim for dim, names in zip(("body", "element"), self._names) if own in names), None)
            values = self[column].reshape(self.shape)
            if of is None:
                variables[name] = _variable(dims, values, unit)
            else:
                gathered.setdefault((of, quantity), {"unit": unit})[own] = values
        for (of, quantity), found in gathered.items():
            unit = found.pop("unit")
            coords.setdefault(of, list(self._names[of == "element"]))
            stacked = np.stack([found[own] for own in coords[of]], axis=-1)
            variables[quantity] = _variable([*dims, of], stacked, unit)
        return module("xarray").Dataset(variables, coords=coords)

    def plot(self, *names: str, ax: Any = None, **style: Any) -> Any:
        """Draws answers over the last axis with matplotlib, a line for each place on the other axes, and returns the axes of the
        picture. By default the greatest displacement of each body."""
        from ._plot import lines, titled

        known = {_bare(name): name for name in self}
        shown = [known.get(name, name) for name in names] or [name for name in self._answers() if _bare(name).endswith(".max_displacement")]
        for name in shown or ("",):
            if name not in self:
                raise unknown(repr(name), name, list(known))
        if not self.axes:
            raise Error("plot: the grid has no axis")
        *others, last = self.axes
        x_name = last.columns[0]
        x = self[x_name][: last.length] if last.labels is None else np.asarray(last.labels)
        curves: dict[str, Any] = {}
        for name in shown:
            rows = self[name].reshape(-1, last.length)
            for place, row in enumerate(rows):
                at = place * last.length
                where = ", ".join(f"{_bare(axis.columns[0])} = {_text(self[axis.columns[0]][at])}" for axis in others)
                curves[f"{_bare(name)}{f' ({where})' if where else ''}"] = row
        units, quantities = self.units, {_bare(name).rpartition(".")[2] for name in shown}
        label = titled(next(iter(quantities)), units.get(_bare(shown[0]), "")) if len(quantities) == 1 else ""
        return lines(ax, x, curves, titled(_bare(x_name), units.get(_bare(x_name), "")), label, style)


def _text(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def some(names: Sequence[str]) -> str:
    """Names in a line that fits a screen."""
    return ", ".join(names if len(names) <= 6 else [*names[:5], f"... {len(names) - 5} more"])
