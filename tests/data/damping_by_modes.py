#!/usr/bin/env python3
"""Damping matrices of structures by modes, for `tests/systems/damping.rs`: `damping_by_modes.py > damping_by_modes.json`.

Needs `pip install mpmath numpy scipy`. The modes are those of the generalised problem K x = ω² M x by mpmath at 50 digits, and C is
M Φ diag(2 ζ ω) Φᵀ M. Coordinates without mass are condensed, and C is carried to coordinates that are moved by the static displacements of the
structure under them, `[I, K_ff⁻¹ K_fm]`, where no motion is rigid. Where all coordinates have mass, scipy.linalg.eigh has the same C to
1e-11. Numbers have four decimals, so that doubles and more digits read the same texts.
"""

import json
import random

import mpmath as mp
import numpy as np
import scipy.linalg

mp.mp.dps = 50
random.seed(78)


def number(low, high):
    return mp.mpf(f"{random.uniform(low, high):.4f}")


def springs(n, links):
    """The stiffness of springs between coordinates, or the ground (None)."""
    k = mp.zeros(n)
    for a, b in links:
        value = number(1, 60)
        for i, j, sign in ((a, a, 1), (b, b, 1), (a, b, -1), (b, a, -1)):
            if i is not None and j is not None:
                k[i, j] += sign * value
    return k


def mass(n, light, coupled):
    m = mp.zeros(n)
    for i in range(n):
        if i not in light:
            m[i, i] = number(1, 5)
    if coupled:
        for i in range(n - 1):
            if i not in light and i + 1 not in light:
                m[i, i + 1] = m[i + 1, i] = number(-0.4, 0.4)
    return m


def part(a, rows, columns):
    return mp.matrix([[a[i, j] for j in columns] for i in rows]) if rows and columns else mp.zeros(len(rows), len(columns))


def damping(m, k, ratios, rigid):
    """C of a structure whose coordinates all have mass."""
    n = m.rows
    low = mp.cholesky(m)
    inverse = mp.inverse(low)
    values, vectors = mp.eigsy(inverse * k * inverse.T)
    order = sorted(range(n), key=lambda j: values[j])[rigid:]
    c = mp.zeros(n)
    for place, j in enumerate(order):
        shape = low * vectors[:, j]
        c += 2 * ratios[min(place, len(ratios) - 1)] * mp.sqrt(values[j]) * shape * shape.T
    if rigid == 0:
        squares, shapes = scipy.linalg.eigh(np.array(k.tolist(), float), np.array(m.tolist(), float))
        each = np.array([float(ratios[min(j, len(ratios) - 1)]) for j in range(n)])
        left = np.array(m.tolist(), float) @ shapes
        other = left @ np.diag(2 * each * np.sqrt(squares)) @ left.T
        assert np.abs(other - np.array(c.tolist(), float)).max() < 1e-11 * np.abs(other).max()
    return c


def case(name, n, links, ratios, light=(), moved=(), coupled=True, rigid=0):
    k = springs(n, links)
    m = mass(n, [*light, *moved], coupled)
    ratios = [mp.mpf(x) for x in ratios]
    bodies = [i for i in range(n) if i not in light and i not in moved]
    free = [i for i in range(n) if i not in light]
    reduced = part(k, free, free)
    if light:
        reduced -= part(k, free, light) * mp.inverse(part(k, light, light)) * part(k, light, free)
    place = {i: a for a, i in enumerate(free)}
    inner, outer = [place[i] for i in bodies], [place[i] for i in moved]
    c = damping(part(m, bodies, bodies), part(reduced, inner, inner), ratios, rigid)
    if moved:
        follows = mp.inverse(part(reduced, inner, inner)) * part(reduced, inner, outer)
        carried = mp.zeros(len(bodies), len(free))
        for a in range(len(bodies)):
            carried[a, inner[a]] = 1
            for b, j in enumerate(outer):
                carried[a, j] = follows[a, b]
        c, columns = carried.T * c * carried, free
    else:
        columns = bodies
    whole = mp.zeros(n)
    for a, i in enumerate(columns):
        for b, j in enumerate(columns):
            whole[i, j] = c[a, b]

    def rows(a, digits):
        return [[mp.nstr(a[i, j], digits) for j in range(n)] for i in range(n)]

    return {
        "name": name,
        "mass": rows(m, 10),
        "stiffness": rows(k, 10),
        "moved": list(moved),
        "ratios": [mp.nstr(x, 10) for x in ratios],
        "damping": rows(whole, 40),
    }


CHAIN = [(None, 0), (0, 1), (1, 2), (2, 3), (3, 4)]
CASES = [
    case("a chain with one ratio", 5, CHAIN, ["0.02"]),
    case("a ratio for each mode", 5, [*CHAIN, (None, 4), (0, 3)], ["0.01", "0.02", "0.03", "0.05", "0.4"]),
    case("the last ratio is that of all further modes", 5, CHAIN, ["0.1", "0.02"], coupled=False),
    case("a chain without ground has a rigid motion", 5, CHAIN[1:], ["0.03", "0.07"], rigid=1),
    case("two chains without ground have two", 5, [(0, 1), (2, 3), (3, 4)], ["0.03"], rigid=2),
    case("joints without mass", 6, [*CHAIN, (4, 5), (1, 4)], ["0.02", "0.05"], light=(2, 4)),
    case("a support that is moved", 5, CHAIN[1:] + [(None, 2)], ["0.05", "0.01"], moved=(0,)),
    case("two supports, a joint", 6, [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (1, 3)], ["0.04"], light=(2,), moved=(0, 5)),
    case("24 coordinates", 24, [(None, 0)] + [(i, i + 1) for i in range(23)] + [(i, i + 5) for i in range(19)], ["0.02", "0.03", "0.01"]),
]
print("[\n" + ",\n".join(json.dumps(case) for case in CASES) + "\n]")
