#!/usr/bin/env python3
"""Writes tests/data/system_digits.json: motions of systems at 50 digits, by a text of its own.

    python3 tests/data/system_digits.py            # needs mpmath, and some minutes
    python3 tests/data/system_digits.py NAME …     # some of the cases, or all, compared with the file

Between events z' = A z with z = (q, q', forces of the elastic contacts, sine and cosine of each load, 1). The state is sampled by the
matrix exponential of a small step, and a guard that has changed its sign between two samples is refined by the method of Illinois on exact
exponentials. Contacts at rest are decided one after the other: what the structure asks of a contact that would stick is compared with its
friction. The files are written as a user types them, with decimals that no double has.
"""

import json
import pathlib
import sys

from mpmath import expm, lu_solve, matrix, mp, mpf, pi

mp.dps = 60
HERE = pathlib.Path(__file__).parent
FILE = HERE / "system_digits.json"


def dot(a, b):
    return sum((x * y for x, y in zip(a, b)), mpf(0))


class Motion:
    def __init__(self, of, step):
        """Matrices M, C, K by rows, loads [(frequency, sine parts, cosine parts)], constant, elements, start and the sampling step."""
        num = lambda x: x if isinstance(x, mpf) else mpf(x)
        rows = lambda m: [[num(x) for x in r] for r in m]
        self.M, self.C, self.K = rows(of["M"]), rows(of["C"]), rows(of["K"])
        self.n = n = len(self.M)
        self.loads = [(num(w), [num(x) for x in s], [num(x) for x in c]) for w, s, c in of.get("loads", [])]
        self.constant = [num(x) for x in of.get("constant", ["0"] * n)]
        self.elements = [
            {k: ([num(x) for x in v] if k == "b" else v if k == "kind" else num(v)) for k, v in e.items()}
            for e in of["elements"]
        ]
        self.elastic = [i for i, e in enumerate(self.elements) if e["kind"] == "elastic"]
        self.size = 2 * n + len(self.elastic) + 2 * len(self.loads) + 1
        inverse = matrix(self.M) ** -1
        self.inverse = [[inverse[i, j] for j in range(n)] for i in range(n)]
        self.step = num(step)
        z = [mpf(0)] * self.size
        start = of.get("start", {})
        for i, x in enumerate(start.get("q", [])):
            z[i] = num(x)
        for i, x in enumerate(start.get("v", [])):
            z[n + i] = num(x)
        for k in range(len(self.loads)):
            z[self.wave(k) + 1] = mpf(1)
        z[-1] = mpf(1)
        self.z, self.t, self.events = z, mpf(0), []
        self.cache = {}
        self.modes = [None] * len(self.elements)
        for i, e in enumerate(self.elements):
            if e["kind"] == "stop":
                self.modes[i] = "away" if dot(e["b"], z[:n]) < e["gap"] else "pressed"
            elif e["kind"] == "hard":
                self.modes[i] = "away"
            elif e["kind"] == "elastic":
                self.modes[i] = "hold"
            else:
                v = self.velocity(i, z)
                self.modes[i] = "stick" if v == 0 else "+" if v > 0 else "-"
        for i, e in enumerate(self.elements):
            if e["kind"] == "contact" and self.modes[i] == "stick":
                self.decide(i, first=True)

    def wave(self, k):
        return 2 * self.n + len(self.elastic) + 2 * k

    def velocity(self, i, z):
        e = self.elements[i]
        return dot(e["b"], z[self.n : 2 * self.n]) - e.get("belt", mpf(0))

    def forces(self, modes):
        """The rows of the forces on the coordinates, of the tensions, and A."""
        n, size = self.n, self.size
        row = lambda: [mpf(0)] * size
        f = [row() for _ in range(n)]
        for i in range(n):
            for j in range(n):
                f[i][j] -= self.K[i][j]
                f[i][n + j] -= self.C[i][j]
            for k, (_, s, c) in enumerate(self.loads):
                f[i][self.wave(k)] += s[i]
                f[i][self.wave(k) + 1] += c[i]
            f[i][-1] += self.constant[i]
        tension = [row() for _ in self.elements]
        stuck = []
        for i, (e, mode) in enumerate(zip(self.elements, modes)):
            t = tension[i]
            if mode in ("+", "-"):
                t[-1] = e["friction"] if mode == "+" else -e["friction"]
            elif mode in ("hold", "yield+", "yield-"):
                t[2 * n + self.elastic.index(i)] = mpf(1)
            elif mode == "pressed":
                for j, b in enumerate(e["b"]):
                    t[j] += e["stiffness"] * b
                    t[n + j] += e.get("damping", mpf(0)) * b
                t[-1] -= e["stiffness"] * e["gap"]
            elif mode == "stick":
                stuck.append(i)
            for j in range(n):
                f[j] = [x - e["b"][j] * y for x, y in zip(f[j], t)]
        if stuck:
            b = [self.elements[i]["b"] for i in stuck]
            response = [[dot(r, own) for r in self.inverse] for own in b]
            G = matrix([[dot(x, y) for y in response] for x in b])
            asked = [[sum(r[j] * f[j][k] for j in range(n)) for k in range(size)] for r in response]
            held = [[mpf(0)] * size for _ in stuck]
            for k in range(size):
                x = lu_solve(G, matrix([a[k] for a in asked]))
                for row_, value in zip(held, x):
                    row_[k] = value
            for i, own, t in zip(stuck, b, held):
                tension[i] = t
                for j in range(n):
                    f[j] = [x - own[j] * y for x, y in zip(f[j], t)]
        A = matrix(size, size)
        for i in range(n):
            A[i, n + i] = mpf(1)
            for k in range(size):
                A[n + i, k] = sum(self.inverse[i][j] * f[j][k] for j in range(n))
        for place, i in enumerate(self.elastic):
            if modes[i] == "hold":
                e = self.elements[i]
                for j, b in enumerate(e["b"]):
                    A[2 * n + place, n + j] = e["stiffness"] * b
                A[2 * n + place, size - 1] = -e["stiffness"] * e.get("belt", mpf(0))
        for k, (w, _, _) in enumerate(self.loads):
            A[self.wave(k), self.wave(k) + 1], A[self.wave(k) + 1, self.wave(k)] = w, -w
        return tension, A

    def branch(self):
        key = tuple(self.modes)
        if key not in self.cache:
            tension, A = self.forces(self.modes)
            self.cache[key] = tension, A, expm(A * self.step)
        return self.cache[key]

    def guards(self, tension):
        """(element, event, function of z) that is positive as long as the mode lasts."""
        n = self.n
        found = []
        for i, (e, mode) in enumerate(zip(self.elements, self.modes)):
            v = lambda z, i=i: self.velocity(i, z)
            y = lambda z, e=e: dot(e["b"], z[:n])
            T = lambda z, t=tension[i]: dot(t, z)
            if mode == "stick":
                most = e["friction"] * e.get("peak", mpf(1))
                found += [(i, "slip+", lambda z, T=T, m=most: m - T(z)), (i, "slip-", lambda z, T=T, m=most: m + T(z))]
            elif mode == "+":
                found.append((i, "zero", v))
            elif mode == "-":
                found.append((i, "zero", lambda z, v=v: -v(z)))
            elif mode == "hold":
                most = e["friction"]
                found += [(i, "yield+", lambda z, T=T, m=most: m - T(z)), (i, "yield-", lambda z, T=T, m=most: m + T(z))]
            elif mode == "yield+":
                found.append((i, "hold", v))
            elif mode == "yield-":
                found.append((i, "hold", lambda z, v=v: -v(z)))
            elif mode == "away":
                kind = "blow" if e["kind"] == "hard" else "close"
                found.append((i, kind, lambda z, y=y, g=e["gap"]: g - y(z)))
            elif mode == "pressed":
                found.append((i, "open", T))
        return found

    def decide(self, i, first=False):
        """What a contact at rest does: it sticks where the friction holds what the structure asks."""
        e = self.elements[i]
        modes = list(self.modes)
        modes[i] = "stick"
        tension, _ = self.forces(modes)
        asked = dot(tension[i], self.z)
        most = e["friction"] * e.get("peak", mpf(1))
        self.modes[i] = "stick" if abs(asked) <= most else "+" if asked > 0 else "-"

    def run(self, until):
        until = mpf(until) if not isinstance(until, mpf) else until
        passed = {}
        while True:
            tension, A, E = self.branch()
            guards = self.guards(tension)
            z = matrix(self.z)
            last = self.t + self.step > until
            h = until - self.t if last else self.step
            after = list((expm(A * h) if last else E) * z)
            before = [g(self.z) for _, _, g in guards]
            late = []
            for (i, what, g), old in zip(guards, before):
                new = g(after)
                if new < 0 and (old > 0 or (i, what) not in passed):
                    late.append((i, what, g))
            if not late:
                self.z, self.t, passed = after, self.t + h, {}
                if last:
                    return
                continue
            places = [(self.zero(A, z, g, h), i, what) for i, what, g in late]
            at, i, what = min(places)
            self.z = list(expm(A * at) * z)
            self.t += at
            self.turn(i, what)
            passed = {(i, what): True}

    def zero(self, A, z, g, h):
        value = lambda s: g(list(expm(A * s) * z))
        # Just after an event of the same element the guard is rounding: from a place on at which it is positive.
        a, fa = mpf(0), g(list(z))
        part = h
        while fa <= mpf(10) ** -45:
            part /= 16
            if part < h / mpf(16) ** 8:
                return mpf(0)
            a, fa = part, value(part)
        b, fb = h, value(h)
        side = 0
        while abs(b - a) > mpf(10) ** -56 * max(h, mpf(1)):
            c = (a * fb - b * fa) / (fb - fa)
            fc = value(c)
            if fc == 0:
                return c
            if (fc > 0) == (fb > 0):
                b, fb = c, fc
                fa = fa / 2 if side == 1 else fa
                side = 1
            else:
                a, fa = c, fc
                fb = fb / 2 if side == -1 else fb
                side = -1
            if abs(fc) < mpf(10) ** -57:
                return c
        return b

    def turn(self, i, what):
        e, n = self.elements[i], self.n
        if what == "blow":
            v = dot(e["b"], self.z[n : 2 * n])
            response = [dot(r, e["b"]) for r in self.inverse]
            P = (1 + e["restitution"]) * v / dot(e["b"], response)
            for j in range(n):
                self.z[n + j] -= response[j] * P
            self.events.append((self.t, i, "blow"))
            for k, other in enumerate(self.elements):
                if other["kind"] == "contact" and self.modes[k] != "stick":
                    self.modes[k] = "+" if self.velocity(k, self.z) > 0 else "-"
                elif other["kind"] == "contact":
                    assert abs(self.velocity(k, self.z)) < mpf(10) ** -50, "a blow that sets a contact in motion"
            return
        if what in ("slip+", "slip-"):
            self.modes[i] = what[-1]
            self.events.append((self.t, i, "slip"))
            return
        if what == "zero":
            self.decide(i)
            kind = "stick" if self.modes[i] == "stick" else "reverse"
            self.events.append((self.t, i, kind))
            return
        names = {"yield+": "yield", "yield-": "yield", "hold": "lock", "close": "close", "open": "open"}
        self.modes[i] = {"close": "pressed", "open": "away"}.get(what, what)
        self.events.append((self.t, i, names[what]))


def digits(x):
    return mp.nstr(x, 48, strip_zeros=False)


G = mpf("9.80665")

# The files, with what they mean in SI units: written out here, and not read by a program.
CASES = {}

CASES["two masses with decimals"] = {
    "file": """{"mass": [[1.1, 0], [0, 0.7]], "damping": [[0.03, -0.01], [-0.01, 0.02]],
 "stiffness": [[3.3, -1.30000000000000000000000000000000000001], [-1.3000000000000000000000000000000000000100, 1.9]],
 "elements": [{"type": "contact", "direction": [0, 1], "friction": 0.1234567890123456789012345678901234567890}],
 "harmonics": [{"frequency": 1.3, "sin": [0.9, 0.1], "cos": [0, 0.3]}],
 "start": {"displacement": [0.1, -0.2], "velocity": [0.3, 0]}}""",
    "until": "20.3",
    "step": "0.02",
    "of": {
        "M": [["1.1", "0"], ["0", "0.7"]],
        "C": [["0.03", "-0.01"], ["-0.01", "0.02"]],
        "K": [
            ["3.3", "-1.30000000000000000000000000000000000001"],
            ["-1.30000000000000000000000000000000000001", "1.9"],
        ],
        "elements": [
            {"kind": "contact", "b": ["0", "1"], "friction": "0.1234567890123456789012345678901234567890"}
        ],
        "loads": [("1.3", ["0.9", "0.1"], ["0", "0.3"])],
        "start": {"q": ["0.1", "-0.2"], "v": ["0.3", "0"]},
    },
}

CASES["a belt with a static friction"] = {
    "file": """{"mass": [[1.3]], "damping": [[0.01]], "stiffness": [[7.7]],
 "elements": [{"type": "contact", "direction": [1], "friction": 0.3, "peak": 1.7, "belt": 0.05}]}""",
    "until": "17.9",
    "step": "0.01",
    "of": {
        "M": [["1.3"]],
        "C": [["0.01"]],
        "K": [["7.7"]],
        "elements": [{"kind": "contact", "b": ["1"], "friction": "0.3", "peak": "1.7", "belt": "0.05"}],
    },
}

CASES["an elastic contact and an elastic stop"] = {
    "file": """{"mass": [[2.2, 0], [0, 0.9]], "damping": [[0.1, -0.05], [-0.05, 0.07]], "stiffness": [[9.1, -3.3], [-3.3, 4.4]],
 "elements": [{"type": "elastic", "direction": [1, 0], "stiffness": 12.3, "friction": 0.77},
              {"type": "stop", "direction": [-1, 1], "gap": 0.21, "stiffness": 31.1, "damping": 0.0}],
 "harmonics": [{"frequency": 1.7, "sin": [2.1, 0.4], "cos": [0.3, 0]}]}""",
    "until": "12.7",
    "step": "0.01",
    "of": {
        "M": [["2.2", "0"], ["0", "0.9"]],
        "C": [["0.1", "-0.05"], ["-0.05", "0.07"]],
        "K": [["9.1", "-3.3"], ["-3.3", "4.4"]],
        "elements": [
            {"kind": "elastic", "b": ["1", "0"], "stiffness": "12.3", "friction": "0.77"},
            {"kind": "stop", "b": ["-1", "1"], "gap": "0.21", "stiffness": "31.1"},
        ],
        "loads": [("1.7", ["2.1", "0.4"], ["0.3", "0"])],
    },
}

CASES["blows at a stop"] = {
    "file": """{"mass": [[1.9]], "damping": [[0.13]], "stiffness": [[5.7]],
 "elements": [{"type": "contact", "direction": [1], "friction": 0.1}, {"type": "stop", "direction": [1], "gap": 0.3, "restitution": 0.7}],
 "harmonics": [{"frequency": 1.1, "sin": [3.1], "cos": [0.7]}]}""",
    "until": "14.1",
    "step": "0.01",
    "of": {
        "M": [["1.9"]],
        "C": [["0.13"]],
        "K": [["5.7"]],
        "elements": [
            {"kind": "contact", "b": ["1"], "friction": "0.1"},
            {"kind": "hard", "b": ["1"], "gap": "0.3", "restitution": "0.7"},
        ],
        "loads": [("1.1", ["3.1"], ["0.7"])],
    },
}

# 1 in = 25.4 mm, 1 lbf = 0.45359237 kg × 9.80665 m/s², in N, mm, t and s.
_w = 2 * pi * mpf("1.9")
_amplitude = mpf("0.3") * G * 1000
_phase = mpf("37") / 180 * pi
CASES["units, a base in g and a phase in degrees"] = {
    "file": """units = "N,mm"
[masses]
block = "1.1 t"
roof = { mass = "330 kg", start = "0.1 in", velocity = "70 mm/s" }
[[springs]]
between = ["ground", "block"]
stiffness = "120.7 N/mm"
damping = "2.3 N*s/mm"
[[springs]]
between = ["block", "roof"]
stiffness = "77 kN/m"
[[contacts]]
name = "bearing"
between = ["ground", "block"]
coefficient = 0.1
normal_load = "9.3 kN"
[base]
acceleration = { amplitude = "0.3 g", frequency = "1.9 Hz", phase = "37 deg" }
[[forces]]
on = "roof"
constant = "7 lbf"
""",
    "until": "2.9",
    "step": "0.004",
    "of": {
        "M": [["1.1", "0"], ["0", "0.33"]],
        "C": [["2.3", "0"], ["0", "0"]],
        "K": [["197.7", "-77"], ["-77", "77"]],
        "constant": [mpf(0), 7 * mpf("0.45359237") * G],
        "elements": [{"kind": "contact", "b": ["1", "0"], "friction": "930"}],
        "loads": [
            (
                _w,
                [-mpf("1.1") * _amplitude * mp.cos(_phase), -mpf("0.33") * _amplitude * mp.cos(_phase)],
                [-mpf("1.1") * _amplitude * mp.sin(_phase), -mpf("0.33") * _amplitude * mp.sin(_phase)],
            )
        ],
        "start": {"q": ["0", "2.54"], "v": ["0", "70"]},
    },
}


def transient(case):
    motion = Motion(case["of"], case["step"])
    motion.run(case["until"])
    n = motion.n
    return {
        "file": case["file"],
        "until": case["until"],
        "events": [[digits(t), i, kind] for t, i, kind in motion.events],
        "displacement": [digits(x) for x in motion.z[:n]],
        "velocity": [digits(x) for x in motion.z[n : 2 * n]],
    }


STEADY = {
    "file": """{"mass": [[1.7, 0], [0, 0.6]], "damping": [[1.9, -0.7], [-0.7, 0.9]], "stiffness": [[5.9, -2.1], [-2.1, 3.1]],
 "elements": [{"type": "contact", "direction": [1, 0], "friction": 0.9}],
 "harmonics": [{"frequency": 0.9, "sin": [1.3, 0.7], "cos": [0.1, 0]}]}""",
    "of": {
        "M": [["1.7", "0"], ["0", "0.6"]],
        "C": [["1.9", "-0.7"], ["-0.7", "0.9"]],
        "K": [["5.9", "-2.1"], ["-2.1", "3.1"]],
        "elements": [{"kind": "contact", "b": ["1", "0"], "friction": "0.9"}],
        "loads": [("0.9", ["1.3", "0.7"], ["0.1", "0"])],
    },
}


def steady(case):
    """The state at phase 0 after so many periods that a disturbance is below 10^-45."""
    motion = Motion(case["of"], "0.02")
    period = 2 * pi / mpf("0.9")
    before, change = None, mpf(1)
    for count in range(1, 60):
        # Each period begins with exact waves.
        motion.t = mpf(0)
        motion.events = []
        motion.z[motion.wave(0)], motion.z[motion.wave(0) + 1] = mpf(0), mpf(1)
        motion.run(period)
        now = motion.z[: 2 * motion.n]
        if before is not None:
            change = max(abs(a - b) for a, b in zip(now, before))
            if change < mpf(10) ** -45:
                break
        before = now
    assert change < mpf(10) ** -45, change
    n = motion.n
    return {
        "file": case["file"],
        "period": digits(period),
        "events": [[digits(t), i, kind] for t, i, kind in motion.events],
        "displacement": [digits(x) for x in motion.z[:n]],
        "velocity": [digits(x) for x in motion.z[n : 2 * n]],
    }


def border():
    """One body without a damper: eq. 61 of the paper, α_min = |1 − Ω²| √(1/Ω⁴ + tan²(π/2Ω)/Ω²)."""
    mass, stiffness, friction, load = mpf("1.1"), mpf("2.3"), mpf("0.1"), mpf("0.7")
    ratio = mpf("1.9") / mp.sqrt(stiffness / mass)
    alpha = abs(1 - ratio**2) * mp.sqrt(1 / ratio**4 + (mp.tan(pi / 2 / ratio) / ratio) ** 2)
    return {
        "file": """{"mass": [[1.1]], "stiffness": [[2.3]], "elements": [{"type": "contact", "direction": [1], "friction": 0.1}],
 "harmonics": [{"frequency": 1.9, "sin": [0.7]}]}""",
        "least_load_factor": digits(alpha * friction / load),
    }


def main(names):
    is_checked, names = bool(names), [] if names == ["all"] else names
    found = {name: transient(case) for name, case in CASES.items() if not names or name in names}
    if not names or "steady" in names:
        found["steady"] = steady(STEADY)
    if not names or "border" in names:
        found["border"] = border()
    if is_checked:
        kept = json.loads(FILE.read_text())
        for name, answer in found.items():
            assert kept[name] == answer, name
            print(name, "as in the file")
    else:
        FILE.write_text(json.dumps(found, indent=1) + "\n")
        for name, answer in found.items():
            print(name, len(answer.get("events", [])))


main(sys.argv[1:])
