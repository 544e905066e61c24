#!/usr/bin/env python3
"""Writes figure_3.csv: the four error measures of figure 3 by a simulation of its own.

    python3 tests/data/figure_3.py              # needs mpmath; takes ten seconds
    git diff --exit-code tests/data             # nothing changes

The motion from rest is followed event by event at 40 digits: stuck until the force exceeds the friction, then sliding until the velocity
is zero, found by steps of a hundredth of the shorter period and bisection. Extrema are those of the 21st cycle.
"""
from pathlib import Path
from mpmath import mp, mpf, cos, sin, pi, findroot, ceil

HERE = Path(__file__).parent
mp.dps = 40
CYCLES = 20
# The places of the figure's points, and three force ratios.
OMEGAS = [mpf("0.6025") + mpf("0.005") * i for i in (0, 37, 64, 79, 80, 95, 130, 199, 279)]
INVERSES = ["0.3", "0.4", "0.5"]


class Slide:
    """Sliding from (t, x, v) in natural time with the friction -sign: x" + x = alpha sin(omega t) - sign."""

    def __init__(self, omega, alpha, t, x, v, sign):
        self.omega, self.t, self.sign = omega, t, sign
        self.amplitude = alpha / (1 - omega**2)
        self.a = x + sign - self.amplitude * sin(omega * t)
        self.b = v - self.amplitude * omega * cos(omega * t)

    def x(self, t):
        s = t - self.t
        return self.amplitude * sin(self.omega * t) - self.sign + self.a * cos(s) + self.b * sin(s)

    def v(self, t):
        s = t - self.t
        return self.amplitude * self.omega * cos(self.omega * t) - self.a * sin(s) + self.b * cos(s)

    def w(self, t):
        s = t - self.t
        return -self.amplitude * self.omega**2 * sin(self.omega * t) - self.a * cos(s) - self.b * sin(s)


def bisect(f, a, b):
    low = f(a)
    for _ in range(140):
        middle = (a + b) / 2
        if (f(middle) > 0) == (low > 0):
            a = middle
        else:
            b = middle
    return (a + b) / 2


def zeros(f, a, b, step, value=None):
    """The sign changes of f after a, up to b."""
    count = int(ceil((b - a) / step))
    at, here = a, f(a) if value is None else value
    for i in range(1, count + 1):
        after = min(a + i * step, b)
        there = f(after)
        if (here > 0) != (there > 0):
            yield bisect(f, at, after)
        at, here = after, there


def errors(omega, alpha):
    step = min(pi / omega, pi) / 50
    turn = 2 * pi / omega
    begin, end = CYCLES * turn, (CYCLES + 1) * turn
    t, x, v = mpf(0), mpf(0), mpf(0)
    positions, velocities = [], []
    while t < end:
        force = lambda t: alpha * sin(omega * t) - x
        if v == 0 and abs(force(t)) <= 1:
            # At rest until the force is more than friction.
            t = next(zeros(lambda t: abs(force(t)) - 1, t, t + turn, step, value=mpf(-1)))
            sign = 1 if force(t) > 0 else -1
        else:
            sign = 1 if (v > 0 or v == 0 and force(t) > 0) else -1
        slide = Slide(omega, alpha, t, x, v, sign)
        first = t + step / 1000
        assert slide.v(first) * sign > 0
        stop = next(zeros(slide.v, first, end + turn, step), end + turn)
        low, high = max(t, begin), min(stop, end)
        if high > low:
            positions += [(slide.x(low), low), (slide.x(high), high)]
            instants = [low, high] + list(zeros(slide.w, low, high, step))
            velocities += [(slide.v(i), i) for i in instants]
        t, x, v = stop, slide.x(stop), mpf(0)
    found = []
    for values in (positions, velocities):
        (most, at_most), (least, at_least) = max(values), min(values)
        found += [abs(most + least) / most, abs((abs(at_least - at_most) * omega - pi) / (2 * pi))]
    return found


if __name__ == "__main__":
    lines = ["inverse,omega,error_1,error_2,error_3,error_4"]
    for inverse in INVERSES:
        for omega in OMEGAS:
            found = errors(omega, 1 / mpf(inverse))
            lines.append(",".join([inverse, mp.nstr(omega, 10)] + [mp.nstr(e, 15, strip_zeros=False) for e in found]))
            print(lines[-1], flush=True)
    (HERE / "figure_3.csv").write_text("\n".join(lines) + "\n")
