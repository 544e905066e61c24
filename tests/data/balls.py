#!/usr/bin/env python3
"""Values of Arb, by python-flint, for the unit tests of `src/float/ball`: `balls.py > balls.csv`.

Needs `pip install python-flint`. Each row is a function, its arguments and the result, each a midpoint and a radius as a ratio of
integers, so that nothing is rounded on the way; `nan` is the whole line.
"""

import random

from flint import arb, ctx

ctx.prec = 128
random.seed(20)


def ratio(x):
    """A dyadic number as p/q."""
    mantissa, exponent = x.man_exp()
    mantissa, exponent = int(mantissa), int(exponent)
    return f"{mantissa << exponent}" if exponent >= 0 else f"{mantissa}/{1 << -exponent}"


def ball(exact_share):
    mid = arb(random.getrandbits(128) * random.choice([1, -1])) * arb(2) ** (random.randint(-6, 4) - 128)
    if random.random() < exact_share:
        return mid
    radius = arb(random.getrandbits(20) | 1) * arb(2) ** random.choice([-20, -22, -25, -40, -80, -120, -140])
    return arb(mid, radius)


def written(x):
    if not x.is_finite():
        return "nan,nan"
    return f"{ratio(x.mid())},{ratio(x.rad())}"


FUNCTIONS = {
    "add": lambda x, y: x + y,
    "sub": lambda x, y: x - y,
    "mul": lambda x, y: x * y,
    "div": lambda x, y: x / y,
    "sqrt": lambda x, y: x.sqrt(),
    "sin": lambda x, y: x.sin(),
    "cos": lambda x, y: x.cos(),
    "tan": lambda x, y: x.tan(),
    "exp": lambda x, y: x.exp(),
    "atan2": lambda x, y: arb.atan2(x, y),
}

print("function,x,x_rad,y,y_rad,mid,rad")
for _ in range(50):
    x, y = ball(0.3), ball(0.3)
    for name, function in FUNCTIONS.items():
        print(f"{name},{written(x)},{written(y)},{written(function(x, y))}")
