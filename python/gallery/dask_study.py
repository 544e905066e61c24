"""A study on many processors by Dask: 8,000 isolators of random period and friction under one earthquake, in blocks, each of which is one call."""

import dask
import matplotlib.pyplot as plt
import numpy as np

import stickslip as ss

t = np.arange(0, 15, 0.01)
quake = ss.Record(0.3 * np.exp(-(((t - 6) / 3) ** 2)) * np.sin(6 * t) * np.cos(t), time_step=0.01, unit="g")


def block(seed):
    random = np.random.default_rng(seed)
    period, friction = random.uniform(1, 4, 1000), random.uniform(0.02, 0.12, 1000)
    found = ss.spectrum(quake, period=period, friction_coefficient=friction, damping_ratio=0.05)
    return period, friction, found.max_displacement


found = dask.compute(*[dask.delayed(block)(seed) for seed in range(8)], scheduler="threads")
period, friction, displacement = map(np.concatenate, zip(*found))
axes = plt.figure(layout="constrained").gca()
dots = axes.hexbin(period, friction, C=displacement * 1e3, gridsize=30)
axes.figure.colorbar(dots, label="mean of the greatest displacements (mm)")
axes.set(xlabel="natural period (s)", ylabel="coefficient of friction")
assert np.array_equal(block(3)[2], found[3][2])  # blocks do not depend on where they run
