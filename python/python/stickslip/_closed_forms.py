"""Closed forms of the non-sticking cycle, and its border."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from decimal import Decimal
from typing import Any, NamedTuple, Optional, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._native import Error
from . import _rows
from ._outputs import BorderOutputs, MachineResponseOutputs, ResponseOutput, ResponseOutputs
from ._labels import Labelled, WrongType
from ._result import (
    RATIOS,
    Floats,
    Points,
    Row,
    V,
    W,
    Words,
    decimals,
    digits,
    filled,
    named,
    of_type,
    paired,
    points,
    precision,
)
from ._wide import wide

_ROWS: dict[str, Row] = {row[0]: row for row in _native.RESPONSE}
#: Names of the outputs of `response`.
OUTPUTS: tuple[ResponseOutput, ...] = tuple(_ROWS)  # type: ignore[arg-type]
#: Those that are numbers of a definition of their own, which have enclosures.
CLOSED_FORMS: tuple[str, ...] = tuple(_native.OUTPUTS)
_WORDS = {"regime": _native.REGIMES}
#: The outputs that are computed at once for arrays: those that one pass of vector instructions computes. The others
#: are computed when they are read.
OF_ARRAYS = (
    "regime",
    "max_displacement",
    "displacement_phase",
    "max_velocity",
    "velocity_phase",
    "deviation",
    "min_force_ratio",
    "loop_size_stiffness",
    "loop_size_inertia",
    "contraction",
)
#: The number of points from which on outputs are computed when they are read, unless they are named.
_MANY = 1 << 17
#: The outputs that are computed at once at a single point: those that need no search.
_OF_POINT = tuple(name for name, row in _ROWS.items() if not row[4])


_OF_BORDER = (
    "min_force_ratio",
    "min_force_ratio_turning_point",
    "border_phase",
    "least_displacement",
    "best_force_ratio",
)


class _Source(NamedTuple):
    """The question, for outputs that are computed when they are read."""

    at: Points
    excitation: Optional[str] = None

    def __call__(self, names: Iterable[str]) -> dict[str, Any]:
        if self.at.shape is None:
            return paired(_native.response_at(self.at.columns, self.excitation, list(names)))
        return filled(_native.response_into, _ROWS, _WORDS, self.at, names, self.excitation)


class Response(ResponseOutputs[V, W]):
    """The closed-form response at one point or many; see `response`.

    Its attributes are the ratios ``omega``, ``alpha``, ``damping_ratio`` and ``static_friction_ratio``, and the outputs. Displacements
    are in units of B = r_y/k, velocities in B ω_d, phases in radians of the drive; ``units`` has the unit of each.
    """


class MachineResponse(MachineResponseOutputs[V, W]):
    """The closed-form response of a machine in its units; see `Machine.response`. ``units`` has the unit of each value."""

    _ratios: Response[V, W]

    @property
    def ratios(self) -> Response[V, W]:
        """The same response in ratios."""
        return self._ratios


class Border(BorderOutputs[V]):
    """The border of the non-sticking cycle; see `border`."""


@overload
def response(
    omega: float,
    alpha: float,
    damping_ratio: float = 0.0,
    static_friction_ratio: float = 1.0,
    *,
    outputs: Optional[Iterable[ResponseOutput]] = None,
) -> Response[float, str]: ...


@overload
def response(
    omega: Labelled,
    alpha: Any,
    damping_ratio: Any = 0.0,
    static_friction_ratio: Any = 1.0,
    *,
    outputs: Optional[Iterable[ResponseOutput]] = None,
) -> Response[Any, Any]: ...


@overload
def response(
    omega: ArrayLike,
    alpha: Labelled,
    damping_ratio: Any = 0.0,
    static_friction_ratio: Any = 1.0,
    *,
    outputs: Optional[Iterable[ResponseOutput]] = None,
) -> Response[Any, Any]: ...


@overload
def response(
    omega: ArrayLike,
    alpha: ArrayLike,
    damping_ratio: ArrayLike = 0.0,
    static_friction_ratio: ArrayLike = 1.0,
    *,
    outputs: Optional[Iterable[ResponseOutput]] = None,
    out: Optional[Mapping[str, NDArray[np.float64]]] = None,
) -> Response[Floats, Words]: ...


@overload
def response(
    omega: Any,
    alpha: Any,
    damping_ratio: Any = 0.0,
    static_friction_ratio: Any = 1.0,
    *,
    outputs: Optional[Iterable[ResponseOutput]] = None,
    bits: int,
) -> Response[Decimal, str]: ...


def response(
    omega: Any,
    alpha: Any,
    damping_ratio: Any = 0.0,
    static_friction_ratio: Any = 1.0,
    *,
    outputs: Optional[Iterable[ResponseOutput]] = None,
    out: Optional[Mapping[str, NDArray[np.float64]]] = None,
    bits: Optional[int] = None,
) -> Response[Any, Any]:
    """The response at (omega, alpha) in closed form.

    Parameters
    ----------
    omega : float or array
        Frequency ratio, > 0.
    alpha : float or array
        Force ratio, > 0.
    damping_ratio : float or array
        Damping ratio of a viscous damper, >= 0.
    static_friction_ratio : float or array
        Ratio of static to kinetic friction, >= 1. It raises the border, but does not change the non-sticking cycle.
        Above 1 the motion can depend on the start.
    outputs : names, optional
        The outputs to compute at once, from `OUTPUTS`; ``dict(result)`` then has these alone. Without it, those that
        take little time are computed at once below 131,072 points, and every other output when it is read.
    out : mapping of names to arrays, optional
        For array arguments: existing arrays that receive the named outputs. Each is C-contiguous, of type float64 and
        of the broadcast shape. Reusing arrays avoids new memory.
    bits : int, optional
        For a single point: the precision in bits, up to 1024, with every output rounded once. Arguments may then be
        text, `decimal.Decimal` or numbers of mpmath, and the outputs are `decimal.Decimal`. A float has its exact
        binary value: ``"0.7"`` and ``0.7`` differ in the 17th digit.

    Returns
    -------
    Response
        Numbers for single numbers, and arrays of the broadcast shape otherwise, where counts and flags are numbers,
        too. A value that does not exist, such as the displacement of a body that sticks, is NaN; ``regime`` says why.
        An argument of pandas with the shape of the result, a series or a frame, gives results with its index; series
        must have one index. Masked arrays give masked arrays.

    Raises
    ------
    Error
        If a single number is outside the domain. In an array such a point, or a masked one, has the regime
        ``"invalid"`` and NaN for its numbers.

    Examples
    --------
    >>> import numpy as np, stickslip as ss
    >>> ss.response(0.4, 6).regime
    'sticking'
    >>> ss.response(0.4, 6).min_force_ratio
    6.9497...
    >>> ss.response("0.7", 2, bits=100).max_displacement
    Decimal('3.4885078724977...')
    >>> curve = ss.response(np.linspace(0.6, 1.6, 5), 2.5, outputs=["max_displacement"])
    >>> curve.max_displacement.round(3)
    array([ 3.786,  8.004, 10.087,  2.508,  1.301])
    >>> stroke = np.empty(5)
    >>> ss.response(np.linspace(0.6, 1.6, 5), 2.5, out={"max_displacement": stroke}).max_displacement is stroke
    True
    """
    if out is not None and (outputs is not None or bits is not None):
        raise Error("out: names the outputs itself, in floats, so that outputs and bits must be left out")
    chosen = None if outputs is None else named(outputs, OUTPUTS)
    if bits is not None:
        texts = wide_ratios(omega, alpha, damping_ratio, static_friction_ratio)
        answer = decimals(wide("wide_response", precision(bits), texts))
        ratios = dict(zip(RATIOS, map(Decimal, texts)))
        return Response({**answer, **ratios}, chosen=None if chosen is None else (*RATIOS, *chosen))
    given = (omega, alpha, damping_ratio, static_friction_ratio)
    at = points(**dict(zip(RATIOS, given)))
    if out is None:
        return of_points(at, chosen)
    if at.shape is None:
        raise Error("out: is for arrays, but omega, alpha and the other ratios are single numbers")
    flat = _flat(out, at.shape, given)
    _native.response_into(at.columns, at.size, None, list(out), flat)
    return Response({**at.in_shape(), **out}, _Source(at), chosen=(*RATIOS, *out))


def of_points(at: Points, chosen: Optional[tuple[str, ...]], excitation: Optional[str] = None) -> Response[Any, Any]:
    """The response at points, under an excitation if there is one."""
    source = _Source(at, excitation)
    if chosen is not None:
        first: tuple[str, ...] = chosen
    else:
        first = _OF_POINT if at.shape is None else OF_ARRAYS if at.size < _MANY else ()
    names = None if chosen is None else (*RATIOS, *chosen)
    return Response({**at.in_shape(), **source(first)}, source, chosen=names, like=at.like)


@overload
def border(
    omega: float, damping_ratio: float = 0.0, static_friction_ratio: float = 1.0
) -> Border[float]: ...


@overload
def border(
    omega: ArrayLike, damping_ratio: ArrayLike = 0.0, static_friction_ratio: ArrayLike = 1.0
) -> Border[Floats]: ...


@overload
def border(
    omega: Any, damping_ratio: Any = 0.0, static_friction_ratio: Any = 1.0, *, bits: int
) -> Border[Decimal]: ...


def border(
    omega: Any,
    damping_ratio: Any = 0.0,
    static_friction_ratio: Any = 1.0,
    *,
    bits: Optional[int] = None,
) -> Border[Any]:
    """The minimum force ratio at which the cycle of two reversals does not stop at omega.

    With one friction every start leads to this cycle; with a static friction above the kinetic one it attracts its
    neighbourhood.

    Parameters
    ----------
    omega : float or array
        Frequency ratio, > 0.
    damping_ratio : float or array
        Damping ratio of a viscous damper, >= 0.
    static_friction_ratio : float or array
        Ratio of static to kinetic friction, >= 1.
    bits : int, optional
        For a single omega: the precision, as for `response`.

    Returns
    -------
    Border

    Examples
    --------
    >>> import stickslip as ss
    >>> ss.border(0.4).min_force_ratio
    6.9497...
    >>> ss.border(0.4, static_friction_ratio=1.5).min_force_ratio
    8.1501...
    >>> [round(low, 3) for low, high in ss.border(0.331).no_stop_force_ratios]
    [53.673, 179.876]
    """
    # The border does not depend on the force ratio, so any value serves.
    if bits is not None:
        texts = wide_ratios(omega, "1", damping_ratio, static_friction_ratio)
        found = decimals(wide("wide_response", precision(bits), texts))
        return Border({**found, **dict(zip(RATIOS, map(Decimal, texts)))})
    return border_of(points(omega=omega, alpha=1.0, damping_ratio=damping_ratio, static_friction_ratio=static_friction_ratio))


def border_of(at: Points) -> Border[Any]:
    """The border at the frequency ratios of points."""
    found = {**at.in_shape(), **_Source(at)(_OF_BORDER)}
    single = at.shape is None and found["static_friction_ratio"] == 1
    no_stop = _native.no_stop(found["omega"], found["damping_ratio"]) if single else None
    return Border({**found, "no_stop_force_ratios": no_stop}, like=at.like)


def wide_ratios(*values: Any) -> tuple[str, ...]:
    """The ratios as text with all their digits, in the order of `RATIOS`."""
    return tuple(digits(name, value) for name, value in zip(RATIOS, values))


def _flat(out: Mapping[str, Any], shape: tuple[int, ...], given: Iterable[Any]) -> list[NDArray[Any]]:
    of_type("out", out, Mapping)
    numbers = tuple(name for name, row in _ROWS.items() if row[1] != "text")
    for name, array in out.items():
        if name not in numbers:
            raise Error(f"out: {name!r} must be one of {', '.join(numbers)}")
        if not isinstance(array, np.ndarray) or array.dtype != np.float64 or array.shape != shape:
            kind = Error if isinstance(array, np.ndarray) else WrongType
            raise kind(f"out[{name!r}]: must be an array of float64 of shape {shape}")
        if not (array.flags.c_contiguous and array.flags.writeable):
            raise Error(f"out[{name!r}]: must be C-contiguous and writeable")
        for ratio, own in zip(RATIOS, given):
            if isinstance(own, np.ndarray) and np.may_share_memory(array, own):
                raise Error(f"out[{name!r}]: must not overlap {ratio}")
    arrays = list(out.values())
    if any(np.may_share_memory(a, b) for i, a in enumerate(arrays) for b in arrays[:i]):
        raise Error("out: the arrays must not overlap")
    return [array.reshape(-1) for array in arrays]


for _kind, _outputs in ((Response, _rows.RESPONSE), (Border, _rows.BORDER), (MachineResponse, _rows.MACHINE_RESPONSE)):
    _shown = {name: row for name, row in _outputs.items() if name in _kind._names}
    _kind.__doc__ = f"{_kind.__doc__}\n\n    Outputs\n    -------\n{_rows.explained(_shown)}\n\n    In the formulae {_rows.SYMBOLS}\n    "
