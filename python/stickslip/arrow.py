"""Arrow tables as input and output, for pyarrow, polars, arro3, DuckDB and the engines that use them.

A table is any object with the PyCapsule interface (``__arrow_c_array__`` or ``__arrow_c_stream__``). Results have the
same interface: ``pyarrow.table(result)``, ``polars.DataFrame(result)``. Columns of 64-bit floats without nulls are
read without a copy. A batch gives a batch, as ``map_batches`` and ``mapInArrow`` require.
"""

from __future__ import annotations

from typing import Any, Iterable, Optional, Protocol, Union

from . import _native
from ._closed_forms import OF_ARRAYS, known
from ._start import REST, Start, periods_of, state

__all__ = ["response", "steady"]


class _Batch(Protocol):
    def __arrow_c_array__(self, requested_schema: Any = None) -> Any: ...


class _Stream(Protocol):
    def __arrow_c_stream__(self, requested_schema: Any = None) -> Any: ...


Table = Union[_Batch, _Stream]


def response(table: Table, outputs: Optional[Iterable[str]] = None) -> Any:
    """The closed forms at every row; see `stickslip.response`.

    Parameters
    ----------
    table : Arrow table or record batch
        With the columns ``omega`` and ``alpha``, and optionally ``damping_ratio`` and ``static_friction_ratio``.
    outputs : names, optional
        The columns of the result, from `stickslip.OUTPUTS`.

    Returns
    -------
    Arrow table, or record batch for a record batch
        One row for each row of the table, with null for values that do not exist.
    """
    chosen = OF_ARRAYS if outputs is None else known(outputs)
    return _native.arrow_response(table, list(chosen))


def steady(table: Table, *, start: Start = REST, max_periods: int = _native.MAX_PERIODS) -> Any:
    """The steady state at every row; see `stickslip.steady`.

    Parameters
    ----------
    table : Arrow table or record batch
        As for `response`.
    start, max_periods
        As for `stickslip.steady`, the same for all rows.

    Returns
    -------
    Arrow table, or record batch for a record batch
    """
    return _native.arrow_steady(table, state(start), periods_of(max_periods))
