"""Arrow tables as input and output, for pyarrow, polars, arro3, DuckDB and the engines that use them.

A table is any object with the PyCapsule interface (``__arrow_c_array__`` or ``__arrow_c_stream__``). Results have the
same interface: ``pyarrow.table(result)``, ``polars.DataFrame(result)``. Columns of 64-bit floats without nulls are
read without a copy. A batch gives a batch, as ``map_batches`` and ``mapInArrow`` require.
"""

from __future__ import annotations

from typing import Any, Iterable, Optional, Protocol, Union

from . import _native
from ._closed_forms import OF_ARRAYS, OUTPUTS
from ._result import named, whole_number
from ._start import REST, Start, state
from ._steady import AT_ONCE, STEADY_OUTPUTS

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
        The outputs, from `stickslip.OUTPUTS`; by default those that one pass computes.

    Returns
    -------
    Arrow table, or record batch for a record batch
        The columns of the table and after them the outputs, with null for values that do not exist.
    """
    chosen = OF_ARRAYS if outputs is None else named(outputs, OUTPUTS)
    return _native.arrow_response(table, list(chosen))


def steady(
    table: Table,
    outputs: Optional[Iterable[str]] = None,
    *,
    start: Start = REST,
    max_periods: int = _native.MAX_PERIODS,
) -> Any:
    """The steady state at every row; see `stickslip.steady`.

    Parameters
    ----------
    table : Arrow table or record batch
        As for `response`.
    outputs : names, optional
        The outputs, from `stickslip.STEADY_OUTPUTS`; by default those that need no search.
    start, max_periods
        As for `stickslip.steady`, the same for all rows.

    Returns
    -------
    Arrow table, or record batch for a record batch
        As for `response`; ``multipliers`` are four columns of real and imaginary parts.
    """
    chosen = AT_ONCE if outputs is None else named(outputs, STEADY_OUTPUTS)
    return _native.arrow_steady(table, list(chosen), state(start), whole_number("max_periods", max_periods))
