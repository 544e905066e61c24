"""Answers in the units of a machine."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple, Optional, TypeVar

import numpy as np

from . import _native, _rows
from ._native import Error
from ._result import RATIOS, PhysicalResult, Points, Result, Value, points

#: The values of a body, in the order of the compiled part.
OF_BODY = ("mass", "stiffness", "friction", "friction_backward", "damping", "static_friction_ratio")
_OF_DRIVE = ("amplitude", "angular_frequency", "mean_force")
#: The kinds of the values that a machine's answers do not have.
_KINDS = {
    "mass": "mass",
    "stiffness": "stiffness",
    "friction": "force",
    "friction_backward": "force",
    "damping": "damping constant",
    "mean_force": "force",
}
#: Values that do not exist without a spring.
_OF_SPRING = ("friction_displacement", "mean_displacement", "max_spring_force", "dynamic_amplification", "equivalent_damping_ratio")
#: Scales that do not depend on the drive.
_CONSTANT = ("length", "force", "mean_displacement", "mean_friction", "damping_ratio", "static_friction_ratio")
#: Name in units, scale and kind of the values of `simulate`, `waveform` and `decay`; a phase stays beside its time.
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
    """A body or several under one drive or many, in one system of units."""

    excitation: str
    #: The amplitude, the angular frequency and the mean force, and the values of the body.
    at: Points
    units: Optional[str]
    #: Whether the frequency was given in hertz.
    is_in_hertz: bool = False
    #: Where the stiffness was given as 0.
    springless: Any = False

    @classmethod
    def by(cls, body: Mapping[str, Any], drive: Mapping[str, Any], excitation: str, units: Optional[str]) -> "Driven":
        values: dict[str, Any] = {**drive, **body}
        return cls(excitation, points(**values), units)._without_zeros()

    def _without_zeros(self) -> "Driven":
        """The same with a friction or an amplitude far below the rounding of every motion in place of one of 0, as the command has it."""
        at = self.at
        if all(np.all(at.given[name] != 0) for name in ("friction", "amplitude", "stiffness")):
            return self
        springless = at.given["stiffness"] == 0
        backward = at.given["friction_backward"]
        drifts = (at.given["mean_force"] != 0) | ~(np.isnan(backward) | (backward == at.given["friction"]))
        if np.any(springless & drifts):
            raise Error("stiffness: must be > 0 with a mean force or friction that differs by direction, because the body drifts. Machine.system(drive).steady() answers with the drift")
        found = _native.without_zeros(*self._native_columns)
        return self._replace(springless=springless, at=at._replace(given={**at.given, **{name: column.reshape(at.shape or ()) for name, column in found.items()}}))

    @property
    def _native_columns(self) -> tuple[list[Value], str, list[Value], int]:
        """The values of the bodies, the excitation, the values of the drives, and the number of points."""
        at = self.at
        columns = dict(zip(at.given, at.columns))
        body, drive = ([columns[name] for name in group] for group in (OF_BODY, _OF_DRIVE))
        n = 1 if at.shape is None else at.size
        if self._is_none:
            # One number would be refused as the mass of all places.
            body[0] = np.full(n, np.nan)
        return body, self.excitation, drive, n

    @property
    def _is_none(self) -> bool:
        """Whether there is one body, as an array of one, that is outside the domain."""
        mass = self.at.given["mass"]
        return self.at.shape is not None and mass.size == 1 and bool(np.isnan(mass.flat[0]))

    @property
    def is_one(self) -> bool:
        """Whether there is one body under one mean force."""
        given = self.at.given
        return all(given[name].size == 1 for name in ("mean_force", *OF_BODY))

    def columns(self, *names: str) -> list[Any]:
        """Ratios or scales by their names, in the shape of the points."""
        at = self.at
        found = _native.machine_columns(*self._native_columns, at.shape is not None, list(names))
        return [found[name].item() if at.shape is None else found[name].reshape(at.shape) for name in names]

    def constant(self, name: str) -> Value:
        """A ratio or a scale that is the same under all amplitudes and frequencies."""
        if name == "damping_ratio" and "damping_ratio" in self.at.given:
            return self.at.given["damping_ratio"]
        if not self.is_one or self._is_none:
            value: Value = self.columns(name)[0]
            return value
        columns = dict(zip(self.at.given, self.at.columns))
        body, mean = [columns[key] for key in OF_BODY], columns["mean_force"]
        found = _native.machine_columns(body, self.excitation, [1.0, 1.0, mean], 1, False, [name])
        return float(found[name][0])

    def ratios(self) -> Points:
        omega, alpha = self.columns("omega", "alpha")
        given = (omega, alpha, self.constant("damping_ratio"), self.constant("static_friction_ratio"))
        return Points(self.at.shape, dict(zip(RATIOS, map(np.asarray, given))), self.at.like)

    def scale(self, name: str) -> Value:
        """The size of one unit of a measure, or a ratio."""
        if name == "work":
            return self.constant("force") * self.constant("length")
        if name == "period":
            return 2 * np.pi * self.scale("time")
        if name in _CONSTANT:
            return self.constant(name)
        value: Value = self.columns(name)[0]
        return value

    def varied(self) -> dict[str, tuple[Any, str]]:
        """The frequency if it was given in hertz, and the values that differ among the bodies and drives, in the shape of the points, with their
        units; the amplitude of a force is a value of each answer."""
        found: dict[str, tuple[Any, str]] = {}
        if self.is_in_hertz:
            found["frequency"] = (np.asarray(self.at.in_shape()["angular_frequency"]) / (2 * np.pi), "Hz")
        kinds = {**_KINDS, **dict(_native.EXCITATIONS)}
        units = names_of(self.units, kinds) or {}
        for name in (*_KINDS, *({self.excitation} - {"force"})):
            array = self.at.given[name if name in _KINDS else "amplitude"]
            # Without a friction of its own backward it is NaN.
            if array.size and np.any((array != array.flat[0]) & ~np.isnan(array)):
                found[name] = (np.broadcast_to(array, self.at.shape or ()), units.get(name, ""))
        return found

    def names(self, rows: Mapping[str, Any], sources: Mapping[str, str]) -> list[str]:
        """The values that exist under this excitation."""
        known = _native.physical_outputs(self.excitation)
        units = {own for own, _, _ in _rows.physical_names().values()}
        here = {own for own, _, _ in known.values()}
        return [name for name in rows if name not in units or name in here]


class Scaled(NamedTuple):
    """The values of an answer in units, computed when they are read."""

    answer: Result
    driven: Driven
    #: The output of the answer that each value follows from.
    sources: Mapping[str, str]

    def __call__(self, names: Iterable[str]) -> dict[str, Any]:
        names = tuple(names)
        if len(names) > 1:
            self.answer._compute(self.sources[name] for name in names if name in self.sources)
        return {name: self.value(name) for name in names}

    def value(self, name: str) -> Any:
        found = self._value(name)
        if name in _OF_SPRING and np.any(self.driven.springless):
            found = np.where(self.driven.springless, np.nan, found)
            return found.item() if found.ndim == 0 else found
        return found

    def _value(self, name: str) -> Any:
        driven, shape = self.driven, self.driven.at.shape
        if name == "angular_frequency":
            return driven.at.in_shape()[name]
        if name == "force_amplitude":
            return driven.scale(name)
        if name in ("friction_displacement", "mean_displacement"):
            constant = driven.scale("length" if name == "friction_displacement" else name)
            return constant if shape is None else np.broadcast_to(constant, shape)
        output = self.sources[name]
        known = {**_native.physical_outputs(driven.excitation), **OF_SIMULATION}
        own, scale, _ = known.get(output, (output, "", ""))
        if name == own and scale:
            if name == "best_force_energy":
                # The loop is that of the best force, not of the given one.
                best = self.raw("best_force_ratio") * driven.scale("force")
                return self.raw(output) * (0.5 * best * (best / driven.at.in_shape()["stiffness"]))
            value = self.raw(output) * driven.scale(scale)
            # Friction that differs by direction is symmetric about its mean.
            return value + driven.scale("mean_friction") if output == "friction" else value
        if name != output or name in {own for own, _, _ in _rows.physical_names().values()}:
            # No such value exists under this excitation.
            return float("nan") if shape is None else np.full(shape, np.nan)
        return self.raw(output)

    def is_at_hand(self, name: str) -> bool:
        """Whether the value of the answer is there."""
        return name in _rows.DRIVE_ROWS or self.sources.get(name) in self.answer._values

    def raw(self, name: str) -> Any:
        """A value of the answer as a number or an array of NumPy."""
        if name not in self.answer._values:
            getattr(self.answer, name)
        return self.answer._values[name]


_R = TypeVar("_R", bound=PhysicalResult)


def related(answer: _R, ratios: Result, driven: Driven) -> _R:
    """An answer in units with the same one in ratios, and with its machine."""
    object.__setattr__(answer, "_ratios", ratios)
    object.__setattr__(answer, "_driven", driven)
    return answer


def outputs_of(chosen: Iterable[str], sources: Mapping[str, str]) -> list[str]:
    """The outputs that chosen values of a machine follow from; the name of an output stands for its value."""
    return list(dict.fromkeys(sources.get(name, name) for name in chosen if name not in _rows.DRIVE_ROWS))
