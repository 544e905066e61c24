"""Storeys with four elastic dampers by SciPy's stiff solvers with events, and by stickslip, beside DOP853 at 1e-12.

Needs numpy, scipy and the command stickslip, by its path. It takes some minutes and prints the table of docs/limits.md:

    python benches/peers/systems/storeys.py target/release/stickslip 20 100 200
"""

import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp
from scipy.sparse import csc_matrix

MASS, ACCELERATION, OMEGA, UNTIL = 100e3, 0.981, np.pi, 20.0
FRICTION, SPRING = 1500e3, 200e6


def storeys(n):
    """The stiffness and the damping of a chain with the period 0.1 n s, and the storeys with a damper."""
    first = 2 * np.pi / (0.1 * n)
    k = MASS * (first / (2 * np.sin(np.pi / (2 * (2 * n + 1))))) ** 2
    chain = 2 * np.eye(n) - np.eye(n, k=1) - np.eye(n, k=-1)
    chain[-1, -1] = 1
    directions = np.zeros((4, n))
    for row, at in zip(directions, [j * n // 4 for j in range(4)]):
        row[at] = 1
        if at > 0:
            row[at - 1] = -1
    return k * chain, 2 * 0.002 / first * k * chain, directions


def by_scipy(n, method, rtol):
    """The state at the end, with a restart at each event of a damper."""
    stiffness, damping, directions = storeys(n)
    yields = [0] * 4
    z, t, events = np.zeros(2 * n + 4), 0.0, 0
    scale = np.concatenate([np.full(n, 0.1), np.full(n, 1.0), np.full(4, FRICTION)])
    while t < UNTIL:
        a = np.zeros((2 * n + 4, 2 * n + 4))
        a[:n, n : 2 * n] = np.eye(n)
        a[n : 2 * n, :n], a[n : 2 * n, n : 2 * n] = -stiffness / MASS, -damping / MASS
        a[n : 2 * n, 2 * n :] = -directions.T / MASS
        for i, sign in enumerate(yields):
            if sign == 0:
                a[2 * n + i, n : 2 * n] = SPRING * directions[i]
        sparse = csc_matrix(a)
        load = np.concatenate([np.zeros(n), np.full(n, -ACCELERATION), np.zeros(4)])

        def guard(i, sign):
            if sign == 0:
                of = lambda _, z: FRICTION - abs(z[2 * n + i])
            else:
                of = lambda _, z: sign * (directions[i] @ z[n : 2 * n])
            of.terminal, of.direction = True, -1
            return of

        guards = [guard(i, sign) for i, sign in enumerate(yields)]
        stiff = {} if method == "DOP853" else {"jac": sparse}
        found = solve_ivp(
            lambda t, z: sparse @ z + load * np.sin(OMEGA * t),
            (t, UNTIL),
            z,
            method=method,
            rtol=rtol,
            atol=rtol * scale,
            events=guards,
            **stiff,
        )
        t, z = found.t[-1], found.y[:, -1].copy()
        if found.status == 1:
            i = next(i for i, times in enumerate(found.t_events) if len(times))
            events += 1
            if yields[i] == 0:
                yields[i] = int(np.sign(z[2 * n + i]))
                z[2 * n + i] = yields[i] * FRICTION
            else:
                yields[i] = 0
    return z, events


def by_stickslip(program, n):
    stiffness, damping, directions = storeys(n)
    elements = [
        {"type": "elastic", "name": f"damper {i}", "direction": list(b), "stiffness": SPRING, "friction": FRICTION}
        for i, b in enumerate(directions)
    ]
    with tempfile.TemporaryDirectory() as folder:
        for name, matrix in [("mass", MASS * np.eye(n)), ("damping", damping), ("stiffness", stiffness)]:
            np.save(Path(folder) / f"{name}.npy", matrix)
        file = Path(folder) / "storeys.json"
        matrices = {name: f"{name}.npy" for name in ["mass", "stiffness"]}
        load = {"frequency": OMEGA, "sin": [-MASS * ACCELERATION] * n}
        damping = {"file": "damping.npy"}
        file.write_text(json.dumps(matrices | {"damping": damping, "elements": elements, "harmonics": [load]}))
        command = [program, "system", file, "simulate", "--until", str(UNTIL), "--format", "json"]
        found = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
    return np.array(found["end"]["displacement"] + found["end"]["velocity"]), len(found["events"])


def error(z, due, n):
    part = lambda of: np.abs(z[of] - due[of]).max() / np.abs(due[of]).max()
    return max(part(slice(0, n)), part(slice(n, 2 * n)))


program, sizes = sys.argv[1], [int(n) for n in sys.argv[2:]]
for n in sizes:
    due, count = by_scipy(n, "DOP853", 1e-12)
    for name, run in [
        ("stickslip", lambda: by_stickslip(program, n)),
        *(
            (f"SciPy {method}, {rtol:g}", lambda method=method, rtol=rtol: by_scipy(n, method, rtol))
            for method in ["BDF", "Radau", "DOP853"]
            for rtol in [1e-6, 1e-9]
        ),
    ]:
        start = time.process_time()
        z, events = run()
        spent = time.process_time() - start
        print(f"n = {n}: {name}: {spent:.2f} s, error {error(z, due, n):.1e}, {events} events of {count}", flush=True)
