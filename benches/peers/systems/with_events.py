"""Two masses with a contact by SciPy's solve_ivp with events: time a period, and the error of the state after 100 periods.

The system is `chain(2, 0, 1.0, 1.5)` of benches/systems.rs, which prints its own state. Run: python benches/peers/systems/with_events.py
"""

import time

import numpy as np
from scipy.integrate import solve_ivp

OMEGA, FORCE, FRICTION = 0.9, 1.5, 1.0
MASS = np.array([1.0, 0.5])
STIFFNESS = np.array([[3.0, -1.0], [-1.0, 1.0]])
DAMPING = 0.02 * STIFFNESS


def load(t, y):
    """The force on each body without friction."""
    force = -STIFFNESS @ y[:2] - DAMPING @ y[2:]
    force[1] += FORCE * np.sin(OMEGA * t)
    return force


def sliding(sign):
    def f(t, y):
        force = load(t, y)
        force[0] -= sign * FRICTION
        return np.concatenate([y[2:], force / MASS])

    return f


def stuck(t, y):
    force = load(t, y)
    return np.array([0.0, y[3], 0.0, force[1] / MASS[1]])


def simulate(until, rtol, method):
    t, y, events, calls = 0.0, np.zeros(4), 0, 0
    mode = 0
    while t < until:
        if mode == 0:
            ends = [lambda t, y: load(t, y)[0] - FRICTION, lambda t, y: load(t, y)[0] + FRICTION]
            ends[0].direction, ends[1].direction = 1, -1
        else:
            ends = [lambda t, y: y[2]]
            ends[0].direction = -mode
        for end in ends:
            end.terminal = True
        f = stuck if mode == 0 else sliding(mode)
        r = solve_ivp(f, (t, until), y, method=method, rtol=rtol, atol=1e-12, events=ends)
        calls += r.nfev
        t, y = r.t[-1], r.y[:, -1].copy()
        if r.status == 1:
            events += 1
            if mode == 0:
                mode = 1 if len(r.t_events[0]) else -1
            else:
                y[2] = 0.0
                force = load(t, y)[0]
                mode = 0 if abs(force) <= FRICTION else int(np.sign(force))
    return y, events, calls


def main():
    period = 2 * np.pi / OMEGA
    # Of `System::states` after 100 periods.
    exact = np.array(EXACT)
    for method, rtol in [("RK45", 1e-6), ("DOP853", 1e-10), ("Radau", 1e-8)]:
        began = time.process_time()
        y, events, calls = simulate(100 * period, rtol, method)
        took = (time.process_time() - began) / 100 * 1e6
        error = np.abs(y - exact).max()
        print(f"{method} {rtol:g}: {took:.0f} µs a period, {calls / 100:.0f} calls, {events} events, error {error:.1e}")


EXACT = [-2.5726518965613074, -4.428722213559313, 2.912471257663425, 7.636733106547826]

if __name__ == "__main__":
    main()
