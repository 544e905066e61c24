"""Several steady motions of one machine with a static friction above the kinetic one: which of them each start leads to."""

import matplotlib.pyplot as plt
import numpy as np

import stickslip as ss

x, v = np.linspace(-6, 6, 120), np.linspace(-6, 6, 120)
found = ss.basins(0.573, 3.92, damping_ratio=0.005, static_friction_ratio=1.87, displacement=x, velocity=v)
axes = plt.figure(layout="constrained").gca()
axes.pcolormesh(x, v, found.attractor, cmap="viridis", shading="nearest", rasterized=True)
peaks = [limit.max_displacement for limit in found.attractors]
title = "peaks " + ", ".join(f"{peak:.2f}" for peak in sorted(peaks))
axes.set(xlabel="displacement at the start (B)", ylabel="velocity at the start (B ω)", title=title)
assert len(peaks) > 1 and set(np.unique(found.attractor)) <= set(range(-1, len(peaks)))
