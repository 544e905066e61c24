"""Base classes of results, and conversion of numbers and arrays."""

from __future__ import annotations

import dataclasses
import importlib
import inspect
import operator
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from decimal import Decimal
from typing import TYPE_CHECKING, Any, ClassVar, Generic, NamedTuple, Optional, Protocol, TypeVar, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._native import Error

Floats = NDArray[np.float64]
Words = NDArray[np.str_]
#: A number for a single point, an array for many.
Value = Union[float, Floats]
#: The numbers of a result: `float` or `Decimal` at a point, an array at many points.
V = TypeVar("V")
#: The words of a result: `str` or an array.
W = TypeVar("W")
#: The ratios that determine the motion.
RATIOS = ("omega", "alpha", "damping_ratio", "static_friction_ratio")


class WrongType(Error, TypeError):
    """An argument is of a type that has no meaning here."""


class Codes(NamedTuple):
    """Words at many points, stored as places in a list and converted to text on request."""

    places: NDArray[np.uint8]
    names: Sequence[str]

    def words(self) -> Words:
        return np.asarray(self.names)[self.places]


class Like(NamedTuple):
    """The kind of array in which the arguments were given: masked, or of pandas."""

    shape: tuple[int, ...]
    mask: Optional[NDArray[np.bool_]] = None
    #: The index and the columns of a series or a frame of pandas.
    index: Any = None
    columns: Any = None

    def dressed(self, name: str, array: NDArray[Any]) -> Any:
        """An array of results in the kind of the arguments."""
        if array.shape != self.shape:
            return array
        if self.columns is not None:
            return _pandas().DataFrame(array, index=self.index, columns=self.columns, copy=False)
        if self.index is not None:
            return _pandas().Series(array, index=self.index, name=name, copy=False)
        # Each output has a mask of its own, so that a change of one is none of the others.
        return array if self.mask is None else np.ma.MaskedArray(array, self.mask.copy())


def _pandas() -> Any:
    return importlib.import_module("pandas")


class Source(Protocol):
    """Computes further values of a result by their names."""

    def __call__(self, names: tuple[str, ...]) -> Mapping[str, Any]: ...


class Result(Mapping[str, Any]):
    """Named values, read as attributes or as items. A value that is not there yet is computed when it is read."""

    #: The names of all values, in order: those annotated.
    _names: ClassVar[tuple[str, ...]] = ()
    _values: dict[str, Any]
    _source: Optional[Source]
    _chosen: tuple[str, ...]
    _like: Optional[Like]
    #: The same values in units, for the answer of a machine.
    _physical: Optional[Result]

    def __init_subclass__(cls, **options: Any) -> None:
        super().__init_subclass__(**options)
        if "_names" not in cls.__dict__:
            annotated = (name for base in reversed(cls.__mro__) for name in inspect.get_annotations(base))
            cls._names = tuple(name for name in annotated if not name.startswith("_"))

    def __init__(
        self,
        values: Mapping[str, Any],
        source: Optional[Source] = None,
        *,
        chosen: Optional[Iterable[str]] = None,
        like: Optional[Like] = None,
        physical: Optional[Result] = None,
    ) -> None:
        kept = {name: values[name] for name in self._names if name in values}
        known = self._names if source is not None else kept
        object.__setattr__(self, "_values", kept)
        object.__setattr__(self, "_source", source)
        object.__setattr__(self, "_chosen", tuple(known if chosen is None else chosen))
        object.__setattr__(self, "_like", like)
        object.__setattr__(self, "_physical", physical)

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            if name == "physical":
                raise AttributeError("values in units are those of a machine; see Machine")
            if name.startswith("_") or name not in self._names:
                raise AttributeError(f"{type(self).__name__} has no value {name}. Its values are {', '.join(self._names)}")
            if name not in self._values and self._source is not None:
                self._values.update(self._source((name,)))
            if name not in self._values:
                raise AttributeError(f"{name} was not computed")
            value = self._values[name]
            value = value.words() if isinstance(value, Codes) else value
            if self._like is not None and isinstance(value, np.ndarray):
                value = self._like.dressed(name, value)
            object.__setattr__(self, name, value)
            return value

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"{type(self).__name__} cannot be changed")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"{type(self).__name__} cannot be changed")

    def __getitem__(self, name: str) -> Any:
        if name not in self._names:
            raise KeyError(name)
        return getattr(self, name)

    def __contains__(self, name: object) -> bool:
        return name in self._chosen

    def __iter__(self) -> Iterator[str]:
        return iter(self._chosen)

    def __len__(self) -> int:
        return len(self._chosen)

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._names})

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self) or not isinstance(other, Result):
            return NotImplemented
        same = self._chosen == other._chosen and self._physical == other._physical
        return same and all(_are_same(self._at_hand(name), other._at_hand(name)) for name in self)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        values = ((name, self._at_hand(name)) for name in self._chosen if self._is_at_hand(name))
        texts = (f"{name}={self._text(name, value)}" for name, value in values if not _is_nothing(value))
        return f"{type(self).__name__}({', '.join(texts)})"

    def _text(self, name: str, value: Any) -> str:
        return _short(value)

    def _is_at_hand(self, name: str) -> bool:
        """Whether a value takes no further computation."""
        return name in self._values

    def _at_hand(self, name: str) -> Any:
        """A value as it is read, but words of many points by their codes, which take less memory."""
        value = self._values.get(name)
        return value if isinstance(value, Codes) and self._like is None else self[name]

    def to_dict(self) -> dict[str, Any]:
        """All values by name, or those named by ``outputs``. A value that does not exist is NaN."""
        return dict(self)


def _is_nothing(value: Any) -> bool:
    return value is None or isinstance(value, (float, Decimal)) and value != value


def _short(value: Any) -> str:
    """A value for reading; of a long array its shape and its range."""
    if isinstance(value, Codes):
        value = value.words() if value.places.size <= 6 else value.places.astype("S1")
    if _is_pandas(value):
        value = value.to_numpy()
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
    return all(_are_same(getattr(one, name), getattr(other, name)) for name in names)


def _are_same(one: Any, other: Any) -> bool:
    """Whether two values are equal, NaN included."""
    if isinstance(one, Codes) and isinstance(other, Codes):
        return one.names == other.names and np.array_equal(one.places, other.places)
    if _is_pandas(one):
        return type(one) is type(other) and bool(one.equals(other))
    if isinstance(one, (np.ndarray, float)) and isinstance(other, (np.ndarray, float)):
        a, b = np.ma.getdata(one), np.ma.getdata(other)
        masks = np.array_equal(np.ma.getmaskarray(one), np.ma.getmaskarray(other))
        return masks and np.array_equal(a, b, equal_nan=a.dtype.kind in "fc" and b.dtype.kind in "fc")
    if isinstance(one, Decimal) and isinstance(other, Decimal) and one.is_nan():
        return other.is_nan()
    return bool(one == other)


def _is_pandas(value: Any) -> bool:
    """Whether a value is a series or a frame of pandas."""
    return type(value).__module__.partition(".")[0] == "pandas" and hasattr(value, "index") and hasattr(value, "iloc")


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

    def _text(self, name: str, value: Any) -> str:
        return f"{_short(value)} {(self.units or {}).get(name, '')}".rstrip()

    def _is_at_hand(self, name: str) -> bool:
        is_at_hand = getattr(self._source, "is_at_hand", None)
        return super()._is_at_hand(name) or is_at_hand is not None and is_at_hand(name)


class Physical(PhysicalResult, Generic[V]):
    """Values in the machine's units under a drive."""

    angular_frequency: V
    """Angular frequency of the drive."""
    force_amplitude: V
    """Amplitude of the drive as a force."""
    friction_displacement: V
    """Friction bound over stiffness, B."""
    mean_displacement: V
    """The shift due to a mean force or to friction that depends on the direction."""


#: The points whose columns are in memory at once, where arrays are broadcast.
_BLOCK = 1 << 18


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
            if array.size == 1:
                return float(array.reshape(-1)[0])
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


def numbers(name: str, value: ArrayLike) -> Floats:
    """A number or an array of any numeric type as 64-bit floats in new memory, with NaN for masked elements."""
    try:
        array = np.ma.asarray(value) if isinstance(value, np.ma.MaskedArray) else np.asarray(value)
        if array.dtype.kind == "O" and array.ndim:
            # This is a column of numbers of another library, or with gaps, as in pandas.
            if any(isinstance(element, (str, bytes)) for element in array.flat):
                raise TypeError
            column: Any = value
            array = column.to_numpy(np.float64, na_value=np.nan) if _is_pandas(value) else array.astype(np.float64)
        elif array.dtype.kind in "OUS" and array.ndim == 0 and value is not None:
            # This is a number as text, or of another library.
            array = array.astype(np.float64)
    except (TypeError, ValueError, OverflowError):
        kind = Error if isinstance(value, str) else WrongType
        raise kind(f"{name}: must be numbers, not {' '.join(repr(value).split()):.60}") from None
    if array.dtype.kind not in "iuf":
        raise WrongType(f"{name}: must be numbers, not of type {array.dtype}")
    floats = array.astype(np.float64)
    return np.ma.filled(floats, np.nan) if isinstance(floats, np.ma.MaskedArray) else floats


def of_type(name: str, value: object, kind: type) -> None:
    """Fails where an argument is not of its class."""
    if not isinstance(value, kind):
        raise WrongType(f"{name}: must be a {kind.__name__}, not {type(value).__name__}")


def one(name: str, value: Any) -> float:
    """A single number."""
    array = numbers(name, value)
    if array.ndim != 0:
        raise Error(f"{name}: must be one number, not an array of shape {array.shape}")
    return float(array)


def whole_number(name: str, value: Any, most: int = 2**32) -> int:
    """A number of things, at least 1 and less than `most`."""
    try:
        number = operator.index(value)
    except TypeError:
        raise WrongType(f"{name} = {value!r}: must be a whole number") from None
    if not 1 <= number < most:
        raise Error(f"{name} = {value} must be >= 1" + ("" if number < 1 else f" and < {most}"))
    return number


def points(**values: ArrayLike) -> Points:
    """The points of ratios, broadcast to a common shape."""
    given = {name: numbers(name, value) for name, value in values.items()}
    try:
        shape = np.broadcast_shapes(*(array.shape for array in given.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in given.items() if array.ndim)
        raise Error(f"the shapes do not broadcast: {shapes}") from None
    if all(array.ndim == 0 for array in given.values()):
        return Points(None, given, None)
    return Points(shape, given, _like(values, shape))


def _like(values: Mapping[str, Any], shape: tuple[int, ...]) -> Optional[Like]:
    """The kind of arrays that results have: of pandas where an argument of their shape is, masked where any is."""
    frames = {name: value for name, value in values.items() if _is_pandas(value) and np.shape(value) == shape}
    if frames:
        (first, like), *others = frames.items()
        columns = getattr(like, "columns", None)
        for name, other in others:
            theirs = getattr(other, "columns", None)
            if not like.index.equals(other.index) or columns is not None and not columns.equals(theirs):
                raise Error(f"{first} and {name}: have different indices. Align them, or pass them by to_numpy()")
        return Like(shape, index=like.index, columns=columns)
    masked = [value for value in values.values() if isinstance(value, np.ma.MaskedArray)]
    if not masked:
        return None
    mask = np.zeros(shape, dtype=bool)
    for value in masked:
        mask |= np.ma.getmaskarray(value)
    return Like(shape, mask)


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
            raise Error(f"output {name!r} is none of {', '.join(names)}")
    return tuple(dict.fromkeys(chosen))


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
