"""Answers in the units of a machine."""

from __future__ import annotations

from typing import Any, Iterable, Mapping, NamedTuple, Optional

import numpy as np

from . import _native
from ._drive import Drive
from ._result import RATIOS, Points, Result, Value, points

#: Mass, stiffness, friction forward and backward, damping constant and static friction ratio.
Body = tuple[float, float, float, float, float, float]
#: The names of every answer in units.
_OF_DRIVE = {
    "angular_frequency": "frequency",
    "force_amplitude": "force",
    "friction_displacement": "length",
    "mean_displacement": "length",
}
#: Physical name, scale and kind of the values of `simulate`.
OF_SIMULATION = {
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


class Driven(NamedTuple):
    """A body under one drive or many, in one system of units."""

    body: Body
    excitation: str
    drives: Points
    mean_force: float
    units: Optional[str]
    #: The damping ratio as given; None if the damping constant was.
    damping_ratio: Optional[float]

    @classmethod
    def by(cls, body: Body, damping_ratio: Optional[float], drive: Drive[Any]) -> "Driven":
        at = points(amplitude=drive.amplitude, angular_frequency=drive.angular_frequency)
        return cls(body, drive.excitation, at._replace(like=drive._like), drive.mean_force, drive.units, damping_ratio)

    def columns(self, *names: str) -> list[Any]:
        """Ratios or scales by their names, in the shape of the drives."""
        at = self.drives
        size = at.size if at.shape is not None else 1
        many = at.shape is not None
        found = _native.machine_columns(self.body, self.excitation, at.columns, size, many, self.mean_force, list(names))
        return [found[name].item() if at.shape is None else found[name].reshape(at.shape) for name in names]

    def constant(self, name: str) -> float:
        """A ratio or a scale that is the same under all drives."""
        if name == "damping_ratio" and self.damping_ratio is not None:
            return self.damping_ratio
        found = _native.machine_columns(self.body, self.excitation, (1.0, 1.0), 1, False, self.mean_force, [name])
        return float(found[name][0])

    def ratios(self) -> Points:
        omega, alpha = self.columns("omega", "alpha")
        given = (omega, alpha, self.constant("damping_ratio"), self.constant("static_friction_ratio"))
        return Points(self.drives.shape, dict(zip(RATIOS, map(np.asarray, given))), self.drives.like)

    def scale(self, name: str) -> Value:
        """The size of one unit of a measure, or a ratio."""
        if name == "work":
            return self.constant("force") * self.constant("length")
        if name == "period":
            return 2 * np.pi * self.scale("time")
        if name in ("length", "force", "mean_displacement", "mean_friction"):
            return self.constant(name)
        value: Value = self.columns(name)[0]
        return value

    def kinds(self, outputs: Iterable[str]) -> dict[str, str]:
        """The kind of each value in units by its physical name, for these outputs."""
        known = {**_native.physical_outputs(self.excitation), **OF_SIMULATION}
        own = {known[name][0]: known[name][2] for name in outputs if name in known}
        return {**_OF_DRIVE, **own}


class Scaled(NamedTuple):
    """The values of an answer in units, computed when they are read."""

    answer: Result
    driven: Driven

    def __call__(self, names: Iterable[str]) -> dict[str, Any]:
        return {name: self.value(name) for name in names}

    def value(self, name: str) -> Any:
        driven = self.driven
        shape = driven.drives.shape
        if name == "angular_frequency":
            return driven.drives.in_shape()[name]
        if name == "force_amplitude":
            return driven.scale(name)
        if name in ("friction_displacement", "mean_displacement"):
            constant = driven.scale("length" if name == "friction_displacement" else name)
            return constant if shape is None else np.broadcast_to(constant, shape)
        found = self.outputs(name)
        if not found:
            # No such value exists under this excitation.
            return float("nan") if shape is None else np.full(shape, np.nan)
        output, scale = next(iter(found.items()))
        if name == "best_force_energy":
            # The loop is that of the best force, not of the given one.
            best = self.raw("best_force_ratio") * driven.scale("force")
            return self.raw(output) * (0.5 * best * (best / driven.body[1]))
        value = self.raw(output) * driven.scale(scale)
        # Friction that differs by direction is symmetric about its mean.
        return value + driven.scale("mean_friction") if output == "friction" else value

    def is_at_hand(self, name: str) -> bool:
        """Whether the value of the answer is there."""
        return name in _OF_DRIVE or any(output in self.answer._values for output in self.outputs(name))

    def outputs(self, name: str) -> dict[str, str]:
        """The output of this physical name and its scale, if there is one under this excitation."""
        known = {**_native.physical_outputs(self.driven.excitation), **OF_SIMULATION}
        found = ((output, scale) for output, (own, scale, _) in known.items() if own == name)
        return {output: scale for output, scale in found if output in self.answer._names}

    def raw(self, name: str) -> Any:
        """A value of the answer as a number or an array of NumPy."""
        if name not in self.answer._values:
            getattr(self.answer, name)
        return self.answer._values[name]
