"""Answers in the units of a machine."""

from __future__ import annotations

from typing import Any, Mapping, Optional

import numpy as np

from . import _native
from ._drive import Drive
from ._result import Physical, Result

#: Physical name, scale and kind of the values of `simulate`.
_OF_SIMULATION = {
    "phase": ("time", "time", "time"),
    "start_phase": ("start_time", "time", "time"),
    "end_phase": ("end_time", "time", "time"),
    "duration": ("duration", "time", "time"),
    "displacement": ("displacement", "length", "length"),
    "start_displacement": ("start_displacement", "length", "length"),
    "end_displacement": ("end_displacement", "length", "length"),
    "velocity": ("velocity", "velocity", "velocity"),
    "start_velocity": ("start_velocity", "velocity", "velocity"),
    "friction": ("friction_force", "force", "force"),
}


def names_of(system: Optional[str], kinds: Mapping[str, str]) -> Optional[dict[str, str]]:
    """The unit of each kind in a system of units, if it is known."""
    return None if system is None else {name: _native.unit_of(system, kind) for name, kind in kinds.items()}


def in_units(answer: Result, drive: Drive, ratios: Mapping[str, Any], scales: Mapping[str, Any]) -> Physical:
    """The values of an answer that have units, by their physical names, and those of the drive."""
    sizes = {**scales, "work": scales["force"] * scales["length"], "period": 2 * np.pi * scales["time"]}
    outputs = {**_native.physical_outputs(drive.excitation), **_OF_SIMULATION}
    physical = {
        "angular_frequency": 1.0 / scales["time"],
        "force_amplitude": ratios["alpha"] * scales["force"],
        "friction_displacement": scales["length"],
        "mean_displacement": scales["mean_displacement"],
    }
    kinds = dict(zip(physical, ("frequency", "force", "length", "length")))
    for name in answer._names:
        value = getattr(answer, name) if name in outputs and answer._has(name) else None
        if value is not None:
            named, scale, kind = outputs[name]
            # Friction that differs by direction is symmetric about its mean.
            physical[named] = value * sizes[scale] + (scales["mean_friction"] if name == "friction" else 0.0)
            kinds[named] = kind
    return Physical(physical, names_of(drive.units, kinds))


def felt_around(answer: Result, drive: Drive, ratios: Mapping[str, Any]) -> dict[str, Any]:
    """The values of an answer, with the loads on the surroundings if the spring's foot moves."""
    values = answer._with({})
    acceleration = values.get("max_acceleration")
    if "foot" not in drive.excitation or acceleration is None:
        return values
    shape = np.shape(acceleration)
    given = (ratios["omega"], ratios["alpha"], ratios["damping_ratio"], 0.0, acceleration)
    columns = tuple(np.ascontiguousarray(np.broadcast_to(value, shape), np.float64).reshape(-1) for value in given)
    force, ratio = (column.reshape(shape) for column in _native.transmitted(drive.excitation, columns))
    # The surface is fixed, so that the displacement over it is absolute.
    least = values.get("min_displacement")
    most: Any = values.get("max_displacement")
    amplitude: Any = most if least is None else np.maximum(np.abs(most), np.abs(least))
    felt = {"transmitted_force": force, "transmissibility": ratio, "max_absolute_displacement": amplitude}
    for name, value in felt.items():
        if values.get(name) is not None:
            values[name] = value if shape or value is most else value.item()
    return values
