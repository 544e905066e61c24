"""What the results have in common, and arrays on their way in and out."""

from __future__ import annotations

from decimal import Decimal
from typing import Any, ClassVar, Mapping, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native

Floats = NDArray[np.float64]
#: A number for a single point, an array for many.
Value = Union[float, Floats]


class Result:
    """Named values, read as attributes."""

    #: The names of the values, in order.
    _names: ClassVar[Sequence[str]] = ()

    def __init__(self, values: Mapping[str, Any]) -> None:
        for name in self._names:
            object.__setattr__(self, name, values.get(name))

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"{type(self).__name__} cannot be changed")

    def __repr__(self) -> str:
        values = (f"{name}={value!r}" for name, value in self.to_dict().items() if value is not None)
        return f"{type(self).__name__}({', '.join(values)})"

    def to_dict(self) -> dict[str, Any]:
        """All values by name: None where a single point has none, NaN in an array."""
        return {name: getattr(self, name) for name in self._names}


class Physical(Result):
    """The values of a result in the machine's units."""

    def __init__(self, values: Mapping[str, Any]) -> None:
        object.__setattr__(self, "_names", tuple(values))
        super().__init__(values)

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(f"no value {name}; there are {', '.join(self._names)}")


def broadcast(*values: ArrayLike) -> tuple[tuple[int, ...] | None, list[Floats]]:
    """The common shape, None for single numbers, and the values as columns of one length."""
    arrays = [np.asarray(value, dtype=np.float64) for value in values]
    shape = np.broadcast_shapes(*(array.shape for array in arrays))
    columns = [np.ascontiguousarray(np.broadcast_to(array, shape)).reshape(-1) for array in arrays]
    return (None if all(array.ndim == 0 for array in arrays) else shape), columns


def shaped(columns: Mapping[str, NDArray[Any]], shape: tuple[int, ...]) -> dict[str, NDArray[Any]]:
    """The columns in the shape of what they were computed for."""
    return {name: column.reshape(shape) for name, column in columns.items()}


def named(codes: NDArray[np.uint8], names: Sequence[str]) -> NDArray[np.str_]:
    """The names that codes stand for."""
    return np.asarray(names)[codes]


def digits(name: str, value: Any) -> str:
    """A single number with all its digits: text, int, Decimal, float, or a number of mpmath."""
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
    """The digits of an answer as numbers that keep them."""

    def read(value: Any) -> Any:
        if isinstance(value, str):
            return Decimal(value)
        if isinstance(value, list):
            return [tuple(read(part) for part in pair) for pair in value]
        return value

    return {name: value if name in ("regime", "limit") else read(value) for name, value in found.items()}


def precision(bits: int) -> int:
    """The bits asked for, as the compiled part takes them."""
    if not 1 <= bits < 2**32:
        raise _native.Error(f"bits = {bits} must be >= 1")
    return int(bits)
