"""Answers in the units of a machine."""

from __future__ import annotations

from typing import Any, Mapping, Optional

import numpy as np

from . import _native
from ._drive import Drive
from ._result import Physical, Result

#: Names of values in physical units that differ from those in ratios. Both loop sizes are the same energy.
_PHYSICAL = {
    "min_force_ratio": "min_force",
    "min_force_ratio_turning_point": "min_force_turning_point",
    "loop_size_stiffness": "energy_per_cycle",
    "best_force_ratio": "best_force",
    "best_loop_size": "best_force_energy",
    "damper_work": "damper_energy_per_cycle",
    "periods": "followed_for",
    "phase": "time",
    "friction": "friction_force",
}
#: Scales of the outputs of `steady` and `simulate` that `response` does not have.
_OF_MOTION = {
    "min_displacement": "length",
    "rest_position": "length",
    "distance": "length",
    "min_velocity": "velocity",
    "energy_in": "work",
    "energy_out": "work",
    "damper_work": "work",
    "periods": "period",
    "phase": "time",
    "duration": "time",
    "start_displacement": "length",
    "end_displacement": "length",
    "displacement": "length",
    "start_velocity": "velocity",
    "velocity": "velocity",
    "friction": "force",
}
#: The kind of quantity of each scale, of `_native.machine_columns` or derived from its scales.
_KIND_OF_SCALE = {
    "length": "length",
    "velocity": "velocity",
    "time": "time",
    "force": "force",
    "energy": "energy",
    "energy_inertia": "energy",
    "acceleration": "acceleration",
    "work": "energy",
    "period": "time",
}


def names_of(system: Optional[str], kinds: Mapping[str, str]) -> Optional[dict[str, str]]:
    """The unit of each kind in a system of units, if it is known."""
    return None if system is None else {name: _native.unit_of(system, kind) for name, kind in kinds.items()}


def in_units(answer: Result, drive: Drive, ratios: Mapping[str, Any], scales: Mapping[str, Any]) -> Physical:
    """The values of an answer that have units, by their physical names, and those of the drive."""
    sizes = {**scales, "work": scales["force"] * scales["length"], "period": 2 * np.pi * scales["time"]}
    units = {**dict(_native.UNITS), **_OF_MOTION, "loop_size_inertia": ""}
    if not drive.excitation.startswith("base_"):
        units["max_absolute_displacement"] = ""
    physical = {
        "angular_frequency": 1.0 / scales["time"],
        "force_amplitude": ratios["alpha"] * scales["force"],
        "friction_displacement": scales["length"],
        "mean_displacement": scales["mean_displacement"],
    }
    kinds = dict(zip(physical, ("frequency", "force", "length", "length")))
    for name in answer._names:
        # A damper on the moving foot dissipates by the velocity between body and foot, which is not in these.
        if drive.excitation == "damped_foot_displacement" and name in ("damper_work", "energy_in"):
            continue
        scale = "time" if name.endswith("_phase") else units.get(name, "")
        value = getattr(answer, name) if scale else None
        if value is not None:
            named = _PHYSICAL.get(name, name.replace("_phase", "_time"))
            # Friction that differs by direction is symmetric about its mean.
            physical[named] = value * sizes[scale] + (scales["mean_friction"] if name == "friction" else 0.0)
            kinds[named] = _KIND_OF_SCALE[scale]
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
    amplitude = values["max_displacement"] if least is None else max(abs(values["max_displacement"]), abs(least))
    felt = {"transmitted_force": force, "transmissibility": ratio, "max_absolute_displacement": amplitude}
    for name, value in felt.items():
        if values.get(name) is not None:
            values[name] = value if shape or value is amplitude else value.item()
    return values
