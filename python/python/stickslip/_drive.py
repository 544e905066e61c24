"""Drives in physical units, and values with units."""

from __future__ import annotations

import copy
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, Generic, Optional, Union, overload

import numpy as np
from numpy.typing import ArrayLike

from . import _native
from ._labels import Labelled, Like, aligned, in_units, is_labelled, numbers, shape_of
from ._native import Error
from ._quantity import parted
from ._result import Floats, Frozen, V, Value, are_equal, one, read_only, short

#: The kind of the amplitude of each excitation.
_KINDS = dict(_native.EXCITATIONS)
#: The kind of each keyword.
INPUTS = dict(_native.INPUTS)
#: A number, or text with a unit such as ``"12 kN"``.
Quantity = Union[float, str]
#: The excitations of which `Drive` has a keyword.
EXCITATIONS: tuple[str, ...] = tuple(_KINDS)


def texts(given: Mapping[str, Any]) -> list[tuple[str, str]]:
    """The given single values by name, as text with all their digits and their units."""
    return [(name, text(name, value)) for name, value in given.items()]


def text(name: str, value: Any) -> str:
    """A single value as text with all its digits and its unit."""
    value, unit = parted(name, value)
    return value if isinstance(value, str) else f"{one(name, value)!r} {unit}".rstrip()


def read(given: Mapping[str, tuple[Any, str]], units: Optional[str]) -> tuple[dict[str, float], Optional[str]]:
    """The numbers of the given (value, kind) pairs, by name, and their system of units if it is known."""
    named = texts({name: value for name, (value, _) in given.items()})
    values, system = _native.read_values([(*pair, kind) for pair, (_, kind) in zip(named, given.values())], units)
    return dict(zip(given, values)), system


def of_kind(name: str, value: Any, kind: str, units: Optional[str] = None) -> Any:
    """A number or an array in a system of units, if it is a text or has a unit; others as they are."""
    if isinstance(value, str):
        return read({name: (value, kind)}, units)[0][name]
    return in_system(name, *parted(name, value), kind, units)


def in_system(name: str, value: Any, unit: str, kind: str, units: Optional[str]) -> Any:
    """The parts of a value together: numbers in a system of units if there is a unit, and otherwise as they are."""
    return _with(value, in_units(name, numbers(name, value), unit, kind, units)) if unit else value


def is_array(value: Any) -> bool:
    """Whether a value is an array of any kind rather than a number or a text."""
    return isinstance(value, (list, tuple)) or is_labelled(value) and bool(value.shape) or not isinstance(value, (str, bytes)) and np.ndim(value) > 0


def kept(given: Mapping[str, Any], own: Mapping[str, Any]) -> dict[str, Any]:
    """The given values in memory that later changes of the arguments do not reach: that of the object's own values, where they are the same."""

    def one(name: str, value: Any) -> Any:
        known = own.get(name)
        if type(value) is type(known) is np.ndarray and value.dtype == known.dtype and np.array_equal(value, known):
            return known
        return copy.deepcopy(value) if is_array(value) else value

    return {name: one(name, value) for name, value in given.items() if value is not None}


def relabelled(values: Mapping[str, Any], fields: Iterable[str]) -> tuple[dict[str, Any], Optional[Like]]:
    """The values by their keywords as numbers and arrays by the names of fields, aligned by their labels, in the kind in which they
    were given."""
    given, like = aligned(values)
    shape = shape_of(given)
    found: dict[str, Any] = {}
    for name, array in zip(fields, given.values()):
        if array.ndim == 0:
            found[name] = float(array)
        elif like is None:
            found[name] = array
        else:
            found[name] = like.dressed(name, np.broadcast_to(array, shape), {})
    return found, like


def system_of(what: str, units: Optional[str], is_named: bool, own: Optional[str], is_bare: bool, machine: str = "the machine") -> None:
    """The one rule for values beside a machine: a bare number is in the system that the machine names, and a value with a unit
    needs a machine with units."""
    if own is not None and units is None:
        bare, other = machine, what
    elif own is None and units is not None and is_bare and not is_named:
        bare, other = what, machine
    else:
        return
    raise Error(
        f"{bare}: has no unit beside {other}. Give every value a unit, or name the system of bare numbers, "
        'as by units="kN,m"'
    )


@dataclass(frozen=True, init=False, eq=False, repr=False)
class Drive(Frozen, Generic[V]):
    """A harmonic drive: an amplitude and a frequency, numbers or arrays that broadcast.

    Parameters
    ----------
    force : float, str or array
        Amplitude of a force on the body; as text with its unit, such as ``"12 kN"``.
    unbalance : float, str or array
        Mass times eccentricity of a mass that rotates on the body, such as ``"0.35 kg*m"``: a force of this times the
        square of the angular frequency.
    foot_displacement : float, str or array
        Amplitude of a motion of the spring's support over a fixed surface.
    damped_foot_displacement : float, str or array
        The same, with the damper attached to the moving support.
    base_displacement, base_velocity, base_acceleration : float, str or array
        Amplitude of a motion of the base that carries the surface, as under an isolator. The resulting
        displacement is that of the body relative to the base.
    frequency : float, str or array
        In hertz, or as text such as ``"2 Hz"`` or ``"120 rpm"``.
    angular_frequency : float or array
        The same in radians per second; give one of the two.
    mean_force : float, str or array
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
    >>> drive = ss.Drive(force="12 kN", frequency="2 Hz")
    >>> drive
    Drive(force=12000.0, frequency=2.0, units='N,m')
    >>> drive.replace(frequency="3 Hz").frequency
    3.0
    """

    excitation: str
    amplitude: V
    angular_frequency: V
    mean_force: Value
    units: Optional[str]

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
        self: "Drive[Any]",
        *,
        force: Optional[Any] = None,
        unbalance: Optional[Any] = None,
        foot_displacement: Optional[Any] = None,
        damped_foot_displacement: Optional[Any] = None,
        base_displacement: Optional[Any] = None,
        base_velocity: Optional[Any] = None,
        base_acceleration: Optional[Any] = None,
        frequency: Labelled,
        mean_force: Any = 0.0,
        units: Optional[str] = None,
    ) -> None: ...

    @overload
    def __init__(
        self: "Drive[Any]",
        *,
        force: Optional[Labelled] = None,
        unbalance: Optional[Labelled] = None,
        foot_displacement: Optional[Labelled] = None,
        damped_foot_displacement: Optional[Labelled] = None,
        base_displacement: Optional[Labelled] = None,
        base_velocity: Optional[Labelled] = None,
        base_acceleration: Optional[Labelled] = None,
        frequency: ArrayLike,
        mean_force: Any = 0.0,
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
        mean_force: ArrayLike = 0.0,
        units: Optional[str] = None,
    ) -> None: ...

    def __init__(
        self,
        *,
        force: Any = None,
        unbalance: Any = None,
        foot_displacement: Any = None,
        damped_foot_displacement: Any = None,
        base_displacement: Any = None,
        base_velocity: Any = None,
        base_acceleration: Any = None,
        frequency: Any = None,
        angular_frequency: Any = None,
        mean_force: Any = 0.0,
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
        # An array is read as a column; a number stands for it where units are checked.
        parts = {name: parted(name, value) for name, value in {**given, "mean_force": mean_force}.items()}
        arrays = {name: value for name, (value, _) in parts.items() if is_array(value)}
        values = {name: stand_in(parts[name][1]) if name in arrays else value for name, value in given.items()}
        if "mean_force" in arrays:
            values["mean_force"] = stand_in(parts["mean_force"][1])
        elif isinstance(mean_force, str) or one("mean_force", mean_force, "force") != 0.0:
            values["mean_force"] = mean_force
        arrays = {name: in_system(name, *parts[name], INPUTS[name], units) for name in arrays}
        name, amplitude, mean, system = _native.drive(texts(values), units)
        of_frequency = "frequency" if frequency is not None else "angular_frequency"
        columns, like = relabelled(
            {name: arrays.get(name, amplitude), of_frequency: angular, "mean_force": arrays.get("mean_force", mean)},
            ("amplitude", "angular_frequency", "mean_force"),
        )
        fields = {**columns, "excitation": name, "units": system, "_named": units is not None}
        keywords = {**given, "frequency": frequency, "angular_frequency": angular_frequency, "mean_force": mean_force}
        fields["_keywords"] = kept(keywords, {**fields, name: fields["amplitude"]})
        for key, value in fields.items():
            object.__setattr__(self, key, read_only(value))

    @property
    def frequency(self) -> V:
        """The frequency in hertz."""
        found: Any = self.angular_frequency
        return found / (2 * np.pi)  # type: ignore[no-any-return]

    @overload
    def replace(self: "Drive[float]", **changes: Union[float, str, None]) -> "Drive[float]": ...

    @overload
    def replace(self, **changes: Any) -> "Drive[Floats]": ...

    def replace(self, **changes: Any) -> "Drive[Any]":
        """This drive with other values, by the keywords of `Drive`; another amplitude takes the place of this one."""
        own = dict(vars(self)["_keywords"])
        if any(name in _KINDS for name in changes):
            own = {name: value for name, value in own.items() if name not in _KINDS}
        if "frequency" in changes or "angular_frequency" in changes:
            own = {name: value for name, value in own.items() if name not in ("frequency", "angular_frequency")}
        if vars(self)["_named"]:
            own["units"] = self.units
        return Drive(**{**own, **changes})

    __replace__ = replace

    def __repr__(self) -> str:
        mean = {} if not is_array(self.mean_force) and self.mean_force == 0 else {"mean_force": self.mean_force}
        given = {self.excitation: self.amplitude, "frequency": self.frequency, **mean, "units": self.units}
        return f"Drive({', '.join(f'{name}={short(value)}' for name, value in given.items())})"

    def __eq__(self, other: object) -> bool:
        return are_equal(self, other)

    def __hash__(self) -> int:
        return hash((self.excitation, self.amplitude, self.angular_frequency, self.mean_force, self.units))

    def _in(self, units: Optional[str], is_named: bool) -> dict[str, Any]:
        """The amplitude, the angular frequency and the mean force in a machine's system of units."""
        found: dict[str, Any] = {"amplitude": self.amplitude, "angular_frequency": self.angular_frequency, "mean_force": self.mean_force}
        if units == self.units:
            return found
        system_of("the drive", units, is_named, self.units, True)
        if self.units is None:
            return found
        for name, kind in (("amplitude", _KINDS[self.excitation]), ("mean_force", "force")):
            text = f"1 {_native.unit_of(self.units, kind)}"
            factor = read({name: (text, kind)}, units)[0][name]
            found[name] = found[name] * factor
        return found


def angular_of(frequency: Optional[ArrayLike], angular_frequency: Optional[ArrayLike]) -> Any:
    """The angular frequency of one given in hertz or in radians per second, with its labels; it is the same in all systems of
    units."""
    if (frequency is None) == (angular_frequency is None):
        raise Error("give one of frequency (in Hz) and angular_frequency (in rad/s)")
    name, value, factor = ("frequency", frequency, 2 * np.pi) if frequency is not None else ("angular_frequency", angular_frequency, 1.0)
    found = angular(name, value, factor)
    if isinstance(found, float) and not 0 < found < np.inf:
        raise Error(f"{name} {text(name, value)}: must be > 0 and finite")
    return found


def angular(name: str, value: Any, factor: float) -> Any:
    """Frequencies in radians per second, of which bare numbers have this factor."""
    if isinstance(value, str):
        values, system = read({name: (value, "frequency")}, None)
        # A bare number as text has no unit.
        return values[name] * (factor if system is None else 1.0)
    value, unit = parted(name, value)
    array = numbers(name, value)
    array = in_units(name, array, unit, "frequency", None) if unit else array * factor
    return float(array) if array.ndim == 0 else _with(value, array)


def has_unit(name: str, value: Any) -> bool:
    """Whether a value has a unit."""
    return _native.has_unit(value) if isinstance(value, str) else parted(name, value)[1] != ""


def stand_in(unit: str, number: float = 1.0) -> str:
    """The text of a number that stands for an array."""
    return f"{number!r} {unit}".rstrip()


def _with(value: Any, array: Any) -> Any:
    """Other numbers in the kind of array in which they were given."""
    if is_labelled(value):
        return value.copy(data=array) if hasattr(value, "dims") else type(value)(array, index=value.index, **_columns(value))
    return np.ma.MaskedArray(array, np.ma.getmaskarray(value)) if isinstance(value, np.ma.MaskedArray) else array


def _columns(value: Any) -> dict[str, Any]:
    return {"columns": value.columns} if hasattr(value, "columns") else {"name": value.name}


def one_value(name: str, value: Any, kind: str, units: Optional[str], is_named: bool) -> float:
    """A single value as a number in a machine's system of units."""
    if not isinstance(value, str) and parted(name, value)[1]:
        value = text(name, value)
    if isinstance(value, str):
        system = read({name: (value, kind)}, None)[1]
        if system is not None:
            system_of(f"{name} {value}", units, is_named, system, False)
            return read({name: (value, kind)}, units)[0][name]
        value = float(value)
    number = one(name, value)
    if not np.isnan(number):
        system_of(f"{name} {value}", units, is_named, None, number != 0.0)
    return number


def values_of(name: str, value: Any, kind: str, units: Optional[str], is_named: bool) -> Any:
    """A value or an array of numbers in a machine's system of units."""
    if not is_array(value):
        return one_value(name, value, kind, units, is_named)
    value, unit = parted(name, value)
    array = in_system(name, value, unit, kind, units)
    system_of(f"{name} [{unit}]" if unit else name, units, is_named, "N,m" if unit else None, bool(np.any(numbers(name, array) != 0.0)))
    return array
