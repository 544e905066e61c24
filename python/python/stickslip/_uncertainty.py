"""Uncertain machines: Monte-Carlo, and sensitivities to every value."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, NamedTuple, Optional, Union, overload

import numpy as np
from numpy.typing import NDArray

from ._design import Estimate
from ._drive import EXCITATIONS, Drive, is_array
from ._labels import WrongType, is_labelled, numbers
from ._machine import Machine
from ._native import REGIMES, Error
from ._record import Record
from ._physical import OF_BODY, related
from ._result import Codes, Floats, Joined, Result, are_same, blocks, of_number, of_type, read_only, unknown, whole_number

#: How a value is distributed: the relative standard deviation of a normal distribution, the ends of a uniform one, a function of
#: a generator and a number of draws, a distribution of SciPy, or draws.
Distribution = Union[float, tuple[float, float], Callable[[np.random.Generator, int], Any], Any]
#: The values of a machine that can be varied.
_OF_MACHINE = ("mass", "stiffness", "friction", "friction_backward", "damping", "damping_ratio", "static_friction_ratio")
_OF_LOAD = ("amplitude", "frequency", "angular_frequency", "mean_force")
#: 97.5 % of a normal distribution lie below this.
_QUANTILE = 1.959963984540054
#: The number of draws from which on they are answered in pieces: no more is in memory than the draws and what is asked of them.
_MANY = 1 << 20


class MonteCarlo(NamedTuple):
    """The answers of many machines drawn at random; see `monte_carlo`."""

    #: The drawn values, by name.
    drawn: Mapping[str, Floats]
    #: The answer of every draw, as an array for each value.
    answer: Any

    def __eq__(self, other: object) -> bool:
        return isinstance(other, MonteCarlo) and are_same(self.drawn, other.drawn) and are_same(self.answer, other.answer)

    def __ne__(self, other: object) -> bool:
        return not self == other

    def __repr__(self) -> str:
        invalid = f", {self.invalid} invalid" if self.invalid else ""
        return f"MonteCarlo({self.draws} draws of {', '.join(self.drawn) or 'nothing'}{invalid})"

    @property
    def draws(self) -> int:
        """The number of draws, invalid ones included."""
        return int(self._is_valid.size)

    @property
    def invalid(self) -> int:
        """The number of draws outside the domain, which have no answer and count in no probability."""
        return int(np.count_nonzero(~self._is_valid))

    @property
    def _is_valid(self) -> NDArray[np.bool_]:
        if "regime" in self.answer._names:
            return ~self._has("invalid")
        return np.atleast_1d(~np.isnan(_column(self.answer, "path")))

    def _has(self, regime: str) -> NDArray[np.bool_]:
        """The draws of a regime. Codes are compared, because words of millions of draws take hundreds of megabytes."""
        self.answer._compute(("regime",))
        known = self.answer._values["regime"]
        same = known.places == known.names.index(regime) if isinstance(known, Codes) else np.asarray(known) == regime
        return np.atleast_1d(same)

    def _values(self, name: str) -> Floats:
        values = np.atleast_1d(_column(self.answer, name))
        missing = np.isnan(values)
        values = values[~missing] if missing.any() else values
        if not values.size:
            raise Error(f"{name}: no draw has it")
        return values

    @overload
    def quantile(self, name: str, share: float) -> float: ...

    @overload
    def quantile(self, name: str, share: Union[Sequence[float], Floats]) -> Floats: ...

    def quantile(self, name: str, share: Any) -> Union[float, Floats]:
        """The value that this share of the draws does not exceed, among those that have it; an array for several shares."""
        shares = numbers("share", share) if is_array(share) else np.asarray(of_number("share", share))
        outside = shares[~((shares >= 0) & (shares <= 1))]
        if outside.size:
            raise Error(f"share = {outside.flat[0]}: must be >= 0 and <= 1")
        found: Floats = np.quantile(self._values(name), shares)
        return found if shares.ndim else float(found)

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

    def probability(self, is_met: Union[str, Sequence[bool], NDArray[np.bool_], Callable[[Any], Any]]) -> Estimate:
        """The probability of a regime or of a condition among the valid draws, with Wilson's 95 % interval.

        Parameters
        ----------
        is_met : str, array or function
            The name of a regime; a flag, True or False, for each draw; or a function of ``answer`` that returns these flags.

        >>> import stickslip as ss
        >>> machine = ss.Machine(mass=50, stiffness=1000, friction=5)
        >>> found = ss.monte_carlo(machine, ss.Drive(force=12, frequency=1), {"friction": 0.3}, draws=2000, seed=7)
        >>> found.probability("sticking").value == found.probability(found.answer.regime == "sticking").value
        True
        >>> found.probability(lambda answer: answer.max_displacement > 0.01).value
        0.5075
        """
        is_valid = self._is_valid
        flags = self._flags(is_met, is_valid.size)[is_valid]
        n, met, z2 = flags.size, int(np.count_nonzero(flags)), _QUANTILE**2
        if not n:
            raise Error("probability: no draw is valid")
        share = met / n
        middle = (share + z2 / (2 * n)) / (1 + z2 / n)
        half = _QUANTILE / (1 + z2 / n) * math.sqrt(share * (1 - share) / n + z2 / (4 * n * n))
        # The ends are exact where no draw or every draw meets the condition; rounding must not move them.
        low, high = max(0.0, middle - half) if met else 0.0, min(1.0, middle + half) if met < n else 1.0
        return Estimate(share, math.sqrt(share * (1 - share) / n), (low, high))

    def _flags(self, is_met: Any, draws: int) -> NDArray[np.bool_]:
        if isinstance(is_met, str):
            if "regime" not in self.answer._names:
                raise Error(f"is_met = {is_met!r}: the answers to a record have no regime. Give flags or a function")
            regimes = [name for name in REGIMES if name != "invalid"]
            if is_met not in regimes:
                raise unknown(f"is_met = {is_met!r}", is_met, regimes)
            return self._has(is_met)
        given = is_met(self.answer) if callable(is_met) else is_met
        flags = np.asarray(given)
        if isinstance(given, np.ma.MaskedArray) or flags.dtype != np.bool_:
            kind = f"type {flags.dtype}" if is_array(given) or is_labelled(given) else repr(given)
            raise WrongType(f"is_met: must be a regime, flags (True or False), or a function of the answer that returns flags, not {kind}")
        if flags.shape != (draws,):
            raise Error(f"is_met: must have a flag for each of the {draws} draws, not the shape {flags.shape}")
        return flags


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
        The values to vary, by their names: those of a machine (``mass``, ``stiffness``, ``friction``, ``damping_ratio``, …)
        and of a drive (``amplitude``, ``frequency``, ``mean_force``). A number is the relative standard deviation of a
        normal distribution about the value, a pair (low, high) the ends of a uniform one. Otherwise give a distribution of
        ``scipy.stats``, an array of draws, or a function of a generator and a number of draws. Numbers are in the units of
        the machine, frequencies in hertz. Of the damper, its ratio is held if it was given so, and otherwise its constant.
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
        With quantiles, intervals, means and probabilities. A draw outside the domain has NaN; ``invalid`` counts these. From 1,048,576
        draws on under a drive each output is computed when it is read, or at once if ``outputs`` names it, in pieces.

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
    _of_one(machine, load)
    n = whole_number("draws", draws)
    random = np.random.default_rng(seed)
    drawn = {name: _draws(name, of, _value(machine, load, name), random, n) for name, of in vary.items()}
    if n < _MANY or not drawn or isinstance(load, Record):
        return MonteCarlo(drawn, _answered(machine, load, drawn, exact, outputs))
    return MonteCarlo(drawn, _Pieces(machine, load, drawn, exact).answer(outputs))


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

    The accuracy is some 1e-10 where the output is smooth; at a sticking threshold, where it has a corner, the error is large.

    One value is varied while the others stay. Of the damper, ``damping_ratio`` stays if the machine was given by it, and
    otherwise ``damping``. The stiffness, the friction and the static friction ratio stay, even if a period, a coefficient of
    friction or a static friction was given.

    Parameters
    ----------
    machine : Machine
    load : Drive or Record
    of : str
        The output, such as ``"max_displacement"``.
    by : list of str, optional
        The values, as of `monte_carlo`: by default all that are not zero, the damper by ``damping_ratio`` if it was given so.
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
    _of_one(machine, load)
    damper = _damper(machine)
    loads = (*_OF_LOAD[:2], "mean_force") if isinstance(load, Drive) else ()
    names = list(by) if by is not None else [*_OF_MACHINE[:4], damper, "static_friction_ratio", *loads]
    at = {name: _value(machine, load, name) for name in names}
    if by is None:
        is_default = {"static_friction_ratio": 1.0}
        at = {name: value for name, value in at.items() if value not in (0, is_default.get(name)) and not math.isnan(value)}
    for name, value in at.items():
        if value == 0 or math.isnan(value):
            raise Error(f"{name} = {'None' if math.isnan(value) else 0}: a relative step needs another value")
    alone = _answered(machine, load, {}, exact, None)
    here = float(_column(alone, of))
    steps: Floats = np.exp2(-np.arange(7.0, 15.0))
    factors = np.concatenate([1 + steps, 1 - steps])
    size = factors.size
    drawn: dict[str, Floats] = {}
    # Names of one value step the same column: the damper as it was given, and the frequency in radians per second.
    same = {"damping": damper, "damping_ratio": damper, "frequency": "angular_frequency"}
    for place, name in enumerate(at):
        own = same.get(name, name)
        column = drawn.setdefault(own, np.full(size * len(at), _value(machine, load, own)))
        column[place * size : (place + 1) * size] *= factors
    values = _column(_answered(machine, load, drawn, exact, None), of).reshape(len(at), 2, steps.size)
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


def _damper(machine: Machine[float]) -> str:
    """The value of the damper that was given, and that stays while others are varied."""
    return "damping_ratio" if "damping_ratio" in vars(machine)["_keywords"] else "damping"


def _of_one(machine: Any, load: Any) -> None:
    """Fails where a machine or its drive is of arrays."""
    of_type("machine", machine, Machine)
    if any(is_array(getattr(machine, name)) for name in OF_BODY):
        raise WrongType("machine: must be one machine, not an array of machines")
    if isinstance(load, Record):
        return
    of_type("load", load, Drive)
    if any(is_array(getattr(load, name)) for name in ("amplitude", "angular_frequency", "mean_force")):
        raise WrongType("load: must be one drive, not an array of drives")


def _column(answer: Result, name: str) -> Floats:
    """The numbers of an output by its name."""
    if name not in answer._names:
        raise unknown(f"output {name!r}", name, answer._names)
    try:
        values = np.asarray(answer[name])
    except AttributeError as error:
        raise Error(f"output {name!r}: {error}") from None
    if values.dtype.kind not in "biuf":
        raise WrongType(f"output {name!r}: must be a number, not {'a word' if values.dtype.kind in 'UO' else values.dtype}")
    return values.astype(np.float64, copy=False)


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
    raise Error(f"{name!r} must be one of {', '.join(known)}")


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
        if math.isnan(value):
            raise Error(f"{name} = None: a relative standard deviation needs a value")
        drawn = value * (1 + share * random.standard_normal(n))
    found = numbers(name, drawn)
    if found.shape != (n,):
        raise Error(f"{name}: must have {n} draws, not the shape {found.shape}")
    # Outputs may be computed from it later.
    return read_only(found)  # type: ignore[no-any-return]


class _Pieces(NamedTuple):
    """The question of many draws, each output of which is computed for a piece of them after the other."""

    machine: Machine[float]
    load: Drive[float]
    drawn: Mapping[str, Floats]
    exact: bool
    is_in_ratios: bool = False

    def _of(self, part: slice, outputs: Any = ()) -> Any:
        drawn = {name: column[part] for name, column in self.drawn.items()}
        return _answered(self.machine, self.load, drawn, self.exact, outputs)

    def __call__(self, names: tuple[str, ...]) -> dict[str, Any]:
        n = next(iter(self.drawn.values())).size
        joined, words = Joined(n), dict[str, Sequence[str]]()
        for part in blocks(n):
            answer = self._of(part)
            answer = answer.ratios if self.is_in_ratios else answer
            answer._compute(names)
            found = {name: answer._values[name] for name in names}
            words |= {name: value.names for name, value in found.items() if isinstance(value, Codes)}
            joined.put(part, {name: value.places if isinstance(value, Codes) else value for name, value in found.items()})
        return {name: Codes(column, words[name]) if name in words else column for name, column in joined.columns.items()}

    def answer(self, outputs: Optional[Iterable[str]]) -> Any:
        """The answer of all draws: with the names, the units and the ratios of the answer of one."""
        chosen = outputs if outputs is None else tuple([outputs] if isinstance(outputs, str) else outputs)
        one = self._of(slice(1), chosen)
        ratios = type(one.ratios)({}, self._replace(is_in_ratios=True), chosen=one.ratios._chosen)
        whole = related(type(one)({}, self, units=one.units, chosen=one._chosen), ratios, one._driven)
        if chosen is not None:
            whole._compute(whole._chosen)
        return whole


def _answered(machine: Machine[float], load: Any, drawn: Mapping[str, Floats], exact: bool, outputs: Any) -> Any:
    names = ("mass", "stiffness", "friction", "friction_backward", "static_friction_ratio")
    body: dict[str, Any] = {name: getattr(machine, name) for name in names}
    # A varied damper takes the place of the given one.
    dampers = [name for name in ("damping", "damping_ratio") if name in drawn] or [_damper(machine)]
    body |= {name: getattr(machine, name) for name in dampers}
    body |= {name: column for name, column in drawn.items() if name in _OF_MACHINE}
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
