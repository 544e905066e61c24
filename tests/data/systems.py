#!/usr/bin/env python3
"""Recomputes the answers of tests/data/systems.json, and fails where one differs from the file.

    python3 tests/data/systems.py        # needs numpy and scipy; `.ci/slow references` runs it

Between events a system is linear: z' = A z for the state z = (q, q', forces of the elastic contacts, sine and cosine of
each load, value and slope of the record, 1). A step is the Taylor series of z. An event is the first zero of a guard, a row that
is positive on z until then: it is bracketed on the polynomial of a step, and refined by Brent's method. After an event the ways of the contacts
whose velocity is zero are tried, those that stick most first. Steady motions are followed from rest period by period, until
the state repeats; nothing is extrapolated, and no closed form of a slide is used.
"""

import itertools
import json
import pathlib
import sys

import numpy as np
from scipy.optimize import brentq

TERMS = 24  # of the Taylor series of a step
STEPS = 40  # in the shortest period of a mode
SHARES = np.linspace(0.0, 1.0, 9)
POWERS = SHARES[:, None] ** np.arange(TERMS)


class Doubtful(Exception):
    """The program cannot decide what a system does next."""


def value(polynomial, t):
    return np.polynomial.polynomial.polyval(t, polynomial)


def first_zero(polynomial):
    """The first time in (0, 1] at which a guard that is positive falls to 0. At the start it may be zero and rise."""
    size = np.abs(polynomial).sum()
    lowest = next((n for n, c in enumerate(polynomial) if abs(c) > 1e-13 * size), None) if size else None
    if lowest is None or polynomial[lowest] < 0:
        return 0.0 if lowest is not None else None
    rest = polynomial[lowest:]
    values = POWERS[:, : len(rest)] @ rest
    slopes = rest[1:] * np.arange(1, len(rest))
    before = 0.0
    for share, at in zip(SHARES[1:], values[1:]):
        if at <= 0:
            return brentq(lambda t: value(rest, t), before, share, xtol=1e-16, rtol=1e-15)
        # A dip between two samples.
        if value(slopes, before) < 0 < value(slopes, share):
            turn = brentq(lambda t: value(slopes, t), before, share, xtol=1e-16)
            if value(rest, turn) <= 0:
                return brentq(lambda t: value(rest, t), before, turn, xtol=1e-16, rtol=1e-15)
        before = share
    return None


class System:
    def __init__(self, model, constant=None, one_way=False):
        self.M = np.array(model["mass"], dtype=float)
        n = self.n = len(self.M)
        self.inverse = np.linalg.inv(self.M)
        self.elements, self.one_way = model["elements"], one_way
        self.elastic = [i for i, e in enumerate(self.elements) if e["type"] == "elastic"]
        self.contacts = [i for i, e in enumerate(self.elements) if e["type"] == "contact"]
        self.loads = 2 * n + len(self.elastic)
        harmonics = model.get("harmonics", [])
        self.record = model.get("record")
        self.d = d = self.loads + 2 * len(harmonics) + 3
        self.force, self.turn, self.phases = np.zeros((n, d)), np.zeros((d, d)), []
        self.force[:, :n] = -np.array(model["stiffness"], dtype=float)
        self.force[:, n : 2 * n] = -np.array(model["damping"], dtype=float)
        if constant is not None:
            self.force[:, -1] = constant
        if self.record:
            self.force[:, -3] = self.record["force"]
            self.turn[-3, -2] = 1.0
        for k, harmonic in enumerate(harmonics):
            i, w = self.loads + 2 * k, harmonic["frequency"]
            self.turn[i, i + 1], self.turn[i + 1, i] = w, -w
            self.force[:, i] += harmonic.get("sin", [0.0] * n)
            self.force[:, i + 1] += harmonic.get("cos", [0.0] * n)
            self.phases.append(w)
        stiff = -self.force[:, :n] + sum(
            e.get("stiffness", 0.0) * np.outer(e["direction"], e["direction"]) for e in self.elements
        )
        damp = np.abs(self.inverse @ self.force[:, n : 2 * n]).sum() + sum(
            e.get("damping", 0.0) * np.abs(self.inverse).sum() for e in self.elements
        )
        rates = np.sqrt(np.abs(np.linalg.eigvals(self.inverse @ stiff)))
        self.step = 2 * np.pi / STEPS / max([*rates, damp, *self.phases, 1e-3])
        self.modes, self.scale = {}, np.ones(d)

    def unit(self, place):
        row = np.zeros(self.d)
        row[place] = 1.0
        return row

    def velocity(self, i):
        """The velocity of an element's ends over each other."""
        row = np.zeros(self.d)
        row[self.n : 2 * self.n] = np.array(self.elements[i]["direction"]) * self.elements[i].get("side", 1)
        row[-1] = -self.elements[i].get("belt", {}).get("const", 0.0)
        return row

    def normal(self, i):
        """The normal load as a row, in its nominal value."""
        given = self.elements[i].get("normal", {"const": 1.0})
        row = given.get("const", 1.0) * self.unit(-1)
        for k, part in enumerate(given.get("sin", [])):
            row[self.loads + 2 * k] += part
        for k, part in enumerate(given.get("cos", [])):
            row[self.loads + 2 * k + 1] += part
        return row

    def law(self, i):
        """Pieces of the friction law: the lowest speed, the friction at speed 0 of its line, the slope."""
        points = self.elements[i].get("law") or [[0.0, self.elements[i]["friction"]]]
        if len(points) == 1:
            return [(0.0, points[0][1], 0.0)]
        pieces = []
        for (v0, r0), (v1, r1) in zip(points, points[1:]):
            slope = (r1 - r0) / (v1 - v0)
            pieces.append((v0, r0 - slope * v0, slope))
        return pieces

    def beyond(self, i):
        row = np.zeros(self.d)
        row[: self.n] = np.array(self.elements[i]["direction"]) * self.elements[i].get("side", 1)
        row[-1] = -self.elements[i]["gap"]
        return row

    def pressed(self, i):
        e = self.elements[i]
        return e["stiffness"] * self.beyond(i) + e.get("damping", 0.0) * self.velocity(i)

    def row(self, i, mode):
        """The force that an element exerts against its velocity; None for a contact at rest."""
        e = self.elements[i]
        if e["type"] == "elastic":
            return self.unit(2 * self.n + self.elastic.index(i))
        if e["type"] == "stop":
            return self.pressed(i) if mode[i] == 1 else np.zeros(self.d)
        if mode[i] == 0:
            return None
        sign = 1 if mode[i] > 0 else -1
        _, level, slope = self.law(i)[abs(mode[i]) - 1]
        if slope:
            return sign * level * self.unit(-1) + slope * self.velocity(i)
        return sign * level * self.normal(i)

    def direction(self, i):
        return np.array(self.elements[i]["direction"], dtype=float) * self.elements[i].get("side", 1)

    def bound(self, i):
        return self.elements[i].get("peak", 1.0) * self.law(i)[0][1] * self.normal(i)

    def mode(self, mode):
        """The matrix of a mode, the forces of contacts at rest, and the guards with what follows when they fall to 0."""
        if mode in self.modes:
            return self.modes[mode]
        n, force, resting = self.n, self.force.copy(), []
        for i in range(len(self.elements)):
            row = self.row(i, mode)
            if row is None:
                resting.append(i)
            else:
                force -= np.outer(self.direction(i), row)
        holds = {}
        if resting:
            B = np.array([self.direction(i) for i in resting])
            hold = np.linalg.solve(B @ self.inverse @ B.T, B @ self.inverse @ force)
            force -= B.T @ hold
            holds = dict(zip(resting, hold))
        A = self.turn.copy()
        A[:n, n : 2 * n] = np.eye(n)
        A[n : 2 * n] = self.inverse @ force
        guards = []
        for i, e in enumerate(self.elements):
            speed = self.velocity(i)
            if e["type"] == "contact" and mode[i] == 0:
                guards.append((self.bound(i) - holds[i], ("slip", i, 1)))
                if not self.one_way:
                    guards.append((self.bound(i) + holds[i], ("slip", i, -1)))
            elif e["type"] == "contact":
                sign, piece = (1 if mode[i] > 0 else -1), abs(mode[i]) - 1
                pieces = self.law(i)
                if piece == 0:
                    guards.append((sign * speed, ("zero", i, 0)))
                else:
                    guards.append((sign * speed - pieces[piece][0] * self.unit(-1), ("law", i, sign * piece)))
                if piece + 1 < len(pieces):
                    guards.append((pieces[piece + 1][0] * self.unit(-1) - sign * speed, ("law", i, sign * (piece + 2))))
            elif e["type"] == "elastic":
                place = 2 * n + self.elastic.index(i)
                if mode[i] == 0:
                    A[place] = e["stiffness"] * speed
                    for sign in (1, -1):
                        guards.append((e["friction"] * self.unit(-1) - sign * self.unit(place), ("yield", i, sign)))
                else:
                    guards.append((mode[i] * speed, ("lock", i, 0)))
            elif mode[i] == 1:
                guards.append((self.pressed(i), ("open", i, 2)))
            elif mode[i] == 0:
                guards.append((-self.beyond(i), ("close", i, 1)))
            else:
                # The damper has let go of it, beyond the gap.
                guards += [(self.beyond(i), ("back", i, 0)), (-self.pressed(i), ("close", i, 1))]
        rows = np.array([row for row, _ in guards]) if guards else np.zeros((0, self.d))
        self.modes[mode] = A, holds, rows, [label for _, label in guards]
        return self.modes[mode]

    def ways(self, z, mode, forced):
        """The ways of the contacts without velocity, and of those that have just slipped."""
        size = max(1e-300, self.scale[self.n : 2 * self.n].max())
        still = [i for i in self.contacts if i in forced or abs(self.velocity(i) @ z) <= 1e-11 * size]
        options = [(forced[i],) if i in forced and forced[i] else (0, 1, -1) for i in still]
        for ways in sorted(itertools.product(*options), key=lambda ways: sum(map(abs, ways))):
            tried = list(mode)
            for i, way in zip(still, ways):
                tried[i] = way
            A, holds, *_ = self.mode(tuple(tried))
            slope = A @ z
            room = 1e-11 * np.abs(slope[self.n : 2 * self.n]).max() + 1e-13
            fits = all(
                (self.one_way and holds[i] @ z <= 0 or abs(holds[i] @ z) <= self.bound(i) @ z * (1 + 1e-11) + 1e-13)
                if way == 0
                else way * (self.velocity(i) @ slope) >= -room and not (self.one_way and way < 0)
                for i, way in zip(still, ways)
            )
            if fits:
                return tuple(tried)
        raise Doubtful("no way fits")

    def begin(self, displacement=None, velocity=None):
        z = np.zeros(self.d)
        z[-1] = 1.0
        if displacement is not None:
            z[: self.n], z[self.n : 2 * self.n] = displacement, velocity
        self.set_phase(z)
        self.scale = np.maximum(np.abs(z), 1e-6)
        mode = [0] * len(self.elements)
        for i in self.contacts:
            speed = self.velocity(i) @ z
            if speed:
                piece = sum(abs(speed) >= low for low, *_ in self.law(i))
                mode[i] = int(np.sign(speed)) * piece
        self.set_record(z, 0.0)
        return self.ways(z, mode, {}), z

    def set_phase(self, z, phases=None):
        for k, phase in enumerate(phases or [0.0] * len(self.phases)):
            z[self.loads + 2 * k], z[self.loads + 2 * k + 1] = np.sin(phase), np.cos(phase)

    def set_record(self, z, time):
        """The value and the slope of the record from a time on, and the time up to which they hold."""
        if not self.record:
            return np.inf
        times, values = self.record["times"], self.record["values"]
        after = next((k for k, t in enumerate(times) if t > time + 1e-12), None)
        if after is None:
            z[-3] = z[-2] = 0.0
            return np.inf
        slope = (values[after] - values[after - 1]) / (times[after] - times[after - 1])
        z[-3], z[-2] = values[after - 1] + slope * (time - times[after - 1]), slope
        return times[after]

    def follow(self, mode, z, length, seen=None):
        """The mode and the state after a time."""
        time, count = 0.0, 0
        until = self.set_record(z, 0.0)
        while time < length:
            h = min(self.step, length - time, until - time)
            A, _, rows, labels = self.mode(mode)
            terms = [z]
            for k in range(1, TERMS):
                terms.append(A @ terms[-1] * (h / k))
            terms = np.array(terms)
            hit = None
            if len(labels):
                polynomials = terms @ rows.T
                ends = POWERS @ polynomials
                size = np.abs(rows) @ self.scale
                for j in np.nonzero((ends <= 1e-9 * size).any(axis=0) | (np.diff(ends, axis=0) > 0).any(axis=0))[0]:
                    # What is rounding of the value and of its slope is zero.
                    polynomial = polynomials[:, j].copy()
                    steep = np.abs(rows[j]) @ np.abs(A) @ self.scale * h
                    polynomial[0] *= abs(polynomial[0]) > 1e-12 * size[j]
                    polynomial[1] *= abs(polynomial[1]) > 1e-13 * steep
                    share = first_zero(polynomial)
                    if share is not None and (hit is None or share < hit[0]):
                        hit = share, labels[j]
            share = hit[0] if hit else 1.0
            if seen:
                seen.step(self, mode, terms, share, h)
            z = share ** np.arange(TERMS) @ terms
            np.maximum(self.scale, np.abs(z), out=self.scale)
            time = time + share * h
            if hit:
                count += 1
                if count > 3000:
                    raise Doubtful("too many events")
                before, mode = mode, self.after(mode, z, hit[1])
                if seen:
                    seen.event(self, time, before, mode, hit[1])
            elif time >= until - 1e-12:
                time = until
                until = self.set_record(z, time)
        return mode, z

    def after(self, mode, z, label):
        kind, i, to = label
        new, forced = list(mode), {}
        if kind in ("slip", "zero"):
            forced[i] = to
            if kind == "zero":
                # The velocity is zero: without its rounding.
                b = self.direction(i)
                z[self.n : 2 * self.n] -= self.inverse @ b * (self.velocity(i) @ z) / (b @ self.inverse @ b)
                forced[i] = 0
        else:
            new[i] = to
            if kind == "yield":
                z[2 * self.n + self.elastic.index(i)] = to * self.elements[i]["friction"]
            if kind in ("law", "yield", "lock", "open", "back"):
                return tuple(new)
        return self.ways(z, new, forced)


class Seen:
    """Extremes, times at rest and events."""

    def __init__(self, system):
        n, count = 2 * system.n, len(system.elements)
        self.most, self.least = np.full(n, -np.inf), np.full(n, np.inf)
        self.rest, self.events = np.zeros(count), []

    def step(self, system, mode, terms, share, h):
        n = 2 * system.n
        ends = [terms[0, :n], share ** np.arange(TERMS) @ terms[:, :n]]
        slopes = terms[1:, :n] * np.arange(1, TERMS)[:, None]
        for j in np.nonzero(slopes[0] * (share ** np.arange(TERMS - 1) @ slopes) < 0)[0]:
            # A slope that is rounding has no zero of its own.
            if value(slopes[:, j], 0.0) * value(slopes[:, j], share) < 0:
                turn = brentq(lambda t: value(slopes[:, j], t), 0.0, share, xtol=1e-16)
                ends.append(ends[0].copy())
                ends[-1][j] = value(terms[:, j], turn)
        self.most = np.maximum(self.most, np.max(ends, axis=0))
        self.least = np.minimum(self.least, np.min(ends, axis=0))
        self.rest += [share * h * (m == 0) for m in mode]

    def event(self, system, time, before, after, label):
        kind, i, _ = label
        names = {"yield": "yield", "lock": "lock", "close": "close", "open": "open"}
        if kind in names:
            self.events.append((time, i, kind))
        for j in system.contacts:
            one, two = np.sign(before[j]), np.sign(after[j])
            if one != two:
                name = "slip" if one == 0 else "stick" if two == 0 else "reverse"
                self.events.append((time, j, name))


def steady(system, period, limit=3000):
    """The state at the beginning of a period that repeats, and what it has."""
    mode, z = system.begin()
    calm = 0
    for n in range(limit):
        before = z.copy()
        mode, z = system.follow(mode, z, period)
        system.set_phase(z)
        if n == 20:
            system.scale = np.maximum(0.2 * system.scale, np.abs(z))
        size = system.scale[: system.loads]
        calm = calm + 1 if (np.abs(z - before)[: system.loads] <= 1e-13 * size).all() else 0
        if calm == 3:
            break
    seen = Seen(system)
    start = z.copy()
    system.follow(mode, z, period, seen)
    return start, seen


def numbers(given):
    return np.array([float(x) for x in given])


def off(found, due, size=None):
    size = size or max(1e-300, np.abs(due).max(initial=0.0))
    return float(np.abs(np.asarray(found) - due).max(initial=0.0) / size)


def main():
    cases = json.loads((pathlib.Path(__file__).parent / "systems.json").read_text(encoding="utf-8"))
    chosen = sys.argv[1:]
    wrong = 0
    for case in cases:
        if chosen and case["name"] not in chosen:
            continue
        run, due = case["run"], case["answer"]
        system = System(case["system"])
        if run["kind"] == "steady":
            length = run["period"]
            z, seen = steady(system, length)
            state = off(z[: 2 * system.n], numbers(due["start"]))
            rests = off(seen.rest, numbers(due["at_rest"]), length)
        else:
            length = run["until"]
            mode, z = system.begin(run.get("displacement"), run.get("velocity"))
            seen, rests = Seen(system), 0.0
            _, z = system.follow(mode, z, length, seen)
            state = off(z[: 2 * system.n], np.concatenate([numbers(due["displacement"]), numbers(due["velocity"])]))
        extremes = max(off(seen.most, numbers(due["max"])), off(seen.least, numbers(due["min"])))
        events = sorted(seen.events)
        listed = [(float(t), i, kind) for t, i, kind in due["events"]]
        # The file has the first events where there are many.
        same = len(events) == due["event_count"] and [e[1:] for e in events[: len(listed)]] == [e[1:] for e in listed]
        times = off([e[0] for e in events[: len(listed)]], np.array([e[0] for e in listed]), length) if same else np.inf
        worst = max(state, extremes, rests, times)
        print(f"{case['name']}: state {state:.1e}, extremes {extremes:.1e}, rests {rests:.1e}, events {times:.1e}")
        # The falling law of the table of 50 points lets rounding grow by some 10⁵.
        if not worst <= 1e-10:
            wrong += 1
            print(f"  differs: {events[:12]} for {listed[:12]}", file=sys.stderr)
    print(f"{wrong} differ")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
