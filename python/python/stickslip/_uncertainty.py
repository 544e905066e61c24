"""Uncertain machines: Monte-Carlo, and sensitivities to every value."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, NamedTuple, Optional, Union

import numpy as np

from ._design import Estimate
from ._drive import EXCITATIONS, Drive, is_array
from ._labels import WrongType, numbers
from ._machine import Machine
from ._native import Error
from ._record import Record
from ._result import Floats, of_number, of_type, whole_number

#: How a value is distributed: the relative standard deviation of a normal distribution, the ends of a uniform one, a function of
#: a generator and a number of draws, a distribution of SciPy, or draws.
Distribution = Union[float, tuple[float, float], Callable[[np.random.Generator, int], Any], Any]
#: The values of a machine that can be varied.
_OF_MACHINE = ("mass", "stiffness", "friction", "friction_backward", "damping", "damping_ratio", "static_friction_ratio")
_OF_LOAD = ("amplitude", "frequency", "angular_frequency", "mean_force")
#: 97.5 % of a normal distribution lie below this.
_QUANTILE = 1.959963984540054


class MonteCarlo(NamedTuple):
    """The answers of many machines drawn at random; see `monte_carlo`."""

    #: The drawn values, by name.
    drawn: Mapping[str, Floats]
    #: The answer of every draw, as an array for each value.
    answer: Any

    def _values(self, name: str) -> Floats:
        values: Floats = np.asarray(self.answer[name], dtype=np.float64)
        values = values[~np.isnan(values)]
        if not values.size:
            raise Error(f"{name}: no draw has it")
        return values

    def quantile(self, name: str, share: float) -> float:
        """The value that this share of the draws does not exceed, among those that have it."""
        if not 0 <= of_number("share", share) <= 1:
            raise Error(f"share = {share}: must be >= 0 and <= 1")
        return float(np.quantile(self._values(name), share))

    def interval(self, name: str, share: float = 0.95) -> tuple[float, float]:
        """The middle interval that holds this share of the draws."""
        if not 0 < of_number("share", share) < 1:
            raise Error(f"share = {share}: must be > 0 and < 1")
        return self.quantile(name, (1 - share) / 2), self.quantile(name, (1 + share) / 2)

    def mean(self, name: str) -> Estimate:
        """The mean of the draws that have a value, with its standard error and 95 % interval."""
        values = self._values(name)
        error = float(np.std(values, ddof=1) / math.sqrt(values.size)) if values.size > 1 else math.inf
        mean = float(np.mean(values))
        return Estimate(mean, error, (mean - _QUANTILE * error, mean + _QUANTILE * error))

    def probability(self, is_met: Any) -> Estimate:
        """The probability of a regime by its name, or of a condition as an array of flags, with Wilson's 95 % interval.

        >>> import stickslip as ss
        >>> machine = ss.Machine(mass=50, stiffness=1000, friction=5)
        >>> found = ss.monte_carlo(machine, ss.Drive(force=12, frequency=1), {"friction": 0.3}, draws=2000, seed=7)
        >>> found.probability("sticking").value == found.probability(found.answer.regime == "sticking").value
        True
        """
        flags = np.asarray(self.answer.regime == is_met if isinstance(is_met, str) else is_met, dtype=bool)
        n, share, z2 = flags.size, float(np.mean(flags)), _QUANTILE**2
        middle = (share + z2 / (2 * n)) / (1 + z2 / n)
        half = _QUANTILE / (1 + z2 / n) * math.sqrt(share * (1 - share) / n + z2 / (4 * n * n))
        return Estimate(share, math.sqrt(share * (1 - share) / n), (max(0.0, middle - half), min(1.0, middle + half)))


class Sensitivity(NamedTuple):
    """How an output changes with a value; see `sensitivities`."""

    #: The derivative, in the unit of the output over that of the value.
    derivative: float
    #: Percent of change per percent of the value.
    elasticity: float
    #: Estimated error of the elasticity.
    error: float


def monte_carlo(
    machine: Machine[float],
    load: Union[Drive[float], Record],
    vary: Mapping[str, Distribution],
    *,
    draws: int = 10_000,
    seed: Union[int, np.random.Generator],
    exact: bool = True,
    outputs: Optional[Iterable[str]] = None,
) -> MonteCarlo:
    """The answers of machines whose values are drawn at random, all at once and on all cores.

    Parameters
    ----------
    machine : Machine
    load : Drive or Record
    vary : dict
        The values to vary, by their names: those of a machine (``mass``, ``stiffness``, ``friction``, ``damping_ratio``, …) and of
        a drive (``amplitude``, ``frequency``, ``mean_force``). Each by the relative standard deviation of a normal distribution
        about it, the ends (low, high) of a uniform one, a function of a generator and a number of draws, a distribution of
        ``scipy.stats``, or an array of draws. Numbers are in the units of the machine, frequencies in hertz.
    draws : int
    seed : int or numpy.random.Generator
        The same seed gives the same draws.
    exact : bool
        Whether the exact motion under a drive is followed, stops included; otherwise the closed forms are evaluated.
    outputs : names, optional
        As of `Machine.steady` or `Machine.response`.

    Returns
    -------
    MonteCarlo
        With quantiles, intervals, means and probabilities. A draw outside the domain has NaN.

    Examples
    --------
    >>> import stickslip as ss
    >>> machine = ss.Machine(mass="800 kg", period="2.2 s", friction_coefficient=0.05, units="N,mm")
    >>> floor = ss.Drive(base_acceleration="0.15 g", frequency="2 Hz")
    >>> found = ss.monte_carlo(machine, floor, {"friction": 0.1, "frequency": (1.8, 2.2)}, draws=1000, seed=1)
    >>> low, high = found.interval("max_displacement", 0.9)
    >>> bool(low < machine.steady(floor).max_displacement < high)
    True
    """
    of_type("machine", machine, Machine)
    n = whole_number("draws", draws)
    random = np.random.default_rng(seed)
    drawn = {name: _draws(name, of, _value(machine, load, name), random, n) for name, of in vary.items()}
    return MonteCarlo(drawn, _answered(machine, load, drawn, exact, outputs))


def sensitivities(
    machine: Machine[float],
    load: Union[Drive[float], Record],
    of: str,
    *,
    by: Optional[Sequence[str]] = None,
    exact: bool = True,
) -> dict[str, Sensitivity]:
    """How an output changes with each value of a machine and its load: derivatives by differences, extrapolated to a step of
    zero, with their errors. All machines of the differences are computed at once.

    The accuracy is some 1e-10 where the output is smooth; at a border of sticking, where it has a corner, the error is large.

    Parameters
    ----------
    machine : Machine
    load : Drive or Record
    of : str
        The output, such as ``"max_displacement"``.
    by : list of str, optional
        The values, as of `monte_carlo`: by default all that are not zero.
    exact : bool
        As of `monte_carlo`.

    Examples
    --------
    One percent more mass gives 2.08 percent less displacement:

    >>> import stickslip as ss
    >>> machine = ss.Machine(mass=50, stiffness=1000, friction=5)
    >>> found = ss.sensitivities(machine, ss.Drive(force=12, frequency=1), "max_displacement", exact=False)
    >>> round(found["mass"].elasticity, 6), round(found["friction"].elasticity, 4)
    (-2.084325, -0.5445)
    """
    of_type("machine", machine, Machine)
    loads = (*_OF_LOAD[:2], "mean_force") if isinstance(load, Drive) else ()
    names = list(by) if by is not None else [name for name in (*_OF_MACHINE[:3], "damping", "static_friction_ratio", *loads)]
    at = {name: _value(machine, load, name) for name in names}
    if by is None:
        at = {name: value for name, value in at.items() if value != 0 and not (name == "static_friction_ratio" and value == 1)}
    for name, value in at.items():
        if value == 0:
            raise Error(f"{name} = 0: a relative step needs another value")
    steps: Floats = np.exp2(-np.arange(7.0, 15.0))
    factors = np.concatenate([1 + steps, 1 - steps])
    size = factors.size
    drawn = {}
    for place, (name, value) in enumerate(at.items()):
        column = np.full(size * len(at), value)
        column[place * size : (place + 1) * size] *= factors
        drawn[name] = column
    values = np.asarray(_answered(machine, load, drawn, exact, None)[of], dtype=float).reshape(len(at), 2, steps.size)
    here = float(np.asarray(_answered(machine, load, {}, exact, None)[of]))
    found = {}
    for (name, value), (above, below) in zip(at.items(), values):
        slope, error = _extrapolated((above - below) / (2 * steps), steps)
        found[name] = Sensitivity(slope / value, slope / here if here else math.nan, error / abs(here) if here else math.nan)
    return found


def _extrapolated(differences: Floats, steps: Floats) -> tuple[float, float]:
    """The limit of central differences for a step of zero, by Richardson's table, and its error (Ridders 1982)."""
    table = list(map(float, differences))
    best, error = math.nan, math.inf
    factor = 1.0
    for _ in range(1, len(table)):
        factor *= 4.0
        better = [fine + (fine - coarse) / (factor - 1) for coarse, fine in zip(table, table[1:])]
        for place, value in enumerate(better):
            change = max(abs(value - table[place]), abs(value - table[place + 1]))
            if change < error:
                best, error = value, change
        table = better
    return best, error


def _value(machine: Machine[float], load: Any, name: str) -> float:
    """The value of a machine or its drive in the machine's units."""
    if name in _OF_MACHINE:
        value = getattr(machine, name)
        return float("nan") if value is None else float(value)
    if name in _OF_LOAD and isinstance(load, Drive):
        given = load._in(machine.units, vars(machine)["_named"])
        value = given["angular_frequency"] / (2 * np.pi) if name == "frequency" else given[name]
        if is_array(value):
            raise Error(f"{name}: must be one number, not an array")
        return float(value)
    known = (*_OF_MACHINE, *_OF_LOAD) if isinstance(load, Drive) else _OF_MACHINE
    raise Error(f"{name!r} is none of {', '.join(known)}")


def _draws(name: str, of: Any, value: float, random: np.random.Generator, n: int) -> Floats:
    if callable(of):
        drawn = of(random, n)
    elif hasattr(of, "rvs"):
        drawn = of.rvs(size=n, random_state=random)
    elif isinstance(of, tuple):
        if len(of) != 2:
            raise WrongType(f"{name}: a uniform distribution is (low, high)")
        low, high = of_number(name, of[0]), of_number(name, of[1])
        if not low <= high:
            raise Error(f"{name}: low = {low} must be <= high = {high}")
        drawn = random.uniform(low, high, n)
    elif is_array(of):
        drawn = of
    else:
        share = of_number(name, of)
        if not 0 <= share < math.inf:
            raise Error(f"{name}: the relative standard deviation = {share} must be >= 0 and finite")
        drawn = value * (1 + share * random.standard_normal(n))
    found = numbers(name, drawn)
    if found.shape != (n,):
        raise Error(f"{name}: must have {n} draws, not the shape {found.shape}")
    return found


def _answered(machine: Machine[float], load: Any, drawn: Mapping[str, Floats], exact: bool, outputs: Any) -> Any:
    names = ("mass", "stiffness", "friction", "friction_backward", "static_friction_ratio")
    body: dict[str, Any] = {name: getattr(machine, name) for name in names}
    damper = "damping" if "damping" in drawn else "damping_ratio"
    body = {**body, damper: getattr(machine, damper), **{name: column for name, column in drawn.items() if name in _OF_MACHINE}}
    units = machine.units
    varied: Machine[Any] = Machine(**{name: value for name, value in body.items() if value is not None}, units=units)
    if isinstance(load, Record):
        return varied.follow(load)
    of_type("load", load, Drive)
    given = load._in(units, vars(machine)["_named"])
    if "frequency" in drawn:
        given["angular_frequency"] = 2 * np.pi * drawn["frequency"]
    given |= {name: column for name, column in drawn.items() if name in given}
    amplitude = {load.excitation: given.pop("amplitude")}
    assert load.excitation in EXCITATIONS
    drive: Drive[Any] = Drive(**amplitude, **given, units=units)
    return varied.steady(drive, outputs=outputs) if exact else varied.response(drive, outputs=outputs)
