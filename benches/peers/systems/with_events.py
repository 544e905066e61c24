"""Bodies with a contact at the first by SciPy's solve_ivp with events: time a period, and the error of the state after 100 periods.

The system is `chain(n, 0, 1.0, 1.5)` of benches/systems.rs. Run: python benches/peers/systems/with_events.py [N], N = 2 or 4
"""

import sys
import time

import numpy as np
from scipy.integrate import solve_ivp

OMEGA, FORCE, FRICTION = 0.9, 1.5, 1.0
N = int(sys.argv[1]) if len(sys.argv) > 1 else 2
MASS = np.array([1.0] + [0.5] * (N - 1))
STIFFNESS = np.diag([3.0] + [2.0] * (N - 2) + [1.0]) - np.eye(N, k=1) - np.eye(N, k=-1)
DAMPING = 0.02 * STIFFNESS


def load(t, y):
    """The force on each body without friction."""
    force = -STIFFNESS @ y[:N] - DAMPING @ y[N:]
    force[-1] += FORCE * np.sin(OMEGA * t)
    return force


def sliding(sign):
    def f(t, y):
        force = load(t, y)
        force[0] -= sign * FRICTION
        return np.concatenate([y[N:], force / MASS])

    return f


def stuck(t, y):
    rate = np.concatenate([y[N:], load(t, y) / MASS])
    rate[[0, N]] = 0.0
    return rate


def simulate(until, rtol, method):
    t, y, events, calls = 0.0, np.zeros(2 * N), 0, 0
    mode = 0
    while t < until:
        if mode == 0:
            ends = [lambda t, y: load(t, y)[0] - FRICTION, lambda t, y: load(t, y)[0] + FRICTION]
            ends[0].direction, ends[1].direction = 1, -1
        else:
            ends = [lambda t, y: y[N]]
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
                y[N] = 0.0
                force = load(t, y)[0]
                mode = 0 if abs(force) <= FRICTION else int(np.sign(force))
    return y, events, calls


def main():
    period = 2 * np.pi / OMEGA
    # Of `System::states` after 100 periods.
    exact = np.array(EXACT[N])
    for method, rtol in [("RK45", 1e-6), ("DOP853", 1e-10), ("Radau", 1e-8)]:
        began = time.process_time()
        y, events, calls = simulate(100 * period, rtol, method)
        took = (time.process_time() - began) / 100 * 1e6
        error = np.abs(y - exact).max()
        print(f"{method} {rtol:g}: {took:.0f} µs a period, {calls / 100:.0f} calls, {events} events, error {error:.1e}")


EXACT = {
    2: [-2.5726518965613074, -4.428722213559313, 2.912471257663425, 7.636733106547826],
    # By DOP853 at 1e-12.
    4: [
        0.693721688642545, -0.08819846662437891, -0.4665255476407204, -0.9847466116272514,
        -0.7926352358829796, -2.0324023663342494, -2.5193102970872716, -1.8135297758651447,
    ],
}

if __name__ == "__main__":
    main()
