"""Arrays with labels: their alignment as arguments, and the labels of results."""

from __future__ import annotations

import errno
import importlib
import os
from collections.abc import Mapping
from typing import Any, NamedTuple, Optional, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._native import Error
from ._quantity import parted

Floats = NDArray[np.float64]


class Labelled(Protocol):
    """An array with labels of its own, such as a series or a frame of pandas or a data array of xarray."""

    def to_numpy(self) -> Any: ...


class WrongType(Error, TypeError):
    """An argument is of a type that has no meaning here."""


class FileError(Error, OSError):
    """A file cannot be opened. It is an `Error` and an `OSError`, with ``errno``, ``strerror`` and ``filename``; of a missing file, it is
    a `FileNotFoundError`, too."""

    #: The message, of a file that another one names with the place where it does.
    message: Optional[str] = None

    def __new__(cls, *given: Any) -> "FileError":
        # The first base would make no error of the system.
        return OSError.__new__(cls, *given)

    def __str__(self) -> str:
        return self.message or f"{self.filename}: {self.strerror}"


class _MissingFile(FileError, FileNotFoundError):
    """There is no such file."""


def unreadable(name: object, error: OSError) -> FileError:
    """The error of a file that cannot be opened."""
    kind = _MissingFile if isinstance(error, FileNotFoundError) else FileError
    file: Any = error.filename or name
    # A folder in the place of a file is refused before the system is asked.
    number = errno.EISDIR if error.errno is None and os.path.isdir(file) else error.errno
    found = kind(number, error.strerror or str(error), file)
    found.message = getattr(error, "message", None)
    return found


class Like(NamedTuple):
    """The kind of arrays in which the arguments were given: with a mask, with labels of pandas, or with dims of xarray."""

    shape: tuple[int, ...]
    mask: Optional[NDArray[np.bool_]] = None
    #: The labels of the last axes, as indices of pandas.
    axes: tuple[Any, ...] = ()
    #: The names of all axes and the coordinates of xarray.
    dims: tuple[str, ...] = ()
    coords: Any = None

    def dressed(self, name: str, array: NDArray[Any], attributes: Mapping[str, str]) -> Any:
        """An array of results in the kind of the arguments."""
        if self.dims and array.shape[: len(self.shape)] == self.shape:
            # Complex numbers of a cycle are two for each point.
            dims = (*self.dims, *(f"{name}_part" for _ in array.shape[len(self.shape) :]))
            return module("xarray").DataArray(array, coords=self.coords, dims=dims, name=name, attrs=dict(attributes))
        if array.shape != self.shape:
            return array
        if self.axes and len(self.axes) == len(self.shape) == 2:
            return module("pandas").DataFrame(array, index=self.axes[0], columns=self.axes[1], copy=False)
        if self.axes and len(self.axes) == len(self.shape) == 1:
            return module("pandas").Series(array, index=self.axes[0], name=name, copy=False)
        # Each output has a mask of its own, so that a change of one is none of the others.
        return array if self.mask is None else np.ma.MaskedArray(array, self.mask.copy())


def module(name: str) -> Any:
    """A package that the result needs and the package does not."""
    try:
        return importlib.import_module(name)
    except ImportError:
        raise Error(f"this needs the package {name}: pip install {name}") from None


def is_pandas(value: Any) -> bool:
    """Whether a value is a series or a frame of pandas."""
    return type(value).__module__.partition(".")[0] == "pandas" and hasattr(value, "index") and hasattr(value, "iloc")


def is_xarray(value: Any) -> bool:
    """Whether a value is a data array of xarray."""
    return type(value).__module__.partition(".")[0] == "xarray" and hasattr(value, "dims") and hasattr(value, "coords")


def is_labelled(value: Any) -> bool:
    return is_pandas(value) or is_xarray(value)


def numbers(name: str, value: Any, kind: str = "ratio") -> Floats:
    """A number or an array of any numeric type as 64-bit floats that later changes of the argument do not reach, with NaN for masked
    elements; in SI units, if it has a unit, which must be one of this kind."""
    value, unit = parted(name, value)
    floats = _numbers(name, value)
    return floats if not unit else in_units(name, floats, unit, kind, None)


def in_units(name: str, floats: Floats, unit: str, kind: str, units: Optional[str]) -> Floats:
    """Numbers in a unit, in a system of units."""
    return _native.read_column(name, np.ascontiguousarray(floats).reshape(-1), unit, kind, units).reshape(floats.shape)


def _numbers(name: str, value: Any) -> Floats:
    try:
        array = np.ma.asarray(value) if isinstance(value, np.ma.MaskedArray) else np.asarray(value)
        if array.dtype.kind == "O" and array.ndim:
            # This is a column of numbers of another library, or with gaps, as in pandas.
            if any(isinstance(element, (str, bytes)) for element in array.flat):
                raise _of_texts(name, value)
            column: Any = value
            array = column.to_numpy(np.float64, na_value=np.nan) if is_pandas(value) else array.astype(np.float64)
        elif array.dtype.kind in "OU" and array.ndim == 0 and value is not None:
            # This is a number as text, or of another library.
            array = array.astype(np.float64)
    except WrongType:
        raise
    except (TypeError, ValueError, OverflowError):
        kind = Error if isinstance(value, str) else WrongType
        raise kind(f"{name}: must be numbers, not {' '.join(repr(value).split()):.60}") from None
    if array.dtype.kind in "US":
        raise _of_texts(name, value)
    if array.dtype.kind not in "iuf":
        raise WrongType(f"{name}: must be numbers, not of type {array.dtype}")
    if array.dtype == np.float64 and is_frozen(array):
        return array
    if array.size > 1 and not any(array.strides) and type(array) is np.ndarray:
        # One number for all places stays one.
        return np.broadcast_to(array.flat[:1].astype(np.float64).reshape(()), array.shape)
    floats = array.astype(np.float64)
    return np.ma.filled(floats, np.nan) if isinstance(floats, np.ma.MaskedArray) else floats


def is_frozen(array: Any) -> bool:
    """Whether nothing can change an array: neither it nor one whose memory it shows is writeable."""
    while type(array) is np.ndarray and not array.flags.writeable:
        array = array.base
    return array is None


def _of_texts(name: str, value: Any) -> WrongType:
    short = " ".join(repr(value).split())
    return WrongType(f'{name}: must be numbers, not {short:.60}: arrays are bare numbers. Pass floats, and their units as units="kN,m"')


def shape_of(given: Mapping[str, Floats]) -> tuple[int, ...]:
    """The common shape of arrays."""
    try:
        return np.broadcast_shapes(*(array.shape for array in given.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in given.items() if array.ndim)
        raise Error(f"the shapes do not broadcast: {shapes}") from None


def aligned(values: Mapping[str, Any]) -> tuple[dict[str, Floats], Optional[Like]]:
    """The given numbers as arrays that broadcast, aligned by their labels, and how results are dressed.

    Data arrays of xarray are aligned by their dims and labels. Series and frames of pandas are aligned by their labels: a
    series beside a frame lies along that axis of the frame whose labels it has. Labels in another order are put in that of
    the first argument; other labels are refused. Arrays without labels broadcast as in NumPy.
    """
    of_dims = {name: value for name, value in values.items() if is_xarray(value)}
    of_labels = {name: value for name, value in values.items() if is_pandas(value)}
    if of_dims and of_labels:
        raise Error(f"{next(iter(of_dims))} and {next(iter(of_labels))}: labels of xarray and of pandas do not mix. Convert one of them")
    if of_dims:
        return _by_dims(values, of_dims)
    if of_labels:
        return _by_labels(values, of_labels)
    given = {name: numbers(name, value) for name, value in values.items()}
    masked = [value for value in values.values() if isinstance(value, np.ma.MaskedArray)]
    if not masked:
        return given, None
    shape = shape_of(given)
    mask = np.zeros(shape, dtype=bool)
    for value in masked:
        mask |= np.ma.getmaskarray(value)
    return given, Like(shape, mask) if shape else None


def _order(first: tuple[str, Any], other: tuple[str, Any], along: str = "") -> Optional[NDArray[np.intp]]:
    """The places of the first labels among others; None where they are the same. Labels that differ are refused."""
    (name, due), (own_name, own) = first, other
    if due.equals(own):
        return None
    if len(due) != len(own) or not due.is_unique or not own.is_unique or not due.isin(own).all():
        where = f" along {along}" if along else ""
        raise Error(f"{name} and {own_name}: have different labels{where}. Align them, or pass them by to_numpy()")
    places: NDArray[np.intp] = own.get_indexer(due)
    return places


def _same(one: Any, other: Any) -> bool:
    return len(one) == len(other) and bool(one.isin(other).all()) and bool(other.isin(one).all())


def _by_labels(values: Mapping[str, Any], labelled: Mapping[str, Any]) -> tuple[dict[str, Floats], Optional[Like]]:
    given = {name: numbers(name, value) for name, value in values.items()}
    frames = {name: value for name, value in labelled.items() if hasattr(value, "columns")}
    axes: tuple[Any, ...]
    if frames:
        first = next(iter(frames))
        rows, columns = axes = (frames[first].index, frames[first].columns)
        for name, value in labelled.items():
            array = given[name]
            if name in frames:
                for axis, (due, own) in enumerate(((rows, value.index), (columns, value.columns))):
                    order = _order((first, due), (name, own), ("the rows", "the columns")[axis])
                    array = array if order is None else array.take(order, axis)
            else:
                on_rows, on_columns = _same(rows, value.index), _same(columns, value.index)
                if on_rows == on_columns:
                    have = "both the rows and the columns" if on_rows else "neither the rows nor the columns"
                    raise Error(f"{name}: its labels are those of {have} of {first}. Give a frame, or an array by to_numpy()")
                order = _order((first, rows if on_rows else columns), (name, value.index))
                array = array if order is None else array[order]
                array = array[:, None] if on_rows else array[None, :]
            given[name] = array
    else:
        first = next(iter(labelled))
        axes = (labelled[first].index,)
        for name, value in labelled.items():
            order = _order((first, axes[0]), (name, value.index))
            given[name] = given[name] if order is None else given[name][order]
    shape = shape_of(given)
    if shape[-len(axes) :] != tuple(map(len, axes)):
        raise Error(f"{first}: has labels for a shape of {tuple(map(len, axes))}, but the other arrays give {shape}")
    return given, Like(shape, axes=axes)


def _by_dims(values: Mapping[str, Any], labelled: Mapping[str, Any]) -> tuple[dict[str, Floats], Optional[Like]]:
    dims: dict[str, int] = {}
    indexes: dict[str, tuple[str, Any]] = {}
    coordinates: dict[str, Any] = {}
    conflicting: set[str] = set()
    arrays: dict[str, tuple[tuple[str, ...], Floats]] = {}
    for name, value in labelled.items():
        array, own_dims = numbers(name, value), tuple(map(str, value.dims))
        for axis, (dim, length) in enumerate(zip(own_dims, array.shape)):
            if dims.setdefault(dim, length) != length:
                raise Error(f"{name}: has {length} values along {dim}, and another argument has {dims[dim]}")
            if dim in value.indexes:
                own = value.indexes[dim]
                order = _order(indexes.setdefault(dim, (name, own)), (name, own), dim)
                array = array if order is None else array.take(order, axis)
        for key, coordinate in value.coords.items():
            # A coordinate beside the labels, such as one of a single number, is kept unless two arguments contradict each other.
            if key not in value.dims and indexes.get(str(key)) is not None:
                continue
            if key not in value.dims:
                # Its labels are put in the order of the result, as are the values.
                along = {dim: indexes[dim][1] for dim in coordinate.dims if dim in indexes and dim in coordinate.indexes}
                coordinate = coordinate.sel(along) if along else coordinate
                if not coordinates.setdefault(str(key), coordinate).variable.equals(coordinate.variable):
                    conflicting.add(str(key))
            coordinates.setdefault(str(key), coordinate)
        arrays[name] = (own_dims, array)
    shape = tuple(dims.values())
    given: dict[str, Floats] = {}
    for name, value in values.items():
        if name in arrays:
            own_dims, array = arrays[name]
            order_of = [own_dims.index(dim) for dim in dims if dim in own_dims]
            array = array.transpose(order_of)
            given[name] = array.reshape([dims[dim] if dim in own_dims else 1 for dim in dims])
        else:
            given[name] = numbers(name, value)
    if shape_of(given) != shape:
        names = ", ".join(dims)
        raise Error(f"the dims are {names or 'none'}, of shape {shape}: an array without dims gives another shape {shape_of(given)}")
    coordinates = {key: value.drop_vars(conflicting, errors="ignore") for key, value in coordinates.items() if key not in conflicting}
    if not shape:
        return given, None
    return given, Like(shape, dims=tuple(dims), coords=coordinates)
