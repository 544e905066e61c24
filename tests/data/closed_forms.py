#!/usr/bin/env python3
"""Writes points.csv and cycles.csv, the values that the closed forms are held against.

    python3 tests/data/closed_forms.py          # needs mpmath; takes about ten minutes
    git diff --exit-code tests/data             # nothing changes

Nothing here uses a formula of the paper or of the library. One half cycle between two reversals is solved as the linear equation
x" + x = 1 + alpha sin(theta) that it is (natural time, lengths in r_y/k); its start is found from x(T) = -x(0), x'(T) = 0; every other
value follows from that motion by its definition: extrema by search, work by quadrature, multipliers by differences of the half-turn
map, sensitivities by differences of the whole computation, optima by search.
"""
import sys
from pathlib import Path
from mpmath import mp, mpf, cos, sin, pi, sqrt, atan2, findroot, quad, hypot, matrix, lu_solve

HERE = Path(__file__).parent
mp.dps = 90

POINTS = """1.5 2.5|0.7 2.0|0.8 2.0|0.6 2.0|2.0 2.0|0.45 6.0|0.4 9.0|0.35 30.0|0.3 12.0|0.22 30.0|0.25 20.0|0.5 4.0|3.0 4.0
10.0 2.5|0.95 1.6|1.02 2.0|0.93924 1.2491"""
# Exact in 24 bits, so that f32, f64, batches and any precision are held against one table: below 1/2 between all poles down to 1/13,
# beside 1, 1/2 and 2/3, high; force ratios from just above the border to far above it.
OMEGAS = [
    "0.0810546875", "0.1015625", "0.1171875", "0.13671875", "0.15625", "0.1796875", "0.21875", "0.234375", "0.25", "0.28125",
    "0.3125", "0.359375", "0.375", "0.421875", "0.46875", "0.498046875", "0.5", "0.501953125", "0.5625", "0.625", "0.6640625", "0.75",
    "0.8515625", "0.9375", "0.9921875", "0.9990234375", "1.0009765625", "1.0078125", "1.0625", "1.25", "1.5", "1.75", "2.0", "2.5", "4.0", "10.0",
    "64.0", "1000.0",
]
OVERS = ["1.0009765625", "1.0625", "1.5", "3.0", "40.0"]


def forced(omega, s, c, phi):
    """The forced part of the motion and its velocity, for a drive s cos(omega phi) + c sin(omega phi)."""
    r = 1 / (1 - omega**2)
    return (
        r * (s * cos(omega * phi) + c * sin(omega * phi)),
        r * omega * (c * cos(omega * phi) - s * sin(omega * phi)),
        -r * omega**2 * (s * cos(omega * phi) + c * sin(omega * phi)),
    )


def slide(omega, s, c, x, v, sign, phi):
    """Displacement, velocity, acceleration after the time phi; sign is that of the velocity."""
    p, q, _ = forced(omega, s, c, mpf(0))
    a, b = x + sign - p, v - q
    f, g, h = forced(omega, s, c, phi)
    return (
        -sign + f + a * cos(phi) + b * sin(phi),
        g - a * sin(phi) + b * cos(phi),
        h - a * cos(phi) - b * sin(phi),
    )


class Frequency:
    """What belongs to one frequency ratio: the start (s, c) of the half cycle down from the maximum d, affine in d."""

    def __init__(self, omega):
        self.omega, self.time = omega, pi / omega
        end = lambda s, c, d: slide(omega, s, c, d, mpf(0), -1, self.time)[:2]
        # x(T) + d = 0 and x'(T) = 0 are affine in (s, c, d).
        zero, one = mpf(0), mpf(1)
        x0, v0 = end(zero, zero, zero)
        column = lambda s, c, d: matrix([end(s, c, d)[0] + d - x0, end(s, c, d)[1] - v0])
        by_s, by_c, by_d = column(one, zero, zero), column(zero, one, zero), column(zero, zero, one)
        m = matrix([[by_s[0], by_c[0]], [by_s[1], by_c[1]]])
        self.at_zero = lu_solve(m, matrix([-x0, -v0]))
        self.per_d = lu_solve(m, -by_d)

    def drive(self, d):
        return [self.at_zero[i] + self.per_d[i] * d for i in (0, 1)]

    def alpha(self, d):
        return hypot(*self.drive(d))

    def displacement(self, alpha):
        """The larger root d of |drive(d)| = alpha."""
        a = self.per_d[0] ** 2 + self.per_d[1] ** 2
        b = self.per_d[0] * self.at_zero[0] + self.per_d[1] * self.at_zero[1]
        c = self.at_zero[0] ** 2 + self.at_zero[1] ** 2 - alpha**2
        return (-b + sqrt(b * b - a * c)) / a

    def border(self):
        """The least d whose half cycle goes down all the way, where its velocity touches zero first, and the least that the turn allows."""
        omega = self.omega

        def least(phi):
            # The velocity is u + d w, negative where d is above this.
            parts = [slide(omega, *self.drive(d), d, mpf(0), -1, phi) for d in (mpf(0), mpf(1))]
            i = 1 if phi > 0 else 2
            return -parts[0][i] / (parts[1][i] - parts[0][i])

        # At the end of the half cycle velocity and bound vanish as at its start: by symmetry the same, upside down.
        at_turn = least(mpf(0))
        count = 40 + int(60 / omega)
        # Closer and closer to the turn, where the touching begins as the frequency ratio falls below 1/(2n).
        grid = [self.time / count / mpf(2) ** k for k in range(24, 0, -1)]
        grid += [self.time * i / count for i in range(1, count)]
        with mp.workdps(50):
            values = [least(+phi) for phi in grid]
        top = max(range(len(values)), key=values.__getitem__)
        if values[top] <= at_turn * (1 + mpf(10) ** -25):
            return at_turn, mpf(0), at_turn
        # Golden sections until Newton's method on the derivative can take over.
        a, b = grid[max(top - 1, 0)], grid[min(top + 1, len(grid) - 1)]
        golden = (3 - sqrt(mpf(5))) / 2
        with mp.workdps(60):
            for _ in range(80):
                p, q = a + golden * (b - a), b - golden * (b - a)
                a, b = (a, q) if least(p) > least(q) else (p, b)

        # Where u + d w and its derivative vanish together.
        def touch(phi):
            d = least(phi)
            return slide(omega, *self.drive(d), d, mpf(0), -1, phi)[2]

        phi = findroot(touch, ((a + b) / 2, (a + b) / 2 * (1 + mpf(10) ** -15)), tol=mpf(10) ** (-2 * mp.dps + 40), verify=False)
        return least(phi), omega * phi, at_turn


def turn(x):
    return x % (2 * pi)


def multipliers(omega, s, c, d):
    """Of the map over half a turn, from the middle of the half cycle down, by differences."""
    half = pi / omega / 2
    x, v, _ = slide(omega, s, c, d, mpf(0), -1, half)
    # The drive at that instant.
    s, c = s * cos(omega * half) + c * sin(omega * half), c * cos(omega * half) - s * sin(omega * half)

    def over(x, v):
        # The turn is beside that of the cycle itself, in the middle: Newton's method from there.
        phi = half
        for _ in range(6):
            _, speed, slope = slide(omega, s, c, x, v, -1, phi)
            phi -= speed / slope
        y, _, _ = slide(omega, s, c, x, v, -1, phi)
        so, co = s * cos(omega * phi) + c * sin(omega * phi), c * cos(omega * phi) - s * sin(omega * phi)
        x, v, _ = slide(omega, so, co, y, mpf(0), 1, 2 * half - phi)
        return -x, -v

    h = mpf(10) ** (-mp.dps // 3)
    by_x = [(p - q) / (2 * h) for p, q in zip(over(x + h, v), over(x - h, v))]
    by_v = [(p - q) / (2 * h) for p, q in zip(over(x, v + h), over(x, v - h))]
    trace, det = by_x[0] + by_v[1], by_x[0] * by_v[1] - by_x[1] * by_v[0]
    root = sqrt(mp.mpc(trace**2 / 4 - det))
    return [trace / 2 + root, trace / 2 - root]


def outputs(omega, alpha, with_multipliers=True):
    at = Frequency(omega)
    d = at.displacement(alpha)
    s, c = at.drive(d)
    motion = lambda phi: slide(omega, s, c, d, mpf(0), -1, phi)
    # The fastest instant of the half cycle.
    count = 40 + int(60 / omega)
    grid = [at.time * i / count for i in range(count + 1)]
    with mp.workdps(30):
        speeds = [motion(phi)[1] for phi in grid]
    fastest = min(range(len(grid)), key=speeds.__getitem__)
    low, high = grid[max(fastest - 1, 0)], grid[min(fastest + 1, count)]
    phi = findroot(lambda phi: motion(phi)[2], (low, high), solver="illinois", tol=mpf(10) ** (-2 * mp.dps + 20), maxsteps=400)
    x, v, _ = motion(phi)
    theta = atan2(s, c)
    # The work of the drive over the half cycle, once more by what it does: the integral of force times velocity.
    parts = [at.time * i / 8 for i in range(9)] if omega > 0.2 else [at.time * i / 40 for i in range(41)]
    with mp.workdps(50):
        work = 2 * quad(lambda phi: (s * cos(omega * phi) + c * sin(omega * phi)) * motion(phi)[1], parts)
    least, touching, at_turn = at.border()
    # The force ratio of the largest loop, were there no sticking: d/alpha^2 is greatest.
    size = lambda a: 8 * at.displacement(a) / a**2
    start = hypot(*at.drive(mpf(0)))
    best = None
    if start > mpf(10) ** -60:
        slope = lambda a: mp.diff(lambda a: mp.log(size(a)), a, h=mpf(10) ** -(mp.dps // 3))
        # The drive that d = 0 needs is |K|, below which there is no motion.
        best = findroot(slope, (start * mpf("1.4"), start * mpf("1.43")), tol=mpf(10) ** -(mp.dps // 3), verify=False)
        best = exact_best(at, start, best)
    found = {
        "max_displacement": d,
        "displacement_phase": turn(theta),
        "max_velocity": -v / omega,
        "velocity_phase": turn(theta + omega * phi + pi),
        "deviation": -x,
        "min_force_ratio": at.alpha(least),
        "min_force_ratio_turning_point": at.alpha(at_turn),
        "border_phase": touching,
        "loop_size_stiffness": 2 * work / alpha**2,
        "loop_size_inertia": 2 * work / alpha**2 * omega**2,
        "best_force_ratio": mpf(0) if best is None else best,
        "best_loop_size": None if best is None else size(best),
        "contraction": max(abs(m) for m in multipliers(omega, s, c, d)) if with_multipliers else None,
    }
    return found


def exact_best(at, start, near):
    """The maximum of d/alpha^2 to all digits: where d' alpha = 2 d, with d' from |drive(d)| = alpha."""

    def condition(alpha):
        d = at.displacement(alpha)
        s, c = at.drive(d)
        slope = alpha / (s * at.per_d[0] + c * at.per_d[1])
        return slope * alpha - 2 * d

    return findroot(condition, (near, near * (1 + mpf(10) ** -12)), tol=mpf(10) ** -(2 * mp.dps - 30), verify=False)


def text(value, digits):
    if value is None:
        return ""
    if value == 0:
        return "0.0"
    return mp.nstr(value, digits, strip_zeros=False, min_fixed=-30, max_fixed=60)


def points():
    names = None
    lines = []
    for point in POINTS.replace("\n", "|").split("|"):
        omega, alpha = point.split()
        found = outputs(mpf(float(omega)), mpf(float(alpha)))
        names = names or list(found)
        lines.append(",".join([omega, alpha] + [text(found[name], 40) for name in names]))
    (HERE / "points.csv").write_text("\n".join([",".join(["omega", "alpha"] + names)] + lines) + "\n")


SLOPES = [
    "max_displacement", "displacement_phase", "max_velocity", "velocity_phase", "deviation", "min_force_ratio",
    "loop_size_stiffness", "best_force_ratio", "contraction",
]


def sensitivities(omega, alpha, names):
    """By Omega and by alpha, by central differences of everything above."""
    h = mpf(10) ** -15
    result = {}
    for variable, (u, w) in {"omega": (h, 0), "alpha": (0, h)}.items():
        a, b = (outputs(omega + k * u, alpha + k * w) for k in (1, -1))
        for name in names:
            result[f"{name}_by_{variable}"] = (a[name] - b[name]) / (2 * h)
    return result


def cycles(only=None):
    lines = []
    head = None
    for i, omega in enumerate(OMEGAS):
        if only is not None and omega not in only:
            continue
        at = Frequency(mpf(omega))
        border = at.alpha(at.border()[0])
        for j, over in enumerate(OVERS):
            if (i + j) % 2 and over != "1.5":
                continue
            # Above the border by about that factor, with at most 20 bits.
            scale = mpf(2) ** (20 - int(mp.floor(mp.log(border * mpf(over), 2))))
            alpha = mp.ceil(border * mpf(over) * scale) / scale
            if alpha < border:
                sys.exit("below the border")
            found = outputs(mpf(omega), alpha)
            slopes = {}
            if over == "1.5" and omega not in ("0.5", "0.25"):
                slopes = sensitivities(mpf(omega), alpha, SLOPES)
            row = dict(found)
            for variable in ("omega", "alpha"):
                for name in SLOPES:
                    key = f"{name}_by_{variable}"
                    row[key] = slopes.get(key)
            head = head or ["omega", "alpha"] + list(row)
            lines.append(",".join([omega, mp.nstr(alpha, 40)] + [text(row[k], 25) for k in head[2:]]))
            print(omega, over, flush=True)
    if only is not None:
        return lines
    (HERE / "cycles.csv").write_text("\n".join([",".join(head)] + lines) + "\n")


if __name__ == "__main__":
    wanted = sys.argv[1:] or ["points", "cycles"]
    for name in wanted:
        globals()[name]()
