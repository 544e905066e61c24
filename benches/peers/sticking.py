"""A motion with stops and damping from rest until it repeats, by SciPy (solve_ivp with events) and by
closed-form slides in numba, each where it is installed. Slides end at the velocity's zero, the end of a stop is
its arcsine.

Usage: sticking.py OMEGA ALPHA ZETA RTOL REFERENCE. Prints, for each, the least time in microseconds and the
relative error of the maximum displacement.
"""
import math
import sys
import time

omega, alpha, zeta, rtol, reference = map(float, sys.argv[1:6])


def released(w, a, t, x):
    """From rest at x: when the body slides, and which way."""
    force = a * math.sin(w * t) - x
    if abs(force) > 1:
        return t, math.copysign(1.0, force)
    now, first, way = w * t, math.inf, 0.0
    for s in (1.0, -1.0):
        y = (x + s) / a
        if abs(y) < 1:
            angle = math.asin(y) if s > 0 else math.pi - math.asin(y)
            angle += math.ceil((now - angle) / (2 * math.pi)) * 2 * math.pi
            if angle <= now:
                angle += 2 * math.pi
            if angle < first:
                first, way = angle, s
    return first / w, way


def settled(w, a, z, tolerance, slide):
    """The greatest displacement of a turn of the drive, once two turns have the same to 1e-12."""
    t, x, turns, turn = 0.0, 0.0, 1, 2 * math.pi / w
    most = before = -math.inf
    while turns < 2000:
        t, way = released(w, a, t, x)
        t, x = slide(w, a, z, tolerance, t, x, way)
        if t > turns * turn:
            if abs(most - before) < 1e-12 * (1 + most):
                break
            before, most, turns = most, -math.inf, int(t / turn) + 1
        most = max(most, x)
    return most


def by_scipy(w, a, z, tolerance, t, x, way):
    from scipy.integrate import solve_ivp

    def stops(_, y):
        return y[1]

    stops.terminal, stops.direction = True, -way
    solution = solve_ivp(
        lambda t, y: (y[1], a * math.sin(w * t) - y[0] - 2 * z * y[1] - way),
        (t, t + 8 * math.pi / w),
        (x, 0.0),
        method="DOP853",
        rtol=tolerance,
        atol=tolerance / 100,
        events=stops,
    )
    return solution.t_events[0][0], solution.y_events[0][0][0]


def in_closed_form(w, a, z, tolerance, t, x, way):
    """Steps of a sixteenth of the shorter period to the velocity's zero, which is then bisected and polished."""
    d, p, k = math.sqrt(1 - z * z), 1 - w * w, 2 * z * w
    scale = a / (p * p + k * k)
    sine, cosine = p * scale, -k * scale
    c = x + way - (sine * math.sin(w * t) + cosine * math.cos(w * t))
    e = (z * c - w * (sine * math.cos(w * t) - cosine * math.sin(w * t))) / d
    step = 2 * math.pi / max(1.0, w) / 16
    low, high, value, at, rate = 0.0, 0.0, 1.0, x, 0.0
    for i in range(10000):
        bisecting = value <= 0
        if not bisecting:
            low, high = high, high + step
            h = high
        else:
            h = (low + high) / 2
        for polish in range(60 if bisecting else 1):
            fade = math.exp(-z * h)
            sd, cd = math.sin(d * h), math.cos(d * h)
            st, ct = math.sin(w * (t + h)), math.cos(w * (t + h))
            at = sine * st + cosine * ct - way + fade * (c * cd + e * sd)
            v = w * (sine * ct - cosine * st) + fade * ((d * e - z * c) * cd - (d * c + z * e) * sd)
            rate = a * st - at - 2 * z * v - way
            value = v * way
            if not bisecting:
                break
            if value > 0:
                low = h
            else:
                high = h
            next = h - v / rate
            if abs(next - h) < 4e-16 * (1 + h):
                return t + h, at
            h = next if low < next < high else (low + high) / 2
        if bisecting:
            break
    return t + h, at


def timed(name, run, runs):
    run()
    best = math.inf
    for _ in range(runs):
        begin = time.perf_counter()
        most = run()
        best = min(best, time.perf_counter() - begin)
    print(f"{name}\t{best * 1e6:.2f}\t{abs(most / reference - 1):.1e}", flush=True)


try:
    import scipy

    name = f"SciPy {scipy.__version__}, DOP853, {rtol:g}"
    timed(name, lambda: settled(omega, alpha, zeta, rtol, by_scipy), 1)
except ImportError:
    pass
try:
    import numba

    released, in_closed_form = numba.njit(released), numba.njit(in_closed_form)
    settle = numba.njit(settled)
    name = f"numba {numba.__version__}, closed-form slides"
    timed(name, lambda: settle(omega, alpha, zeta, rtol, in_closed_form), 200)
except ImportError:
    pass
