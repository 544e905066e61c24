"""Results with a guarantee: each output as an interval that contains it, rounding included.

Ratios are exact: ``"0.4"`` is four tenths, ``"1/3"`` is one third, and a float has its exact binary value.
"""

from __future__ import annotations

from decimal import Decimal, localcontext
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Union

from ._closed_forms import CLOSED_FORMS as _OUTPUTS
from ._machine import Machine
from ._native import Error
from ._physical import names_of
from ._record import UNITS_OF_ANSWERS, Block, Record
from ._record import Followed as _OfRecord
from ._result import PhysicalResult, Result, digits, of_type, one, precision
from ._wide import wide

_ANSWERS_OF_RECORD = _OfRecord._names

__all__ = ["Enclosure", "Followed", "Response", "Steady", "Unproved", "border", "follow", "response", "steady"]


class Enclosure(NamedTuple):
    """An interval with midpoint and radius that contains the output.

    >>> from stickslip import enclosed
    >>> enclosed.border("0.4").min_force_ratio.mid
    Decimal('6.94973775590873527...')
    >>> enclosed.border("0.4").min_force_ratio.rad < Decimal("1e-18")
    True
    """

    mid: Decimal
    rad: Decimal

    def __contains__(self, value: object) -> bool:
        if not isinstance(value, (int, float, Decimal)):
            return False
        with localcontext() as context:
            context.prec = 5000
            return abs(Decimal(value) - self.mid) <= self.rad

    def __str__(self) -> str:
        return f"{self.mid} ± {self.rad}"


class Response(Result):
    """The closed forms at one point, enclosed; see `response`.

    Attributes
    ----------
    regime : str or None
        ``"stuck"``, ``"below the border"``, ``"non-sticking"`` or ``"unbounded"``; None if it is undecided. With a
        static friction above the kinetic one ``"depends-on-start"`` where a motion without a stop exists and other
        starts may lead to other motions.
    moves_from_rest : bool or None
        Whether a body at rest is released, alpha > static_friction_ratio; None if it is undecided.
    bits : int
        The final precision of the computation, in bits.
    max_displacement, max_velocity, ... : Enclosure or None
        The outputs, with the names of `stickslip.response`; None if one does not exist or has no enclosure.
    """

    _names = ("regime", "moves_from_rest", "bits", *_OUTPUTS)

    if TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any: ...


class Steady(Result):
    """A periodic motion proved to exist; see `steady`. It counts as true, and `Unproved` as false.

    Attributes
    ----------
    symmetric : bool
        Whether each half of a cycle is the mirror image of the other.
    turns_per_cycle : int
        Turns of the drive in a cycle.
    max_displacement, min_displacement, max_velocity, min_velocity, stick_fraction : Enclosure
        In B, in B w, and as a fraction of a cycle.
    sticks_per_cycle, velocity_zeros_per_cycle : int
    multipliers : list of (Enclosure, Enclosure)
        Real and imaginary parts of the Floquet multipliers of a cycle.
    start_phase, start_displacement : Enclosure
        Phase and displacement of a release, or of a reversal if the body never stops.
    only_within : float
        Within this distance (B) of ``start_displacement`` there is no other motion of the same kind.
    bits : int
    """

    symmetric: bool
    turns_per_cycle: int
    max_displacement: Enclosure
    min_displacement: Enclosure
    max_velocity: Enclosure
    min_velocity: Enclosure
    stick_fraction: Enclosure
    sticks_per_cycle: int
    velocity_zeros_per_cycle: int
    multipliers: list[tuple[Enclosure, Enclosure]]
    start_phase: Enclosure
    start_displacement: Enclosure
    only_within: float
    bits: int


class Unproved(NamedTuple):
    """The reason why a steady motion is not proved to exist; it counts as false.

    >>> from stickslip import enclosed
    >>> enclosed.steady("0.7", "0.9")
    Unproved(reason='the motion from rest does not become periodic')
    """

    reason: str

    def __bool__(self) -> bool:
        return False


def _enclosure(pair: Optional[tuple[str, str]]) -> Optional[Enclosure]:
    return None if pair is None else Enclosure(Decimal(pair[0]), Decimal(pair[1]))


def _texts(*values: Any) -> list[str]:
    names = ("omega", "alpha", "damping_ratio", "static_friction_ratio")
    return [digits(name, value) for name, value in zip(names, values)]


def _response(found: dict[str, Any]) -> Response:
    outputs = {name: _enclosure(found[name]) for name in _OUTPUTS}
    own = {name: found[name] for name in ("regime", "moves_from_rest", "bits")}
    return Response({**own, **outputs})


def response(
    omega: Any,
    alpha: Any,
    damping_ratio: Any = 0,
    static_friction_ratio: Any = 1,
    *,
    bits: int = 64,
) -> Response:
    """The closed forms at (omega, alpha), each output with its error bound.

    Parameters
    ----------
    omega, alpha, damping_ratio, static_friction_ratio : str, Decimal, int, float or a number of mpmath
        The ratios, exactly as given; the last is static friction over the kinetic one.
    bits : int
        The number of guaranteed bits in each output, up to 8192.

    Examples
    --------
    >>> from stickslip import enclosed
    >>> found = enclosed.response("0.4", 9)
    >>> found.regime, str(found.max_velocity)
    ('non-sticking', '13.69686082687735713... ± ...')
    """
    texts = _texts(omega, alpha, damping_ratio, static_friction_ratio)
    return _response(wide("enclosed_response", texts, precision(bits)))


def border(
    omega: Any, damping_ratio: Any = 0, static_friction_ratio: Any = 1, *, bits: int = 64
) -> Response:
    """The border at omega, with its error bound; parameters as for `response`."""
    omega_text, _, *others = _texts(omega, 1, damping_ratio, static_friction_ratio)
    return _response(wide("enclosed_border", [omega_text, *others], precision(bits)))


def steady(
    omega: Any,
    alpha: Any,
    damping_ratio: Any = 0,
    static_friction_ratio: Any = 1,
    *,
    bits: int = 64,
) -> Union[Steady, Unproved]:
    """The steady motion from rest, stops included, proved to exist; or the reason why there is no proof.

    Parameters
    ----------
    omega, alpha, damping_ratio, static_friction_ratio : str, Decimal, int, float or a number of mpmath
        The ratios, exactly as given; the last is static friction over the kinetic one.
    bits : int
        As for `response`.

    Examples
    --------
    >>> from stickslip import enclosed
    >>> motion = enclosed.steady("0.4", 6)
    >>> motion.sticks_per_cycle, str(motion.max_displacement)
    (2, '6.7938216049671567... ± ...')
    """
    texts = _texts(omega, alpha, damping_ratio, static_friction_ratio)
    found = wide("enclosed_steady", texts, precision(bits))
    if "reason" in found:
        return Unproved(found["reason"])
    pairs = (
        "max_displacement",
        "min_displacement",
        "max_velocity",
        "min_velocity",
        "stick_fraction",
        "start_phase",
        "start_displacement",
    )
    enclosures = {name: _enclosure(found[name]) for name in pairs}
    multipliers = [(_enclosure(re), _enclosure(im)) for re, im in found["multipliers"]]
    return Steady({**found, **enclosures, "multipliers": multipliers})


class Followed(PhysicalResult):
    """The motion of a body under a record, enclosed; see `follow`.

    Its values are those of `stickslip.Followed`, each an `Enclosure`, a number for a count, or None where it does not exist.
    """

    _names = _ANSWERS_OF_RECORD

    if TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any: ...


def follow(
    body: Union[Machine[float], Block],
    record: Record,
    *,
    displacement: Any = 0.0,
    velocity: Any = 0.0,
    mean_force: Any = 0.0,
    bits: int = 64,
) -> Followed:
    """The motion of one machine or block under a record, each answer with its error bound, and every stop proved.

    The numbers of the body and the samples are taken exactly as the floats that they are, in the units of the body.

    Parameters
    ----------
    body : Machine or Block
    record : Record
    displacement, velocity, mean_force
        As of `Machine.follow`; a block has its own mean force.
    bits : int
        The number of bits asked for in the greatest displacement and velocity.

    Raises
    ------
    Error
        Where a sign stays uncertain: the load is at the bound of friction, or the velocity grazes zero.

    Examples
    --------
    A pulse of 3 m/s**2 for 1 s moves a block of yield acceleration 1 m/s**2 by a(a - r)t**2/(2r) = 3 m:

    >>> import stickslip as ss
    >>> from stickslip import enclosed
    >>> block = ss.Block(mass=2.0, friction=2.0)
    >>> found = enclosed.follow(block, ss.Record([-3.0, -3.0], time_step=1.0))
    >>> 3 in found.residual_displacement, found.residual_displacement.rad < 1e-18, found.slides
    (True, True, 1)
    """
    of_type("record", record, Record)
    if isinstance(body, Block):
        sliding = body._sliding()
        start = body._start(displacement, velocity)
        if isinstance(mean_force, str) or mean_force != 0.0:
            raise Error("mean_force: a block has its own. Give it to Block")
    else:
        of_type("body", body, Machine)
        sliding, start = body._sliding(mean_force), body._start(displacement, velocity)
    of, times, samples, after = sliding.load(record)
    *values, one_way = sliding.one()
    numbers = tuple(one(name, value) for name, value in zip(sliding.values, values))
    x, v = one("displacement", start[0]), one("velocity", start[1])
    found = wide("enclosed_record", numbers, one_way, of, times.tolist(), samples.tolist(), after, (x, v), precision(bits))
    answers = {name: _enclosure(value) if isinstance(value, tuple) else value for name, value in found.items()}
    return Followed(answers, units=names_of(sliding.units, UNITS_OF_ANSWERS))
