"""The slip force of a friction damper between two storeys that makes the greatest displacement of the roof over a band of frequencies least, by
`scipy.optimize`."""

import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import minimize_scalar

import stickslip as ss

hertz = np.linspace(0.5, 2.5, 61)
frame = (
    ss.System(units="kN,mm")
    .mass("first", "60 t")
    .mass("roof", "60 t")
    .spring("ground", "first", "12 kN/mm", damping="0.02 kN*s/mm")
    .spring("first", "roof", "12 kN/mm", damping="0.02 kN*s/mm")
    .contact("first", "roof", "20 kN", name="damper")
    .force("roof", "30 kN", frequency="1 Hz")
)


def roof(slip):
    return frame.grid({"damper.friction": [f"{slip} kN"]}, frequency=hertz)["roof.max_displacement"]


best = minimize_scalar(lambda slip: roof(slip).max(), bounds=(2, 120), method="bounded", options={"xatol": 0.5})
axes = plt.figure(layout="constrained").gca()
for slip, style in ((2.0, ":"), (best.x, "-"), (120.0, "--")):
    axes.plot(hertz, roof(slip), style, label=f"slips at {slip:.3g} kN")
axes.set(xlabel="frequency (Hz)", ylabel="greatest displacement of the roof (mm)", yscale="log")
axes.legend()
assert best.fun < 0.8 * min(roof(2.0).max(), roof(120.0).max())
