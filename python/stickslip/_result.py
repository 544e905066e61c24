"""What the results have in common, and arrays on their way in and out."""

from __future__ import annotations

from typing import Any, ClassVar, Mapping, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

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
