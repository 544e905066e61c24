"""Closed forms of the non-sticking cycle, and its border."""

from __future__ import annotations

from decimal import Decimal
from typing import Any, ClassVar, Iterable, Mapping, Optional, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._result import Codes, Physical, Points, Result, Value, decimals, digits, points, precision
from ._wide import wide

#: The ratios that determine the motion.
RATIOS = ("omega", "alpha", "damping_ratio", "static_friction_ratio")
_OF_POINT = ("regime", "reversals_per_cycle", "motion_without_stop", "moves_from_rest")
#: Names of the outputs of `response`.
OUTPUTS: tuple[str, ...] = (*_OF_POINT, *_native.OUTPUTS)
#: The default outputs for arrays: those that one pass of vector instructions computes.
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
_OF_BORDER = (
    "min_force_ratio",
    "min_force_ratio_turning_point",
    "border_phase",
    "least_displacement",
    "best_force_ratio",
)


class Response(Result):
    """The closed-form response at one point or many; see `response`.

    Attributes
    ----------
    omega, alpha, damping_ratio, static_friction_ratio : float or array
        The ratios of the point or points.
    regime : str or array of str
        What every start leads to: ``"stuck"``, ``"sticking"``, ``"non-sticking"`` or ``"unbounded"``. With a static
        friction above the kinetic one also ``"depends-on-start"``. ``"invalid"`` in an array for a point outside the
        domain.
    reversals_per_cycle : int or array
        Reversals in the cycle without a stop, if there is one: 2, or 6 near a pole ``omega = 1/(2n+1)`` below the
        border.
    motion_without_stop : bool or array
        Whether a motion without a stop exists and attracts its neighbourhood; 1 or 0 in an array.
    moves_from_rest : bool or array
        Whether a body at rest is released, ``alpha > static_friction_ratio``; 1 or 0 in an array.
    max_displacement, displacement_phase : float or array
        Maximum displacement (B) and its phase (rad).
    max_velocity, velocity_phase : float or array
        Maximum velocity (B w) and its phase (rad).
    deviation : float or array
        Displacement at the maximum velocity (B).
    min_force_ratio : float or array
        The border: at this force ratio or a larger one the cycle without a stop exists.
    loop_size_stiffness, loop_size_inertia : float or array
        Energy that friction dissipates in a cycle, in units of ``p0**2/(2 k)`` and of ``p0**2/(2 m w**2)``.
    best_force_ratio, best_loop_size : float or array
        Force ratio of the largest loop at this omega, and the size of that loop.
    contraction : float or array
        Share of a disturbance that remains after half a cycle.
    margin : float or array
        ``alpha/min_force_ratio``.
    dynamic_amplification : float or array
        ``k max_displacement/p0``.
    max_acceleration, transmitted_force, max_absolute_displacement : float or array
        Maximum acceleration (B w**2), maximum force of spring, damper and friction on the base (r), and
        maximum absolute displacement if a base carries the surface (B).
    transmissibility : float or array
        ``transmitted_force/p0``; with a moving foot or base the maximum absolute acceleration of the body
        over that of the foot or base. A mean force is not included in the transmitted force.
    physical : Physical or None
        The same outputs in the machine's units; None without a machine.
    """

    _names: ClassVar[Sequence[str]] = (*RATIOS, *OUTPUTS, "physical")

    _numbers: ClassVar[frozenset[str]] = frozenset(("reversals_per_cycle", *_native.OUTPUTS))
    _optional: ClassVar[frozenset[str]] = frozenset(OUTPUTS)

    omega: Value
    alpha: Value
    damping_ratio: Value
    static_friction_ratio: Value
    regime: Any
    reversals_per_cycle: Any
    motion_without_stop: Any
    moves_from_rest: Any
    max_displacement: Any
    displacement_phase: Any
    max_velocity: Any
    velocity_phase: Any
    deviation: Any
    loop_size_stiffness: Any
    loop_size_inertia: Any
    contraction: Any
    margin: Any
    min_force_ratio: Any
    min_force_ratio_turning_point: Any
    least_displacement: Any
    border_phase: Any
    best_force_ratio: Any
    best_loop_size: Any
    dynamic_amplification: Any
    max_acceleration: Any
    transmitted_force: Any
    transmissibility: Any
    max_absolute_displacement: Any
    physical: Optional[Physical]


class Border(Result):
    """The border of the non-sticking cycle; see `border`.

    Attributes
    ----------
    omega, damping_ratio, static_friction_ratio : float or array
    min_force_ratio : float or array
        The minimum force ratio without sticking.
    min_force_ratio_turning_point : float or array
        The minimum force ratio by the turning-point condition, eq. 61 of the source paper. The condition is necessary
        at every omega, and sufficient for omega >= 1/2.
    border_phase : float or array
        Phase where the velocity first touches zero on the border (rad).
    least_displacement : float or array
        Maximum displacement on the border (B).
    best_force_ratio : float or array
        Force ratio of the largest loop.
    no_stop_force_ratios : list of (float, float or None), or None
        The intervals of the force ratio without any stop, for a single omega with equal static and kinetic
        friction.
    """

    _names: ClassVar[Sequence[str]] = ("omega", *RATIOS[2:], *_OF_BORDER, "no_stop_force_ratios")

    omega: Value
    damping_ratio: Value
    static_friction_ratio: Value
    min_force_ratio: Any
    min_force_ratio_turning_point: Any
    border_phase: Any
    least_displacement: Any
    best_force_ratio: Any
    no_stop_force_ratios: Optional[list[tuple[float, Optional[float]]]]


def response(
    omega: ArrayLike,
    alpha: ArrayLike,
    damping_ratio: ArrayLike = 0.0,
    static_friction_ratio: ArrayLike = 1.0,
    *,
    outputs: Optional[Iterable[str]] = None,
    out: Optional[Mapping[str, NDArray[np.float64]]] = None,
    bits: Optional[int] = None,
) -> Response:
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
        The outputs to compute, from `OUTPUTS`; a few take less time than all. By default all at a single point, and
        those of one pass, `OF_ARRAYS`, for arrays.
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
        Floats for single numbers, and arrays of the broadcast shape otherwise. A value that does not exist, such as
        the displacement of a body that sticks, is NaN; ``regime`` says why.

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
        raise _native.Error("out: names the outputs itself, in floats, so that outputs and bits must be left out")
    if bits is not None:
        texts = wide_ratios(omega, alpha, damping_ratio, static_friction_ratio)
        answer = decimals(wide("wide_response", precision(bits), texts))
        names = OUTPUTS if outputs is None else known(outputs)
        return Response({**dict(zip(RATIOS, map(Decimal, texts))), **{name: answer[name] for name in names}})
    at = points(
        omega=omega, alpha=alpha, damping_ratio=damping_ratio, static_friction_ratio=static_friction_ratio
    )
    if at.shape is None:
        if out is not None:
            raise _native.Error("out: is for arrays, but omega, alpha and the other ratios are single numbers")
        found = _native.response_at(at.columns)
        chosen = OUTPUTS if outputs is None else known(outputs)
        return Response({**at.in_shape(), **{name: found[name] for name in chosen}})
    if out is not None:
        _native.response_into(at.columns, list(out), _flat(out, at), None)
        return Response({**at.in_shape(), **out})
    chosen = OF_ARRAYS if outputs is None else known(outputs)
    places = np.empty(at.shape, np.uint8) if "regime" in chosen else None
    arrays = {name: np.empty(at.shape) for name in chosen if name != "regime"}
    flat = [array.reshape(-1) for array in arrays.values()]
    _native.response_into(at.columns, list(arrays), flat, None if places is None else places.reshape(-1))
    regime = {} if places is None else {"regime": Codes(places, _native.REGIMES)}
    return Response({**at.in_shape(), **arrays, **regime})


def border(
    omega: ArrayLike,
    damping_ratio: ArrayLike = 0.0,
    static_friction_ratio: ArrayLike = 1.0,
    *,
    bits: Optional[int] = None,
) -> Border:
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
    found = response(omega, 1.0, damping_ratio, static_friction_ratio, outputs=_OF_BORDER).to_dict()
    single = np.ndim(found["omega"]) == 0 and found["static_friction_ratio"] == 1
    no_stop = _native.no_stop(found["omega"], found["damping_ratio"]) if single else None
    return Border({**found, "no_stop_force_ratios": no_stop})


def wide_ratios(*values: Any) -> tuple[str, ...]:
    """The ratios as text with all their digits, in the order of `RATIOS`."""
    return tuple(digits(name, value) for name, value in zip(RATIOS, values))


def known(outputs: Iterable[str]) -> tuple[str, ...]:
    chosen = (outputs,) if isinstance(outputs, str) else tuple(outputs)
    for name in chosen:
        if name not in OUTPUTS:
            raise _native.Error(f"output {name!r} is none of {', '.join(OUTPUTS)}")
    return chosen


def _flat(out: Mapping[str, NDArray[np.float64]], at: Points) -> list[NDArray[np.float64]]:
    for name, array in out.items():
        if name in _OF_POINT or name not in OUTPUTS:
            numbers = (own for own in OUTPUTS if own not in _OF_POINT)
            raise _native.Error(f"out: {name!r} is none of {', '.join(numbers)}")
        if not isinstance(array, np.ndarray) or array.dtype != np.float64 or array.shape != at.shape:
            raise _native.Error(f"out[{name!r}]: must be an array of float64 of shape {at.shape}")
        if not (array.flags.c_contiguous and array.flags.writeable):
            raise _native.Error(f"out[{name!r}]: must be C-contiguous and writeable")
        for other, given in at.given.items():
            if np.may_share_memory(array, given):
                raise _native.Error(f"out[{name!r}]: must not overlap {other}")
    arrays = list(out.values())
    if any(np.may_share_memory(a, b) for i, a in enumerate(arrays) for b in arrays[:i]):
        raise _native.Error("out: the arrays must not overlap")
    return [array.reshape(-1) for array in arrays]
