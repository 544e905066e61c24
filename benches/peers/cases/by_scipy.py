"""SciPy's `solve_ivp` on the case file: friction smoothed to tanh(v/eps), and modes with events at stops and releases.

Needs numpy and scipy:

    python benches/peers/cases/by_scipy.py tests/data/cases.json
"""

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from common import by_modes, main, settled, stops_of

#: In a period of the drive or of the body, the shorter of the two. Between them the zeros of the velocity are found, and with them the greatest displacement. (LSODA's dense output is not
#: continuous enough for `solve_ivp`'s events.)
SAMPLES = 1000


def smoothed(omega, alpha, zeta, eta, setting):
    """Static friction cannot be smoothed. A stop has |v| < 10 eps for a hundredth of a period of the drive or of the body."""
    eps = {"default": 1e-3, "tight": 1e-5}[setting]
    tolerances = {"default": {}, "tight": {"rtol": 1e-9, "atol": 1e-12}}[setting]
    turn = 2 * np.pi / omega
    samples = SAMPLES * int(np.ceil(max(1 / omega, 1)))
    state = np.zeros(2)

    def slope(t, y):
        return y[1], alpha * np.sin(omega * t) - y[0] - 2 * zeta * y[1] - np.tanh(y[1] / eps)

    def period(n):
        times = np.linspace(n * turn, (n + 1) * turn, samples + 1)
        found = solve_ivp(slope, (times[0], times[-1]), state, method="LSODA", dense_output=True, **tolerances)
        if not found.success:
            return np.nan, -1
        state[:] = found.y[:, -1]
        velocities = found.sol(times)[1]
        turns = np.flatnonzero(velocities[:-1] * velocities[1:] < 0)
        zeros = [brentq(lambda t: found.sol(t)[1], times[i], times[i + 1]) for i in turns]
        greatest = max((abs(found.sol(t)[0]) for t in zeros), default=np.abs(state[0]))
        return greatest, stops_of(velocities[1:], 10 * eps, SAMPLES // 100)

    return settled(period, setting)


def integrate(slope, event, direction, span, state, max_step, setting):
    options = {"default": {}, "tight": {"method": "DOP853", "rtol": 1e-10, "atol": 1e-12}}[setting]
    event.terminal, event.direction = True, direction
    found = solve_ivp(slope, span, state, events=event, max_step=max_step, **options)
    return found.t[-1], found.y[:, -1], found.t_events[0].size > 0


main("SciPy", {"smoothed": smoothed, "events": lambda *machine: by_modes(*machine, integrate)})
