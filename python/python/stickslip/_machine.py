"""Machines in physical units."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Generic, Optional, TypeVar, Union, overload

import numpy as np
from numpy.typing import ArrayLike

from . import _closed_forms, _native, _rows, _steady
from ._attractors import Basins, MachineAttractors, attractors
from ._closed_forms import OUTPUTS, Border, MachineResponse
from ._drive import INPUTS, Drive, Quantity, angular, angular_of, has_unit, in_system, is_array, kept, one_value, stand_in, texts, values_of
from ._labels import WrongType, aligned, numbers, shape_of
from ._motion import MachineDecay, MachinePhases, MachineSamples, decay_of, samples_of, simulate
from ._native import Error
from ._outputs import MachineResponseOutput, MachineSteadyOutput
from ._physical import OF_BODY, Driven, Scaled, names_of, outputs_of, related
from ._record import FloorSpectrum, Followed, Motion, Polarities, Record, Sliding, floor_spectrum, follow, motion, polarities
from ._quantity import parted
from ._result import RATIOS, Floats, Frozen, Joined, PhysicalResult, Points, Result, V, Words, are_equal, blocks, named, of_type, one, points, read_only, short, whole_number
from ._start import REST, STATE, Starts, three
from ._steady import STEADY_OUTPUTS, MachineSteady

if TYPE_CHECKING:
    from ._design import Band, BandFriction, BestFriction, BestStiffness, TargetFriction
    from ._system import System


_R = TypeVar("_R", bound=PhysicalResult)
#: Keywords that determine each other: one of a group takes the place of the others.
_GROUPS = (
    ("mass", "weight"),
    ("stiffness", "natural_frequency", "period", "pendulum_radius"),
    ("friction", "friction_coefficient"),
    ("damping", "damping_ratio"),
    ("static_friction", "static_friction_ratio"),
)


@dataclass(frozen=True, init=False, eq=False, repr=False)
class Machine(Frozen, Generic[V]):
    """A body on its spring and friction surface, or several of them.

    Values are text with units, such as ``"12 kN/mm"``, or quantities of pint or astropy, in any mixture, or numbers in one
    consistent system. Arrays of numbers
    that broadcast make as many machines: ``Machine(mass=50, stiffness=1000, friction=np.linspace(1, 9, 100))``. Arrays of
    pandas and xarray are aligned by their labels. A machine of an array outside the domain has NaN for its answers.

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
        Friction force: the force of friction while the body slides; 0 for a body without friction, which no question of
        design takes.
    friction_coefficient, gravity : float or str
        In place of the friction force: ``friction_coefficient * mass * gravity``. The default gravity is
        9.80665 m/s**2; bare numbers without a known system of units are then in SI.
    friction_backward : float or str, optional
        Friction force of backward motion, if it differs from that of forward motion. The friction force of
        the ratios and the static friction are then means of both directions: at rest the bounds are
        ``static_friction_ratio*(friction + friction_backward)/2 ± (friction - friction_backward)/2``.
    damping : float or str
        Constant of a viscous damper, >= 0.
    damping_ratio : float or str
        In place of the damping constant: ``c/(2 sqrt(k m))``.
    static_friction : float or str
        The force that releases the body at rest, at least the friction force.
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
    >>> answer.regime, round(answer.max_displacement, 9), answer.units["max_displacement"]
    ('non-sticking', 0.009914465, 'm')
    >>> ss.Machine(mass="800 kg", period="2.2 s", friction_coefficient=0.05)
    Machine(mass=800.0, stiffness=6525.3..., friction=392.2..., units='N,m')
    >>> many = ss.Machine(mass=50, stiffness=1000, friction=[4, 6], units="kN,m")
    >>> many.response(ss.Drive(force="12 kN", frequency="1 Hz")).max_displacement.round(6)
    array([0.010843, 0.008646])
    """

    mass: V
    stiffness: V
    friction: V
    friction_backward: Optional[V]
    damping: V
    static_friction_ratio: V
    units: Optional[str]

    @overload
    def __init__(
        self: "Machine[float]",
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
    ) -> None: ...

    @overload
    def __init__(
        self: "Machine[Floats]",
        mass: Optional[ArrayLike] = None,
        stiffness: Optional[ArrayLike] = None,
        friction: Optional[ArrayLike] = None,
        *,
        friction_backward: Optional[ArrayLike] = None,
        damping: Optional[ArrayLike] = None,
        weight: Optional[ArrayLike] = None,
        natural_frequency: Optional[ArrayLike] = None,
        period: Optional[ArrayLike] = None,
        pendulum_radius: Optional[ArrayLike] = None,
        friction_coefficient: Optional[ArrayLike] = None,
        gravity: Optional[ArrayLike] = None,
        damping_ratio: Optional[ArrayLike] = None,
        static_friction: Optional[ArrayLike] = None,
        static_friction_ratio: Optional[ArrayLike] = None,
        units: Optional[str] = None,
    ) -> None: ...

    def __init__(
        self,
        mass: Optional[ArrayLike] = None,
        stiffness: Optional[ArrayLike] = None,
        friction: Optional[ArrayLike] = None,
        *,
        friction_backward: Optional[ArrayLike] = None,
        damping: Optional[ArrayLike] = None,
        weight: Optional[ArrayLike] = None,
        natural_frequency: Optional[ArrayLike] = None,
        period: Optional[ArrayLike] = None,
        pendulum_radius: Optional[ArrayLike] = None,
        friction_coefficient: Optional[ArrayLike] = None,
        gravity: Optional[ArrayLike] = None,
        damping_ratio: Optional[ArrayLike] = None,
        static_friction: Optional[ArrayLike] = None,
        static_friction_ratio: Optional[ArrayLike] = None,
        units: Optional[str] = None,
    ) -> None:
        given = {
            "mass": mass,
            "weight": weight,
            "natural_frequency": natural_frequency,
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
        given = {name: value for name, value in given.items() if value is not None}
        own, failed, system = _bodies(given, units)
        if friction_backward is None:
            own["friction_backward"] = float("nan")
        hidden = {"_own": own, "_keywords": kept(given, own), "_named": units is not None, "_failed": failed}
        shown: dict[str, Any] = {name: own[name] for name in OF_BODY}
        if friction_backward is None:
            shown["friction_backward"] = None
        for name, value in {**shown, "units": system, **hidden}.items():
            object.__setattr__(self, name, read_only(value))

    @overload
    def replace(self: "Machine[float]", **changes: Union[float, str, None]) -> "Machine[float]": ...

    @overload
    def replace(self, **changes: Any) -> "Machine[Floats]": ...

    def replace(self, **changes: Any) -> "Machine[Any]":
        """This machine with other values, by the keywords of `Machine`. Values that it takes the place of are left out, such as the
        coefficient of friction for ``friction``; all others stay as they were given.

        >>> import numpy as np, stickslip as ss
        >>> machine = ss.Machine(mass="800 kg", period="2.2 s", friction_coefficient=0.05)
        >>> machine.replace(friction="300 N")
        Machine(mass=800.0, stiffness=6525.3..., friction=300.0, units='N,m')
        >>> machine.replace(friction_coefficient=np.linspace(0.02, 0.1, 5)).friction.round(1)
        array([156.9, 313.8, 470.7, 627.6, 784.5])
        """
        own = dict(vars(self)["_keywords"])
        for group in _GROUPS:
            # The stiffness and the period take the place of the mass, so that each of them is varied alone.
            is_of_mass = group == _GROUPS[1] and not {"mass", "weight"} & {*own, *changes}
            if any(name in changes for name in group) and not is_of_mass:
                own = {name: value for name, value in own.items() if name not in group}
        if "friction" in changes and not {"weight", "pendulum_radius"} & set(own):
            own.pop("gravity", None)
        if vars(self)["_named"]:
            own["units"] = self.units
        return Machine(**{**own, **changes})

    __replace__ = replace

    def __repr__(self) -> str:
        shown = {name: getattr(self, name) for name in OF_BODY}
        none = {"friction_backward": None, "damping": 0.0, "static_friction_ratio": 1.0}
        texts = [
            f"{name}={short(value)}" for name, value in shown.items() if is_array(value) or name not in none or value != none[name]
        ]
        return f"Machine({', '.join(texts)}, units={self.units!r})"

    def __eq__(self, other: object) -> bool:
        return are_equal(self, other)

    def __hash__(self) -> int:
        return hash((*(getattr(self, name) for name in OF_BODY), self.units))

    @property
    def natural_angular_frequency(self) -> V:
        """Natural angular frequency ``sqrt(k/m)``, in radians per second."""
        stiffness: Any = self.stiffness
        ratio = stiffness / self.mass
        found: V = np.sqrt(ratio) if is_array(ratio) else float(np.sqrt(ratio))  # type: ignore[assignment]
        return found

    @property
    def natural_frequency(self) -> V:
        """Natural frequency ``sqrt(k/m)/(2 pi)``, in hertz, as the frequency of a `Drive`."""
        found: Any = self.natural_angular_frequency
        return found / (2 * np.pi)  # type: ignore[no-any-return]

    @property
    def period(self) -> V:
        """Natural period in seconds."""
        found: Any = self.natural_angular_frequency
        return 2 * np.pi / found  # type: ignore[no-any-return]

    @property
    def damping_ratio(self) -> V:
        """Damping ratio ``c/(2 sqrt(k m))``."""
        return vars(self)["_own"]["damping_ratio"]  # type: ignore[no-any-return]

    @property
    def friction_displacement(self) -> V:
        """Friction force over stiffness, B, with the mean of both directions."""
        friction: Any = self.friction
        backward: Any = friction if self.friction_backward is None else self.friction_backward
        return (friction + backward) / 2 / self.stiffness  # type: ignore[no-any-return]

    @property
    def _body(self) -> tuple[float, float, float, float, float, float]:
        own = vars(self)["_own"]
        if any(is_array(own[name]) for name in OF_BODY):
            raise Error("this question takes one machine, not an array of machines")
        return tuple(own[name] for name in OF_BODY)

    @overload
    def response(
        self: "Machine[float]", drive: Drive[float], *, outputs: Optional[Iterable[MachineResponseOutput]] = None
    ) -> MachineResponse[float, str]: ...

    @overload
    def response(
        self: "Machine[Any]", drive: Drive[Any], *, outputs: Optional[Iterable[MachineResponseOutput]] = None
    ) -> MachineResponse[Floats, Words]: ...

    def response(self, drive: Drive[Any], *, outputs: Optional[Iterable[str]] = None) -> MachineResponse[Any, Any]:
        """The response in closed form, in the machine's units; ``ratios`` has the same one in ratios. See `response`.

        >>> import stickslip as ss
        >>> machine = ss.Machine(mass="50 t", stiffness="1000 kN/m", friction="5 kN", units="kN,mm")
        >>> found = machine.response(ss.Drive(force="12 kN", frequency="1 Hz"))
        >>> round(found.max_displacement, 3), found.units["max_displacement"], round(found.ratios.max_displacement, 6)
        (9.914, 'mm', 1.982893)
        """
        chosen = None if outputs is None else named(outputs, (*_rows.MACHINE_RESPONSE, *OUTPUTS))
        driven = self._driven(drive)
        asked = None if chosen is None else tuple(outputs_of(chosen, _rows.RESPONSE_SOURCES))
        answer = _closed_forms.of_points(driven.ratios(), without(asked), driven.excitation)
        return _with_units(answer, MachineResponse, driven, _rows.MACHINE_RESPONSE, _rows.RESPONSE_SOURCES, chosen)

    @overload
    def steady(
        self: "Machine[float]",
        drive: Drive[float],
        *,
        start: Starts = REST,
        max_periods: int = _native.MAX_PERIODS,
        outputs: Optional[Iterable[MachineSteadyOutput]] = None,
    ) -> MachineSteady[float, str]: ...

    @overload
    def steady(
        self: "Machine[Any]",
        drive: Drive[Any],
        *,
        start: Starts = REST,
        max_periods: int = _native.MAX_PERIODS,
        outputs: Optional[Iterable[MachineSteadyOutput]] = None,
    ) -> MachineSteady[Floats, Words]: ...

    def steady(
        self,
        drive: Drive[Any],
        *,
        start: Any = REST,
        max_periods: int = _native.MAX_PERIODS,
        outputs: Optional[Iterable[str]] = None,
    ) -> MachineSteady[Any, Any]:
        """The steady state, stops included, in the machine's units; ``ratios`` has the same one in ratios. See `steady`.

        The start is a phase of the drive (rad), and a displacement and a velocity in the machine's units, from the mean
        displacement. Transmissibility over frequency, stops included:

        >>> import numpy as np, stickslip as ss
        >>> machine = ss.Machine(mass="800 kg", period="2.2 s", friction_coefficient=0.05, damping_ratio="5%")
        >>> drive = ss.Drive(base_acceleration="0.15 g", frequency=np.linspace(0.3, 3, 4))
        >>> machine.steady(drive).transmissibility.round(3)
        array([1.943, 0.48 , 0.38 , 0.358])
        """
        chosen = None if outputs is None else named(outputs, (*_rows.MACHINE_STEADY, *STEADY_OUTPUTS))
        periods = whole_number("max_periods", max_periods)
        driven = self._driven(drive, start)
        ratios, starts = driven.ratios(), dict(zip(STATE, self._starts(driven)))
        asked = None if chosen is None else tuple(outputs_of(chosen, _rows.STEADY_SOURCES))
        at = Points(ratios.shape, {**ratios.given, **starts}, ratios.like)
        answer = _steady.of_points(at, without(asked), periods, driven.excitation)
        return _with_units(answer, MachineSteady, driven, _rows.MACHINE_STEADY, _rows.STEADY_SOURCES, chosen)

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
    ) -> MachinePhases: ...

    @overload
    def simulate(
        self,
        drive: Drive[Any],
        *,
        phase: float = 0.0,
        displacement: ArrayLike = 0.0,
        velocity: ArrayLike = 0.0,
        cycles: float = 1.0,
        samples: int,
    ) -> MachineSamples: ...

    def simulate(
        self,
        drive: Drive[Any],
        *,
        phase: float = 0.0,
        displacement: ArrayLike = 0.0,
        velocity: ArrayLike = 0.0,
        cycles: float = 1.0,
        samples: Optional[int] = None,
    ) -> Union[MachinePhases, MachineSamples]:
        """The exact motion from a start, in the machine's units; ``ratios`` has the same one in ratios. See `simulate`.

        The start is a phase of the drive (rad), a displacement and a velocity. Displacements are measured from
        ``mean_displacement``, the shift due to a mean force or to friction that depends on the direction.

        >>> import stickslip as ss
        >>> machine = ss.Machine(mass="50 kg", stiffness="1 kN/mm", friction="5 kN")
        >>> drive = ss.Drive(force="12 kN", angular_frequency="20 Hz")
        >>> found = machine.simulate(drive, displacement="1 mm", samples=2)
        >>> found.displacement.round(6), found.units["displacement"]
        (array([ 0.001   ,  0.008907, -0.018173]), 'm')
        """
        driven = self._driven(drive, (one("phase", phase, "angle"), displacement, velocity))
        point, starts = driven.ratios(), self._starts(driven)
        if point.shape is not None:
            at = Points(point.shape, {**point.given, **dict(zip(STATE, starts))}, point.like)
            return MachineSamples.of(samples_of(at, cycles, samples), driven)
        start: tuple[float, float, float] = tuple(map(float, starts))  # type: ignore[assignment]
        ratios: dict[str, Any] = dict(zip(RATIOS, point.columns))
        if samples is None:
            return MachinePhases.of(simulate(**ratios, start=start, cycles=cycles), driven)
        return MachineSamples.of(simulate(**ratios, start=start, cycles=cycles, samples=samples), driven)

    @staticmethod
    def _starts(driven: Driven) -> tuple[Any, Any, Any]:
        """The starts of motions in ratios."""
        given = driven.at.given
        scales = (1.0, driven.scale("length"), driven.scale("velocity"))
        starts = (given[name] / np.asarray(scale) if np.any(given[name]) else np.asarray(0.0) for name, scale in zip(STATE, scales))
        phase, x, v = starts
        return phase, x, v

    def attractors(
        self, drive: Drive[float], *, starts: Any = 1000, reach: Optional[float] = None, max_periods: int = 2000
    ) -> MachineAttractors:
        """All attractors that many starts lead to, in the machine's units; see `attractors`.

        Starts that are given, and the reach, are in the machine's units, too: a phase (rad), a displacement and a velocity.
        """
        driven = self._driven(drive)
        at = driven.ratios()
        if at.shape is not None:
            raise Error("attractors take one machine and a drive of one amplitude and one frequency")
        ratios: dict[str, Any] = dict(zip(RATIOS, at.columns))
        length, velocity = one("length", driven.scale("length")), one("velocity", driven.scale("velocity"))
        if isinstance(starts, Iterable) and not isinstance(starts, str):
            given = (three(start) for start in starts)
            starts = [
                (phase, self._value("displacement", x, "length") / length, self._value("velocity", v, "velocity") / velocity)
                for phase, x, v in given
            ]
        far = None if reach is None else self._value("reach", reach, "length") / length
        found = attractors(**ratios, starts=starts, reach=far, max_periods=max_periods)
        return MachineAttractors.of(found, driven, length, velocity)

    def basins(
        self,
        drive: Drive[float],
        *,
        displacement: ArrayLike,
        velocity: ArrayLike,
        phase: float = 0.0,
        max_periods: int = 2000,
    ) -> Basins:
        """The limit that each start of a plane leads to, with the axes and the limits in the machine's units; see `basins`.

        >>> import numpy as np, stickslip as ss
        >>> machine = ss.Machine(mass=2.0, stiffness=8.0, friction=4.0, damping_ratio=0.02, static_friction_ratio=1.3)
        >>> drive = ss.Drive(force=16.0, angular_frequency=1.0)
        >>> found = machine.basins(drive, displacement=np.linspace(-4, 4, 7), velocity=np.linspace(-4, 4, 5))
        >>> found.attractor.shape, sorted(round(limit.max_displacement, 3) for limit in found.attractors)
        ((5, 7), [2.593, 2.681])
        """
        axes = (self._values("displacement", displacement, "length"), self._values("velocity", velocity, "velocity"))
        x, v = (np.atleast_1d(numbers(name, axis)) for name, axis in zip(("displacement", "velocity"), axes))
        starts = [(phase, place, speed) for speed in v.reshape(-1) for place in x.reshape(-1)]
        if x.ndim != 1 or v.ndim != 1:
            raise Error("displacement, velocity: must be arrays of one dimension")
        # The numbers are in the machine's units already.
        own = self if self.units is None or vars(self)["_named"] else self.replace(units=self.units)
        found = own.attractors(drive, starts=starts, max_periods=max_periods)
        units = names_of(self.units, {"displacement": "length", "velocity": "velocity"})
        values = {"displacement": x, "velocity": v, "attractor": found.of_start.reshape(v.size, x.size), "attractors": found.attractors}
        return Basins.of(values, units)

    def decay(self, displacement: ArrayLike, velocity: ArrayLike = 0.0) -> MachineDecay[Any]:
        """Free vibration to rest, in the machine's units; ``ratios`` has the same one in ratios. See `decay`.

        The start is a displacement and a velocity of the machine, or arrays of them.

        >>> import stickslip as ss
        >>> machine = ss.Machine(mass="2 kg", stiffness="800 N/m", friction="3 N")
        >>> found = machine.decay("50 mm")
        >>> found.half_cycles, round(found.rest_position, 6), found.units["rest_position"]
        (7, 0.0025, 'm')
        """
        driven = self._driven(Drive(force=1.0, angular_frequency=1.0, units=self.units), (0.0, displacement, velocity))
        at, given = driven.at, driven.at.given
        without = np.asarray(self.friction) == 0
        if at.shape is None and without:
            raise Error("friction = 0: must be > 0, as a free vibration without friction does not end")
        time = 1.0 / np.sqrt(given["stiffness"] / given["mass"])
        length = np.asarray(driven.constant("length"))
        x = given[STATE[1]] / length
        ratios = (driven.constant("damping_ratio"), driven.constant("static_friction_ratio"))
        # A vibration without friction does not end.
        values = (np.where(without, np.nan, x), given[STATE[2]] * time / length, *map(np.asarray, ratios))
        names = ("displacement", "velocity", *RATIOS[2:])
        found = decay_of(Points(at.shape, dict(zip(names, values)), at.like))
        sizes = {"first_turn": ("length", length), "rest_position": ("length", length), "path": ("length", length), "rest_time": ("time", time)}
        scaled = {name: found._values[name] * size for name, (_, size) in sizes.items()}
        if at.shape is None:
            scaled = {name: float(value) for name, value in scaled.items()}
        units = names_of(self.units, {name: kind for name, (kind, _) in sizes.items()})
        return related(MachineDecay({"half_cycles": found._values["half_cycles"], **scaled}, units=units, like=at.like), found, driven)

    def follow(
        self,
        record: Record,
        *,
        displacement: ArrayLike = 0.0,
        velocity: ArrayLike = 0.0,
        mean_force: ArrayLike = 0.0,
    ) -> Followed[Any]:
        """The exact motion under a record and after it, until the body rests, in the machine's units.

        No stop is missed: between samples the load is a straight line, under which slides and stops are closed forms.
        With a record of a base acceleration, displacements and velocities are those in relation to the base.
        Displacements are from the position of the relaxed spring, also with a mean force. Several machines or starts are followed
        at once, on all cores.

        >>> import numpy as np, stickslip as ss
        >>> t = np.arange(0, 12, 0.01)
        >>> record = ss.Record(0.3 * np.exp(-(((t - 4) / 2) ** 2)) * np.sin(9 * t), time_step="10 ms", unit="g")
        >>> isolator = ss.Machine(mass="800 kg", period="2.5 s", friction_coefficient=0.06, damping_ratio="5%")
        >>> found = isolator.follow(record)
        >>> found.slides == found.stops + found.reversals, found.units["residual_displacement"]
        (True, 'm')
        >>> isolator.replace(friction_coefficient=[0.03, 0.06, 0.12]).follow(record).path.shape
        (3,)
        """
        return follow(self._sliding(mean_force), record, self._start(displacement, velocity))

    def motion(
        self,
        record: Record,
        *,
        displacement: Quantity = 0.0,
        velocity: Quantity = 0.0,
        mean_force: Quantity = 0.0,
        interval: Optional[Quantity] = None,
    ) -> Motion:
        """The states and events of the motion under a record, and its answers; see `follow`.

        The states are at most ``interval`` seconds apart; by default the longest step of the record.
        """
        start = self._start(displacement, velocity)
        return motion(self._sliding(mean_force), record, start, interval)

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
        return polarities(self._sliding(mean_force), record, start)

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
        return floor_spectrum(self._sliding(mean_force), record, start, period, damping_ratio)

    def system(
        self,
        load: Union[Drive[Any], Record],
        *,
        displacement: Quantity = 0.0,
        velocity: Quantity = 0.0,
        mean_force: Quantity = 0.0,
    ) -> System:
        """This body as a `System`, under a drive or under a record that repeats itself; its ``steady`` has the drift of a body
        without a spring. Half the difference of frictions by direction is a constant force there.

        A machine on skids with an unbalance, on a floor that falls by 1 %, in millimetres an hour:

        >>> import stickslip as ss
        >>> skids = ss.Machine(mass="300 kg", stiffness="0 N/mm", friction_coefficient=0.15, units="N,mm")
        >>> drive = ss.Drive(unbalance="0.04 kg*m", frequency="25 Hz", mean_force="29.4 N")
        >>> walk = skids.system(drive).steady()
        >>> round(float(walk.mean_velocity[0]) * 3600, 1)
        5600.7
        """
        from ._one_body import one_body

        return one_body(self._sliding(mean_force), load, self._start(displacement, velocity), vars(self)["_own"])

    def _start(self, displacement: ArrayLike, velocity: ArrayLike) -> tuple[Any, Any]:
        return self._values("displacement", displacement, "length"), self._values("velocity", velocity, "velocity")

    def _sliding(self, mean_force: ArrayLike) -> Sliding:
        own = vars(self)["_own"]
        names = ("mass", "stiffness", "damping", "friction", "friction_backward", "static_friction_ratio")
        values = {**{name: own[name] for name in names}, "mean_force": self._values("mean_force", mean_force, "force")}
        return Sliding(values, False, self.units, vars(self)["_named"], vars(self)["_failed"])

    @overload
    def border(
        self: "Machine[float]", *, frequency: Optional[Quantity] = None, angular_frequency: Optional[Quantity] = None
    ) -> Border[float]: ...

    @overload
    def border(
        self: "Machine[Any]", *, frequency: Optional[ArrayLike] = None, angular_frequency: Optional[ArrayLike] = None
    ) -> Border[Floats]: ...

    def border(
        self, *, frequency: Optional[ArrayLike] = None, angular_frequency: Optional[ArrayLike] = None
    ) -> Border[Any]:
        """The border at a frequency, in ratios; `min_force` gives it as a force.

        >>> import stickslip as ss
        >>> machine = ss.Machine(mass="800 kg", period="2.2 s", friction_coefficient=0.05)
        >>> round(machine.border(frequency="2 Hz").min_force_ratio, 4)
        1.8225
        """
        given: dict[str, Any] = {"frequency": frequency, "angular_frequency": angular_frequency}
        # The border does not depend on the force, so any value serves.
        drive: Drive[Any] = Drive(force=1.0, units=self.units, **given)
        return _closed_forms.border_of(self._driven(drive).ratios())

    @overload
    def min_force(
        self: "Machine[float]",
        *,
        frequency: Optional[Quantity] = None,
        angular_frequency: Optional[Quantity] = None,
        excitation: str = "force",
    ) -> float: ...

    @overload
    def min_force(
        self: "Machine[Any]",
        *,
        frequency: Optional[ArrayLike] = None,
        angular_frequency: Optional[ArrayLike] = None,
        excitation: str = "force",
    ) -> Floats: ...

    def min_force(
        self,
        *,
        frequency: Optional[ArrayLike] = None,
        angular_frequency: Optional[ArrayLike] = None,
        excitation: str = "force",
    ) -> Any:
        """The minimum amplitude of an excitation at which the cycle without a stop exists, at a frequency or several.

        With one friction the body then never sticks. With a static friction above the kinetic one the cycle attracts
        its neighbourhood, and a body at rest is released only by a force above the static friction.

        The excitation is the force, or another amplitude by its name in `Drive`.

        >>> import stickslip as ss
        >>> machine = ss.Machine(mass="800 kg", period="2.2 s", friction_coefficient=0.05)
        >>> machine.min_force(frequency=[1.0, 2.0]).round(2)
        array([669.95, 714.91])
        """
        given = {"amplitude": 1.0, "angular_frequency": angular_of(frequency, angular_frequency)}
        return self._design("min_amplitude", excitation, given)[0]

    def max_friction(self, drive: Drive[Any]) -> Any:
        """The maximum friction force with which the cycle without a stop exists under a drive; see `min_force`.

        >>> import stickslip as ss
        >>> machine = ss.Machine(mass="800 kg", period="2.2 s", friction_coefficient=0.05)
        >>> round(machine.max_friction(ss.Drive(force="900 N", frequency="2 Hz")), 2)
        493.82
        """
        return self._designed("max_friction", drive)[0]

    def best_friction(self, drive: Drive[Any], *, sticking: bool = False) -> "BestFriction":
        """The friction force that dissipates most under a drive: among those at which the body does not stick, or of all, stops
        included.

        >>> import stickslip as ss
        >>> machine = ss.Machine(mass="800 kg", period="2.2 s", friction_coefficient=0.05)
        >>> best = machine.best_friction(ss.Drive(force="900 N", frequency="0.2 Hz"), sticking=True)
        >>> best.optimum, round(best.friction, 1)
        ('sticking', 679.1)
        """
        from ._design import BestFriction

        friction, energy, _, optimum = self._designed("best_friction_of_all" if sticking else "best_friction", drive)
        return BestFriction(friction, energy, optimum)

    def best_stiffness(self, drive: Drive[float], *, stiffness: tuple[Quantity, Quantity]) -> "BestStiffness":
        """The stiffness in a range that dissipates most under a drive, among those with which the body does not stick.

        >>> import stickslip as ss
        >>> machine = ss.Machine(mass=50.0, stiffness=1000.0, friction=5.0)
        >>> best = machine.best_stiffness(ss.Drive(force=12.0, frequency=1.0), stiffness=(500.0, 1500.0))
        >>> best.energy > machine.steady(ss.Drive(force=12.0, frequency=1.0)).energy_out
        True
        """
        from ._design import BestStiffness

        ends = [self._value("stiffness", end, "stiffness") for end in stiffness]
        return BestStiffness(*_native.best_stiffness(self._body, *self._single(drive), ends[0], ends[1]))

    def frictions_for_displacement(self, max_displacement: Quantity, drive: Drive[float]) -> "list[TargetFriction]":
        """The friction forces with which the steady motion under a drive has a given peak displacement, stops included; none
        where no friction gives it.

        >>> import stickslip as ss
        >>> machine = ss.Machine(mass=50.0, stiffness=1000.0, friction=1.0)
        >>> [(round(found.friction, 3), found.regime) for found in machine.frictions_for_displacement(0.01, ss.Drive(force=12.0, angular_frequency=6.0))]
        [(6.342, 'non-sticking')]
        """
        from ._design import TargetFriction

        target = self._value("max_displacement", max_displacement, "length")
        return [TargetFriction(*found) for found in _native.frictions_for_displacement(self._body, *self._single(drive), target)]

    def hold(self, drive: Drive[Any], *, angular: bool = False) -> Any:
        """The frequency up to which friction holds the body at rest under the amplitude of a drive, in hertz or in radians per second:
        infinite where it does at every frequency, 0 where it does at none.

        >>> import stickslip as ss
        >>> machine = ss.Machine(mass=20.0, stiffness=2e4, friction=80.0)
        >>> machine.hold(ss.Drive(base_displacement=0.01, frequency=1.0), angular=True)
        20.0
        """
        found = self._designed("hold", drive)[0]
        return found if angular else found / (2 * np.pi)

    def best_friction_over(
        self,
        drive: Drive[float],
        *,
        frequency: Optional[tuple[Quantity, Quantity]] = None,
        angular_frequency: Optional[tuple[Quantity, Quantity]] = None,
        of: str = "absolute-displacement",
    ) -> "BandFriction":
        """The friction force whose greatest amplitude between two frequencies is least, stops included.

        The friction of this machine and the frequency of the drive play no part. The amplitude is ``"displacement"``,
        ``"absolute-displacement"``, ``"transmitted-force"`` or ``"acceleration"`` (in space).

        >>> import stickslip as ss
        >>> machine = ss.Machine(mass="800 kg", period="2.2 s", friction="1 N", damping_ratio=0.05)
        >>> drive = ss.Drive(base_displacement="50 mm", frequency="1 Hz")
        >>> best = machine.best_friction_over(drive, frequency=(0.2, 2.0))
        >>> round(best.friction, 2), round(best.greatest, 9), best.optimum
        (320.69, 0.05, 'interior')
        >>> best.up_to >= best.rest_friction  # the optimum is flat: every greater friction is as good
        True
        """
        from ._design import BandFriction

        kind, amplitude, _ = self._single(drive)
        ends, unit = _range(frequency, angular_frequency)
        friction, greatest, at, optimum, rest, up_to = _native.best_friction_over(self._body, kind, amplitude, *ends, of)
        return BandFriction(friction, greatest, [(low / unit, high / unit) for low, high in at], optimum, rest, up_to)

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
        units = self.units if vars(self)["_named"] and not any(isinstance(x, str) for x in amplitudes) else None
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
        max_displacement: ArrayLike,
        *,
        frequency: Optional[ArrayLike] = None,
        angular_frequency: Optional[ArrayLike] = None,
    ) -> Any:
        """The force amplitude at which the cycle has a given peak displacement, at a frequency.

        >>> import stickslip as ss
        >>> machine = ss.Machine(mass="800 kg", period="2.2 s", friction_coefficient=0.05)
        >>> round(machine.force_for_displacement("10 mm", frequency="1.7 Hz"), 2)
        1043.21
        """
        target = self._values("max_displacement", max_displacement, "length")
        given = {"amplitude": target, "angular_frequency": angular_of(frequency, angular_frequency)}
        return self._design("force_for_displacement", "force", given)[0]

    def force_for_velocity(
        self,
        max_velocity: ArrayLike,
        *,
        frequency: Optional[ArrayLike] = None,
        angular_frequency: Optional[ArrayLike] = None,
    ) -> Any:
        """The force amplitude at which the cycle has a given peak velocity, at a frequency; as `force_for_displacement`."""
        target = self._values("max_velocity", max_velocity, "velocity")
        given = {"amplitude": target, "angular_frequency": angular_of(frequency, angular_frequency)}
        return self._design("force_for_velocity", "force", given)[0]

    def _designed(self, question: str, drive: Drive[Any]) -> tuple[Any, Any, Any, Any]:
        of_type("drive", drive, Drive)
        given = drive._in(self.units, vars(self)["_named"])
        return self._design(question, drive.excitation, {name: given[name] for name in ("amplitude", "angular_frequency")})

    def _design(self, question: str, excitation: str, given: Mapping[str, Any]) -> tuple[Any, Any, Any, Any]:
        """The answers to a question of design, for each machine, amplitude and frequency."""
        own = vars(self)["_own"]
        at = points(**given, **{name: own[name] for name in OF_BODY})
        target, frequency, *body = at.columns
        size, many = (1, False) if at.shape is None else (at.size, True)
        columns, words = _native.design_each(question, body, excitation, target, frequency, size, many)
        if at.shape is None:
            first, second, third = (float(column[0]) for column in columns)
            return first, second, third, _OPTIMA[int(words[0])]
        shape, like = at.shape, at.like
        dressed = [column.reshape(shape) for column in (*columns, np.asarray(_OPTIMA)[np.minimum(words, 3)])]
        if like is not None:
            dressed = [like.dressed(question, column, {}) for column in dressed]
        return dressed[0], dressed[1], dressed[2], dressed[3]

    def _value(self, name: str, value: Quantity, kind: str) -> float:
        """A value as a number in the machine's system of units, to which bare numbers belong."""
        return one_value(name, value, kind, self.units, vars(self)["_named"])

    def _values(self, name: str, value: ArrayLike, kind: str) -> Any:
        """The same for an array of numbers."""
        return values_of(name, value, kind, self.units, vars(self)["_named"])

    def _driven(self, drive: Drive[Any], start: Any = None) -> Driven:
        of_type("drive", drive, Drive)
        own = vars(self)["_own"]
        given = drive._in(self.units, vars(self)["_named"])
        if start is not None:
            phase, x, v = three(start)
            values = (phase, self._values(STATE[1], x, "length"), self._values(STATE[2], v, "velocity"))
            given |= dict(zip(STATE, values))
        return Driven.by(own, given, drive.excitation, self.units)._replace(is_in_hertz="frequency" in vars(drive)["_keywords"])

    def _single(self, drive: Drive[Any]) -> tuple[str, float, float]:
        of_type("drive", drive, Drive)
        given = drive._in(self.units, vars(self)["_named"])
        if any(is_array(given[name]) for name in ("amplitude", "angular_frequency")):
            raise Error("this design takes a drive of one amplitude and one frequency")
        return drive.excitation, float(given["amplitude"]), float(given["angular_frequency"])


#: Kinds of an optimum, by the numbers of the compiled part; the last is for a place without an answer.
_OPTIMA = ("interior", "border", "sticking", "invalid")


def _bodies(given: Mapping[str, Any], units: Optional[str]) -> tuple[dict[str, Any], dict[int, str], Optional[str]]:
    """The values of one body or several by name, with the damping ratio if it was given, the places that have none with the reasons,
    and their system of units."""
    # A bare frequency is in hertz here, and an angular one in the library.
    natural = given.get("natural_frequency")
    if natural is not None and not has_unit("natural_frequency", natural):
        given = {**given, "natural_frequency": angular("natural_frequency", natural, 2 * np.pi)}
    parts = {name: parted(name, value) for name, value in given.items() if is_array(value)}
    if not parts:
        body, ratio, system = _native.machine(texts(given), units)
        return {**dict(zip(OF_BODY, body)), "damping_ratio": ratio}, {}, system
    numbered, like = aligned({name: in_system(name, *part, INPUTS[name], units) for name, part in parts.items()})
    shape = shape_of(numbered)
    # One of its numbers stands for an array when units are checked.
    single = {name: stand_in(parts[name][1], _any_of(numbered[name])) if name in numbered else value for name, value in given.items()}
    columns = [(name, np.ascontiguousarray(np.broadcast_to(array, shape)).reshape(-1)) for name, array in numbered.items()]
    # In parts, because all values of all bodies would take several times the memory of those that vary.
    joined, failed = Joined(int(np.prod(shape))), dict[int, str]()
    for part in blocks(joined.n):
        cut = [(name, column[part]) for name, column in columns]
        found, reasons, system = _native.machines(texts(single), cut, part.stop - part.start, units)
        joined.put(part, found)
        failed.update((part.start + place, reason) for place, reason in reasons)
    own = {}
    for name, column in joined.columns.items():
        array = read_only(column).reshape(shape)
        own[name] = like.dressed(name, array, {}) if like is not None else array
    if "friction_backward" not in given:
        own["friction_backward"] = float("nan")
    return own, failed, system


def _any_of(array: Floats) -> float:
    usable = (array > 0) & (array < np.inf)
    return float(array.flat[np.argmax(usable)]) if usable.any() else 1.0


def without(asked: Optional[tuple[str, ...]]) -> Optional[tuple[str, ...]]:
    """The chosen outputs but for the ratios, which every answer has."""
    return None if asked is None else tuple(name for name in asked if name not in RATIOS)


def _one_frequency(frequency: Optional[Quantity], angular_frequency: Optional[Quantity]) -> float:
    """One frequency in radians per second."""
    if frequency is not None:
        return one("frequency", angular("frequency", frequency, 2 * np.pi))
    return one("angular_frequency", angular("angular_frequency", angular_frequency, 1.0))


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


def _with_units(
    answer: Result,
    kind: type[_R],
    driven: Driven,
    rows: Mapping[str, tuple[str, str]],
    sources: Mapping[str, str],
    chosen: Optional[tuple[str, ...]],
) -> _R:
    """The answer with its values in the machine's units."""
    here = driven.names(rows, sources)
    if chosen is not None:
        by_output = {output: name for name, output in reversed(list(sources.items()))}
        asked = [name if name in rows else by_output[name] for name in chosen]
        # The name of an output stands for all its values.
        values = [name for name in here if name in _rows.DRIVE_ROWS or name in asked or sources[name] in chosen and name in here]
        here = [*values, *RATIOS]
    elif driven.at.shape is not None:
        here = [name for name in here if name != "multipliers"]
    kinds = {name: of for name, (of, _) in rows.items() if of not in ("", "1", "rad", "2π/ω_d")}
    units = names_of(driven.units, kinds)
    if units is not None:
        units |= {name: "rad" for name, (of, _) in rows.items() if of == "rad"}
    found = kind({}, Scaled(answer, driven, sources), units=units, chosen=dict.fromkeys(here), like=answer._like)
    return related(found, answer, driven)
