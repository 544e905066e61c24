"""The steady state of the exact motion."""

from __future__ import annotations

from collections.abc import Iterable
from decimal import Decimal
from typing import Any, NamedTuple, Optional, overload

from numpy.typing import ArrayLike

from . import _native
from ._closed_forms import wide_ratios
from ._outputs import PhysicalSteady, SteadyOutputs
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
    paired,
    points,
    precision,
    whole_number,
)
from ._start import REST, STATE, Start, state, three
from ._wide import wide

_ROWS: dict[str, Row] = {row[0]: row for row in _native.STEADY}
#: Names of the outputs of `steady`.
STEADY_OUTPUTS: tuple[str, ...] = tuple(_ROWS)
_WORDS = {"regime": _native.REGIMES, "limit": _native.LIMITS}
#: The measures of asymmetry, for which the cycle is followed once more.
_OF_ASYMMETRY = ("error_1", "error_2", "error_3", "error_4")
#: The outputs that need a search for the peaks of a cycle.
_OF_PEAKS = tuple(name for name, row in _ROWS.items() if row[4])
#: The other outputs, which are computed at once.
AT_ONCE = tuple(name for name in _ROWS if name not in (*_OF_ASYMMETRY, *_OF_PEAKS))


class _Source(NamedTuple):
    """The question, for outputs that are computed when they are read."""

    at: Points
    start: Start
    max_periods: int
    excitation: Optional[str] = None

    def __call__(self, names: Iterable[str]) -> dict[str, Any]:
        """The named outputs, with those that come with them."""
        asked = tuple(names)
        for group in (_OF_PEAKS, _OF_ASYMMETRY):
            if len(asked) == 1 and asked[0] in group:
                asked = group
        more = (self.start, self.max_periods)
        if self.at.shape is None:
            return paired(_native.steady_at(self.at.columns, self.excitation, list(asked), *more))
        return filled(_native.steady_into, _ROWS, _WORDS, self.at, asked, self.excitation, *more)


class Steady(SteadyOutputs[V, W]):
    """The steady state of the motion from a start; see `steady`.

    Its attributes are the ratios ``omega``, ``alpha``, ``damping_ratio`` and ``static_friction_ratio``, and the outputs.
    """

    _physical: Optional[PhysicalSteady[V]]

    @property
    def physical(self) -> PhysicalSteady[V]:
        """The outputs in the machine's units, for the answer of a machine."""
        if self._physical is None:
            raise AttributeError("physical")
        return self._physical


@overload
def steady(
    omega: float,
    alpha: float,
    damping_ratio: float = 0.0,
    static_friction_ratio: float = 1.0,
    *,
    start: Start = REST,
    max_periods: int = _native.MAX_PERIODS,
    outputs: Optional[Iterable[str]] = None,
) -> Steady[float, str]: ...


@overload
def steady(
    omega: ArrayLike,
    alpha: ArrayLike,
    damping_ratio: ArrayLike = 0.0,
    static_friction_ratio: ArrayLike = 1.0,
    *,
    start: Start = REST,
    max_periods: int = _native.MAX_PERIODS,
    outputs: Optional[Iterable[str]] = None,
) -> Steady[Floats, Words]: ...


@overload
def steady(
    omega: Any,
    alpha: Any,
    damping_ratio: Any = 0.0,
    static_friction_ratio: Any = 1.0,
    *,
    start: Any = REST,
    max_periods: int = _native.MAX_PERIODS,
    outputs: Optional[Iterable[str]] = None,
    bits: int,
) -> Steady[Decimal, str]: ...


def steady(
    omega: Any,
    alpha: Any,
    damping_ratio: Any = 0.0,
    static_friction_ratio: Any = 1.0,
    *,
    start: Any = REST,
    max_periods: int = _native.MAX_PERIODS,
    outputs: Optional[Iterable[str]] = None,
    bits: Optional[int] = None,
) -> Steady[Any, Any]:
    """The steady state of the exact motion from a start, stops included.

    Parameters
    ----------
    omega : float or array
        Frequency ratio, from 2**-20 to 2**20.
    alpha : float or array
        Force ratio, > 0.
    damping_ratio : float or array
        Damping ratio of a viscous damper, >= 0.
    static_friction_ratio : float or array
        Ratio of static to kinetic friction, >= 1. Above 1 the steady state may depend on the start; see `attractors`.
    start : (phase, displacement, velocity)
        In radians of the drive, B and B w; at rest by default.
    max_periods : int
        Periods of the drive to follow; a motion that has not settled by then is ``"not-converged"``.
    outputs : names, optional
        The outputs to compute at once; ``dict(result)`` then has these alone. Without it, all are but those that need
        more work, such as ``transmissibility``, which are computed when they are read. Naming them saves following the
        motion twice.
    bits : int, optional
        For a single point: the precision, as for `response`.

    Returns
    -------
    Steady
        Numbers or arrays as for `response`. ``multipliers`` are two complex numbers for each point, along the last axis of
        an array.

    Examples
    --------
    >>> import stickslip as ss
    >>> found = ss.steady(0.4, 6)
    >>> found.regime, found.sticks_per_cycle, round(found.max_displacement, 6)
    ('sticking', 2, 6.793822)
    >>> ss.steady([0.4, 0.7, 1.5], 6).sticks_per_cycle
    array([2., 0., 0.])
    >>> ss.steady([0.4, 0.7, 1.5], 6).transmissibility.round(4)
    array([1.299 , 2.1046, 0.9432])
    """
    chosen = None if outputs is None else named(outputs, STEADY_OUTPUTS)
    periods = whole_number("max_periods", max_periods)
    if bits is not None:
        texts = wide_ratios(omega, alpha, damping_ratio, static_friction_ratio)
        state_digits = tuple(digits(name, value) for name, value in zip(STATE, three(start)))
        found = decimals(wide("wide_steady", precision(bits), texts, state_digits, periods))
        ratios = dict(zip(RATIOS, map(Decimal, texts)))
        return Steady({**found, **ratios}, chosen=None if chosen is None else (*RATIOS, *chosen))
    given = (omega, alpha, damping_ratio, static_friction_ratio)
    return of_points(points(**dict(zip(RATIOS, given))), chosen, state(start), periods)


def of_points(
    at: Points, chosen: Optional[tuple[str, ...]], start: Start, max_periods: int, excitation: Optional[str] = None
) -> Steady[Any, Any]:
    """The steady state at points, under an excitation."""
    source = _Source(at, start, max_periods, excitation)
    names = None if chosen is None else (*RATIOS, *chosen)
    values = source(AT_ONCE) if chosen is None else source(chosen)
    return Steady({**at.in_shape(), **values}, source, chosen=names, like=at.like)
