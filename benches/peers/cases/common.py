"""The case file for every tool: one rule for the end of a transient, one way to count stops, one line for each answer.

Friction, its bound and the stiffness are 1. Each tool starts from rest and follows the drive period by period. It ends when the
greatest displacements of three successive periods agree, or after a number of periods.
"""

import json
import sys
import time

import numpy as np

#: The relative agreement of three successive periods and the most periods, for each setting.
ENDS = {"default": (1e-6, 300), "tight": (1e-9, 10_000)}
#: A slide starts with this velocity, so that its start is not found as its end.
START = 1e-13


def stops_of(velocities, small, least):
    """How often |v| stays below a bound for a number of samples or more, in a period that repeats itself."""
    slow = np.abs(np.asarray(velocities)) < small
    if slow.all():
        return 1
    slow = np.roll(slow, -np.flatnonzero(~slow)[0])
    edges = np.flatnonzero(np.diff(np.concatenate(([0], slow, [0]))))
    return int(np.count_nonzero(edges[1::2] - edges[::2] >= least))


def settled(period, setting, at_most=10_000):
    """The greatest displacement and the stops of the last period, and the number of periods.

    `period(n)` follows the period n and gives its greatest displacement and its stops. Fixed steps take a limit of their own: their
    motions may never repeat themselves to 1e-9.
    """
    agreement, most = ENDS[setting]
    before = []
    for n in range(min(most, at_most)):
        greatest, stops = period(n)
        before = [*before[-2:], greatest]
        if not np.isfinite(greatest):
            break
        if n >= 10 and max(before) - min(before) <= agreement * max(before):
            break
    return greatest, stops, n + 1


def by_modes(omega, alpha, zeta, eta, setting, integrate):
    """Slides end at a zero of the velocity, and stops where the force exceeds static friction.

    `integrate(slope, event, direction, span, state, max_step, setting)` follows the state to the end of the span or to a zero of the
    event in a direction. It returns the time, the state, and whether it met the event.
    """
    turn = 2 * np.pi / omega
    x, v, mode, t = 0.0, 0.0, 0, 0.0

    def force(t, x):
        return alpha * np.sin(omega * t) - x

    def period(n):
        nonlocal x, v, mode, t
        end, greatest, stops = (n + 1) * turn, 0.0, 0
        for _ in range(200):
            greatest = max(greatest, abs(x))
            if t >= end - 1e-9 * turn:
                return greatest, stops
            if mode == 0:
                met = abs(force(t, x)) > eta
                if not met:
                    # The state of a body at rest does not change, so that nothing but a limit keeps the steps short.
                    release = lambda t, y: abs(force(t, x)) - eta
                    t, _, met = integrate(lambda t, y: (0.0,), release, 1, (t, end), (0.0,), turn / 50, setting)
                    t += 1e-12 * turn * met
                mode = np.sign(force(t, x)) if met else 0
                v = START * mode
                continue
            slope = lambda t, y: (y[1], force(t, y[0]) - 2 * zeta * y[1] - mode)
            t, (x, v), met = integrate(slope, lambda t, y: y[1], -mode, (t, end), (x, v), np.inf, setting)
            if met:
                rests = abs(force(t, x)) <= eta
                stops += rests
                mode = 0 if rests else np.sign(force(t, x))
                v = START * mode
        return np.nan, -1

    return settled(period, setting)


def main(tool, methods, settings=ENDS):
    """Solves every case by every method in every setting. A method is called with Ω, α, ζ, η and the setting."""
    for case in json.load(open(sys.argv[1]))["cases"]:
        machine = [float(case[name]) for name in ("omega", "alpha", "damping_ratio", "static_friction_ratio")]
        for name, method in methods.items():
            for setting in settings:
                begin = time.process_time()
                greatest, stops, periods = method(*machine, setting)
                took = time.process_time() - begin
                print(f"{tool}, {name}", setting, case["name"], f"{greatest:.17g}", stops, periods, f"{took:.6f}", sep="\t", flush=True)
