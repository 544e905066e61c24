#!/usr/bin/env python3
"""Long runs of 200 random machines with dry friction and end stops, followed from rest period by period.

    python3 tests/data/limits.py tests/data/limits.json    # needs numpy and scipy; takes minutes on two processors

The machine obeys M q'' + C q' + K q = f(t) - sum b T. Between events it is linear: z' = A z for the state
z = (q, q', forces of the elastic contacts, sine and cosine of each load, 1). The samples of the events' guards are
products with e^{Ah}; an event within a sample step is bracketed and refined on the Taylor series of the state.
The sticking set after an event is found by trying the sets, those that stick most first.

A machine is followed until the states at the ends of the load's periods repeat after m <= 16 periods within 1e-11 of
the motion's size. It is then followed further, until they repeat within 1e-13 or as many periods again have gone by.
Machines that do not repeat within LIMITS periods are dropped, and others are drawn. Nothing is extrapolated. The seeds
are the numbers of the machines, so that the file is the same each time, but for the last digits on other processors.

Fields of an answer: `periods` of the load in one `period` of the motion; the extremes of displacement and velocity
over one such period; `drift`, the displacement gained in one such `period`; `rest`, whether all bodies are at rest;
`followed`, the number of load periods followed. Without load (belts) a "period" is one of the lowest natural
frequency, the period of the motion is that of the limit cycle, and null for an equilibrium.
"""

import itertools
import json
import sys
from functools import lru_cache
from multiprocessing import Pool

import numpy as np
from scipy.linalg import expm
from scipy.optimize import brentq

COUNTS = {"frame": 60, "stop": 50, "belt": 30, "drift": 30, "parallel": 30}
LIMITS = {"frame": 20000, "stop": 2000, "belt": 1000, "drift": 20000, "parallel": 20000}  # periods
TERMS = 20  # of the Taylor series in a sample step
SAMPLES = 24  # in the shortest natural or load period of a branch
CHUNK = 48  # sample steps that are looked at together
FINE = np.linspace(0.0, 1.0, 17)
VANDERMONDE = FINE[:, None] ** np.arange(TERMS)
ORDERS = np.arange(TERMS)


class Doubtful(Exception):
    """The program cannot decide what the machine does next."""


def horner(coefficients, s):
    """The polynomial at s."""
    value = 0.0
    for c in reversed(coefficients):
        value = value * s + c
    return value


def first_root(coefficients, order, end):
    """The first zero in (0, end] of a polynomial in the share of the step that starts positive, after its zero of this order at 0."""
    shifted = coefficients[order:]
    values = VANDERMONDE[:, : len(shifted)] @ shifted
    if order and values[0] <= 0:
        return 0.0
    plain = shifted.tolist()

    def value(s):
        return horner(plain, s)

    last = len(FINE) - 1
    for i in range(last):
        low, high = FINE[i], FINE[i + 1]
        if low >= end:
            return None
        if values[i] <= 0:
            return low
        if values[i + 1] <= 0:
            root = brentq(value, low, high, xtol=1e-15, rtol=1e-14)
            return root if root <= end else None
    # A dip below zero between two of the fine samples.
    slope = (shifted[1:] * np.arange(1, len(shifted))).tolist()
    slopes = [horner(slope, s) for s in FINE]
    for i in range(last):
        if slopes[i] < 0 < slopes[i + 1]:
            low = brentq(lambda s: horner(slope, s), FINE[i], FINE[i + 1], xtol=1e-15)
            if value(low) < 0:
                root = brentq(value, FINE[i], low, xtol=1e-15, rtol=1e-14)
                return root if root <= end else None
    return None


class Law:
    """The friction force by speed: pieces (lowest speed, force at speed zero of the line, slope)."""

    def __init__(self, points):
        if len(points) == 1:
            self.pieces = [(0.0, points[0][1], 0.0)]
        else:
            self.pieces = []
            for (v0, r0), (v1, r1) in zip(points, points[1:]):
                slope = (r1 - r0) / (v1 - v0)
                self.pieces.append((v0, r0 - slope * v0, slope))
            _, level, slope = self.pieces[-1]
            if slope < 0:
                self.pieces.append((-level / slope, 0.0, 0.0))
        self.at_zero = points[0][1]


class Branch:
    """The linear system of one set of modes, with its guards, all of them positive until an event."""

    def __init__(self, machine, mode):
        m, n = machine, machine.n
        d = m.d
        force = m.load.copy()
        self.stuck = [i for i in m.contacts if mode[i] == 0]
        for i, e in enumerate(m.elements):
            b = e["direction"]
            row = m.element_force(i, mode)
            if row is not None:
                force -= np.outer(b, row)
        B = np.array([m.elements[i]["direction"] for i in self.stuck]).reshape(-1, n)
        if self.stuck:
            G = B @ m.inverse @ B.T
            pull = np.linalg.pinv(G, rcond=1e-10) @ B @ m.inverse
            hold = pull @ force
            force = force - B.T @ hold
            self.onto = m.inverse @ B.T @ np.linalg.pinv(G, rcond=1e-10)
        self.B = B
        self.belts = np.array([m.elements[i]["belt"] for i in self.stuck])
        A = m.turn.copy()
        A[:n, n : 2 * n] = np.eye(n)
        A[n : 2 * n] = m.inverse @ force
        rows, self.labels = [], []
        for i, e in enumerate(m.elements):
            if e["type"] == "contact":
                if mode[i]:
                    s, piece = (1, mode[i] - 1) if mode[i] > 0 else (-1, -mode[i] - 1)
                    speed = s * m.velocity_row(i)
                    pieces = e["pieces"]
                    low = speed.copy()
                    low[-1] -= pieces[piece][0]
                    rows.append(low)
                    self.labels.append(("law", i, s * piece) if piece else ("stick", i, s))
                    if piece + 1 < len(pieces):
                        high = -speed
                        high[-1] += pieces[piece + 1][0]
                        rows.append(high)
                        self.labels.append(("law", i, s * (piece + 2)))
            elif e["type"] == "elastic":
                T = np.zeros(d)
                T[e["place"]] = 1.0
                if mode[i] == 0:
                    A[e["place"]] = e["stiffness"] * m.velocity_row(i)
                    for s in (1, -1):
                        row = -s * T
                        row[-1] += e["friction"]
                        rows.append(row)
                        self.labels.append(("yield", i, s))
                else:
                    rows.append(mode[i] * m.velocity_row(i))
                    self.labels.append(("lock", i, 0))
            else:
                beyond, press = m.stop_rows(i)
                if mode[i] == 0:
                    rows.append(-beyond)
                    self.labels.append(("close", i, 1))
                elif mode[i] == 1:
                    rows.append(press)
                    self.labels.append(("open", i, 2 if e["damping"] > 0 else 0))
                else:
                    rows.append(-press)
                    self.labels.append(("press", i, 1))
                    rows.append(beyond)
                    self.labels.append(("leave", i, 0))
        for g in facets(B):
            bound = sum(abs(x) * m.static(i) for x, i in zip(g, self.stuck))
            for s in (1, -1):
                row = -s * (g @ hold)
                row[-1] += bound
                rows.append(row)
                self.labels.append(("slip", None, {i: int(np.sign(s * x)) for x, i in zip(g, self.stuck) if x != 0}))
        if m.section is not None:
            # Maxima of the first displacement: its velocity falls to zero. It has no effect on the motion.
            row = np.zeros(d)
            row[n] = 1.0
            rows.append(row)
            self.labels.append(("section", None, None))
        self.rows = np.array(rows).reshape(-1, d)
        self.A = A
        fastest = max(np.abs(np.linalg.eigvals(A)).max(), m.fastest, 2 * np.pi / m.period)
        self.h = min(2 * np.pi / (SAMPLES * fastest), m.period / 8)
        E = expm(A * self.h)
        powers = [np.eye(d)]
        for _ in range(CHUNK):
            powers.append(E @ powers[-1])
        self.powers = np.array(powers)
        self.guard = (self.rows @ self.powers).reshape(-1, d)
        self.guard_slope = (self.rows @ A @ self.powers).reshape(-1, d)
        term, terms = np.eye(d), []
        for k in range(TERMS):
            terms.append(term)
            term = term @ A * (self.h / (k + 1))
        self.taylor = np.array(terms).reshape(-1, d)
        self.size = np.abs(self.rows)


@lru_cache(maxsize=None)
def facets_of(rows):
    """For contacts at rest with these directions: the coefficients g of the sums g.T that bound the forces they can hold."""
    B = np.array(rows)
    count = len(B)
    if not count:
        return []
    rank = np.linalg.matrix_rank(B, tol=1e-10)
    _, _, basis = np.linalg.svd(B)
    X = B @ basis[:rank].T
    found = []
    for subset in itertools.combinations(range(count), rank - 1):
        if rank == 1:
            u = np.ones(1)
        else:
            part = X[list(subset)]
            if np.linalg.matrix_rank(part, tol=1e-10) < rank - 1:
                continue
            u = np.linalg.svd(part)[2][-1]
        g = X @ u
        g[np.abs(g) < 1e-10] = 0.0
        g /= np.abs(g).max()
        g *= np.sign(g[np.nonzero(g)[0][0]])
        if not any(np.allclose(g, other, atol=1e-9) for other in found):
            found.append(g)
    return found


def facets(B):
    return facets_of(tuple(map(tuple, B)))


class Machine:
    def __init__(self, model):
        self.M = np.array(model["mass"], dtype=float)
        self.n = n = len(self.M)
        self.inverse = np.linalg.inv(self.M)
        self.C, self.K = (np.array(model[key], dtype=float) for key in ("damping", "stiffness"))
        harmonics = model["harmonics"]
        self.elements = []
        place = 2 * n
        for given in model["elements"]:
            e = dict(given)
            e["direction"] = np.array(e["direction"], dtype=float)
            e["belt"] = e.get("moves", {}).get("constant", 0.0)
            if e["type"] == "contact":
                law = Law(e["law"] if "law" in e else [[0.0, e["friction"]]])
                e["pieces"], e["kinetic"], e["peak"] = law.pieces, law.at_zero, e.get("peak", 1.0)
            if e["type"] == "elastic":
                e["place"], place = place, place + 1
            self.elements.append(e)
        self.contacts = [i for i, e in enumerate(self.elements) if e["type"] == "contact"]
        self.own = place  # the states that are not those of the load
        self.d = d = place + 2 * len(harmonics) + 1
        self.load = np.zeros((n, d))
        self.load[:, :n], self.load[:, n : 2 * n] = -self.K, -self.C
        self.load[:, -1] = model.get("constant", [0.0] * n)
        self.turn = np.zeros((d, d))
        self.start = np.zeros(d)
        self.start[-1] = 1.0
        for k, harmonic in enumerate(harmonics):
            i, w = place + 2 * k, harmonic["frequency"]
            self.turn[i, i + 1], self.turn[i + 1, i] = w, -w
            self.start[i + 1] = 1.0
            self.load[:, i] = harmonic.get("sin", [0.0] * n)
            self.load[:, i + 1] = harmonic.get("cos", [0.0] * n)
        natural = np.sqrt(np.maximum(np.linalg.eigvals(self.inverse @ self.K).real, 0))
        self.section = None if harmonics else []
        self.period = 2 * np.pi / (min(x["frequency"] for x in harmonics) if harmonics else natural.min())
        self.fastest = natural.max()
        self.free = abs(self.K.sum()) < 1e-12 and bool(harmonics)  # no spring to the ground
        self.branches = {}
        self.scale = np.zeros(d)

    def branch(self, mode):
        if mode not in self.branches:
            self.branches[mode] = Branch(self, mode)
        return self.branches[mode]

    def static(self, i):
        return self.elements[i]["peak"] * self.elements[i]["kinetic"]

    def velocity_row(self, i):
        row = np.zeros(self.d)
        row[self.n : 2 * self.n] = self.elements[i]["direction"]
        row[-1] = -self.elements[i]["belt"]
        return row

    def stop_rows(self, i):
        """The distance beyond the gap, and the force while pressed."""
        e = self.elements[i]
        beyond = np.zeros(self.d)
        beyond[: self.n] = e["direction"]
        beyond[-1] = -e["gap"]
        return beyond, e["stiffness"] * beyond + e["damping"] * self.velocity_row(i)

    def element_force(self, i, mode):
        """The force of an element as a row, or None for none, or that of a contact at rest."""
        e = self.elements[i]
        if e["type"] == "elastic":
            row = np.zeros(self.d)
            row[e["place"]] = 1.0
            return row
        if mode[i] == 0 or (e["type"] == "stop" and mode[i] != 1):
            return None
        if e["type"] == "stop":
            return self.stop_rows(i)[1]
        s = 1 if mode[i] > 0 else -1
        _, level, slope = e["pieces"][abs(mode[i]) - 1]
        row = slope * self.velocity_row(i)
        row[-1] += s * level
        return row

    def decide(self, mode, z, forced):
        """Which contacts of zero velocity stick, and which way the others go; `forced` have just lost their hold."""
        near = [i for i in self.contacts if mode[i] == 0 or i in forced]
        if not near:
            return mode
        # Contacts whose velocity follows from those at rest are at rest with them.
        for i in self.contacts:
            if i not in near:
                row = self.velocity_row(i)
                if abs(row @ z) <= 1e-11 * (np.abs(row) @ self.scale):
                    near.append(i)
        near.sort()
        outside = list(mode)
        for i in near:
            outside[i] = 0
        force = self.load @ z
        for i, e in enumerate(self.elements):
            if i not in near:
                row = self.element_force(i, outside)
                if row is not None:
                    force = force - e["direction"] * (row @ z)
        B = np.array([self.elements[i]["direction"] for i in near])
        bounds = {i: self.static(i) for i in near}
        slid = {}
        for i, s in forced.items():
            if s:
                slid[i], bounds[i] = s, self.elements[i]["kinetic"]
        small = 1e-11 * (np.abs(self.load) @ self.scale).max() + 1e-11 * max(bounds.values())
        while True:
            ways = self.sticking(near, B, force, bounds, slid, small)
            if ways is None:
                ways = self.sticking(near, B, force, bounds, {}, small)
            if ways is None:
                raise Doubtful("no sticking set")
            again = [i for i, s in zip(near, ways) if s and bounds[i] > self.elements[i]["kinetic"]]
            if not again:
                break
            for i in again:
                bounds[i] = self.elements[i]["kinetic"]
        for i, s in zip(near, ways):
            outside[i] = s
        return tuple(outside)

    def sticking(self, near, B, force, bounds, fixed, small):
        """The set that sticks most and keeps |T| <= R where a = 0, and s a >= 0 where T = s R."""
        options = [(fixed[i],) if i in fixed else (0, 1, -1) for i in near]
        for ways in sorted(itertools.product(*options), key=lambda w: sum(map(abs, w))):
            w = np.array(ways)
            R = np.array([bounds[i] for i in near])
            net = force - B.T @ (w * R)
            S = B[w == 0]
            if len(S):
                hold = np.linalg.pinv(S @ self.inverse @ S.T, rcond=1e-10) @ (S @ self.inverse @ net)
                RS = R[w == 0]
                if any(abs(g @ hold) > np.abs(g) @ RS + small for g in facets(S)):
                    continue
                net = net - S.T @ hold
            if np.all(w * (B @ self.inverse @ net) >= -small * self.inverse.max()):
                return ways
        return None

    def after(self, mode, z, label):
        kind, i, to = label
        if kind == "section":
            return mode
        new = list(mode)
        if kind in ("law", "yield", "lock", "open", "press", "leave", "close"):
            new[i] = to
            if kind == "yield":
                z[self.elements[i]["place"]] = to * self.elements[i]["friction"]
            if kind != "close":
                return tuple(new)
            return self.settle(self.decide(tuple(new), z, {}), z)
        if kind == "stick":
            return self.settle(self.decide(mode, z, {i: 0}), z)
        return self.settle(self.decide(mode, z, to), z)

    def settle(self, mode, z):
        """Takes the rounding out of the velocities of contacts that stick."""
        branch = self.branch(mode)
        if branch.stuck:
            v = z[self.n : 2 * self.n]
            v -= branch.onto @ (branch.B @ v - branch.belts)
        return mode

    def begin(self):
        """Rest at time zero."""
        mode = []
        z = self.start.copy()
        self.scale = np.ones(self.d)
        for i, e in enumerate(self.elements):
            moving = e["type"] == "contact" and e["belt"]
            piece = sum(abs(e["belt"]) >= p[0] for p in e["pieces"]) if moving else 0
            mode.append(-int(np.sign(e["belt"])) * piece)
        forced = {i: 0 for i in self.contacts if not self.elements[i]["belt"]}
        mode = self.decide(tuple(mode), z, forced) if forced else tuple(mode)
        return self.settle(mode, z), z

    def follow(self, mode, z, length, watch=None):
        """The mode and state after this time; `watch` sees each step (branch, Taylor terms of the state, share of the step)."""
        t, events = 0.0, 0
        n = self.n
        while True:
            branch = self.branch(mode)
            h, count = branch.h, len(branch.labels)
            np.maximum(self.scale, np.abs(z), out=self.scale)
            fresh = True
            hit = None
            while hit is None:
                left = (length - t) / h
                steps = min(CHUNK, int(np.ceil(left)))
                if steps <= 0:
                    return mode, z
                suspects = ()
                if count:
                    g = (branch.guard @ z).reshape(CHUNK + 1, count)[: steps + 1]
                    dg = h * (branch.guard_slope @ z).reshape(CHUNK + 1, count)[: steps + 1]
                    g0, g1, d0, d1 = g[:-1], g[1:], dg[:-1], dg[1:]
                    dip = (d0 < 0) & (d1 > 0)
                    with np.errstate(divide="ignore", invalid="ignore"):
                        # Where the tangents at both ends of the step meet.
                        meet = g0 + d0 * np.where(dip, (g1 - g0 - d1) / (d0 - d1), 0.0)
                    bad = ((g1 <= 0) | (dip & (meet <= 0))).any(axis=1)
                    if fresh:
                        bad[0] = True
                    suspects = np.nonzero(bad)[0]
                looked = range(steps) if watch else suspects
                for k in looked:
                    zk = z if k == 0 else branch.powers[k] @ z
                    terms = (branch.taylor @ zk).reshape(TERMS, -1)
                    end = min(1.0, left - k)
                    if end <= 0:
                        break
                    if count and (bad[k] or watch):
                        polys = terms @ branch.rows.T
                        tiny = 1e-11 * (branch.size @ self.scale)
                        for j in range(count):
                            if k and not (g1[k, j] <= 0 or (dip[k, j] and meet[k, j] <= 0)):
                                continue
                            c = polys[:, j]
                            order = 0
                            if fresh and k == 0:
                                if branch.labels[j][0] == "section":
                                    # It has no meaning while the velocity is not positive.
                                    if c[0] < tiny[j]:
                                        continue
                                else:
                                    while order < 3 and abs(c[order]) <= tiny[j]:
                                        order += 1
                                    if order == 3:
                                        continue
                                    if order == 0 and c[0] < 0:
                                        raise Doubtful("a guard starts negative")
                            elif c[0] <= 0:
                                continue
                            root = first_root(c, order, min(end, hit[0]) if hit else end)
                            if root == 0 and branch.labels[j][0] in ("slip", "close"):
                                raise Doubtful("a contact slips at once")
                            if root is not None and (hit is None or root < hit[0]):
                                hit = (root, j)
                    if hit or watch:
                        share = hit[0] if hit else end
                        if watch:
                            watch(branch, terms, share)
                    if hit:
                        z = share**ORDERS @ terms
                        t += (k + share) * h
                        break
                if hit is None:
                    fresh = False
                    if left <= steps:
                        terms = (branch.taylor @ (branch.powers[steps - 1] @ z)).reshape(TERMS, -1)
                        return mode, (left - steps + 1) ** ORDERS @ terms
                    z = branch.powers[steps] @ z
                    t += steps * h
            events += 1
            if events > 2000:
                raise Doubtful("too many events")
            label = branch.labels[hit[1]]
            if label[0] == "section":
                self.section.append((self.clock + t, mode, z.copy()))
            mode = self.after(mode, z, label)

    def next_period(self, mode, z):
        """One load period, from phase zero to phase zero exactly; also the shift that was taken out of a free machine."""
        mode, z = self.follow(mode, z.copy(), self.period)
        z[self.own :] = self.start[self.own :]
        shift = 0.0
        if self.free:
            shift = z[0]
            z[: self.n] -= shift
        return mode, z, shift


class Extremes:
    """The extremes of displacements and velocities, by the zeros of their derivatives in each step."""

    def __init__(self, n):
        self.n = n
        self.high, self.low = np.full(2 * n, -np.inf), np.full(2 * n, np.inf)

    def __call__(self, branch, terms, share):
        n2 = 2 * self.n
        ends = [terms[0, :n2], share**ORDERS @ terms[:, :n2]]
        slopes = terms[1:, :n2] * np.arange(1, TERMS)[:, None]
        first, last = slopes[0], share ** ORDERS[:-1] @ slopes
        for j in np.nonzero(first * last < 0)[0]:
            slope = slopes[:, j].tolist()
            if horner(slope, 0.0) * horner(slope, share) < 0:
                s = brentq(lambda x: horner(slope, x), 0.0, share, xtol=1e-15)
                extreme = ends[0].copy()
                extreme[j] = horner(terms[:, j].tolist(), s)
                ends.append(extreme)
        self.high = np.maximum(self.high, np.max(ends, axis=0))
        self.low = np.minimum(self.low, np.min(ends, axis=0))


def answer(machine, mode, z, periods, period, length, followed, position):
    n = machine.n
    extremes = Extremes(n)
    start = z.copy()
    drift = 0.0
    if machine.section is not None:
        machine.clock = 0.0
        machine.follow(mode, z, length, extremes)
    else:
        for _ in range(periods):
            z[machine.own :] = machine.start[machine.own :]
            mode, z = machine.follow(mode, z, machine.period, extremes)
        if machine.free:
            drift = z[0] - start[0]
    size = max(np.abs(extremes.high[n:]).max(), np.abs(extremes.low[n:]).max())
    rest = bool(size <= 1e-11 * machine.scale[n : 2 * n].max())
    if rest:
        extremes.high[n:] = extremes.low[n:] = 0.0
        extremes.high[:n] = extremes.low[:n] = start[:n]
    if abs(drift) <= 1e-11 * size * machine.period:
        drift = 0.0
    moved = drift != 0.0
    return {
        "periods": periods,
        "period": None if rest and machine.section is not None else float(period),
        "max_displacement": [None if moved else float(x + position) for x in extremes.high[:n]],
        "min_displacement": [None if moved else float(x + position) for x in extremes.low[:n]],
        "max_velocity": extremes.high[n:].tolist(),
        "min_velocity": extremes.low[n:].tolist(),
        "drift": [float(drift)] * n,
        "rest": rest,
        "followed": followed,
    }


class Repeats:
    """Tells when a sequence of states repeats itself after at most 16 of them."""

    def __init__(self):
        self.states, self.first, self.count = [], None, 0

    def add(self, x, scale):
        """The least number of states after which it repeats, once this is sure."""
        self.count += 1
        gaps = [np.max(np.abs(x - y) / scale) for y in reversed(self.states)]
        self.states = self.states[-15:] + [x]
        best = min(gaps, default=1.0)
        if best >= 1e-11:
            self.first = None
            return None
        if self.first is None:
            self.first = self.count
        if self.count >= 4 and (best < 1e-13 or self.count >= 2 * self.first + 50):
            return 1 + next(i for i, gap in enumerate(gaps) if gap < 1e-11)
        return None


def scales(machine):
    """One size for all displacements, one for all velocities, and the friction of each elastic contact."""
    n, scale = machine.n, machine.scale
    sizes = [scale[:n].max() or 1.0] * n + [scale[n : 2 * n].max() or 1.0] * n
    sizes += [e["friction"] for e in machine.elements if e["type"] == "elastic"]
    return np.array(sizes)


def long_run(model, limit):
    """The limit of the motion from rest, or None if it does not settle."""
    machine = Machine(model)
    mode, z = machine.begin()
    repeats = Repeats()
    position, times = 0.0, []
    for n in range(1, limit + 1):
        if n == 40:
            # The size of the motion without its first transient.
            machine.scale[: machine.own] *= 0.1
        machine.clock = (n - 1) * machine.period
        mode, z, shift = machine.next_period(mode, z)
        position += shift
        if machine.section is None:
            m = repeats.add(z[: machine.own], scales(machine))
            if m:
                return answer(machine, mode, z, m, m * machine.period, None, n, position)
        else:
            found, machine.section = machine.section, []
            for time, at, state in found:
                m = repeats.add(state[: machine.own], scales(machine))
                times = [*times[-16:], time]
                quiet = np.abs(z[machine.n : 2 * machine.n]).max() < 1e-9 * machine.scale[machine.n : 2 * machine.n].max()
                if m and not quiet:
                    length = times[-1] - times[-1 - m]
                    return answer(machine, at, state, 1, length, length, n, position)
            if np.abs(z[machine.n : 2 * machine.n]).max() < 1e-13 * machine.scale[machine.n : 2 * machine.n].max() and all(
                mode[i] for i in machine.contacts
            ):
                return answer(machine, mode, z, 1, None, machine.period, n, position)
    return None


def digits(x, n=3):
    return float(f"{x:.{n}g}")


def chain(masses, springs, dampers):
    """Mass, damping and stiffness matrices of a chain from the ground."""
    n = len(masses)
    C, K = np.zeros((n, n)), np.zeros((n, n))
    for matrix, values in ((C, dampers), (K, springs)):
        for i, x in enumerate(values):
            matrix[i, i] += x
            if i:
                matrix[i - 1, i - 1] += x
                matrix[i, i - 1] -= x
                matrix[i - 1, i] -= x
    # Values with few digits have sums with few digits.
    return {"mass": np.diag(masses).tolist(), "damping": C.round(9).tolist(), "stiffness": K.round(9).tolist()}


def between(n, low, high):
    """The direction from one body to another; -1 is the ground."""
    b = [0.0] * n
    b[high] = 1.0
    if low >= 0:
        b[low] = -1.0
    return b


def log_uniform(rng, low, high):
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def draw(kind, rng):
    """A random machine of this kind."""
    pick = lambda low, high: digits(rng.uniform(low, high))
    some = lambda low, high: digits(log_uniform(rng, low, high))
    if kind == "frame":
        n = int(rng.integers(1, 4))
        masses = [pick(0.6, 1.5) for _ in range(n)]
        springs = [pick(0.6, 2.0) for _ in range(n)]
        ratio = some(0.003, 0.08)
        lowest = np.sqrt(
            np.linalg.eigvals(np.linalg.inv(np.diag(masses)) @ np.array(chain(masses, springs, springs)["stiffness"])).real.min()
        )
        dampers = [digits(2 * ratio * k / lowest) for k in springs]
        model = chain(masses, springs, dampers)
        a, elements = pick(0.3, 1.5), []
        for _ in range(int(rng.integers(1, 3))):
            high = int(rng.integers(0, n))
            b = between(n, high - 1 if rng.random() < 0.7 else -1, high)
            if any(e["direction"] == b for e in elements):
                continue
            friction = digits(a * masses[high] * log_uniform(rng, 0.05, 3))
            if rng.random() < 0.6:
                elements.append({"type": "elastic", "direction": b, "stiffness": pick(0.5, 6), "friction": friction})
            else:
                elements.append(
                    {"type": "contact", "direction": b, "friction": friction, "peak": 1.0 if rng.random() < 0.6 else pick(1.05, 1.5)}
                )
        frequency = digits(lowest * log_uniform(rng, 0.4, 2.2))
        model |= {"elements": elements, "harmonics": [{"frequency": frequency, "sin": [digits(-x * a, 8) for x in masses]}]}
    elif kind == "stop":
        n = int(rng.integers(1, 3))
        model = chain([pick(0.6, 1.5) for _ in range(n)], [pick(0.5, 2) for _ in range(n)], [some(0.03, 0.4) for _ in range(n)])
        ends = [(-1, int(rng.integers(0, n)), 1.0)]
        if rng.random() < 0.5:
            ends.append((-1, ends[0][1], -1.0))
        elements = []
        for low, high, s in ends:
            b = [s * x for x in between(n, low, high)]
            b = [x or 0.0 for x in b]
            damping = 0.0 if rng.random() < 0.25 else pick(0.02, 0.5)
            elements.append({"type": "stop", "direction": b, "gap": some(0.02, 1), "stiffness": some(5, 200), "damping": damping})
        load = [0.0] * n
        load[int(rng.integers(0, n))] = pick(0.3, 2)
        model |= {"elements": elements, "harmonics": [{"frequency": some(0.4, 3), "sin": load}]}
        if rng.random() < 0.3:
            model["constant"] = [pick(-0.4, 0.4)] + [0.0] * (n - 1)
    elif kind == "belt":
        n = int(rng.integers(1, 3))
        model = chain([pick(0.6, 1.5) for _ in range(n)], [pick(0.5, 3) for _ in range(n)], [some(0.02, 0.3) for _ in range(n)])
        elements = []
        for i in range(n):
            if i == 0 or rng.random() < 0.5:
                r = pick(0.5, 2)
                low, far = pick(0.3, 1), pick(1.5, 4)
                law = [[0.0, r], [low, digits(r * rng.uniform(0.5, 0.9))]]
                if rng.random() < 0.6:
                    law.append([far, digits(law[1][1] * rng.uniform(0.8, 1.3))])
                elements.append(
                    {
                        "type": "contact",
                        "direction": between(n, -1, i),
                        "law": law,
                        "peak": 1.0 if rng.random() < 0.4 else pick(1.05, 1.5),
                        "moves": {"constant": pick(0.1, 1.2)},
                    }
                )
        model |= {"elements": elements, "harmonics": []}
    elif kind == "drift":
        n = int(rng.integers(1, 3))
        if n == 1:
            model = {"mass": [[pick(0.6, 1.5)]], "damping": [[0.0]], "stiffness": [[0.0]]}
        else:
            c, k = some(0.01, 0.3), pick(0.5, 4)
            model = {
                "mass": np.diag([pick(0.6, 1.5), pick(0.6, 1.5)]).tolist(),
                "damping": [[c, -c], [-c, c]],
                "stiffness": [[k, -k], [-k, k]],
            }
        elements, load = [], pick(0.8, 2)
        for i in range(n):
            if i == 0 or rng.random() < 0.5:
                elements.append(
                    {
                        "type": "contact",
                        "direction": between(n, -1, i),
                        "friction": digits(load * log_uniform(rng, 0.08, 0.9)),
                        "peak": 1.0 if rng.random() < 0.6 else pick(1.05, 1.4),
                    }
                )
        w = some(0.5, 2.5)
        model |= {"elements": elements, "harmonics": [{"frequency": w, "sin": [load] + [0.0] * (n - 1)}]}
        if rng.random() < 0.75:
            angle, second = rng.uniform(0, 2 * np.pi), load * rng.uniform(0.3, 1)
            model["harmonics"].append(
                {
                    "frequency": digits(2 * w, 8),
                    "sin": [digits(second * np.sin(angle))] + [0.0] * (n - 1),
                    "cos": [digits(second * np.cos(angle))] + [0.0] * (n - 1),
                }
            )
        elif rng.random() < 0.7:
            model["constant"] = [digits(load * rng.uniform(0.05, 0.3))] + [0.0] * (n - 1)
    else:
        n = int(rng.integers(1, 4))
        model = chain([pick(0.6, 1.5) for _ in range(n)], [pick(0.5, 3) for _ in range(n)], [some(0.02, 0.3) for _ in range(n)])
        load = pick(0.8, 2)
        friction = lambda: digits(load * log_uniform(rng, 0.04, 0.5))
        peak = lambda: 1.0 if rng.random() < 0.6 else pick(1.05, 1.4)
        i = int(rng.integers(0, n))
        directions = [between(n, -1, i), between(n, -1, i)]
        if n > 1:
            j = int(rng.integers(1, n))
            if rng.random() < 0.5:
                directions = [between(n, -1, j - 1), between(n, -1, j), between(n, j - 1, j)]
            else:
                directions.append(between(n, j - 1, j))
        elements = [{"type": "contact", "direction": b, "friction": friction(), "peak": peak()} for b in directions]
        if rng.random() < 0.4:
            elements.append({"type": "elastic", "direction": between(n, -1, n - 1), "stiffness": pick(0.5, 4), "friction": friction()})
        sin = [0.0] * n
        sin[int(rng.integers(0, n))] = load
        model |= {"elements": elements, "harmonics": [{"frequency": some(0.5, 2.5), "sin": sin}]}
    return model


def one(task):
    """The entry of one machine, or the reason why there is none."""
    kind, number = task
    model = draw(kind, np.random.default_rng([list(COUNTS).index(kind), number]))
    try:
        limit = long_run(model, LIMITS[kind])
    except Doubtful as error:
        return str(error)
    return "does not settle" if limit is None else {"kind": kind, "model": model} | limit


def main():
    entries = []
    with Pool(2) as pool:
        for kind, wanted in COUNTS.items():
            kept, dropped, number = [], [], 0
            while len(kept) < wanted:
                more = range(number, number + wanted - len(kept))
                number = more.stop
                for n, entry in zip(more, pool.imap(one, [(kind, n) for n in more])):
                    if isinstance(entry, str):
                        dropped.append(f"{n} {entry}")
                    else:
                        kept.append(entry)
            entries += kept
            print(kind, len(kept), "kept; dropped:", dropped, file=sys.stderr, flush=True)
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write("[\n" + ",\n".join(json.dumps(entry) for entry in entries) + "\n]\n")


if __name__ == "__main__":
    main()
