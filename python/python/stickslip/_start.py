"""Where a motion starts."""

from __future__ import annotations

from typing import Any

from numpy.typing import ArrayLike

from ._native import Error
from ._result import one

#: Displacement and velocity at a phase of the drive, as (phase, displacement, velocity).
Start = tuple[float, float, float]
#: The same for many points, as numbers or arrays that broadcast with the others.
Starts = tuple[ArrayLike, ArrayLike, ArrayLike]
REST: Start = (0.0, 0.0, 0.0)
STATE = ("start: phase", "start: displacement", "start: velocity")


def three(start: Any) -> tuple[Any, Any, Any]:
    try:
        phase, displacement, velocity = start
    except (TypeError, ValueError):
        raise Error(f"start = {start!r}: must be (phase, displacement, velocity)") from None
    return phase, displacement, velocity


def state(start: Any) -> Start:
    """A start for the compiled part."""
    phase, displacement, velocity = (
        one(name, value, kind) for name, value, kind in zip(STATE, three(start), ("angle", "ratio", "ratio"))
    )
    return phase, displacement, velocity
