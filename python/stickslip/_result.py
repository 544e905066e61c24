"""Base classes of results, and conversion of numbers and arrays."""

from __future__ import annotations

from decimal import Decimal
from typing import TYPE_CHECKING, Any, ClassVar, Mapping, NamedTuple, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native

Floats = NDArray[np.float64]
#: A number for a single point, an array for many.
Value = Union[float, Floats]


class Codes(NamedTuple):
    """Names at many points, stored as indices and converted to text on request."""

    places: NDArray[np.uint8]
    names: Sequence[str]


class Result:
    """Named values, read as attributes."""

    #: The names of the values, in order.
    _names: ClassVar[Sequence[str]] = ()
    #: The names of the numbers that are NaN, and of the counts that are -1, where they do not exist.
    _numbers: ClassVar[frozenset[str]] = frozenset()
    _counts: ClassVar[frozenset[str]] = frozenset()
    #: The names of the values that are computed only where `outputs` names them.
    _optional: ClassVar[frozenset[str]] = frozenset()

    def __init__(self, values: Mapping[str, Any]) -> None:
        codes = {}
        nan = Decimal("NaN") if any(isinstance(value, Decimal) for value in values.values()) else float("nan")
        for name in self._names:
            if name in self._optional and name not in values:
                continue
            value = values.get(name)
            if isinstance(value, Codes):
                codes[name] = value
                continue
            if value is None and name in self._numbers:
                value = nan
            elif value is None and name in self._counts:
                value = -1
            object.__setattr__(self, name, value)
        object.__setattr__(self, "_codes", codes)

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            codes = self.__dict__.get("_codes", {}).get(name)
            if codes is None and name in self._optional:
                raise AttributeError(f"{name} was not computed. Name it in outputs=")
            if codes is None:
                raise AttributeError(f"{type(self).__name__} has no value {name}. Its values are {', '.join(self._names)}")
            words = np.asarray(codes.names)[codes.places]
            object.__setattr__(self, name, words)
            return words

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"{type(self).__name__} cannot be changed")

    def __repr__(self) -> str:
        values = (f"{name}={_short(value)}" for name, value in self.to_dict().items() if value is not None)
        return f"{type(self).__name__}({', '.join(values)})"

    def to_dict(self) -> dict[str, Any]:
        """All values by name. A number that does not exist is NaN, and a count -1."""
        return {name: getattr(self, name) for name in self._names if self._has(name)}

    def _has(self, name: str) -> bool:
        """Whether a value was computed."""
        return name in self.__dict__ or name in self._codes

    def __getitem__(self, name: str) -> Any:
        if name not in self._names:
            raise KeyError(name)
        return getattr(self, name)

    def keys(self) -> list[str]:
        """The names of the values, so that ``dict(result)`` has all of them."""
        return list(self.to_dict())

    def __len__(self) -> int:
        return len(self.keys())

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._codes})

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        assert isinstance(other, Result)
        mine, others = self.to_dict(), other.to_dict()
        return mine.keys() == others.keys() and all(_are_same(value, others[name]) for name, value in mine.items())

    __hash__ = None  # type: ignore[assignment]

    def _with(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """The stored values, with some replaced by name."""
        own = {name: self._codes.get(name, self.__dict__.get(name)) for name in self._names if self._has(name)}
        return {**own, **values}

    if TYPE_CHECKING:
        _codes: Mapping[str, Codes]


def _short(value: Any) -> str:
    """A value for reading; of a long array its shape and its range."""
    if not isinstance(value, np.ndarray) or value.size <= 6:
        return repr(value)
    if value.dtype.kind not in "iuf" or np.all(np.isnan(value)):
        return f"<{value.dtype}, {value.shape}>"
    return f"<{value.shape}, {np.nanmin(value):.6g} to {np.nanmax(value):.6g}>"


def _are_same(one: Any, other: Any) -> bool:
    """Whether two values are equal, NaN included."""
    if isinstance(one, (np.ndarray, float)) and isinstance(other, (np.ndarray, float)):
        a, b = np.asarray(one), np.asarray(other)
        return a.shape == b.shape and np.array_equal(a, b, equal_nan=a.dtype.kind == "f" and b.dtype.kind == "f")
    if isinstance(one, Decimal) and isinstance(other, Decimal) and one.is_nan():
        return other.is_nan()
    return bool(one == other)


class Physical(Result):
    """The values of a result in the machine's units.

    Attributes
    ----------
    units : dict of str to str, or None
        The unit of each value; None if the machine was given in numbers without units.
    """

    units: Optional[Mapping[str, str]]

    def __init__(self, values: Mapping[str, Any], units: Optional[Mapping[str, str]] = None) -> None:
        object.__setattr__(self, "_names", tuple(values))
        object.__setattr__(self, "units", units)
        super().__init__(values)

    if TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any: ...

    def __repr__(self) -> str:
        units = self.units or {}
        values = self.to_dict()
        values.pop("units", None)
        texts = (f"{name}={_short(value)} {units.get(name, '')}".rstrip() for name, value in values.items())
        return f"Physical({', '.join(texts)})"

    def to_dict(self) -> dict[str, Any]:
        """All values by name, and under ``units`` their units where they are known."""
        values = super().to_dict()
        return values if self.units is None else {**values, "units": dict(self.units)}


class Points(NamedTuple):
    """Ratios at one point or many."""

    #: The common shape; None for single numbers.
    shape: Optional[tuple[int, ...]]
    #: Each ratio as given.
    given: Mapping[str, Floats]
    #: Each ratio as a column with one value for each point, or as one number for all points.
    columns: tuple[Value, ...]

    @property
    def size(self) -> int:
        return int(np.prod(self.shape or ()))

    def in_shape(self) -> dict[str, Any]:
        """The ratios for a result: numbers, or read-only arrays of the common shape."""
        if self.shape is None:
            return dict(zip(self.given, self.columns))
        return {name: np.broadcast_to(array, self.shape) for name, array in self.given.items()}


def numbers(name: str, value: ArrayLike) -> Floats:
    """A number or an array of any numeric type as 64-bit floats, with NaN for masked elements."""
    array = np.ma.asarray(value) if isinstance(value, np.ma.MaskedArray) else np.asarray(value)
    if array.dtype.kind in "OUS" and array.ndim == 0 and value is not None or array.dtype.kind == "O" and array.ndim:
        # This is a number as text or of another library, or a column of numbers with gaps, as in pandas.
        try:
            array = np.asarray(value, dtype=np.float64)
        except (TypeError, ValueError):
            raise _native.Error(f"{name}: must be numbers, not {value!r:.60}") from None
    if array.dtype.kind not in "iuf":
        raise _native.Error(f"{name}: must be numbers, not of type {array.dtype}")
    floats = array.astype(np.float64, copy=False)
    return np.ma.filled(floats, np.nan) if isinstance(floats, np.ma.MaskedArray) else floats


def one(name: str, value: Any) -> float:
    """A single number."""
    array = numbers(name, value)
    if array.ndim != 0:
        raise _native.Error(f"{name}: must be one number, not an array of shape {array.shape}")
    return float(array)


def points(**values: ArrayLike) -> Points:
    """The points of ratios, broadcast to a common shape."""
    given = {name: numbers(name, value) for name, value in values.items()}
    try:
        shape = np.broadcast_shapes(*(array.shape for array in given.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in given.items() if array.ndim)
        raise _native.Error(f"the shapes do not broadcast: {shapes}") from None

    def column(array: Floats) -> Value:
        if array.size == 1:
            return float(array.reshape(-1)[0])
        return np.ascontiguousarray(np.broadcast_to(array, shape)).reshape(-1)

    columns = tuple(column(array) for array in given.values())
    return Points(None if all(array.ndim == 0 for array in given.values()) else shape, given, columns)


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
    raise _native.Error(f"{name} = {value!r}: with bits, give one number, as text, Decimal, mpf, int or float")


def decimals(found: Mapping[str, Any]) -> dict[str, Any]:
    """The digits of an answer as decimal numbers."""

    def read(value: Any) -> Any:
        if isinstance(value, str):
            return Decimal(value)
        if isinstance(value, list):
            return [tuple(read(part) for part in pair) for pair in value]
        return value

    return {name: value if name in ("regime", "limit") else read(value) for name, value in found.items()}


def precision(bits: int) -> int:
    """The precision in bits, for the compiled part."""
    if not 1 <= bits < 2**32:
        raise _native.Error(f"bits = {bits} must be >= 1")
    return int(bits)
