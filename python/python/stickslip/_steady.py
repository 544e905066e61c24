"""The steady state of the exact motion."""

from __future__ import annotations

from collections.abc import Iterable
from decimal import Decimal
from typing import Any, NamedTuple, Optional, overload

from numpy.typing import ArrayLike

from . import _native
from ._closed_forms import wide_ratios
from . import _rows
from ._motion import MachineSamples, Samples, sampled
from ._physical import Driven
from ._outputs import MachineSteadyOutputs, SteadyOutput, SteadyOutputs
from ._labels import Labelled
from ._native import Error
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
from ._start import REST, STATE, Starts, three
from ._wide import wide

_ROWS: dict[str, Row] = {row[0]: row for row in _native.STEADY}
#: Names of the outputs of `steady`.
STEADY_OUTPUTS: tuple[SteadyOutput, ...] = tuple(_ROWS)  # type: ignore[arg-type]
_WORDS = {"regime": _native.REGIMES, "limit": _native.LIMITS}
#: The measures of asymmetry, for which the cycle is followed once more.
_OF_ASYMMETRY = ("error_1", "error_2", "error_3", "error_4")
#: The outputs that need a search for the peaks of a cycle.
_OF_PEAKS = tuple(name for name, row in _ROWS.items() if row[4])
#: The number of points from which on outputs are computed when they are read, unless they are named: all take 300 bytes a point.
_MANY = 1 << 20
#: The other outputs, which are computed at once.
AT_ONCE = tuple(name for name in _ROWS if name not in (*_OF_ASYMMETRY, *_OF_PEAKS))


class _Source(NamedTuple):
    """The question, for outputs that are computed when they are read."""

    #: The ratios and the starts.
    at: Points
    max_periods: int
    excitation: Optional[str] = None

    def __call__(self, names: Iterable[str]) -> dict[str, Any]:
        """The named outputs, with those that come with them."""
        asked = tuple(names)
        for group in (_OF_PEAKS, _OF_ASYMMETRY):
            if len(asked) == 1 and asked[0] in group:
                asked = group
        if self.at.shape is None:
            ratios, start = self.split(self.at.columns)
            return paired(_native.steady_at(ratios, self.excitation, list(asked), start, self.max_periods))
        return filled(_into, _ROWS, _WORDS, self.at, asked, self.excitation, self.max_periods)

    @staticmethod
    def split(columns: Any) -> tuple[Any, Any]:
        return columns[: len(RATIOS)], columns[len(RATIOS) :]


def _into(columns: Any, n: int, excitation: Optional[str], names: list[str], parts: list[Any], max_periods: int) -> None:
    ratios, starts = _Source.split(columns)
    _native.steady_into(ratios, n, excitation, names, parts, starts, max_periods)


class Steady(SteadyOutputs[V, W]):
    """The steady state of the motion from a start; see `steady`.

    Its attributes are the ratios ``omega``, ``alpha``, ``damping_ratio`` and ``static_friction_ratio``, and the outputs. Displacements
    are in units of B = r_y/k, velocities in B ω_d, phases in radians of the drive; ``units`` has the unit of each.
    """

    def waveform(self, n: int = 256) -> Samples:
        """One cycle of the motion at one point: ``n`` samples for each turn of the drive, from phase 0, and the first one again.

        >>> import stickslip as ss
        >>> cycle = ss.steady(0.4, 6).waveform(4)
        >>> cycle.displacement.round(3)
        array([-2.001,  6.793,  2.001, -6.793, -2.001])
        """
        source = self._source
        if not isinstance(source, _Source) or source.at.shape is not None:
            raise Error("a waveform is that of one point, in floats")
        number = whole_number("n", n)
        ratios, start = source.split(source.at.columns)
        found = _native.on_limit(ratios, source.excitation, start, source.max_periods)
        if found is None:
            raise Error(f"the motion tends to no cycle, but to: {self.limit}")
        state, turns = found
        # The samples are those at phase 0 and at equal distances from it.
        return sampled(ratios, state, float(turns), number, True)


class MachineSteady(MachineSteadyOutputs[V, W]):
    """The steady state of a machine in its units; see `Machine.steady`. ``units`` has the unit of each value."""

    _ratios: Steady[V, W]
    _driven: Driven

    @property
    def ratios(self) -> Steady[V, W]:
        """The same motion in ratios."""
        return self._ratios

    def waveform(self, n: int = 256) -> MachineSamples:
        """One cycle of the motion in units, as of `Steady.waveform`.

        >>> import stickslip as ss
        >>> machine = ss.Machine(mass="12 kg", stiffness="30 kN/m", friction="15 N", units="N,mm")
        >>> cycle = machine.steady(ss.Drive(force="40 N", frequency="2.5 Hz")).waveform(4)
        >>> cycle.displacement.round(3), cycle.units["displacement"]
        (array([-0.903,  1.2  ,  0.903, -1.2  , -0.903]), 'mm')
        """
        return MachineSamples.of(self.ratios.waveform(n), self._driven)


@overload
def steady(
    omega: float,
    alpha: float,
    damping_ratio: float = 0.0,
    static_friction_ratio: float = 1.0,
    *,
    start: Starts = REST,
    max_periods: int = _native.MAX_PERIODS,
    outputs: Optional[Iterable[SteadyOutput]] = None,
) -> Steady[float, str]: ...


@overload
def steady(
    omega: Labelled,
    alpha: Any,
    damping_ratio: Any = 0.0,
    static_friction_ratio: Any = 1.0,
    *,
    start: Any = REST,
    max_periods: int = _native.MAX_PERIODS,
    outputs: Optional[Iterable[SteadyOutput]] = None,
) -> Steady[Any, Any]: ...


@overload
def steady(
    omega: ArrayLike,
    alpha: Labelled,
    damping_ratio: Any = 0.0,
    static_friction_ratio: Any = 1.0,
    *,
    start: Any = REST,
    max_periods: int = _native.MAX_PERIODS,
    outputs: Optional[Iterable[SteadyOutput]] = None,
) -> Steady[Any, Any]: ...


@overload
def steady(
    omega: ArrayLike,
    alpha: ArrayLike,
    damping_ratio: ArrayLike = 0.0,
    static_friction_ratio: ArrayLike = 1.0,
    *,
    start: Starts = REST,
    max_periods: int = _native.MAX_PERIODS,
    outputs: Optional[Iterable[SteadyOutput]] = None,
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
    outputs: Optional[Iterable[SteadyOutput]] = None,
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
    outputs: Optional[Iterable[SteadyOutput]] = None,
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
        In radians of the drive, B and B w; at rest by default. Each may be an array that broadcasts with the ratios.
    max_periods : int
        Periods of the drive to follow; a motion that has not settled by then is ``"not-converged"``.
    outputs : names, optional
        The outputs to compute at once; ``dict(result)`` then has these alone. Without it, all are but those that need
        more work, such as ``transmissibility``, which are computed when they are read, and so is each output of 1,048,576 points or
        more. Naming them saves following the motion twice.
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
    values = {**dict(zip(RATIOS, given)), **dict(zip(STATE, three(start)))}
    return of_points(points(**values), chosen, periods)


def of_points(
    at: Points, chosen: Optional[tuple[str, ...]], max_periods: int, excitation: Optional[str] = None
) -> Steady[Any, Any]:
    """The steady state at points with their starts, under an excitation."""
    source = _Source(at, max_periods, excitation)
    names = None if chosen is None else (*RATIOS, *chosen)
    values = source((AT_ONCE if at.size < _MANY else ()) if chosen is None else chosen)
    # Of many points every value is a column of a table; the two multipliers of each are read by their name.
    if names is None and at.shape is not None:
        names = tuple(name for name in Steady._names if name != "multipliers")
    return Steady({**at.in_shape(), **values}, source, chosen=names, like=at.like)


for _kind, _outputs in ((Steady, _rows.STEADY), (MachineSteady, _rows.MACHINE_STEADY)):
    _shown = {name: row for name, row in _outputs.items() if name in _kind._names}
    _kind.__doc__ = f"{_kind.__doc__}\n\n    Outputs\n    -------\n{_rows.explained(_shown)}\n    "
