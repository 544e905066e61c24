"""The attractors of a motion whose steady state depends on its start."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._native import Error
from ._physical import Driven, names_of, related
from ._labels import WrongType, numbers
from ._result import RATIOS, PhysicalResult, Result, one, paired, whole_number
from ._start import Start, state


class Attractor(Result):
    """An attractor and the starts that lead to it; see `attractors`. A number that does not exist is NaN.

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
    symmetric : bool, NaN where there is no cycle
    turns_per_cycle : int, or NaN
        Turns of the drive in a cycle.
    max_displacement, min_displacement : float
        Extreme displacements if the body moves (B).
    sticks_per_cycle, velocity_zeros_per_cycle : int, or NaN
    stick_fraction : float
    multipliers : array of two complex numbers
    lyapunov_exponent, lyapunov_exponent_error : float
        Lyapunov exponent of an irregular motion per turn of the drive, and its standard error.
    rest_from, rest_to : float
        The range of the rest positions found, or of the midpoints of the members of a family (B).
    """

    attractor: int
    limit: str
    share: float
    starts: int
    first_x: float
    first_v: float
    mirror: Optional[int]
    symmetric: float
    turns_per_cycle: float
    max_displacement: float
    min_displacement: float
    sticks_per_cycle: float
    velocity_zeros_per_cycle: float
    stick_fraction: float
    multipliers: NDArray[np.complex128]
    lyapunov_exponent: float
    lyapunov_exponent_error: float
    rest_from: float
    rest_to: float


class Attractors(Result):
    """The attractors that many starts lead to; see `attractors`.

    Attributes
    ----------
    omega, alpha, damping_ratio, static_friction_ratio : float
    starts : int
    reach : float
        The largest displacement (B) and velocity (B w) of the spread starts; NaN for a list of starts.
    unsettled : int
        Starts whose motion had not settled.
    of_start : array of int
        The index of the attractor that each start leads to; -1 if the motion had not settled.
    attractors : list of Attractor
    """

    omega: float
    alpha: float
    damping_ratio: float
    static_friction_ratio: float
    starts: int
    reach: float
    unsettled: int
    of_start: NDArray[np.int64]
    attractors: list[Attractor]


class MachineAttractors(PhysicalResult):
    """The attractors of a machine that many starts lead to, in its units; see `Machine.attractors` and `Attractors`.

    Attributes
    ----------
    starts, unsettled : int
    reach : float
        The largest displacement of the spread starts; NaN for a list of starts.
    of_start : array of int
    attractors : list of Attractor
        With displacements and velocities in the machine's units.
    """

    starts: int
    reach: float
    unsettled: int
    of_start: NDArray[np.int64]
    attractors: list[Attractor]
    _ratios: Attractors

    @property
    def ratios(self) -> Attractors:
        """The same attractors in ratios."""
        return self._ratios

    @classmethod
    def of(cls, found: Attractors, driven: Driven, length: float, velocity: float) -> "MachineAttractors":
        sizes = {name: length for name in ("first_x", "max_displacement", "min_displacement", "rest_from", "rest_to")}
        sizes["first_v"] = velocity
        limits = [
            Attractor({name: value * sizes[name] if name in sizes else value for name, value in limit.items()}) for limit in found.attractors
        ]
        values = {**found, "reach": found.reach * length, "attractors": limits}
        kinds = {name: "velocity" if name == "first_v" else "length" for name in (*sizes, "reach")}
        return related(cls(values, units=names_of(driven.units, kinds)), found, driven)


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
        asked: Any = whole_number("starts", starts, 10_000_001)
    elif isinstance(starts, str) or not isinstance(starts, Iterable):
        raise WrongType(f"starts = {starts!r}: must be a whole number, or a list of (phase, displacement, velocity)")
    else:
        asked = [state(start) for start in starts]
    far = None if reach is None else one("reach", reach)
    found = _native.attractors_at(point, asked, far, whole_number("max_periods", max_periods))
    limits = [Attractor(paired(_existing(limit, "mirror"))) for limit in found.pop("attractors")]
    return Attractors({**dict(zip(RATIOS, point)), **_existing(found), "attractors": limits})


class Basins(PhysicalResult):
    """The limit that each start in a plane of starts leads to; see `basins`.

    Attributes
    ----------
    displacement, velocity : array
        The axes of the plane, in B and B w, or in the units of a machine.
    attractor : array of int
        A row for each velocity and a column for each displacement: the index of the limit in ``attractors``; -1 if the motion had
        not settled.
    attractors : list of Attractor
    """

    displacement: NDArray[np.float64]
    velocity: NDArray[np.float64]
    attractor: NDArray[np.int64]
    attractors: list[Attractor]

    def _shape(self) -> tuple[int, ...]:
        return self.attractor.shape

    def _columns(self) -> tuple[tuple[int, ...], dict[str, NDArray[Any]]]:
        x, v = np.broadcast_arrays(self.displacement, self.velocity[:, None])
        return self.attractor.shape, {"displacement": x, "velocity": v, "attractor": self.attractor}

    def plot(self, *names: str, over: Optional[str] = None, ax: Any = None, **style: Any) -> Any:
        """Draws the plane with matplotlib, a colour for each limit, and returns the axes."""
        from ._plot import plane

        return plane(ax, self.displacement, self.velocity, self.attractor, self._titled("displacement"), self._titled("velocity"))

    @classmethod
    def of(cls, values: dict[str, Any], units: Optional[dict[str, str]]) -> "Basins":
        return cls(values, units=units)


def basins(
    omega: float,
    alpha: float,
    damping_ratio: float = 0.0,
    static_friction_ratio: float = 1.0,
    *,
    displacement: ArrayLike,
    velocity: ArrayLike,
    phase: float = 0.0,
    max_periods: int = 2000,
) -> Basins:
    """The limit that each start of a plane leads to, as ``stickslip basins``.

    Parameters
    ----------
    omega, alpha, damping_ratio, static_friction_ratio : float
    displacement, velocity : array
        The axes of the plane of starts, in B and B w.
    phase : float
        The phase of the drive at the start.
    max_periods : int

    Examples
    --------
    >>> import numpy as np, stickslip as ss
    >>> found = ss.basins(0.5, 4, 0.02, 1.3, displacement=np.linspace(-9, 9, 7), velocity=np.linspace(-9, 9, 5))
    >>> found.attractor.shape, sorted(round(limit.max_displacement, 3) for limit in found.attractors)
    ((5, 7), [5.186, 5.363])
    """
    axes = {name: np.atleast_1d(numbers(name, value)) for name, value in (("displacement", displacement), ("velocity", velocity))}
    for name, axis in axes.items():
        if axis.ndim != 1:
            raise Error(f"{name}: must be an array of one dimension, not of shape {axis.shape}")
    x, v = axes.values()
    at = one("phase", phase, "angle")
    starts = [(at, float(place), float(speed)) for speed in v for place in x]
    found = attractors(omega, alpha, damping_ratio, static_friction_ratio, starts=starts, max_periods=max_periods)
    values = {**axes, "attractor": found.of_start.reshape(v.size, x.size), "attractors": found.attractors}
    return Basins.of(values, {"displacement": "B", "velocity": "B ω_d"})


def _existing(values: dict[str, Any], *optional: str) -> dict[str, Any]:
    """The values, with NaN for those that do not exist."""
    nan = {"multipliers": [float("nan")] * 4}
    return {
        name: nan.get(name, float("nan")) if value is None and name not in optional else value
        for name, value in values.items()
    }
