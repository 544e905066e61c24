"""Reference values of the damped cycle, at 60 digits, without the library: python3 damped.py > damped.csv (needs mpmath).

Displacements in units of B = r_y/k, velocities in B ω_d, phases in radians. The matching conditions give G, H and a in closed form; the
peak velocity and the border are found by dense sampling of the half cycle and a root at full precision.
"""

from mpmath import mp, mpf, mpc, sqrt, sinh, cosh, sin, cos, exp, atan2, pi, findroot

mp.dps = 60

POINTS = """
0.7 0.05 2.3519699279966226
1.0 0.1 4.464608071062507
1.5 0.2 1.808315329064099
0.4 0.05 66.15888396920725
1.0 0.001 1.9128616037207933
0.3333333333333333 0.02 279.45948310767625
0.5 0.01 3.0947965663132337
2.5 0.7 18.574522352540438
0.3 0.03 24.41456343722233
1.0000001 1e-05 3.8197788256398333
0.4147897064560407 0.053876790338357426 66.68124457220506
0.1998474308104274 0.041395532751703004 100.56560558594066
0.8921283057556666 0.00016299356756593642 4.821599095161707
0.7549360054347884 3.0445124259454177e-05 1.780114494656068
0.6 1.0 9.0
1.7 1.0 11.0
0.45 1.5 30.0
3.0 2.5 70.0
0.9 40.0 300.0
20.0 0.05 9.0
300.0 0.3 40.0
50.0 3.0 500.0
0.25 1e-9 40.0
0.33 1e-3 900.0
0.335 1e-3 900.0
0.143 0.004 3000.0
0.07 0.02 400.0
0.45 0.3 12.0
0.2 0.999999 80.0
0.2 1.000001 80.0
"""


def free(zeta, t, x0, v0):
    """Free vibration from (x0, v0) after t: displacement and velocity."""
    d = sqrt(mpc(1 - zeta**2))
    s = t if zeta == 1 else (sin(d * t) / d).real
    c = cos(d * t).real
    e = exp(-zeta * t)
    return e * (x0 * c + (v0 + zeta * x0) * s), e * (v0 * c - (zeta * v0 + x0) * s)


def root(f, low, high):
    return findroot(f, (low, high), solver="anderson", tol=mpf(10) ** -110, verify=False)


def row(omega, zeta, alpha):
    period = pi / omega
    d = sqrt(mpc(1 - zeta**2))
    s = period if zeta == 1 else (sin(d * period) / d).real
    c = cos(d * period).real
    n = cosh(zeta * period) + c
    g, h = (sinh(zeta * period) - zeta * s) / n, s / (omega * n)
    q = sqrt((1 - omega**2) ** 2 + (2 * zeta * omega) ** 2)
    lag = atan2(2 * zeta * omega, 1 - omega**2)
    a, b = sqrt((alpha / q) ** 2 - h**2), omega * h

    def motion(t):
        x, v = free(zeta, t, 1 + g, b)
        x, v = x - 1 - a * cos(omega * t) - h * sin(omega * t), v + a * omega * sin(omega * t) - b * cos(omega * t)
        return x, v

    def acceleration(t):
        x, v = free(zeta, t, 1 + g, b)
        return a * omega**2 * cos(omega * t) + b * omega * sin(omega * t) - 2 * zeta * v - x

    def needed(t):
        return (b * cos(omega * t) - free(zeta, t, 1 + g, b)[1]) / (omega * sin(omega * t))

    def rise(t):
        x, v = free(zeta, t, 1 + g, b)
        slope = -b * omega * sin(omega * t) + 2 * zeta * v + x
        return slope * omega * sin(omega * t) - (b * cos(omega * t) - v) * omega**2 * cos(omega * t)

    count = int(600 * max(1, period / 6, period * zeta / 2))
    times = [period * i / count for i in range(count + 1)]
    mp.dps = 25
    slopes = [acceleration(t) for t in times]
    needs = [needed(t) for t in times[1:-1]]
    mp.dps = 60
    fastest = max(
        (motion(t)[::-1] + (t,) for t in (
            root(acceleration, times[i], times[i + 1]) for i in range(count) if slopes[i] > 0 >= slopes[i + 1]
        )),
        key=lambda found: found[0],
    )
    turning_point = (1 + g + 2 * zeta * b) / omega**2
    least, touch = turning_point, mpf(0)
    for i in range(1, len(needs) - 1):
        if needs[i] >= needs[i - 1] and needs[i] >= needs[i + 1] and needs[i] > turning_point / 2:
            t = root(rise, times[i], times[i + 2])
            if needed(t) > least:
                least, touch = needed(t), omega * t
    t2 = (lag + atan2(a, h)) % (2 * pi)
    t1 = (t2 - pi + omega * fastest[2]) % (2 * pi)
    r = omega**2 * a - g - 2 * zeta * b
    factor = (r - 1) / (r + 1)
    decay = exp(-zeta * period)
    trace = decay * (c + zeta * s) + factor * decay * (c - zeta * s)
    spread = sqrt(mpc(trace**2 - 4 * factor * decay**2))
    contraction = max(abs(-trace + spread), abs(-trace - spread)) / 2
    work = 4 * zeta * mp.quad(lambda t: motion(t)[1] ** 2, mp.linspace(0, period, 9 + int(period * max(1, zeta))))
    return {
        "max_displacement": a - g,
        "displacement_phase": t2,
        "max_velocity": fastest[0] / omega,
        "velocity_phase": t1,
        "deviation": fastest[1],
        "min_force_ratio": q * sqrt(least**2 + h**2),
        "min_force_ratio_turning_point": q * sqrt(turning_point**2 + h**2),
        "border_phase": touch,
        "least_displacement": least - g,
        "contraction": contraction,
        "damper_work": work,
        "condition": (alpha / q) ** 2 / (a * (a - g)),
    }


if __name__ == "__main__":
    header = None
    for line in POINTS.split("\n"):
        if not line:
            continue
        # The numbers are the floats that the decimals name.
        found = row(*(mpf(float(x)) for x in line.split()))
        if header is None:
            header = ["omega", "damping_ratio", "alpha", *found]
            print(",".join(header))
        digits = [mp.nstr(x, 8 if k == "condition" else 45) for k, x in found.items()]
        print(",".join([*line.split(), *digits]))
