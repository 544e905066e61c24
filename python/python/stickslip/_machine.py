"""Machines in physical units."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Optional, TypeVar, Union, overload

import numpy as np
from numpy.typing import ArrayLike

from . import _closed_forms, _native, _steady
from ._attractors import Attractors, attractors
from ._closed_forms import OUTPUTS, Border, Response
from ._drive import Drive, Quantity, angular_of, read, texts
from ._motion import Decay, Phases, PhysicalDecay, PhysicalPhases, PhysicalSamples, Samples, decay, simulate
from ._native import Error
from ._outputs import PhysicalResponse, PhysicalSteady
from ._physical import Driven, Scaled, names_of
from ._record import (
    FloorSpectrum,
    Followed,
    Motion,
    Polarities,
    Record,
    floor_spectrum,
    follow,
    motion,
    polarities,
)
from ._result import RATIOS, Floats, PhysicalResult, Result, Words, WrongType, named, of_type, one, whole_number
from ._start import REST, Start, state
from ._steady import STEADY_OUTPUTS, Steady

if TYPE_CHECKING:
    from ._design import Band, BandFriction, BestFriction


_R = TypeVar("_R", bound=Result)


def angular(frequency: Optional[Quantity]) -> Optional[Quantity]:
    """The angular frequency of a number in hertz; text with a unit as it is."""
    return frequency if frequency is None or isinstance(frequency, str) else 2 * np.pi * one("natural_frequency", frequency)


@dataclass(frozen=True, init=False)
class Machine:
    """A body on its spring and friction surface.

    Values are text with units, such as ``"12 kN/mm"``, in any mixture, or numbers in one consistent system.

    Parameters
    ----------
    mass : float or str
    weight : float or str
        In place of the mass: ``mass = weight/gravity``.
    stiffness : float or str
        Of the spring. With the natural period or frequency it takes the place of the mass.
    natural_frequency : float or str
        In place of the stiffness, in hertz or as text such as ``"1.5 Hz"``.
    period : float or str
        The natural period in place of the stiffness: ``k = m (2 pi/period)**2``.
    pendulum_radius : float or str
        Radius of a friction pendulum in place of the stiffness: ``k = m gravity/radius``, for displacements far below
        the radius.
    friction : float or str
        Friction bound: the force of friction while the body slides. A body without friction, 0, can follow records only.
    friction_coefficient, gravity : float or str
        In place of the friction bound: ``friction_coefficient * mass * gravity``. The default gravity is
        9.80665 m/s**2; bare numbers without a known system of units are then in SI.
    friction_backward : float or str, optional
        Friction bound of backward motion, if it differs from that of forward motion. The friction bound of
        the ratios and the static friction are then means of both directions: at rest the bounds are
        ``static_friction_ratio*(friction + friction_backward)/2 ± (friction - friction_backward)/2``.
    damping : float or str
        Constant of a viscous damper, >= 0.
    damping_ratio : float or str
        In place of the damping constant: ``c/(2 sqrt(k m))``.
    static_friction : float or str
        The force that releases the body at rest, at least the friction bound.
    static_friction_ratio : float
        In place of the static friction: its ratio to the kinetic friction, >= 1.
    units : str, optional
        Units of force and length, such as ``"kN,mm"``: the system of units of results and of bare numbers.

    Attributes
    ----------
    mass, stiffness, friction, friction_backward, damping, static_friction_ratio
        In the system of units.
    units : str or None
        The system of units: as given, or ``"N,m"`` where a value has a unit.

    Examples
    --------
    The machine of the source paper, 50 t on 1000 kN/m, friction 5 kN, under 12 kN at 1 Hz:

    >>> import stickslip as ss
    >>> machine = ss.Machine(mass="50 t", stiffness="1000 kN/m", friction="5 kN")
    >>> answer = machine.response(ss.Drive(force="12 kN", frequency="1 Hz"))
    >>> answer.regime, round(answer.physical.max_displacement, 9), answer.physical.units["max_displacement"]
    ('non-sticking', 0.009914465, 'm')
    >>> ss.Machine(mass="800 kg", period="2.2 s", friction_coefficient=0.05)
    Machine(mass=800.0, stiffness=6525.3..., friction=392.2..., friction_backward=None, damping=0.0, static_friction_ratio=1.0, units='N,m')
    """

    mass: float
    stiffness: float
    friction: float
    friction_backward: Optional[float]
    damping: float
    static_friction_ratio: float
    units: Optional[str]
    #: The damping ratio as given; None if the damping constant was.
    _damping_ratio: Optional[float] = field(repr=False, compare=False)

    def __init__(
        self,
        mass: Optional[Quantity] = None,
        stiffness: Optional[Quantity] = None,
        friction: Optional[Quantity] = None,
        *,
        friction_backward: Optional[Quantity] = None,
        damping: Optional[Quantity] = None,
        weight: Optional[Quantity] = None,
        natural_frequency: Optional[Quantity] = None,
        period: Optional[Quantity] = None,
        pendulum_radius: Optional[Quantity] = None,
        friction_coefficient: Optional[Quantity] = None,
        gravity: Optional[Quantity] = None,
        damping_ratio: Optional[Quantity] = None,
        static_friction: Optional[Quantity] = None,
        static_friction_ratio: Optional[Quantity] = None,
        units: Optional[str] = None,
    ) -> None:
        given = {
            "mass": mass,
            "weight": weight,
            # A bare frequency is in hertz here, and an angular one in the library.
            "natural_frequency": angular(natural_frequency),
            "stiffness": stiffness,
            "period": period,
            "pendulum_radius": pendulum_radius,
            "friction": friction,
            "friction_coefficient": friction_coefficient,
            "gravity": gravity,
            "friction_backward": friction_backward,
            "damping": damping,
            "damping_ratio": damping_ratio,
            "static_friction": static_friction,
            "static_friction_ratio": static_friction_ratio,
        }
        values = texts({name: value for name, value in given.items() if value is not None})
        body, ratio, system = _native.machine(values, units)
        names = ("mass", "stiffness", "friction", "friction_backward", "damping", "static_friction_ratio")
        for name, value in zip(names, body):
            object.__setattr__(self, name, value)
        if friction_backward is None:
            object.__setattr__(self, "friction_backward", None)
        object.__setattr__(self, "_damping_ratio", ratio)
        object.__setattr__(self, "units", system)

    @property
    def natural_angular_frequency(self) -> float:
        """Natural angular frequency ``sqrt(k/m)``, in radians per second."""
        return float(np.sqrt(self.stiffness / self.mass))

    @property
    def natural_frequency(self) -> float:
        """Natural frequency ``sqrt(k/m)/(2 pi)``, in hertz, as the frequency of a `Drive`."""
        return self.natural_angular_frequency / (2 * np.pi)

    @property
    def _body(self) -> tuple[float, float, float, float, float, float]:
        backward = float("nan") if self.friction_backward is None else self.friction_backward
        return (self.mass, self.stiffness, self.friction, backward, self.damping, self.static_friction_ratio)

    @overload
    def response(self, drive: Drive[float], *, outputs: Optional[Iterable[str]] = None) -> Response[float, str]: ...

    @overload
    def response(self, drive: Drive[Floats], *, outputs: Optional[Iterable[str]] = None) -> Response[Floats, Words]: ...

    def response(self, drive: Drive[Any], *, outputs: Optional[Iterable[str]] = None) -> Response[Any, Any]:
        """The response in closed form, in ratios and, as ``physical``, in the machine's units; see `response`."""
        chosen = None if outputs is None else named(outputs, OUTPUTS)
        driven = self._driven(drive)
        answer = _closed_forms.of_points(driven.ratios(), chosen, driven.excitation)
        return _with_units(answer, PhysicalResponse, driven, chosen)

    @overload
    def steady(
        self,
        drive: Drive[float],
        *,
        start: Start = REST,
        max_periods: int = _native.MAX_PERIODS,
        outputs: Optional[Iterable[str]] = None,
    ) -> Steady[float, str]: ...

    @overload
    def steady(
        self,
        drive: Drive[Floats],
        *,
        start: Start = REST,
        max_periods: int = _native.MAX_PERIODS,
        outputs: Optional[Iterable[str]] = None,
    ) -> Steady[Floats, Words]: ...

    def steady(
        self,
        drive: Drive[Any],
        *,
        start: Start = REST,
        max_periods: int = _native.MAX_PERIODS,
        outputs: Optional[Iterable[str]] = None,
    ) -> Steady[Any, Any]:
        """The steady state, in ratios and, as ``physical``, in the machine's units; see `steady`.

        The start is given in radians, B and B w. Transmissibility over frequency, stops included:

        >>> import numpy as np, stickslip as ss
        >>> machine = ss.Machine(mass="800 kg", period="2.2 s", friction_coefficient=0.05, damping_ratio="5%")
        >>> drive = ss.Drive(base_acceleration="0.15 g", frequency=np.linspace(0.3, 3, 4))
        >>> machine.steady(drive).transmissibility.round(3)
        array([1.943, 0.48 , 0.38 , 0.358])
        """
        chosen = None if outputs is None else named(outputs, STEADY_OUTPUTS)
        periods = whole_number("max_periods", max_periods)
        driven = self._driven(drive)
        answer = _steady.of_points(driven.ratios(), chosen, state(start), periods, driven.excitation)
        return _with_units(answer, PhysicalSteady, driven, chosen)

    @overload
    def simulate(
        self,
        drive: Drive[float],
        *,
        phase: float = 0.0,
        displacement: Quantity = 0.0,
        velocity: Quantity = 0.0,
        cycles: float = 1.0,
        samples: None = None,
    ) -> Phases: ...

    @overload
    def simulate(
        self,
        drive: Drive[float],
        *,
        phase: float = 0.0,
        displacement: Quantity = 0.0,
        velocity: Quantity = 0.0,
        cycles: float = 1.0,
        samples: int,
    ) -> Samples: ...

    def simulate(
        self,
        drive: Drive[float],
        *,
        phase: float = 0.0,
        displacement: Quantity = 0.0,
        velocity: Quantity = 0.0,
        cycles: float = 1.0,
        samples: Optional[int] = None,
    ) -> Union[Phases, Samples]:
        """The exact motion from a start, in ratios and, as ``physical``, in the machine's units; see `simulate`.

        The start is a phase of the drive (rad), a displacement and a velocity. Displacements are measured from
        ``physical.mean_displacement``, the shift due to a mean force or to friction that depends on the direction.

        >>> import stickslip as ss
        >>> machine = ss.Machine(mass="50 kg", stiffness="1 kN/mm", friction="5 kN")
        >>> drive = ss.Drive(force="12 kN", angular_frequency="20 Hz")
        >>> found = machine.simulate(drive, displacement="1 mm", samples=2)
        >>> found.physical.displacement.round(6), found.physical.units["displacement"]
        (array([ 0.001   ,  0.008907, -0.018173]), 'm')
        """
        driven = self._driven(drive)
        point = driven.ratios()
        if point.shape is not None:
            raise Error("a motion takes a drive of one amplitude and one frequency")
        x, v = self._value("displacement", displacement, "length"), self._value("velocity", velocity, "velocity")
        start = (one("phase", phase), x / one("length", driven.scale("length")), v / one("velocity", driven.scale("velocity")))
        ratios: dict[str, Any] = dict(zip(RATIOS, point.columns))
        if samples is None:
            phases: Phases = simulate(**ratios, start=start, cycles=cycles)
            return _with_units(phases, PhysicalPhases, driven)
        found: Samples = simulate(**ratios, start=start, cycles=cycles, samples=samples)
        return _with_units(found, PhysicalSamples, driven)

    def attractors(
        self, drive: Drive[float], *, starts: Any = 1000, reach: Optional[float] = None, max_periods: int = 2000
    ) -> Attractors:
        """All attractors that many starts lead to, in ratios; see `attractors`."""
        at = self._driven(drive).ratios()
        if at.shape is not None:
            raise Error("attractors take a drive of one amplitude and one frequency")
        ratios: dict[str, Any] = dict(zip(RATIOS, at.columns))
        return attractors(**ratios, starts=starts, reach=reach, max_periods=max_periods)

    def decay(self, displacement: Quantity, velocity: Quantity = 0.0) -> Decay:
        """Free vibration to rest, in ratios and, as ``physical``, in the machine's units; see `decay`.

        The start is a displacement and a velocity of the machine.

        >>> import stickslip as ss
        >>> machine = ss.Machine(mass="2 kg", stiffness="800 N/m", friction="3 N")
        >>> found = machine.decay("50 mm")
        >>> found.half_cycles, round(found.physical.rest_position, 6), found.physical.units["rest_position"]
        (7, 0.0025, 'm')
        """
        x, v = self._value("displacement", displacement, "length"), self._value("velocity", velocity, "velocity")
        time = 1.0 / self.natural_angular_frequency
        driven = self._driven(Drive(force=self.friction, angular_frequency=1.0, units=self.units))
        length = driven.constant("length")
        ratios = driven.constant("damping_ratio"), driven.constant("static_friction_ratio")
        found = decay(x / length, v * time / length, *ratios)
        sizes = {"first_turn": ("length", length), "rest_position": ("length", length), "path": ("length", length), "rest_time": ("time", time)}
        values = {name: found[name] * size for name, (_, size) in sizes.items()}
        units = names_of(self.units, {name: kind for name, (kind, _) in sizes.items()})
        return Decay(dict(found), physical=PhysicalDecay(values, units=units))

    def follow(
        self,
        record: Record,
        *,
        displacement: Quantity = 0.0,
        velocity: Quantity = 0.0,
        mean_force: Quantity = 0.0,
    ) -> Followed:
        """The exact motion under a record and after it, until the body rests, in the machine's units.

        No stop is missed: between samples the load is a straight line, under which slides and stops are closed forms.
        With a record of a base acceleration, displacements and velocities are those in relation to the base.
        Displacements are from the position of the relaxed spring, also with a mean force.

        >>> import numpy as np, stickslip as ss
        >>> t = np.arange(0, 12, 0.01)
        >>> record = ss.Record(0.3 * np.exp(-(((t - 4) / 2) ** 2)) * np.sin(9 * t), time_step="10 ms", unit="g")
        >>> isolator = ss.Machine(mass="800 kg", period="2.5 s", friction_coefficient=0.06, damping_ratio="5%")
        >>> found = isolator.follow(record)
        >>> found.slides == found.stops + found.reversals, found.units["residual_displacement"]
        (True, 'm')
        """
        return follow(self._sliding(mean_force), self.units, record, self._start(displacement, velocity))

    def motion(
        self,
        record: Record,
        *,
        displacement: Quantity = 0.0,
        velocity: Quantity = 0.0,
        mean_force: Quantity = 0.0,
        interval: Optional[float] = None,
    ) -> Motion:
        """The states and events of the motion under a record, and its answers; see `follow`.

        The states are at most ``interval`` seconds apart; by default the longest step of the record.
        """
        start = self._start(displacement, velocity)
        return motion(self._sliding(mean_force), self.units, record, start, interval)

    def polarities(
        self,
        record: Record,
        *,
        displacement: Quantity = 0.0,
        velocity: Quantity = 0.0,
        mean_force: Quantity = 0.0,
    ) -> Polarities:
        """The answers to a record and to its mirror image, and which of them moves the body further."""
        start = self._start(displacement, velocity)
        return polarities(self._sliding(mean_force), self.units, record, start)

    def floor_spectrum(
        self,
        record: Record,
        *,
        period: ArrayLike,
        damping_ratio: float = 0.05,
        displacement: Quantity = 0.0,
        velocity: Quantity = 0.0,
        mean_force: Quantity = 0.0,
    ) -> FloorSpectrum:
        """The greatest responses of linear oscillators of these natural periods in seconds and one damping ratio that stand on
        the body while it moves under a record, followed exactly.

        >>> import numpy as np, stickslip as ss
        >>> t = np.arange(0, 12, 0.01)
        >>> record = ss.Record(0.3 * np.exp(-(((t - 4) / 2) ** 2)) * np.sin(9 * t), time_step="10 ms", unit="g")
        >>> isolator = ss.Machine(mass="800 kg", period="2.5 s", friction_coefficient=0.06)
        >>> found = isolator.floor_spectrum(record, period=[0.1, 0.5, 1.0])
        >>> found.max_absolute_acceleration.shape, found.units["pseudo_acceleration"]
        ((3,), 'm/s²')
        """
        start = self._start(displacement, velocity)
        return floor_spectrum(self._sliding(mean_force), self.units, record, start, period, damping_ratio)

    def _start(self, displacement: Quantity, velocity: Quantity) -> tuple[float, float]:
        return self._value("displacement", displacement, "length"), self._value("velocity", velocity, "velocity")

    def _sliding(self, mean_force: Quantity) -> tuple[float, float, float, float, float, float, float, bool]:
        backward = self.friction if self.friction_backward is None else self.friction_backward
        force = self._value("mean_force", mean_force, "force")
        ratio = self.static_friction_ratio
        return (self.mass, self.stiffness, self.damping, self.friction, backward, ratio, force, False)

    @overload
    def border(
        self, *, frequency: Optional[Quantity] = None, angular_frequency: Optional[Quantity] = None
    ) -> Border[float]: ...

    @overload
    def border(
        self, *, frequency: Optional[ArrayLike] = None, angular_frequency: Optional[ArrayLike] = None
    ) -> Border[Floats]: ...

    def border(
        self, *, frequency: Optional[ArrayLike] = None, angular_frequency: Optional[ArrayLike] = None
    ) -> Border[Any]:
        """The border at a frequency, in ratios; `min_force` gives it as a force."""
        given: dict[str, Any] = {"frequency": frequency, "angular_frequency": angular_frequency}
        drive: Drive[Any] = Drive(force=self.friction, units=self.units, **given)
        at = self._driven(drive).ratios()
        return _closed_forms.border_of(at)

    def min_force(
        self,
        *,
        frequency: Optional[Quantity] = None,
        angular_frequency: Optional[Quantity] = None,
        excitation: str = "force",
    ) -> float:
        """The minimum amplitude of an excitation at which the cycle without a stop exists, at a frequency.

        With one friction the body then never sticks. With a static friction above the kinetic one the cycle attracts
        its neighbourhood, and a body at rest is released only by a force above the static friction.

        The excitation is the force, or another amplitude by its name in `Drive`.
        """
        return _native.min_amplitude(self._body, excitation, _one_frequency(frequency, angular_frequency))

    def max_friction(self, drive: Drive[float]) -> float:
        """The maximum friction bound with which the cycle without a stop exists under a drive; see `min_force`."""
        return _native.max_friction(self._body, *self._single(drive))

    def best_friction(self, drive: Drive[float]) -> "BestFriction":
        """The friction bound that dissipates most under a drive, among those at which the body does not stick."""
        from ._design import BestFriction

        friction, energy, optimum = _native.best_friction(self._body, *self._single(drive))
        return BestFriction(friction, energy, optimum)

    def best_friction_over(
        self,
        drive: Drive[float],
        *,
        frequency: Optional[tuple[Quantity, Quantity]] = None,
        angular_frequency: Optional[tuple[Quantity, Quantity]] = None,
        of: str = "absolute-displacement",
    ) -> "BandFriction":
        """The friction bound whose greatest amplitude between two frequencies is least, stops included.

        The friction of this machine and the frequency of the drive play no part. The amplitude is ``"displacement"``,
        ``"absolute-displacement"``, ``"transmitted-force"`` or ``"acceleration"`` (in space).

        >>> import stickslip as ss
        >>> machine = ss.Machine(mass="800 kg", period="2.2 s", friction="1 N", damping_ratio=0.05)
        >>> drive = ss.Drive(base_displacement="50 mm", frequency="1 Hz")
        >>> best = machine.best_friction_over(drive, frequency=(0.2, 2.0))
        >>> round(best.friction, 2), round(best.greatest, 9), best.optimum
        (320.69, 0.05, 'interior')
        """
        from ._design import BandFriction

        kind, amplitude, _ = self._single(drive)
        ends, unit = _range(frequency, angular_frequency)
        friction, greatest, at, optimum, rest = _native.best_friction_over(self._body, kind, amplitude, *ends, of)
        return BandFriction(friction, greatest, [(low / unit, high / unit) for low, high in at], optimum, rest)

    def bands(
        self,
        *,
        frequency: Optional[tuple[Quantity, Quantity]] = None,
        angular_frequency: Optional[tuple[Quantity, Quantity]] = None,
        force: Optional[Quantity] = None,
        foot_displacement: Optional[Quantity] = None,
        unbalance: Optional[Quantity] = None,
        base_displacement: Optional[Quantity] = None,
        base_velocity: Optional[Quantity] = None,
        base_acceleration: Optional[Quantity] = None,
    ) -> "list[Band]":
        """All bands between two frequencies in which the body does not stick, in hertz or in radians per second as given.

        With a damper, and under an unbalance or a base motion by displacement or velocity, they are found by a search.

        >>> import stickslip as ss
        >>> machine = ss.Machine(mass="800 kg", period="2.2 s", friction_coefficient=0.05)
        >>> [(round(band.low, 3), band.high) for band in machine.bands(frequency=(0.2, 5.0), force="0.9 kN")]
        [(0.252, 5.0)]
        """
        from ._design import Band

        amplitudes = (force, foot_displacement, unbalance, base_displacement, base_velocity, base_acceleration)
        units = self.units if not any(isinstance(x, str) for x in amplitudes) else None
        drive = Drive(
            force=force,
            foot_displacement=foot_displacement,
            unbalance=unbalance,
            base_displacement=base_displacement,
            base_velocity=base_velocity,
            base_acceleration=base_acceleration,
            angular_frequency=1.0,
            units=units,
        )
        kind, amplitude, _ = self._single(drive)
        ends, unit = _range(frequency, angular_frequency)
        found = _native.bands(self._body, kind, amplitude, *ends)
        return [Band(low / unit, high / unit, *cut) for low, high, *cut in found]

    def force_for_displacement(
        self,
        max_displacement: Quantity,
        *,
        frequency: Optional[Quantity] = None,
        angular_frequency: Optional[Quantity] = None,
    ) -> float:
        """The force amplitude at which the cycle has a given maximum displacement, at a frequency."""
        target = self._value("max_displacement", max_displacement, "length")
        return _native.force_for(self._body, _one_frequency(frequency, angular_frequency), target, False)

    def force_for_velocity(
        self,
        max_velocity: Quantity,
        *,
        frequency: Optional[Quantity] = None,
        angular_frequency: Optional[Quantity] = None,
    ) -> float:
        """The force amplitude at which the cycle has a given maximum velocity, at a frequency."""
        target = self._value("max_velocity", max_velocity, "velocity")
        return _native.force_for(self._body, _one_frequency(frequency, angular_frequency), target, True)

    def _value(self, name: str, value: Quantity, kind: str) -> float:
        """A value as a number in the machine's system of units, to which bare numbers belong."""
        if isinstance(value, str) and self.units is None:
            raise Error(f"{name} {value}: has a unit, and the machine's values have none")
        return read({name: (value, kind)}, self.units)[0][name]

    def _driven(self, drive: Drive[Any]) -> Driven:
        of_type("drive", drive, Drive)
        return Driven.by(self._body, self._damping_ratio, drive._in(self.units))

    def _single(self, drive: Drive[Any]) -> tuple[str, float, float]:
        at = self._driven(drive)
        if at.drives.shape is not None:
            raise Error("a design takes a drive of one amplitude and one frequency")
        amplitude, frequency = (float(column) for column in at.drives.columns)
        return at.excitation, amplitude, frequency


def _one_frequency(frequency: Optional[Quantity], angular_frequency: Optional[Quantity]) -> float:
    """One frequency in radians per second."""
    return one("frequency", angular_of(frequency, angular_frequency))


_Range = Optional[tuple[Quantity, Quantity]]


def _range(frequency: _Range, angular_frequency: _Range) -> tuple[tuple[float, float], float]:
    """The ends of a range in radians per second, and the unit in which it was given."""
    if (frequency is None) == (angular_frequency is None):
        raise Error("give one of frequency (in Hz) and angular_frequency (in rad/s), as (low, high)")
    try:
        low, high = frequency if angular_frequency is None else angular_frequency  # type: ignore[misc]
    except (TypeError, ValueError):
        raise WrongType("a range of frequency must be (low, high)") from None
    if angular_frequency is None:
        return (_one_frequency(low, None), _one_frequency(high, None)), 2 * np.pi
    return (_one_frequency(None, low), _one_frequency(None, high)), 1.0


def _with_units(answer: _R, physical: type[PhysicalResult], driven: Driven, chosen: Optional[Iterable[str]] = None) -> _R:
    """The answer with its values in the machine's units."""
    kinds = driven.kinds(answer._names if chosen is None else chosen)
    names = [name for name in physical._names if name in kinds]
    units = names_of(driven.units, kinds)
    values = physical({}, Scaled(answer, driven), units=units, chosen=names, like=answer._like)
    object.__setattr__(answer, "_physical", values)
    return answer
