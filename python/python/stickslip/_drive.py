"""Drives in physical units, and values with units."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Generic, Optional, Union, overload

import numpy as np
from numpy.typing import ArrayLike

from . import _native
from ._native import Error
from ._result import Floats, Like, V, Value, are_equal, numbers, one, points

#: The kind of the amplitude of each excitation.
_KINDS = dict(_native.EXCITATIONS)
#: A number, or text with a unit such as ``"12 kN"``.
Quantity = Union[float, str]


def texts(given: Mapping[str, Any]) -> list[tuple[str, str]]:
    """The given single values by name, as text with all their digits."""
    return [(name, value if isinstance(value, str) else repr(one(name, value))) for name, value in given.items()]


def read(given: Mapping[str, tuple[Any, str]], units: Optional[str]) -> tuple[dict[str, float], Optional[str]]:
    """The numbers of the given (value, kind) pairs, by name, and their system of units if it is known."""
    named = texts({name: value for name, (value, _) in given.items()})
    values, system = _native.read_values([(*pair, kind) for pair, (_, kind) in zip(named, given.values())], units)
    return dict(zip(given, values)), system


@dataclass(frozen=True, init=False, eq=False)
class Drive(Generic[V]):
    """A harmonic drive: one amplitude and a frequency, numbers or arrays.

    Parameters
    ----------
    force : float, str or array
        Amplitude of a force on the body; as text with its unit, such as ``"12 kN"``.
    unbalance : float, str or array
        Mass times eccentricity of a mass that rotates on the body, such as ``"0.35 kg*m"``: a force of this times the
        square of the angular frequency.
    foot_displacement : float, str or array
        Amplitude of a motion of the spring's foot over a fixed surface.
    damped_foot_displacement : float, str or array
        The same, with the damper attached to the moving foot.
    base_displacement, base_velocity, base_acceleration : float, str or array
        Amplitude of a motion of the base that carries the surface, as under an isolator. The resulting
        displacement is that of the body relative to the base.
    frequency : float, str or array
        In hertz, or as text such as ``"2 Hz"`` or ``"120 rpm"``.
    angular_frequency : float or array
        The same in radians per second; give one of the two.
    mean_force : float or str
        A constant force in addition to the harmonic one; it shifts the motion.
    units : str, optional
        The system of units of bare numbers, such as ``"kN,mm"``; values with units are converted to it.

    Attributes
    ----------
    excitation : str
        Which of the amplitudes is given.
    amplitude, angular_frequency, mean_force : float or array
    units : str or None
        The system of units: as given, or ``"N,m"`` where a value has a unit.

    Examples
    --------
    >>> import stickslip as ss
    >>> ss.Drive(force="12 kN", frequency="2 Hz")
    Drive(excitation='force', amplitude=12000.0, angular_frequency=12.566370614359172, mean_force=0.0, units='N,m')
    """

    excitation: str
    amplitude: Value
    angular_frequency: Value
    mean_force: float
    units: Optional[str]
    _like: Optional[Like] = field(repr=False, compare=False)

    @overload
    def __init__(
        self: "Drive[float]",
        *,
        force: Optional[Quantity] = None,
        unbalance: Optional[Quantity] = None,
        foot_displacement: Optional[Quantity] = None,
        damped_foot_displacement: Optional[Quantity] = None,
        base_displacement: Optional[Quantity] = None,
        base_velocity: Optional[Quantity] = None,
        base_acceleration: Optional[Quantity] = None,
        frequency: Optional[Quantity] = None,
        angular_frequency: Optional[Quantity] = None,
        mean_force: Quantity = 0.0,
        units: Optional[str] = None,
    ) -> None: ...

    @overload
    def __init__(
        self: "Drive[Floats]",
        *,
        force: Optional[ArrayLike] = None,
        unbalance: Optional[ArrayLike] = None,
        foot_displacement: Optional[ArrayLike] = None,
        damped_foot_displacement: Optional[ArrayLike] = None,
        base_displacement: Optional[ArrayLike] = None,
        base_velocity: Optional[ArrayLike] = None,
        base_acceleration: Optional[ArrayLike] = None,
        frequency: Optional[ArrayLike] = None,
        angular_frequency: Optional[ArrayLike] = None,
        mean_force: Quantity = 0.0,
        units: Optional[str] = None,
    ) -> None: ...

    def __init__(
        self,
        *,
        force: Optional[ArrayLike] = None,
        unbalance: Optional[ArrayLike] = None,
        foot_displacement: Optional[ArrayLike] = None,
        damped_foot_displacement: Optional[ArrayLike] = None,
        base_displacement: Optional[ArrayLike] = None,
        base_velocity: Optional[ArrayLike] = None,
        base_acceleration: Optional[ArrayLike] = None,
        frequency: Optional[ArrayLike] = None,
        angular_frequency: Optional[ArrayLike] = None,
        mean_force: Quantity = 0.0,
        units: Optional[str] = None,
    ) -> None:
        amplitudes = {
            "force": force,
            "unbalance": unbalance,
            "foot_displacement": foot_displacement,
            "damped_foot_displacement": damped_foot_displacement,
            "base_displacement": base_displacement,
            "base_velocity": base_velocity,
            "base_acceleration": base_acceleration,
        }
        given = {name: value for name, value in amplitudes.items() if value is not None}
        angular = angular_of(frequency, angular_frequency)
        object.__setattr__(self, "angular_frequency", angular)
        # An amplitude that is not text is a number or an array, for which any number stands when it is read.
        arrays = {name: numbers(name, value) for name, value in given.items() if not isinstance(value, str)}
        values = {**given, **{name: 1.0 if array.ndim else array for name, array in arrays.items()}}
        if isinstance(mean_force, str) or one("mean_force", mean_force) != 0.0:
            values["mean_force"] = mean_force
        name, amplitude, mean, system = _native.drive(texts(values), units)
        of_pandas_or_masked = {
            "amplitude": given[name] if name in arrays else amplitude,
            "frequency": frequency if angular_frequency is None else angular_frequency,
        }
        like: dict[str, Any] = {
            key: angular if isinstance(value, str) else value for key, value in of_pandas_or_masked.items()
        }
        object.__setattr__(self, "_like", points(**like).like)
        object.__setattr__(self, "excitation", name)
        object.__setattr__(self, "amplitude", _plain(arrays[name]) if name in arrays else amplitude)
        object.__setattr__(self, "mean_force", mean)
        object.__setattr__(self, "units", system)

    def __eq__(self, other: object) -> bool:
        return are_equal(self, other)

    def __hash__(self) -> int:
        return hash((self.excitation, self.amplitude, self.angular_frequency, self.mean_force, self.units))

    def _in(self, units: Optional[str]) -> "Drive[V]":
        """The same drive in a machine's system of units."""
        if units == self.units:
            return self
        if units is None or self.units is None:
            bare, other = ("the machine", "the drive") if units is None else ("the drive", "the machine")
            raise Error(
                f"{bare}: has no unit beside {other}. Give every value a unit, or name the system of bare numbers, "
                'as by units="kN,m"'
            )
        factors = {}
        for kind in (_KINDS[self.excitation], "force"):
            text = f"1 {_native.unit_of(self.units, kind)}"
            factors[kind] = read({self.excitation: (text, kind)}, units)[0][self.excitation]
        new: Drive[V] = object.__new__(Drive)
        amplitude = np.asarray(self.amplitude) * factors[_KINDS[self.excitation]]
        values = {"amplitude": _plain(amplitude), "mean_force": self.mean_force * factors["force"], "units": units}
        for name in ("excitation", "amplitude", "angular_frequency", "mean_force", "units", "_like"):
            object.__setattr__(new, name, values.get(name, getattr(self, name)))
        return new


def _plain(array: Floats) -> Value:
    return float(array) if array.ndim == 0 else array


def angular_of(frequency: Optional[ArrayLike], angular_frequency: Optional[ArrayLike]) -> Value:
    """The angular frequency of one given in hertz or in radians per second; it is the same in all systems of units."""
    if (frequency is None) == (angular_frequency is None):
        raise Error("give one of frequency (in Hz) and angular_frequency (in rad/s)")
    for name, value in (("frequency", frequency), ("angular_frequency", angular_frequency)):
        if isinstance(value, str):
            values, system = read({name: (value, "frequency")}, None)
            # A bare number as text has no unit.
            return values[name] * (2 * np.pi if system is None and name == "frequency" else 1.0)
    if frequency is not None:
        return _plain(numbers("frequency", frequency) * (2 * np.pi))
    assert angular_frequency is not None
    return _plain(numbers("angular_frequency", angular_frequency))
