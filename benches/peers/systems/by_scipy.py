"""Twenty systems of `tests/data/systems.json` by SciPy's LSODA with smoothed friction, and by stickslip, beside their answers.

SciPy begins on the steady motion and follows ten periods of it; stickslip finds it from rest.

Needs numpy, scipy and stickslip. It takes some minutes and prints the table of docs/development/comparison.md:

    python benches/peers/systems/by_scipy.py tests/data/systems.json
"""

import json
import sys
import time

import numpy as np
from scipy.integrate import solve_ivp

import stickslip as ss

#: The friction of a contact becomes r tanh(v/eps) with eps of this part of the greatest velocity that the answer has.
SETTINGS = {"default": (1e-3, {}), "tight": (1e-6, {"rtol": 1e-9, "atol": 1e-12})}
#: Evaluations of the equation of motion after which a case is given up.
MOST = 1_000_000
#: Periods from the steady motion on, or from rest to it where elastic contacts have forces of their own.
PERIODS, FROM_REST = 10, 60


def numbers(values):
    return np.array([float(x) for x in values])


def signal(of, harmonics):
    """A constant with its harmonics, as a function of time."""
    if not isinstance(of, dict):
        return lambda t: float(of)
    sin, cos = numbers(of.get("sin", [])), numbers(of.get("cos", []))
    omega = [h["frequency"] for h in harmonics]

    def at(t):
        parts = sum(s * np.sin(w * t) for s, w in zip(sin, omega)) + sum(c * np.cos(w * t) for c, w in zip(cos, omega))
        return of.get("const", 0.0) + parts

    return at


def slope_of(system, eps):
    """The equation of motion: coordinates, velocities, and the forces of the elastic contacts."""
    mass = np.array(system["mass"], dtype=float)
    n, inverse = len(mass), np.linalg.inv(mass)
    damping = np.array(system.get("damping", np.zeros((n, n))), dtype=float)
    stiffness = np.array(system.get("stiffness", np.zeros((n, n))), dtype=float)
    harmonics, record = system.get("harmonics", []), system.get("record")
    elements = system.get("elements", [])
    zero = np.zeros(n)
    loads = [(h["frequency"], numbers(h.get("sin", zero)), numbers(h.get("cos", zero))) for h in harmonics]
    constant = numbers(system.get("constant", zero))
    belts = [signal(e.get("belt", 0.0), harmonics) for e in elements]
    normals = [signal(e.get("normal", 1.0), harmonics) for e in elements]
    directions = [numbers(e["direction"]) for e in elements]
    if record:
        times, values = numbers(record["times"]), numbers(record["values"])

    calls = 0

    def slope(t, z):
        nonlocal calls
        calls += 1
        if calls > MOST:
            raise TimeoutError
        q, v, tensions = z[:n], z[n : 2 * n], z[2 * n :]
        force = constant - damping @ v - stiffness @ q
        for omega, sin, cos in loads:
            force = force + sin * np.sin(omega * t) + cos * np.cos(omega * t)
        if record:
            force = force + numbers(record["force"]) * np.interp(t, times, values, left=0.0, right=0.0)
        rates, held = [], 0
        for e, b, belt, normal in zip(elements, directions, belts, normals):
            y, speed = b @ q, b @ v - belt(t)
            if e["type"] == "contact":
                law = np.array(e.get("law", [[0, e.get("friction", 0)]]), dtype=float)
                load = normal(t)
                if isinstance(e.get("normal"), dict):
                    load = max(load + numbers(e["normal"].get("displacement", zero)) @ q, 0.0)
                # Static friction above the kinetic one cannot be smoothed.
                friction = np.interp(abs(speed), law[:, 0], law[:, 1]) * load * np.tanh(speed / eps)
            elif e["type"] == "elastic":
                friction = np.clip(tensions[held], -e["friction"], e["friction"])
                yields = abs(tensions[held]) >= e["friction"] and tensions[held] * speed > 0
                rates.append(0.0 if yields else e["stiffness"] * speed)
                held += 1
            else:
                side = e.get("side", 1)
                pushed = e["stiffness"] * (side * y - e["gap"]) + e.get("damping", 0.0) * side * speed
                friction = side * max(pushed, 0.0) if side * y > e["gap"] else 0.0
            force = force - b * friction
        return np.concatenate([v, inverse @ force, rates])

    return slope, n + n + sum(e["type"] == "elastic" for e in elements)


def by_scipy(case, setting):
    system, run = case["system"], case["run"]
    part, options = SETTINGS[setting]
    n = len(system["mass"])
    greatest = max(1e-3, max((abs(float(x)) for x in case["answer"].get("max", [1.0])), default=1.0))
    slope, size = slope_of(system, part * greatest)
    state = np.zeros(size)
    if run["kind"] == "transient":
        state[:n], state[n : 2 * n] = numbers(run.get("displacement", [0] * n)), numbers(run.get("velocity", [0] * n))
        span = (0.0, run["until"])
    elif size == 2 * n:
        state[:] = numbers(case["answer"]["start"])[:size]
        span = (0.0, PERIODS * run["period"])
    else:
        span = (0.0, FROM_REST * run["period"])
    try:
        found = solve_ivp(slope, span, state, method="LSODA", **options)
    except TimeoutError:
        return np.full(2 * n, np.nan)
    return found.y[: 2 * n, -1] if found.success else np.full(2 * n, np.nan)


def by_stickslip(case, _):
    fields = {name: value for name, value in case["system"].items() if name not in ("name", "source", "about", "run")}
    run = case["run"]
    if run["kind"] == "transient" and "start" not in fields and "displacement" in run:
        fields["start"] = {"displacement": run["displacement"], "velocity": run["velocity"]}
    system = ss.System(**fields)
    if run["kind"] == "transient":
        motion = system.simulate(run["until"])
        return np.concatenate([motion.end_displacement, motion.end_velocity])
    steady = system.steady()
    return np.concatenate([steady.start_displacement, steady.start_velocity])


def main(file):
    with open(file, encoding="utf-8") as opened:
        cases = json.load(opened)[:20]
    print("| tool | within 10⁻² | within 10⁻⁴ | within 10⁻⁶ | time |\n|---|---|---|---|---|")
    for name, solve, setting in (
        ("stickslip", by_stickslip, ""),
        ("SciPy, LSODA, smoothed, default", by_scipy, "default"),
        ("SciPy, LSODA, smoothed, tight", by_scipy, "tight"),
    ):
        errors, begin = [], time.process_time()
        for case in cases:
            answer = case["answer"]
            if case["run"]["kind"] == "transient":
                due = np.concatenate([numbers(answer["displacement"]), numbers(answer["velocity"])])
            else:
                due = numbers(answer["start"])
            found = solve(case, setting)
            errors.append(np.abs(found - due[: len(found)]).max() / np.abs(due).max())
            print(f"{name}: {case['name']}: {errors[-1]:.1e}", file=sys.stderr)
        spent = time.process_time() - begin
        counts = [sum(error < bound for error in errors) for bound in (1e-2, 1e-4, 1e-6)]
        print(f"| {name} | {counts[0]} | {counts[1]} | {counts[2]} | {spent:.2g} s |", flush=True)


if __name__ == "__main__":
    main(sys.argv[1])
