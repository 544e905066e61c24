"""The closed forms in numpy, and in numba where it is installed: {Δ₀, eq. 61, A₁}, and those with {V₀, t₁}.

Usage: closed_forms.py POINTS, a file of doubles, all frequency ratios and then all force ratios.
"""
import sys
import time

import numpy as np

omega, alpha = np.fromfile(sys.argv[1]).reshape(2, -1)


def triple(w, a, xp=np):
    t, q = xp.tan(np.pi / 2 / w) / w, 1 - w * w
    d = xp.sqrt((a / q) ** 2 - t * t)
    return d, abs(q) * xp.sqrt(1 / (w * w) + (w * t) ** 2) / w, 8 * d / (a * a)


def five(w, a, xp=np):
    d, border, size = triple(w, a)
    b = np.pi / 2 / w
    secant, t, q = 1 / xp.cos(b), xp.tan(b), 1 - w * w
    psi = 0 * w
    for _ in range(3):
        s, c, so, co = xp.sin(psi), xp.cos(psi), xp.sin(w * psi), xp.cos(w * psi)
        v = w * d * co + secant * s - t * so
        d1 = secant * c - w * t * co - w * w * d * so
        d2 = -q * secant * s - w * w * v
        d3 = -q * secant * c - w * w * d1
        d4 = q * secant * s - w * w * d2
        n = -d1 / d2
        e = d3 / d2 * n
        h = n * (1 + e / 2) / (1 + e + d4 / d2 * n * n / 6)
        psi = psi + h
    sign = xp.sign(q)
    phase = xp.arctan2(sign * d, sign * t / w) - np.pi / 2 - w * psi
    return d, border, size, v + h * (d1 + h / 2 * (d2 + h / 3 * d3)), phase


def best(f, runs):
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        f(omega, alpha)
        times.append(time.perf_counter() - start)
    return min(times) / len(omega) * 1e9


print(f"numpy\ttriple\t{best(triple, 15):.2f}\nnumpy\tcycle\t{best(five, 5):.2f}")
try:
    import numba
except ImportError:
    sys.exit()


@numba.njit(fastmath=False)
def triple_loop(omega, alpha):
    out = np.empty((3, omega.size))
    for i in range(omega.size):
        w, a = omega[i], alpha[i]
        t, q = np.tan(np.pi / 2 / w) / w, 1 - w * w
        d = np.sqrt((a / q) ** 2 - t * t)
        out[0, i], out[1, i], out[2, i] = d, abs(q) * np.sqrt(1 / (w * w) + (w * t) ** 2) / w, 8 * d / (a * a)
    return out


triple_loop(omega[:10], alpha[:10])
print(f"numba\ttriple\t{best(triple_loop, 15):.2f}")
