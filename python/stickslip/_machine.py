"""Machines in physical units: SI, or any consistent system."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Iterable, Mapping, Optional

import numpy as np
from numpy.typing import ArrayLike

from . import _native
from ._closed_forms import Border, Response, border, response
from ._motion import _REST, Start, Steady, steady
from ._result import Physical, Result, broadcast

if TYPE_CHECKING:
    from ._design import Band, BestFriction

_EXCITATIONS = (
    "force",
    "foot_displacement",
    "damped_foot_displacement",
    "base_displacement",
    "base_velocity",
    "base_acceleration",
)
_STANDARD_GRAVITY = 9.80665
#: Names of values in physical units, where they are not those in ratios. Both loop sizes are one energy.
_PHYSICAL = {
    "min_force_ratio": "min_force",
    "min_force_ratio_turning_point": "min_force_turning_point",
    "loop_size_stiffness": "energy_per_cycle",
    "best_force_ratio": "best_force",
    "best_loop_size": "best_force_energy",
    "damper_work": "damper_energy_per_cycle",
    "periods": "followed_for",
}
#: Scales of what `steady` gives, beside those of `response`.
_OF_STEADY = {
    "min_displacement": "length",
    "rest_position": "length",
    "distance": "length",
    "min_velocity": "velocity",
    "energy_in": "work",
    "energy_out": "work",
    "damper_work": "work",
    "periods": "period",
}


@dataclass(frozen=True, init=False)
class Drive:
    """A harmonic drive: one amplitude and an angular frequency, numbers or arrays.

    Parameters
    ----------
    force : float or array
        Amplitude of a force on the body.
    foot_displacement : float or array
        Amplitude of a motion of the spring's foot, over a surface that stays.
    damped_foot_displacement : float or array
        The same with the damper standing on the moving foot.
    base_displacement, base_velocity, base_acceleration : float or array
        Amplitude of a motion of the base that carries the surface along, as under an isolator. The
        displacement of the answer is that of the body relative to the base.
    angular_frequency : float or array
        In radians per second: ``2*pi`` times the frequency in hertz.
    mean_force : float
        A constant force beside the harmonic one; it shifts the motion.

    Examples
    --------
    >>> import stickslip as ss
    >>> ss.Drive(force=12.0, angular_frequency=6.28)
    Drive(excitation='force', amplitude=12.0, angular_frequency=6.28, mean_force=0.0)
    """

    excitation: str
    amplitude: ArrayLike
    angular_frequency: ArrayLike
    mean_force: float

    def __init__(
        self,
        *,
        angular_frequency: ArrayLike,
        force: Optional[ArrayLike] = None,
        foot_displacement: Optional[ArrayLike] = None,
        damped_foot_displacement: Optional[ArrayLike] = None,
        base_displacement: Optional[ArrayLike] = None,
        base_velocity: Optional[ArrayLike] = None,
        base_acceleration: Optional[ArrayLike] = None,
        mean_force: float = 0.0,
    ) -> None:
        given = dict(
            zip(
                _EXCITATIONS,
                (force, foot_displacement, damped_foot_displacement, base_displacement, base_velocity, base_acceleration),
            )
        )
        chosen = [(name, value) for name, value in given.items() if value is not None]
        if len(chosen) != 1:
            raise _native.Error(f"give one of {', '.join(_EXCITATIONS)}; {len(chosen)} are given")
        object.__setattr__(self, "excitation", chosen[0][0])
        object.__setattr__(self, "amplitude", chosen[0][1])
        object.__setattr__(self, "angular_frequency", angular_frequency)
        object.__setattr__(self, "mean_force", float(mean_force))


@dataclass(frozen=True)
class Machine:
    """A body on its spring and friction surface, in consistent units.

    Parameters
    ----------
    mass, stiffness, friction : float
        Mass, stiffness of the spring, and friction bound (the greatest force of friction).
    friction_backward : float, optional
        Friction bound against motion backward, where it differs from that forward.
    damping : float
        Constant of a viscous damper, >= 0.

    Examples
    --------
    The machine of the source paper, 50 t on 1000 kN/m, friction 5 kN, under 12 kN at 1 Hz:

    >>> import math, stickslip as ss
    >>> machine = ss.Machine(mass=50.0, stiffness=1000.0, friction=5.0)
    >>> answer = machine.response(ss.Drive(force=12.0, angular_frequency=2 * math.pi))
    >>> answer.regime, round(answer.physical.max_displacement, 9)
    ('non-sticking', 0.009914465)
    """

    mass: float
    stiffness: float
    friction: float
    friction_backward: Optional[float] = None
    damping: float = 0.0

    def __post_init__(self) -> None:
        # Its messages for bad values.
        _native.machine_columns(self._body, "force", np.ones(0), np.ones(0), 0.0)

    @classmethod
    def of_period(
        cls,
        *,
        mass: float,
        period: float,
        friction: Optional[float] = None,
        friction_coefficient: Optional[float] = None,
        gravity: float = _STANDARD_GRAVITY,
        damping_ratio: float = 0.0,
    ) -> "Machine":
        """A machine from its natural period, and from a friction coefficient instead of a friction bound.

        ``k = m (2 pi/period)**2``, ``friction = friction_coefficient * mass * gravity``.

        >>> import stickslip as ss
        >>> ss.Machine.of_period(mass=800, period=2.2, friction_coefficient=0.05)
        Machine(mass=800.0, stiffness=6525.3..., friction=392.2..., friction_backward=None, damping=0.0)
        """
        if (friction is None) == (friction_coefficient is None):
            raise _native.Error("give one of friction and friction_coefficient")
        if not (np.isfinite(period) and period > 0):
            raise _native.Error(f"period = {period} must be > 0 and finite")
        bound = friction if friction is not None else float(friction_coefficient or 0.0) * mass * gravity
        stiffness = mass * (2 * np.pi / period) ** 2
        return cls(float(mass), float(stiffness), float(bound)).with_damping_ratio(damping_ratio)

    def with_damping_ratio(self, damping_ratio: float) -> "Machine":
        """The same machine with a damper of a damping ratio: ``c = 2 damping_ratio sqrt(k m)``."""
        constant = _native.damping_constant(self.mass, self.stiffness, self.friction, damping_ratio)
        return Machine(self.mass, self.stiffness, self.friction, self.friction_backward, constant)

    @property
    def natural_frequency(self) -> float:
        """Natural angular frequency ``sqrt(k/m)``, in radians per second."""
        return float(np.sqrt(self.stiffness / self.mass))

    @property
    def _body(self) -> tuple[float, float, float, float, float]:
        backward = float("nan") if self.friction_backward is None else float(self.friction_backward)
        return (float(self.mass), float(self.stiffness), float(self.friction), backward, float(self.damping))

    def response(self, drive: Drive, *, outputs: Optional[Iterable[str]] = None) -> Response:
        """The answer in closed form, in ratios and, as ``physical``, in the units of the machine; see `response`."""
        ratios, scales = self._ratios(drive)
        answer = response(ratios["omega"], ratios["alpha"], ratios["damping_ratio"], outputs=outputs)
        answer = _felt_around(answer, drive, ratios)
        physical = _in_units(answer, drive, ratios, scales)
        if "best_force_energy" in physical:
            # The loop at the best force, not at this one.
            best = physical["best_force"] / physical["force_amplitude"]
            physical["best_force_energy"] = physical["best_force_energy"] * best**2
        return Response({**answer.to_dict(), "physical": Physical(physical)})

    def steady(self, drive: Drive, *, start: Start = _REST, max_periods: int = _native.MAX_PERIODS) -> Steady:
        """The motion in the long run, in ratios and, as ``physical``, in the units of the machine; see `steady`.

        The start is in radians, B and B w.
        """
        ratios, scales = self._ratios(drive)
        answer = steady(
            ratios["omega"], ratios["alpha"], ratios["damping_ratio"], start=start, max_periods=max_periods
        )
        return Steady({**answer.to_dict(), "physical": Physical(_in_units(answer, drive, ratios, scales))})

    def border(self, angular_frequency: ArrayLike) -> Border:
        """The border at an angular frequency, in ratios; `least_force` is the same in units of force."""
        drive = Drive(force=self.friction, angular_frequency=angular_frequency)
        ratios, _ = self._ratios(drive)
        return border(ratios["omega"], ratios["damping_ratio"])

    def least_force(self, angular_frequency: float, excitation: str = "force") -> float:
        """The least amplitude with which the body does not stick, of a force or of another excitation by its name in `Drive`."""
        return _native.least_amplitude(self._body, excitation, float(angular_frequency))

    def greatest_friction(self, drive: Drive) -> float:
        """The greatest friction bound with which the body does not stick under a drive."""
        return _native.greatest_friction(self._body, *_single(drive))

    def best_friction(self, drive: Drive) -> "BestFriction":
        """The friction bound with which friction dissipates most under a drive, of those that do not stick."""
        from ._design import BestFriction

        friction, energy, optimum = _native.best_friction(self._body, *_single(drive))
        return BestFriction(friction, energy, optimum)

    def bands(self, low: float, high: float, *, force: Optional[float] = None, foot_displacement: Optional[float] = None) -> "list[Band]":
        """The bands of angular frequency between two ends in which the body does not stick, all there are."""
        from ._design import Band

        drive = Drive(force=force, foot_displacement=foot_displacement, angular_frequency=1.0)
        kind, amplitude, _ = _single(drive)
        return [Band(*band) for band in _native.bands(self._body, kind, amplitude, float(low), float(high))]

    def force_for_displacement(self, angular_frequency: float, max_displacement: float) -> float:
        """The force amplitude with which the cycle has a maximum displacement."""
        return _native.force_for(self._body, float(angular_frequency), float(max_displacement), False)

    def force_for_velocity(self, angular_frequency: float, max_velocity: float) -> float:
        """The force amplitude with which the cycle has a maximum velocity."""
        return _native.force_for(self._body, float(angular_frequency), float(max_velocity), True)

    def _ratios(self, drive: Drive) -> tuple[dict[str, Any], dict[str, Any]]:
        shape, (amplitude, frequency) = broadcast(drive.amplitude, drive.angular_frequency)
        columns = _native.machine_columns(self._body, drive.excitation, amplitude, frequency, drive.mean_force)
        of_shape = {
            name: column.item() if shape is None else column.reshape(shape) for name, column in columns.items()
        }
        ratios = {name: of_shape.pop(name) for name in ("omega", "alpha", "damping_ratio")}
        return ratios, of_shape


def _single(drive: Drive) -> tuple[str, float, float]:
    shape, (amplitude, frequency) = broadcast(drive.amplitude, drive.angular_frequency)
    if shape is not None:
        raise _native.Error("a design takes a drive of one amplitude and one frequency")
    return drive.excitation, amplitude.item(), frequency.item()


def _felt_around(answer: Response, drive: Drive, ratios: Mapping[str, Any]) -> Response:
    """The answer with what foot and surface together feel where the foot moves: ``m x''`` and the ratio of accelerations."""
    found = answer.to_dict()
    if "foot" not in drive.excitation or found.get("max_acceleration") is None:
        return answer
    force = found["max_acceleration"] * ratios["omega"] ** 2
    ratio = found["max_acceleration"] / ratios["alpha"]
    for name, value in (("transmitted_force", force), ("transmissibility", ratio)):
        if name in found:
            found[name] = value
    return Response(found)


def _in_units(answer: Result, drive: Drive, ratios: Mapping[str, Any], scales: Mapping[str, Any]) -> dict[str, Any]:
    """The values of an answer that have units, by their physical names, and those of the drive."""
    turn = 2 * np.pi * scales["time"]
    sizes = {**scales, "work": scales["force"] * scales["length"], "period": turn}
    units = {**dict(_native.UNITS), **_OF_STEADY, "loop_size_inertia": ""}
    if not drive.excitation.startswith("base_"):
        units["max_absolute_displacement"] = ""
    physical = {
        "angular_frequency": 1.0 / scales["time"],
        "force_amplitude": ratios["alpha"] * scales["force"],
        "friction_displacement": scales["length"],
        "mean_displacement": scales["mean_displacement"],
    }
    for name, value in answer.to_dict().items():
        unit = "time" if name.endswith("_phase") else units.get(name, "")
        if value is None or not unit:
            continue
        physical[_PHYSICAL.get(name, name.replace("_phase", "_time"))] = value * sizes[unit]
    return physical
