#!/usr/bin/env python3
"""Fifteen questions about drives and loads, each with its files, its command and the values of an independent computation, in tests/data/questions.json.

    python3 tests/data/questions.py           # needs numpy and scipy; `.ci/slow references` runs it: fails where a value differs
    python3 tests/data/questions.py --write

Motions are followed by DOP853 at 1e-12 between events, which are zeros by Brent's method. Values that a line gives are given by that line.
"""

import json
import math
import pathlib
import sys

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

G = 9.80665
TAU = 2 * math.pi


def solve(rate, span, z, ends, longest):
    """Until a guard of `ends` falls through zero, or the end: the time, the state and the guard's place."""
    def watched(guard):
        def event(t, state):
            return guard(t, state)
        event.terminal, event.direction = True, -1
        return event
    done = solve_ivp(rate, span, z, "DOP853", rtol=1e-12, atol=1e-13, max_step=longest, dense_output=True, events=[watched(g) for g in ends])
    if done.status == 0:
        return done.t[-1], done.y[:, -1], None
    which = next(i for i, times in enumerate(done.t_events) if len(times))
    t, early = done.t[-1], max(span[0], done.t[-1] - longest / 4)
    guard = lambda time: ends[which](time, done.sol(time))
    if guard(early) > 0 > guard(t):
        t = brentq(guard, early, t, xtol=1e-15, rtol=4e-15)
    return t, done.sol(t), which


class Sliding:
    """Bodies with one rigid contact: M q'' + C q' + K q = f(t) - b T, |T| <= bound(t, speed)."""

    def __init__(self, mass, damping, stiffness, direction, force, bound, longest):
        self.mass, self.damping, self.stiffness, self.b = map(np.array, (mass, damping, stiffness, direction))
        self.force, self.bound, self.longest = force, bound, longest

    def free(self, t, z):
        n = len(self.mass)
        return self.force(t) - self.damping @ z[n:] - self.stiffness @ z[:n]

    def held(self, t, z):
        """The force that keeps the contact at rest."""
        return (self.b / self.mass) @ self.free(t, z) / ((self.b / self.mass) @ self.b)

    def follow(self, z, start, until, breaks=(), events=None):
        n, t, z = len(self.mass), start, np.array(z, float)
        slip = lambda state: self.b @ state[n:]
        mode = float(np.sign(slip(z)))
        stops = [x for x in breaks if start < x < until] + [until]
        fresh = mode == 0
        while stops:
            if fresh:
                force = self.held(t, z)
                mode = float(np.sign(force)) if abs(force) > self.bound(t, 0.0) * (1 + 1e-14) else 0.0
                fresh = False
            def tension(time, state):
                return mode * self.bound(time, abs(slip(state))) if mode else self.held(time, state)
            def rate(time, state):
                return np.concatenate([state[n:], (self.free(time, state) - self.b * tension(time, state)) / self.mass])
            guards = [lambda time, state: mode * slip(state) + (1e-13 if time < t + 1e-9 else 0)] if mode else [
                lambda time, state: self.bound(time, 0.0) - self.held(time, state), lambda time, state: self.bound(time, 0.0) + self.held(time, state)]
            before = t
            t, z, which = solve(rate, (t, stops[0]), z, guards, self.longest)
            if which is None:
                stops.pop(0)
                # A load may jump there.
                fresh = mode == 0
                continue
            old = mode
            if mode:
                # The velocity of the contact is 0 there.
                z[n:] -= slip(z) * self.b / self.mass / ((self.b / self.mass) @ self.b)
                force = self.held(t, z)
                mode = float(np.sign(force)) if abs(force) > self.bound(t, 0.0) else 0.0
            else:
                mode = (1.0, -1.0)[which]
                z[n:] += mode * 1e-15 * self.b
            if events is not None:
                events.append((t, old, mode))
            if t <= before:
                raise ArithmeticError(f"no step at {t}")
        return z


def one(mass, friction, force, period, damping=0.0, stiffness=0.0, breaks=(), periods=60):
    """The way in the last of some periods from rest, and the extremes and the dissipation of that period."""
    body = Sliding([mass], [[damping]], [[stiffness]], [1.0], lambda t: np.array([force(t)]), lambda t, _: friction(t), period / 40)
    z = np.zeros(2)
    for i in range(periods):
        before = z[0]
        cuts = [i * period + x for x in breaks]
        z = body.follow(z, i * period, (i + 1) * period, cuts)
    return z[0] - before


def named(masses, contacts, rest=""):
    return f'units = "N,m"\nmasses = {masses}\n{contacts}{rest}'


def contact(name, bodies, fields):
    return f'[[contacts]]\nname = "{name}"\nbetween = [{bodies}]\n{fields}\n'


def swept():
    first, last, long, level, mu = 1.0, 12.0, 6.0, 0.4 * G, 0.2
    growth = math.log(last / first)
    wave = lambda t: level * math.sin(TAU * first * long / growth * math.expm1(t / long * growth)) if t < long else 0.0
    body = Sliding([1.0], [[0.0]], [[0.0]], [1.0], lambda t: np.array([-wave(t)]), lambda t, _: mu * G, 0.004)
    z = body.follow([0.0, 0.0], 0.0, long)
    file = named('{ block = 1 }', contact("table", '"ground", "block"', f"coefficient = {mu}\nnormal_load = {G}"),
                 f'[base]\nacceleration = {{ amplitude = "0.4 g", sweep = {{ from = "{first} Hz", to = "{last} Hz", duration = "{long} s", log = true, tolerance = 1e-7 }} }}\n')
    return ("a block on a table that sweeps its frequency", {"sweep.toml": file}, f"system sweep.toml simulate --until {long}s",
            {"/end/displacement/0": (z[0], 1e-6), "/end/velocity/0": (z[1], 1e-6)})


def truck():
    file = named('{ box = 20 }', contact("bed", '"ground", "box"', f"coefficient = 0.25\nnormal_load = {20 * G}"), '[base]\nacceleration = "-4 m/s^2"\n')
    time = math.sqrt(2 * 2 / (4 - 0.25 * G))
    return ("a box slides off a truck after 2 m", {"truck.toml": file}, "system truck.toml simulate --until box=2m", {"/duration": (time, 1e-12), "/end/velocity/0": (math.sqrt(2 * 2 * (4 - 0.25 * G)), 1e-12)})


def held():
    return ("the least friction that holds a crate", {}, "design hold --no-spring --base-acceleration 3m/s^2 --quiet", {"/static_friction_coefficient": (3 / G, 1e-14)})


def skids():
    push = lambda t: 0.04 * (TAU * 25) ** 2 * math.sin(TAU * 25 * t) + 29.4
    drift = one(300.0, lambda _: 0.15 * 300 * G, push, 0.04)
    return ("how far a machine walks on its skids", {}, "steady --no-spring --mass 300kg --friction-coefficient 0.15 --mean-force 29.4N --unbalance 0.04kg*m --frequency 25Hz --units N,m",
            {"/drift/0": (drift, 1e-12), "/mean_velocity/0": (drift / 0.04, 1e-10)})


def wear():
    amplitude, friction = 0.04 * (TAU * 25) ** 2, 0.15 * 300 * G
    body = Sliding([300.0], [[0.0]], [[0.0]], [1.0], lambda t: np.array([amplitude * math.sin(TAU * 25 * t)]), lambda t, _: friction, 0.001)
    z = body.follow([0.0, 0.0], 0.0, 40 * 0.04)
    events, states = [], [z[0]]
    body.follow(z, 1.6, 1.64, (), events)
    # The way between reversals, by the same motion again.
    t = 1.6
    for time, *_ in events:
        z = body.follow(z, t, time)
        states.append(z[0])
        t = time
    states.append(body.follow(z, t, 1.64)[0])
    path = sum(abs(b - a) for a, b in zip(states, states[1:]))
    return ("which power wears the skids", {}, "steady --no-spring --mass 300kg --friction-coefficient 0.15 --unbalance 0.04kg*m --frequency 25Hz --units N,m",
            {"/physical/energy_out": (friction * path, 1e-8)})


def harmonics():
    drift = one(1.0, lambda _: 0.2 * 9.81, lambda t: 6 * math.sin(TAU * 10 * t) + 6 * math.cos(TAU * 20 * t), 0.1)
    forces = "".join(f'[[forces]]\non = "mass"\namplitude = 6\nfrequency = "{f} Hz"\nphase = "{p} deg"\n' for f, p in ((10, 0), (20, 90)))
    file = named("{ mass = 1 }", contact("plate", '"ground", "mass"', "coefficient = 0.2\nnormal_load = 9.81"), forces)
    return ("the drift under two harmonics", {"two.toml": file}, "system two.toml steady", {"/drift/0": (drift, 1e-11)})


def conveyor():
    level = 0.002 * (TAU * 15) ** 2
    along, up = level * math.cos(math.radians(25)), level * math.sin(math.radians(25))
    wave = lambda t: math.sin(TAU * 15 * t)
    drift = one(1.0, lambda t: 0.4 * (9.81 - up * wave(t)), lambda t: along * wave(t), 1 / 15)
    file = named("{ part = 1 }", contact("track", '"ground", "part"', f'coefficient = 0.4\nnormal_load = {{ constant = 9.81, amplitude = {up!r}, frequency = "15 Hz", phase = "180 deg" }}'),
                 f'[base]\nacceleration = {{ amplitude = {along!r}, frequency = "15 Hz", phase = "180 deg" }}\n')
    return ("the speed of a vibratory conveyor", {"conveyor.toml": file}, "system conveyor.toml steady", {"/mean_velocity/0": (15 * drift, 1e-10)})


def jerks():
    drift = one(1.0, lambda _: 0.5 * G, lambda t: (-0.3 if t % 0.08 < 0.06 else 0.9) * G, 0.08, breaks=(0.06,))
    file = named("{ part = 1 }", contact("track", '"ground", "part"', f"coefficient = 0.5\nnormal_load = {G}"), '[base]\nacceleration = { file = "cycle.csv", repeats = true }\n')
    cycle = "time[s],acceleration[g]\n0,0.3\n0.06,0.3\n0.06,-0.9\n0.08,-0.9\n"
    return ("a jerk conveyor by its measured cycle", {"jerks.toml": file, "cycle.csv": cycle}, "system jerks.toml steady", {"/drift/0": (drift, 1e-11)})


def record(count, step, shape):
    return [(i * step, round(shape(i * step), 6)) for i in range(count)]


def pendulum(storeys):
    """On friction pendulums of 2 m under a horizontal and a vertical record; above a slab storeys on springs."""
    step, mu = 0.05, 0.06
    across = record(101, step, lambda t: 0.25 * math.exp(-((t - 2) / 1.2) ** 2) * math.sin(9 * t))
    up = record(101, step, lambda t: 0.2 * math.exp(-((t - 1.8) / 1.0) ** 2) * math.cos(23 * t))
    mass, spring, damper = 1000.0, 4e5, 1500.0
    weight = mass * (1 + storeys) * G
    n = 1 + storeys
    K, C = np.zeros((n, n)), np.zeros((n, n))
    K[0, 0] = weight / 2
    for i in range(1, n):
        b = np.zeros(n)
        b[i], b[i - 1] = 1, -1
        K += spring * np.outer(b, b)
        C += damper * np.outer(b, b)
    at = lambda rows, t: np.interp(t, [row[0] for row in rows], [row[1] for row in rows])
    b = np.zeros(n)
    b[0] = 1
    body = Sliding([mass] * n, C, K, b, lambda t: np.full(n, -mass * G * at(across, t)), lambda t, _: mu * weight * (1 + at(up, t)), 0.02)
    z = body.follow(np.zeros(2 * n), 0.0, 5.0, [row[0] for row in across])
    names = ["slab"] + [f"storey{i}" for i in range(1, n)]
    springs = f'[[springs]]\nbetween = ["ground", "slab"]\nstiffness = {weight / 2!r}\n' + "".join(
        f'[[springs]]\nbetween = ["{a}", "{b}"]\nstiffness = {spring}\ndamping = {damper}\n' for a, b in zip(names, names[1:]))
    load = f'{{ constant = {weight / (2 if storeys else 1)!r}, vertical = {{ file = "up.csv" }} }}'
    bearings = "".join(contact(name, '"ground", "slab"', f"coefficient = {mu}\nnormal_load = {load}") for name in (("left", "right") if storeys else ("bearing",)))
    file = named("{ " + ", ".join(f"{name} = {mass}" for name in names) + " }", springs + bearings, '[base]\nacceleration = "across.csv"\n')
    csv = lambda rows: "time[s],acceleration[g]\n" + "".join(f"{t:.2f},{a:.6f}\n" for t, a in rows)
    values = {f"/end/displacement/{i}": (z[i], 1e-9) for i in range(n)} | {f"/end/velocity/{i}": (z[n + i], 1e-8) for i in range(n)}
    what = "five storeys on two friction pendulums" if storeys else "a friction pendulum under a vertical record"
    name = "five.toml" if storeys else "pendulum.toml"
    return (what, {name: file, "across.csv": csv(across), "up.csv": csv(up)}, f"system {name} simulate --until 5s", values)


def triple():
    """Three springs with sliders behind each other, whose joints have no mass, under an imposed way: each turns by what is beyond its friction."""
    k, r, amplitude = (2600.0, 9400.0, 2600.0), (20.0, 12.0, 75.0), 0.06
    way = lambda force: sum(max(0.0, force - own) / stiffness for own, stiffness in zip(r, k))
    top = brentq(lambda force: way(force) - amplitude, 0.0, 1e4, xtol=1e-13)
    parts = [max(0.0, top - own) / stiffness for own, stiffness in zip(r, k)]
    bodies = ('"ground", "low"', '"low", "high"', '"high", "plate"')
    file = named(f'{{ low = 0, high = 0, plate = {{ moves = {{ displacement = {{ amplitude = {amplitude}, frequency = 0.7 }} }} }} }}',
                 "".join(f"[[springs]]\nbetween = [{own}]\nstiffness = {stiffness}\n" + contact(f"slide{i}", own, f"friction = {friction}") for i, (own, stiffness, friction) in enumerate(zip(bodies, k, r))))
    values = {f"/elements/{i}/work": (4 * own * part, 1e-10) for i, (own, part) in enumerate(zip(r, parts))} | {"/max_displacement/0": (parts[0], 1e-12)}
    return ("a triple pendulum without links of mass", {"triple.toml": file}, "system triple.toml steady", values)


def squeal():
    mass, damping, stiffness = np.eye(2), 0.02 * np.eye(2), np.array([[7.0, -2.0], [-2.0, 5.0]])
    def growth(mu):
        # The pad slides against the belt: its friction -mu (1 - 3 q2) acts on q1 in the belt's direction.
        own = stiffness + mu * np.array([[0.0, 3.0], [0.0, 0.0]])
        best = max(np.linalg.eigvals(np.block([[np.zeros((2, 2)), np.eye(2)], [-own, -damping]])), key=lambda x: x.real)
        return best.real, abs(best.imag)
    threshold = brentq(lambda mu: growth(mu)[0], 0.7, 1.0, xtol=1e-14)
    file = {"mass": mass.tolist(), "damping": damping.tolist(), "stiffness": stiffness.tolist(),
            "elements": [{"type": "contact", "name": "pad", "direction": [1, 0], "friction": 0.7, "belt": 5, "normal": {"const": 1, "displacement": [0, -3]}}]}
    return ("from which friction on two modes squeal", {"squeal.json": json.dumps(file)}, "system squeal.json", {"/sliding/threshold/coefficient": (threshold, 1e-8), "/sliding/threshold/frequency": (growth(threshold)[1], 1e-7)})


def drill():
    low, high, rate = 7572.3797625, 12115.80762, 0.9
    body = Sliding([2122.0, 471.9698], [[564.6, -139.6], [-139.6, 189.6]], [[698.0, -698.0], [-698.0, 698.0]], [0.0, 1.0],
                   lambda t: np.array([10000.0, 0.0]), lambda t, v: low + (high - low) * math.exp(-rate * v), 0.05)
    events = []
    body.follow(np.zeros(4), 0.0, 150.0, (), events)
    rests = [t for t, old, new in events if old and not new]
    # The law is a table in the program, which prints the digits that are known: 5.8463 s.
    file = named("{ top = 2122, bit = 471.9698 }",
                 '[[springs]]\nbetween = ["top", "bit"]\nstiffness = 698\ndamping = 139.6\n[[springs]]\nbetween = ["ground", "top"]\ndamping = 425\n[[springs]]\nbetween = ["ground", "bit"]\ndamping = 50\n'
                 + contact("rock", '"ground", "bit"', f"law = {{ kinetic = {low}, static = {high}, speed = {1 / rate!r}, exponent = 1 }}"), '[[forces]]\non = "top"\nconstant = 10000\n')
    return ("a drill string sticks and slips", {"drill.toml": file}, "system drill.toml steady --law-tolerance 0.02N", {"/period": (rests[-1] - rests[-2], 5e-5)})


def blade():
    m, c, k, kd, mu, omega = 0.05, 0.5, 2e5, 8e4, 0.3, TAU * 320
    normal = lambda t: 40 + 60 * math.cos(omega * t)
    slope = lambda t: -60 * omega * math.sin(omega * t)
    period = TAU / omega
    z, t, mode, marks = np.zeros(3), 0.0, "hold", []
    until = 260 * period
    while t < until:
        def rate(time, state):
            x, v, force = state
            tension = {"hold": force, "open": 0.0, "up": mu * normal(time), "down": -mu * normal(time)}[mode]
            return [v, (10 * math.sin(omega * time) - c * v - k * x - tension) / m, kd * v if mode == "hold" else 0.0]
        guards = {
            "hold": [lambda time, s: mu * normal(time) - s[2], lambda time, s: mu * normal(time) + s[2]],
            "open": [lambda time, s: -normal(time)],
            "up": [lambda time, s: normal(time), lambda time, s: kd * s[1] - mu * slope(time)],
            "down": [lambda time, s: normal(time), lambda time, s: -kd * s[1] - mu * slope(time)],
        }[mode]
        t, z, which = solve(rate, (t, until), z, guards, period / 60)
        if which is None:
            break
        old = mode
        if mode == "hold":
            mode = ("up", "down")[which]
            marks.append((t, "yield"))
        elif mode == "open":
            mode, z[2] = "hold", 0.0
            marks.append((t, "close"))
            # It closes without a force: it holds or yields as its bound grows.
            if abs(kd * z[1]) > mu * slope(t):
                mode = "up" if z[1] > 0 else "down"
        elif which == 0:
            mode, z[2] = "open", 0.0
            marks.append((t, "open"))
        else:
            z[2] = mu * normal(t) * (1 if mode == "up" else -1)
            mode = "hold"
            marks.append((t, "lock"))
    last = [(time - 259 * period, kind) for time, kind in marks if time >= 259 * period]
    file = 'units = "N,m"\nmasses = { blade = 0.05 }\n[[springs]]\nbetween = ["ground", "blade"]\nstiffness = 2e5\ndamping = 0.5\n' + contact(
        "platform", '"ground", "blade"', 'coefficient = 0.3\nstiffness = 8e4\nnormal_load = { constant = 40, amplitude = 60, frequency = "320 Hz", phase = "90 deg" }') + '[[forces]]\non = "blade"\namplitude = 10\nfrequency = "320 Hz"\n'
    values = {"/start/displacement/0": (z[0], 1e-10), "/start/velocity/0": (z[1], 1e-7)} | {f"/events/{i}/time": (time, 1e-9) for i, (time, _) in enumerate(last)}
    return ("the platform under a blade", {"blade.toml": file}, "system blade.toml steady", values)


def imposed():
    k, friction, amplitude = 300.0, 40.0, 0.12
    file = named(f'{{ plate = {{ moves = {{ displacement = {{ amplitude = {amplitude}, frequency = "0.5 Hz" }} }} }} }}',
                 f'[[springs]]\nbetween = ["ground", "plate"]\nstiffness = {k}\n' + contact("bearing", '"ground", "plate"', f"friction = {friction}"))
    return ("the loop of a bearing at an imposed displacement", {"bearing.toml": file}, "system bearing.toml steady", {"/elements/0/work": (4 * friction * amplitude, 1e-11), "/load_work": (4 * friction * amplitude, 1e-11)})


QUESTIONS = [swept, truck, held, skids, wear, harmonics, conveyor, jerks, lambda: pendulum(0), lambda: pendulum(5), triple, squeal, drill, blade, imposed]


def main():
    found = []
    for question in QUESTIONS:
        what, files, line, values = question()
        found.append({"question": what, "files": files, "command": line, "values": {place: list(value) for place, value in values.items()}})
    file = pathlib.Path(__file__).with_suffix(".json")
    if "--write" in sys.argv:
        file.write_text(json.dumps(found, indent=1) + "\n")
        return
    for own, kept in zip(found, json.loads(file.read_text()), strict=True):
        for place, (value, bound) in own["values"].items():
            if abs(value - kept["values"][place][0]) > bound:
                sys.exit(f"{own['question']}: {place} {value} for {kept['values'][place][0]}")
    print(f"{len(found)} questions have their values")


if __name__ == "__main__":
    main()
