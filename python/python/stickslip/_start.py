"""Where a motion starts, and how long it is followed."""

from __future__ import annotations

from typing import Any

from ._native import Error
from ._result import one

#: Displacement and velocity at a phase of the drive, as (phase, displacement, velocity).
Start = tuple[float, float, float]
REST: Start = (0.0, 0.0, 0.0)
STATE = ("phase", "displacement", "velocity")


def three(start: Any) -> tuple[Any, Any, Any]:
    try:
        phase, displacement, velocity = start
    except (TypeError, ValueError):
        raise Error(f"start = {start!r}: must be (phase, displacement, velocity)") from None
    return phase, displacement, velocity


def state(start: Any) -> Start:
    """A start for the compiled part."""
    phase, displacement, velocity = (one(f"start: {name}", value) for name, value in zip(STATE, three(start)))
    return phase, displacement, velocity
