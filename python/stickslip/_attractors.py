"""The attractors of a motion whose steady state depends on its start."""

from __future__ import annotations

from typing import Any, ClassVar, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._closed_forms import RATIOS
from ._result import Result, one
from ._start import Start, periods_of, state


class Attractor(Result):
    """An attractor and the starts that lead to it; see `attractors`.

    Attributes
    ----------
    attractor : int
        Its index in the list.
    limit : str
        As for `steady`.
    share, starts : float and int
        The share and the number of starts that lead to it.
    first_x, first_v : float
        Displacement (B) and velocity (B w) of the first start that leads to it.
    mirror : int or None
        The index of its mirror image.
    symmetric : bool or None
    turns_per_cycle : int or None
        Turns of the drive in a cycle.
    max_displacement, min_displacement : float or None
        Extreme displacements if the body moves (B).
    sticks_per_cycle, velocity_zeros_per_cycle : int or None
    stick_fraction : float or None
    multipliers : list of (float, float) or None
    lyapunov_exponent, lyapunov_exponent_error : float or None
        Lyapunov exponent of an irregular motion per turn of the drive, and its standard error.
    rest_from, rest_to : float or None
        The range of the rest positions found, or of the midpoints of the members of a family (B).
    """

    _names: ClassVar[Sequence[str]] = (
        "attractor",
        "limit",
        "share",
        "starts",
        "first_x",
        "first_v",
        "mirror",
        "symmetric",
        "turns_per_cycle",
        "max_displacement",
        "min_displacement",
        "sticks_per_cycle",
        "velocity_zeros_per_cycle",
        "stick_fraction",
        "multipliers",
        "lyapunov_exponent",
        "lyapunov_exponent_error",
        "rest_from",
        "rest_to",
    )

    attractor: int
    limit: str
    share: float
    starts: int
    first_x: float
    first_v: float
    mirror: Optional[int]
    symmetric: Optional[bool]
    turns_per_cycle: Optional[int]
    max_displacement: Optional[float]
    min_displacement: Optional[float]
    sticks_per_cycle: Optional[int]
    velocity_zeros_per_cycle: Optional[int]
    stick_fraction: Optional[float]
    multipliers: Optional[list[tuple[float, float]]]
    lyapunov_exponent: Optional[float]
    lyapunov_exponent_error: Optional[float]
    rest_from: Optional[float]
    rest_to: Optional[float]


class Attractors(Result):
    """The attractors that many starts lead to; see `attractors`.

    Attributes
    ----------
    omega, alpha, damping_ratio, static_friction_ratio : float
    starts : int
    reach : float or None
        The largest displacement (B) and velocity (B w) of the spread starts; None for a list of starts.
    unsettled : int
        Starts whose motion had not settled.
    of_start : array of int
        The index of the attractor that each start leads to; -1 if the motion had not settled.
    attractors : list of Attractor
    """

    _names: ClassVar[Sequence[str]] = (*RATIOS, "starts", "reach", "unsettled", "of_start", "attractors")

    omega: float
    alpha: float
    damping_ratio: float
    static_friction_ratio: float
    starts: int
    reach: Optional[float]
    unsettled: int
    of_start: NDArray[np.int64]
    attractors: list[Attractor]

    def to_dict(self) -> dict[str, Any]:
        """All values by name, with the attractors as dictionaries."""
        return {**super().to_dict(), "attractors": [found.to_dict() for found in self.attractors]}


def attractors(
    omega: float,
    alpha: float,
    damping_ratio: float = 0.0,
    static_friction_ratio: float = 1.0,
    *,
    starts: Union[int, Sequence[Start]] = 1000,
    reach: Optional[float] = None,
    max_periods: int = 2000,
) -> Attractors:
    """All attractors that many starts lead to. There can be several if static friction exceeds kinetic friction.

    The list is not proved to be complete: other starts may lead to further attractors.

    Parameters
    ----------
    omega, alpha, damping_ratio, static_friction_ratio : float
        Frequency ratio, force ratio, damping ratio, and ratio of static to kinetic friction.
    starts : int or sequence of (phase, displacement, velocity)
        The number of starts at phase 0: the first at rest, the others spread evenly and the same in every call. Or a
        list of starts.
    reach : float, optional
        The largest displacement (B) and velocity (B w) of the spread starts.
    max_periods : int
        Periods of the drive to follow from each start.

    Returns
    -------
    Attractors

    Examples
    --------
    >>> import stickslip as ss
    >>> found = ss.attractors(0.5, 4, 0.02, 1.3, starts=100)
    >>> [(round(limit.max_displacement, 6), limit.symmetric, limit.mirror) for limit in found.attractors]
    [(5.185938, False, 1), (5.362738, False, 0)]
    """
    given = zip(RATIOS, (omega, alpha, damping_ratio, static_friction_ratio))
    point = tuple(one(name, value) for name, value in given)
    if isinstance(starts, (int, np.integer)):
        asked: Any = int(starts)
        if asked < 1:
            raise _native.Error(f"starts = {asked} must be >= 1")
    else:
        asked = [state(start) for start in starts]
    far = None if reach is None else one("reach", reach)
    found = _native.attractors_at(point, asked, far, periods_of(max_periods))
    limits = [Attractor(limit) for limit in found.pop("attractors")]
    return Attractors({**dict(zip(RATIOS, point)), **found, "attractors": limits})
