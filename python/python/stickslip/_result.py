"""Base classes of results, and conversion of numbers and arrays."""

from __future__ import annotations

import copy
import dataclasses
import difflib
import html
import inspect
import operator
import re
from collections.abc import Callable, ItemsView, Iterable, Iterator, KeysView, Mapping, Sequence, ValuesView
from decimal import Decimal
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple, NoReturn, Optional, Protocol, TypeVar, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._help import Brief
from ._labels import Like, WrongType, aligned, is_labelled, module, numbers, shape_of
from ._native import Error

Floats = NDArray[np.float64]
Words = NDArray[np.str_]
#: A number for a single point, an array for many.
Value = Union[float, Floats]
#: The numbers of a result: `float` or `Decimal` at a point, an array at many points.
V = TypeVar("V")
#: The words of a result: `str` or an array.
W = TypeVar("W")
#: The unit and the meaning of an output.
Meaning = tuple[str, str]
#: The values that a result shows on one screen.
_MOST_SHOWN = 12
#: The number of an equation, of no use on an axis.
_NUMBER = re.compile(r" \(eq\. \d+\)")
#: The ratios that determine the motion.
RATIOS = ("omega", "alpha", "damping_ratio", "static_friction_ratio")


class Codes(NamedTuple):
    """Words at many points, stored as places in a list and converted to text on request."""

    places: NDArray[np.uint8]
    names: Sequence[str]

    def words(self) -> Words:
        return np.asarray(self.names)[self.places]


class Source(Protocol):
    """Computes further values of a result by their names."""

    def __call__(self, names: tuple[str, ...]) -> Mapping[str, Any]: ...


def read_only(value: Any) -> Any:
    """A value whose arrays, those of a dict too, cannot be written to."""
    if isinstance(value, dict):
        for inner in value.values():
            read_only(inner)
    elif type(value) is np.ndarray:
        value.flags.writeable = False
    return value


class Frozen:
    """Fields that cannot be changed, not even the arrays of a copy or of an unpickled object."""

    def __setstate__(self, state: Mapping[str, Any]) -> None:
        for name, value in state.items():
            object.__setattr__(self, name, read_only(value))


class Output:
    """A value of a result, which is computed when it is first read."""

    def __init__(self, name: str, text: str) -> None:
        self.__name__ = name
        self.__doc__ = text

    def __get__(self, result: Optional[Result], owner: type) -> Any:
        return self if result is None else result._read(self.__name__)

    def __set__(self, result: Result, value: Any) -> None:
        raise AttributeError(f"{type(result).__name__} cannot be changed")


class Result(dict[str, Any], metaclass=Brief):
    """Named values, read as attributes or as items. A value that is not there yet is computed when it is read."""

    #: The names of all values, in order: those annotated.
    _names: ClassVar[tuple[str, ...]] = ()
    #: The unit and the meaning of each value, where a class has one for all answers.
    _rows: ClassVar[Mapping[str, Meaning]] = {}
    #: The value along which those of a history lie, such as the time.
    _along: ClassVar[Optional[str]] = None
    _values: dict[str, Any]
    _seen: dict[str, Any]
    _source: Optional[Source]
    _chosen: tuple[str, ...]
    _like: Optional[Like]

    def __init_subclass__(cls, **options: Any) -> None:
        super().__init_subclass__(**options)
        if "_names" not in cls.__dict__:
            annotated = (name for base in reversed(cls.__mro__) for name in inspect.get_annotations(base))
            cls._names = tuple(dict.fromkeys(name for name in annotated if not name.startswith("_")))
        for name in cls._names:
            unit, text = cls._rows.get(name, ("", ""))
            setattr(cls, name, Output(name, f"{text} ({unit})" if unit not in ("", "1") else text))

    def __init__(
        self,
        values: Mapping[str, Any],
        source: Optional[Source] = None,
        *,
        chosen: Optional[Iterable[str]] = None,
        like: Optional[Like] = None,
    ) -> None:
        kept = {name: values[name] for name in self._names if name in values}
        known = self._names if source is not None else kept
        fields = {
            "_values": kept,
            "_seen": {},
            "_source": source,
            "_chosen": tuple(known if chosen is None else chosen),
            "_like": like,
        }
        self._restore(fields)

    def _restore(self, fields: Mapping[str, Any]) -> None:
        for name, value in fields.items():
            object.__setattr__(self, name, value)
        # The names alone, so that everything that counts or lists them sees them; values are read by `__getitem__`.
        dict.update(self, dict.fromkeys(self._chosen))

    def __reduce_ex__(self, protocol: Any) -> Any:
        return _restored, (type(self), dict(self.__dict__))

    def __copy__(self) -> Any:
        return _restored(type(self), dict(self.__dict__))

    def __deepcopy__(self, memo: Any) -> Any:
        return _restored(type(self), copy.deepcopy(dict(self.__dict__), memo))

    def _read(self, name: str) -> Any:
        if name not in self._seen:
            if name not in self._values and self._source is not None:
                self._values.update(self._source((name,)))
            if name not in self._values:
                raise AttributeError(f"{name} was not computed")
            value = self._values[name]
            value = value.words() if isinstance(value, Codes) else value
            if self._like is not None and isinstance(value, np.ndarray):
                value = self._like.dressed(name, value, self._attributes(name))
            self._seen[name] = value
        return self._seen[name]

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            if name.startswith("_"):
                raise AttributeError(name)
            raise AttributeError(f"{type(self).__name__} has no value {name}. Its values are {', '.join(self._names)}")

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"{type(self).__name__} cannot be changed")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"{type(self).__name__} cannot be changed")

    def _unchanged(self, *arguments: Any, **keywords: Any) -> NoReturn:
        raise TypeError(f"{type(self).__name__} cannot be changed")

    __setitem__ = __delitem__ = clear = pop = popitem = setdefault = update = __ior__ = _unchanged

    def __getitem__(self, name: str) -> Any:
        if name not in self._names:
            raise KeyError(name)
        return getattr(self, name)

    def get(self, name: str, default: Any = None) -> Any:
        return self[name] if name in self else default

    def __iter__(self) -> Iterator[str]:
        return iter(self._chosen)

    # A view of a dictionary would not see values that are computed when they are read.
    def keys(self) -> KeysView[str]:  # type: ignore[override]
        return KeysView(self)

    def values(self) -> ValuesView[Any]:  # type: ignore[override]
        self._compute(self._chosen)
        return ValuesView(self)

    def items(self) -> ItemsView[str, Any]:  # type: ignore[override]
        self._compute(self._chosen)
        return ItemsView(self)

    def copy(self) -> dict[str, Any]:
        return dict(self)

    def __or__(self, other: Mapping[str, Any]) -> dict[str, Any]:  # type: ignore[override]
        return {**self, **other}

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._names})

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self) or not isinstance(other, Result):
            return NotImplemented
        return self._chosen == other._chosen and all(are_same(self._at_hand(name), other._at_hand(name)) for name in self)

    def __ne__(self, other: object) -> bool:
        same = self.__eq__(other)
        return same if same is NotImplemented else not same

    __hash__ = None

    @property
    def units(self) -> Optional[Mapping[str, str]]:
        """The unit of each value that has one."""
        return {name: unit for name, (unit, _) in self._rows.items() if unit not in ("", "1")}

    def _attributes(self, name: str) -> dict[str, str]:
        """The unit and the meaning of a value, as attributes of xarray."""
        unit, text = (self.units or {}).get(name, ""), _NUMBER.sub("", self._rows.get(name, ("", ""))[1])
        return {key: value for key, value in (("units", unit), ("long_name", text)) if value}

    def _shape(self) -> tuple[int, ...]:
        """The common shape of the values; those of a history have that of its time."""
        if self._like is not None:
            return self._like.shape
        names = (self._along,) if self._along is not None else self._chosen
        arrays = (self._array(name) for name in names if self._is_at_hand(name))
        return next((array.shape for array in arrays), ())

    def _compute(self, names: Iterable[str]) -> None:
        """Computes those of some values that are not there yet at once."""
        missing = tuple(dict.fromkeys(name for name in names if name not in self._values))
        if missing and self._source is not None:
            self._values.update(self._source(missing))

    def _array(self, name: str) -> NDArray[Any]:
        self._read(name)
        value = self._values[name]
        return value.words() if isinstance(value, Codes) else np.asarray(value)

    def _columns(self) -> tuple[tuple[int, ...], dict[str, NDArray[Any]]]:
        """The common shape, and the values of that shape by name: for each point one, two, or the same one for all."""
        self._compute(self._chosen)
        shape = self._shape()
        found: dict[str, NDArray[Any]] = {}
        for name in self._chosen:
            array = self._array(name)
            of_each = self._along is None or array.shape == shape or array.ndim == 1 and array.shape == shape[-1:]
            if array.dtype.kind == "O" or not of_each:
                continue
            if array.ndim == 0 or self._along is not None:
                found[name] = np.broadcast_to(array, shape)
            elif array.shape == shape:
                found[name] = array
            elif array.shape[: len(shape)] == shape and array.ndim == len(shape) + 1:
                found.update({f"{name}_{part + 1}": array[..., part] for part in range(array.shape[-1])})
        return shape, found

    def _given(self, shape: tuple[int, ...]) -> dict[str, tuple[NDArray[Any], str]]:
        """What was given and is no value of the answer, in the shape of the points, with its unit."""
        return {}

    def to_frame(self) -> Any:
        """A frame of pandas with a row for each point, in the order of NumPy, and a column for each value.

        The labels of the arguments are its index. ``frame.attrs["units"]`` has the units. What differs among machines has a
        column, and a frequency that was given in hertz one in hertz, too.
        """
        pandas = module("pandas")
        shape, columns = self._columns()
        axes: Any = None
        like = self._like
        if like is not None and like.dims:
            axes = [like.coords[dim].to_index() if dim in like.coords else pandas.RangeIndex(n, name=dim) for dim, n in zip(like.dims, shape)]
        elif like is not None and like.axes and len(like.axes) == len(shape):
            axes = like.axes
        if axes is None:
            index = None
        elif len(axes) == 1:
            index = axes[0]
        else:
            index = pandas.MultiIndex.from_product(axes, names=[axis.name for axis in axes])
        units = dict(self.units or {})
        given = self._given(shape)
        columns = {**{name: array for name, (array, _) in given.items()}, **columns}
        units |= {name: unit for name, (_, unit) in given.items() if unit}
        frame = pandas.DataFrame({name: array.reshape(-1) for name, array in columns.items()}, index=index)
        frame.attrs["units"] = {name: units[name] for name in columns if name in units}
        return frame

    def to_xarray(self) -> Any:
        """A data set of xarray with a variable for each value, whose attributes are its unit and its meaning."""
        xarray = module("xarray")
        shape, columns = self._columns()
        like = self._like
        coords: dict[str, Any] = {}
        if like is not None and like.dims:
            dims, coords = like.dims, dict(like.coords)
        elif self._along is not None and len(shape) == 1:
            dims = (self._along,)
        elif like is not None and like.axes:
            unlabelled = len(shape) - len(like.axes)
            names = ("index",) if len(like.axes) == 1 else ("row", "column")
            own = [str(axis.name) if axis.name is not None else name for axis, name in zip(like.axes, names)]
            dims = (*(f"dim_{axis}" for axis in range(unlabelled)), *own)
            coords = {dim: (dim, axis) for dim, axis in zip(own, like.axes)}
        else:
            dims = tuple(f"dim_{axis}" for axis in range(len(shape)))
        if self._along is not None and len(shape) > 1:
            # The motions of many points have common phases.
            dims, coords = (*dims[:-1], "phase"), {**coords, "phase": ("phase", self._array("phase"))}
        variables = {name: (dims, array, self._attributes(name)) for name, array in columns.items() if name not in coords}
        for name, (array, unit) in self._given(shape).items():
            if name not in (*variables, *coords, *dims):
                variables[name] = (dims, array, {"units": unit} if unit else {})
        return xarray.Dataset(variables, coords=coords)

    def _titled(self, name: str) -> str:
        from ._plot import titled

        return titled(name, (self.units or {}).get(name, ""))

    def plot(self, *names: str, over: Optional[str] = None, ax: Any = None, **style: Any) -> Any:
        """Draws values with matplotlib, and returns its axes.

        Parameters
        ----------
        names : str
            The values: by default the displacement of a motion, and the peak displacement of many points.
        over : str, optional
            The value along the axis: by default the time of a motion, or the first ratio or frequency that varies. Points in a
            plane are a map over the two that vary along its columns and its rows.
        ax : matplotlib axes, optional
        style
            Of the lines, for matplotlib.
        """
        from ._plot import axes_of, lines, plane

        shown = names or (next(name for name in ("displacement", "max_displacement", "min_force_ratio", *self) if name in self._names),)
        for name in (*shown, *([] if over is None else [over])):
            if name not in self._names:
                raise Error(f"{name!r} must be one of {', '.join(self._names)}")
        shape = self._shape()
        if len(shape) == 1:
            x = over or self._along or next((name for name in self._axes() if np.ptp(self._array(name)) > 0), None)
            if x is None:
                raise Error("over: name the value along the axis")
            curves = {name: self._array(name) for name in shown}
            return lines(ax, self._array(x), curves, self._titled(x), self._titled(shown[0]), style)
        if len(shape) == 2 and self._along is not None:
            # A line for each motion.
            whole = [np.broadcast_to(self._array(name), shape) for name in (over or self._along, *shown)]
            ax = axes_of(ax)
            for one, *others in zip(*whole):
                for other in others:
                    ax.plot(one, other, **style)
            ax.set(xlabel=self._titled(over or self._along), ylabel=self._titled(shown[0]))
            return ax
        if len(shape) == 2 and len(shown) == 1:
            along: list[Optional[str]] = [None, None]
            for name in self._axes():
                array = np.broadcast_to(self._array(name), shape)
                for axis in (0, 1):
                    if along[axis] is None and np.array_equal(array, np.broadcast_to(array.take([0], 1 - axis), shape)) and np.ptp(array) > 0:
                        along[axis] = name
            if along[0] is not None and along[1] is not None:
                rows, columns = self._array(along[0])[:, 0], self._array(along[1])[0]
                return plane(ax, columns, rows, self._array(shown[0]), self._titled(along[1]), self._titled(along[0]), self._titled(shown[0]))
        raise Error(f"plot: draws values along one axis, or one value over a plane, not of shape {shape}")

    def _axes(self) -> list[str]:
        """The values that others may be drawn over."""
        known = ("angular_frequency", "period", "omega", "alpha", "force_amplitude", "friction_coefficient", "damping_ratio", "static_friction_ratio")
        return [name for name in known if name in self._names]

    def to_dict(self) -> dict[str, Any]:
        """All values by name as numbers, texts and lists of them, for ``json.dumps`` as well; a complex number is a pair. A value that
        does not exist is NaN."""
        return {name: _plain(self[name]) for name in self}

    def __repr__(self) -> str:
        values = ((name, self._at_hand(name)) for name in self._chosen if self._is_at_hand(name))
        texts = [f"{name}={self._text(name, value)}" for name, value in values if not _is_nothing(value)]
        if len(texts) > _MOST_SHOWN:
            texts = [*texts[:_MOST_SHOWN], f"... {len(texts) - _MOST_SHOWN} more"]
        return f"{type(self).__name__}({', '.join(texts)})"

    def _repr_html_(self) -> str:
        """A table of the values at hand, with their units and meanings, for notebooks."""
        rows = []
        for name in self._chosen:
            if not self._is_at_hand(name) or _is_nothing(self._at_hand(name)):
                continue
            attributes = self._attributes(name)
            cells = (name, short(self._at_hand(name)), attributes.get("units", ""), attributes.get("long_name", ""))
            rows.append("<tr>" + "".join(f"<td style='text-align:left'>{html.escape(cell)}</td>" for cell in cells) + "</tr>")
        return f"<table><caption>{type(self).__name__}</caption>{''.join(rows)}</table>"

    def _text(self, name: str, value: Any) -> str:
        return short(value)

    def _is_at_hand(self, name: str) -> bool:
        """Whether a value takes no further computation."""
        return name in self._values

    def _at_hand(self, name: str) -> Any:
        """A value as it is read, but words of many points by their codes, which take less memory."""
        value = self._values.get(name)
        return value if isinstance(value, Codes) and self._like is None else self[name]


def _restored(kind: type[Result], fields: Mapping[str, Any]) -> Result:
    new: Result = dict.__new__(kind)
    new._restore(fields)
    return new


def _plain(value: Any) -> Any:
    """A value for JSON."""
    if isinstance(value, Result):
        return value.to_dict()
    if isinstance(value, Mapping):
        return {name: _plain(inner) for name, inner in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(inner) for inner in value]
    if isinstance(value, complex):
        return [value.real, value.imag]
    if isinstance(value, np.ma.MaskedArray) and value.dtype.kind in "fiu":
        value = value.filled(np.nan)
    if is_labelled(value):
        value = value.to_numpy()
    if isinstance(value, np.ndarray):
        return _plain(value.tolist()) if value.dtype.kind == "c" else value.tolist()
    return value


def _is_nothing(value: Any) -> bool:
    return value is None or isinstance(value, (float, Decimal)) and value != value


def short(value: Any) -> str:
    """A value for reading; of a long array its shape and its range."""
    if isinstance(value, Codes):
        value = value.words() if value.places.size <= 6 else value.places.astype("S1")
    if is_labelled(value):
        value = value.to_numpy()
    if isinstance(value, Result):
        return f"<{type(value).__name__}>"
    if isinstance(value, np.ma.MaskedArray) and value.dtype.kind in "iuf" and value.size > 6:
        value = value.filled(np.nan)
    if not isinstance(value, np.ndarray):
        return repr(value)
    if value.size <= 6:
        return " ".join(str(value.tolist() if isinstance(value, np.ma.MaskedArray) else repr(value)).split())
    if value.dtype.kind not in "iuf":
        return f"<{'words' if value.dtype.kind in 'SUO' else value.dtype}, {value.shape}>"
    if np.all(np.isnan(value)):
        return f"<{value.shape}, nan>"
    return f"<{value.shape}, {np.nanmin(value):.6g} to {np.nanmax(value):.6g}>"


def are_equal(one: Any, other: Any) -> bool:
    """Whether two values of a data class are equal in each field that counts, arrays included."""
    if type(other) is not type(one):
        return False
    names = (field.name for field in dataclasses.fields(one) if field.compare)
    return all(are_same(getattr(one, name), getattr(other, name)) for name in names)


def are_same(one: Any, other: Any) -> bool:
    """Whether two values are equal, NaN included."""
    if type(one) is dict and type(other) is dict:
        return list(one) == list(other) and all(are_same(one[name], other[name]) for name in one)
    if isinstance(one, Codes) and isinstance(other, Codes):
        return one.names == other.names and np.array_equal(one.places, other.places)
    if isinstance(one, Codes) or isinstance(other, Codes):
        # One of them has been read before, and the other has not.
        one, other = (value.words() if isinstance(value, Codes) else value for value in (one, other))
    if is_labelled(one):
        return type(one) is type(other) and bool(one.equals(other))
    if isinstance(one, (np.ndarray, float)) and isinstance(other, (np.ndarray, float)):
        a, b = np.ma.getdata(one), np.ma.getdata(other)
        masks = np.array_equal(np.ma.getmaskarray(one), np.ma.getmaskarray(other))
        return masks and np.array_equal(a, b, equal_nan=a.dtype.kind in "fc" and b.dtype.kind in "fc")
    if isinstance(one, Decimal) and isinstance(other, Decimal) and one.is_nan():
        return other.is_nan()
    return bool(one == other)


class PhysicalResult(Result):
    """Values in the machine's units."""

    _units: Optional[Mapping[str, str]]

    def __init__(
        self,
        values: Mapping[str, Any],
        source: Optional[Source] = None,
        *,
        units: Optional[Mapping[str, str]] = None,
        chosen: Optional[Iterable[str]] = None,
        like: Optional[Like] = None,
    ) -> None:
        object.__setattr__(self, "_units", units)
        super().__init__(values, source, chosen=chosen, like=like)

    @property
    def units(self) -> Optional[Mapping[str, str]]:
        """The unit of each value; None if the machine was given in numbers without units."""
        return self._units

    def _given(self, shape: tuple[int, ...]) -> dict[str, tuple[NDArray[Any], str]]:
        driven = getattr(self, "_driven", None)
        return {} if driven is None or (driven.at.shape or ()) != shape else driven.varied()

    def _text(self, name: str, value: Any) -> str:
        return f"{short(value)} {(self.units or {}).get(name, '')}".rstrip()

    def _is_at_hand(self, name: str) -> bool:
        is_at_hand = getattr(self._source, "is_at_hand", None)
        return super()._is_at_hand(name) or is_at_hand is not None and is_at_hand(name)


class Joined:
    """Columns of `n` values, put together from parts. One whose values are all the same takes the memory of one number."""

    def __init__(self, n: int) -> None:
        self.n = n
        self.columns: dict[str, NDArray[Any]] = {}

    def put(self, part: slice, found: Mapping[str, NDArray[Any]]) -> None:
        """Adds the next part of each column."""
        for name, column in found.items():
            known = self.columns.get(name)
            before = column[:1] if known is None else known
            if known is not None and known.size == self.n and any(known.strides):
                known[part] = column
            elif self.n > 1 and column.size and np.all(column == before[0]):
                self.columns[name] = np.broadcast_to(before[0], part.stop)
            elif column.size == self.n:
                self.columns[name] = column
            else:
                self.columns[name] = whole = np.empty(self.n, column.dtype)
                whole[: part.start], whole[part] = before[:1], column


#: The points whose columns are in memory at once, where arrays are broadcast.
_BLOCK = 1 << 18


def blocks(n: int) -> Iterator[slice]:
    """The places of many points in parts; one part where there are few or none."""
    return (slice(low, min(low + _BLOCK, n)) for low in range(0, max(n, 1), _BLOCK))


class Points(NamedTuple):
    """Ratios at one point or many."""

    #: The common shape; None for single numbers.
    shape: Optional[tuple[int, ...]]
    #: Each ratio as given, in memory of its own.
    given: Mapping[str, Floats]
    #: The kind of the arrays given, unless it is that of NumPy.
    like: Optional[Like]

    @property
    def size(self) -> int:
        return int(np.prod(self.shape or ()))

    @property
    def columns(self) -> tuple[Value, ...]:
        """Each ratio as a column with one value for each point, or as one number for all points."""

        def column(array: Floats) -> Value:
            if array.size == 1 or array.size and not any(array.strides):
                return float(array.flat[0])
            return np.ascontiguousarray(np.broadcast_to(array, self.shape or ())).reshape(-1)

        return tuple(column(array) for array in self.given.values())

    def blocks(self) -> Iterator[tuple[int, int, Points]]:
        """The points in parts, each with its first place and the one after its last.

        An array that is broadcast is copied as a column: of a part at a time, so that all columns together take little
        memory beside the results.
        """
        shape = self.shape or ()
        if self.size <= _BLOCK or all(array.size in (1, self.size) for array in self.given.values()):
            yield 0, self.size, self
            return
        axis = next(axis for axis, length in enumerate(shape) if length > 1)
        row = self.size // shape[axis]
        rows = max(1, _BLOCK // row)
        for low in range(0, shape[axis], rows):
            high = min(low + rows, shape[axis])
            cut = (slice(None),) * axis + (slice(low, high),)
            given = {name: a if a.size == 1 else np.broadcast_to(a, shape)[cut] for name, a in self.given.items()}
            yield low * row, high * row, Points((*shape[:axis], high - low, *shape[axis + 1 :]), given, None)

    def in_shape(self) -> dict[str, Any]:
        """The ratios for a result: numbers, or read-only arrays of the common shape."""
        if self.shape is None:
            return dict(zip(self.given, self.columns))
        return {name: np.broadcast_to(array, self.shape) for name, array in self.given.items()}


def of_type(name: str, value: object, kind: type) -> None:
    """Fails where an argument is not of its class."""
    if not isinstance(value, kind):
        raise WrongType(f"{name}: must be a {kind.__name__}, not {type(value).__name__}")


def one(name: str, value: Any, kind: str = "ratio") -> float:
    """A single number, in SI units if it has one."""
    array = numbers(name, value, kind)
    if array.ndim != 0:
        raise Error(f"{name}: must be one number, not an array of shape {array.shape}")
    return float(array)


def of_number(name: str, value: Any, kind: str = "ratio") -> float:
    """A single number that is no flag, in SI units if it has one."""
    if isinstance(value, (bool, np.bool_, str, bytes)):
        raise WrongType(f"{name} = {value!r}: must be a number")
    return one(name, value, kind)


def whole_number(name: str, value: Any, most: int = 2**32) -> int:
    """A number of things, at least 1 and less than `most`."""
    try:
        if isinstance(value, (bool, np.bool_)):
            raise TypeError
        number = operator.index(value)
    except TypeError:
        raise WrongType(f"{name} = {value!r}: must be a whole number") from None
    if not 1 <= number < most:
        raise Error(f"{name} = {value} must be >= 1" + ("" if number < 1 else f" and < {most}"))
    return number


def points(**values: ArrayLike) -> Points:
    """The points of ratios, aligned by their labels and broadcast to a common shape."""
    given, like = aligned(values)
    if all(array.ndim == 0 for array in given.values()):
        return Points(None, given, None)
    return Points(shape_of(given), given, like)


#: A row of the table of an answer's outputs: name, kind, unit, meaning, and whether it needs a search of its own.
Row = tuple[str, str, str, str, bool]


def filled(
    into: Callable[..., None], rows: Mapping[str, Row], words: Mapping[str, list[str]], at: Points, names: Iterable[str], *more: Any
) -> dict[str, Any]:
    """The named outputs at many points, which `into` writes straight to their arrays."""
    shape = at.shape or ()
    found: dict[str, Any] = {}
    flat: list[NDArray[Any]] = []
    for name in names:
        kind = rows[name][1]
        if kind == "text":
            places = np.empty(shape, np.uint8)
            found[name] = Codes(places, words[name])
            flat.append(places.reshape(-1))
        elif kind == "pairs":
            found[name] = np.empty((*shape, 2), np.complex128)
            flat.append(found[name].reshape(-1).view(np.float64))
        else:
            found[name] = np.empty(shape)
            flat.append(found[name].reshape(-1))
    for low, high, part in at.blocks():
        widths = [array.size // max(at.size, 1) for array in flat]
        parts = [array[low * width : high * width] for array, width in zip(flat, widths)]
        into(part.columns, part.size, *more[:1], list(found), parts, *more[1:])
    return found


def paired(found: dict[str, Any]) -> dict[str, Any]:
    """The outputs at one point, with complex numbers for the pairs of their parts."""
    pairs = {name: np.array(value).reshape(-1).view(np.complex128) for name, value in found.items() if isinstance(value, list)}
    return {**found, **pairs}


def named(outputs: Iterable[str], known: Iterable[str]) -> tuple[str, ...]:
    """The names of chosen outputs, if they are known."""
    chosen = (outputs,) if isinstance(outputs, str) else tuple(outputs)
    names = tuple(known)
    for name in chosen:
        if name not in names:
            raise unknown(f"output {name!r}", name, names)
    return tuple(dict.fromkeys(chosen))


def unknown(what: str, name: object, known: Sequence[str]) -> Error:
    """The refusal of a name that is none of the known ones, with the one that it resembles."""
    near = difflib.get_close_matches(str(name), known, 1)
    return Error(f"{what} must be one of {', '.join(known)}" + (f". Did you mean {near[0]!r}?" if near else ""))


def shaped(columns: Mapping[str, NDArray[Any]], shape: tuple[int, ...]) -> dict[str, Any]:
    """The columns in the shape of their arguments."""
    return {name: column.reshape(shape) for name, column in columns.items()}


def digits(name: str, value: Any) -> str:
    """A single number with all its digits: text, int, Decimal, float, or a number of mpmath."""
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value[()]
    if isinstance(value, str):
        return value.strip()
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, Decimal):
        return str(value)
    if isinstance(value, (float, np.floating)):
        # Every binary number has finitely many decimal digits.
        return str(Decimal(float(value)))
    parts = getattr(value, "_mpf_", None)
    if parts is not None and parts[1]:
        sign, mantissa, exponent, _ = parts
        scaled = mantissa * (2**exponent if exponent >= 0 else 5**-exponent)
        return f"{'-' if sign else ''}{scaled}e{min(exponent, 0)}"
    if parts is not None:
        return str(value)
    raise WrongType(f"{name} = {value!r}: with bits, give one number, as text, Decimal, mpf, int or float")


def decimals(found: Mapping[str, Any]) -> dict[str, Any]:
    """The digits of an answer as decimal numbers."""

    def read(value: Any) -> Any:
        if isinstance(value, str):
            return Decimal(value)
        if isinstance(value, list):
            return [tuple(read(part) for part in pair) for pair in value]
        return Decimal("NaN") if value is None else value

    return {name: value if name in ("regime", "limit") else read(value) for name, value in found.items()}


def precision(bits: int) -> int:
    """The precision in bits, for the compiled part."""
    return whole_number("bits", bits)
