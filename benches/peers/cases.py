"""SciPy on the case file: the error of the greatest displacement of `tests/data/cases.json`, and the stops it counts.

Two ways to solve with `solve_ivp`, as its users would: friction smoothed to tanh(v/eps), and modes with events at the zeros of
the velocity and at releases. Both follow the motion from rest for as many periods as a disturbance takes to fall below 1e-9,
which they are told. Needs numpy, scipy and matplotlib (2.4.6, 1.17.1 and 3.11.1 here):

    python benches/peers/cases.py tests/data/cases.json docs/figures/cases.svg
"""

import json
import sys
import time

import numpy as np
from scipy.integrate import solve_ivp


def smoothed(omega, alpha, zeta, eta, start, periods, rtol=1e-8, eps=1e-4):
    """The greatest displacement of the last period; static friction cannot be smoothed."""

    def slope(t, y):
        return y[1], alpha * np.sin(omega * t) - y[0] - 2 * zeta * y[1] - np.tanh(y[1] / eps)

    period = 2 * np.pi / omega
    times = np.linspace((periods - 1) * period, periods * period, 4001)
    found = solve_ivp(slope, (start, periods * period), (0.0, 0.0), method="LSODA", t_eval=times, rtol=rtol, atol=1e-3 * rtol)
    return np.abs(found.y[0]).max() if found.success else np.nan


def by_modes(omega, alpha, zeta, eta, periods, rtol=1e-9):
    """The greatest displacement and the number of stops of the last period."""
    period = 2 * np.pi / omega
    t, x, v, mode, greatest, stops = 0.0, 0.0, 0.0, 0, 0.0, 0
    end, last = periods * period, (periods - 1) * period
    for _ in range(200 * periods):
        if t >= end - 1e-9 * period:
            return greatest, stops
        stop_at = last if t < last else end
        force = lambda t, x: alpha * np.sin(omega * t) - x
        if mode == 0:
            release = lambda t, y: abs(force(t, x)) - eta
            release.terminal, release.direction = True, 1
            if abs(force(t, x)) > eta:
                mode = np.sign(force(t, x))
                continue
            found = solve_ivp(lambda t, y: (0.0,), (t, stop_at), (0.0,), events=release, max_step=period / 50, rtol=rtol)
            t = found.t[-1]
            if found.t_events[0].size:
                mode = np.sign(force(t, x))
                t += 1e-12 * period
            continue
        slope = lambda t, y: (y[1], force(t, y[0]) - 2 * zeta * y[1] - mode)
        zero = lambda t, y: y[1]
        zero.terminal, zero.direction = True, -mode
        found = solve_ivp(slope, (t, stop_at), (x, v), events=zero, method="DOP853", rtol=rtol, atol=1e-12)
        t, (x, v) = found.t[-1], found.y[:, -1]
        if t > last:
            greatest = max(greatest, abs(x))
        if found.t_events[0].size:
            v = 0.0
            rests = abs(force(t, x)) <= eta
            stops += rests and t > last
            mode = 0 if rests else -mode
    return np.nan, -1


def main():
    rows = []
    for case in json.load(open(sys.argv[1]))["cases"]:
        omega, alpha, zeta, eta = (float(case[name]) for name in ("omega", "alpha", "damping_ratio", "static_friction_ratio"))
        answer = case["answer"]
        exact = max(float(answer["max_displacement"]), -float(answer["min_displacement"]))
        periods = 60 if zeta < 0.005 else 30
        begin = time.process_time()
        a = smoothed(omega, alpha, zeta, eta, 0.0, periods) / exact - 1
        between = time.process_time()
        found, stops = by_modes(omega, alpha, zeta, eta, periods)
        rows.append((case["name"], a, found / exact - 1, stops, answer["sticks_per_cycle"], between - begin, time.process_time() - between))
        print("| {} | {:.0e} | {:.0e} | {} of {} | {:.2f} s | {:.2f} s |".format(*rows[-1]), flush=True)
    import matplotlib

    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "stickslip"
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(9, 4))
    place = np.arange(len(rows))
    axes.semilogy(place, [max(abs(row[1]), 1e-16) for row in rows], "s", color="0.6", label="solve_ivp, friction smoothed")
    axes.semilogy(place, [max(abs(row[2]), 1e-16) for row in rows], "k^", label="solve_ivp, modes with events")
    axes.set(xlabel="case of tests/data/cases.json", ylabel="relative error of the greatest displacement", ylim=(1e-16, 10))
    axes.legend()
    figure.tight_layout()
    figure.savefig(sys.argv[2], metadata={"Date": None})


main()
