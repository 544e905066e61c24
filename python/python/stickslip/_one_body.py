"""One body as a system: under a drive, or under a record that repeats itself."""

from __future__ import annotations

from typing import Any, Callable, Mapping, Union

import numpy as np

from ._drive import Drive
from ._labels import WrongType
from ._native import Error
from ._physical import Driven
from ._record import Record, Sliding
from ._result import one
from ._system import System

#: The force on a body for a unit of a record, by its mass and its stiffness.
_FORCES: Mapping[str, Callable[[float, float], float]] = {
    "force": lambda mass, stiffness: 1.0,
    "base_acceleration": lambda mass, stiffness: -mass,
    "foot_displacement": lambda mass, stiffness: stiffness,
}


def one_body(of: Sliding, load: Union[Drive[Any], Record], start: tuple[Any, Any], own: Mapping[str, Any]) -> System:
    """The system of a body, with half the difference of its frictions as a constant force."""
    if not isinstance(load, (Drive, Record)):
        raise WrongType(f"load = {load!r}: must be a Drive or a Record")
    mass, stiffness, damping, forward, backward, ratio, mean_force, one_way = of.one()
    if one_way:
        raise Error("one_way: must be False under a load that repeats itself")
    friction = 0.5 * forward + 0.5 * backward
    loads: dict[str, Any]
    if isinstance(load, Drive):
        given = load._in(of.units, of.is_named)
        mean_force += one("mean_force", given["mean_force"])
        # The amplitude as a force does not depend on the friction.
        alike = {**own, "friction": np.asarray(friction), "friction_backward": np.asarray(np.nan)}
        driven = Driven.by(alike, {**given, "mean_force": np.asarray(0.0)}, load.excitation, of.units)
        amplitude = one("amplitude", driven.columns("alpha")[0]) * friction
        loads = {"harmonics": [{"angular_frequency": one("frequency", given["angular_frequency"]), "sin": [amplitude]}]}
    else:
        kind, times, samples, _ = of.load(load)
        if kind not in _FORCES:
            raise Error(f"record: must be of a force, a base_acceleration or a foot_displacement, not of a {kind}")
        steps = times if len(times) > 1 else times[0] * np.arange(len(samples))
        force = _FORCES[kind](mass, stiffness)
        loads = {"record": {"times": list(map(float, steps)), "values": list(map(float, samples)), "force": [force], "repeats": True}}
    element = {"type": "contact", "name": "surface", "direction": [1.0], "friction": friction, "peak": ratio}
    x, v = one("displacement", start[0]), one("velocity", start[1])
    return System(
        mass=[[mass]],
        damping=[[damping]],
        stiffness=[[stiffness]],
        elements=[element],
        constant=[mean_force - 0.5 * (forward - backward)],
        start={"displacement": [x], "velocity": [v]},
        units=of.units,
        **loads,
    )
