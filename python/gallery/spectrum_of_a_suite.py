"""The spectrum of a suite: greatest displacements of isolators under twelve synthetic earthquakes, with median and 84 % over the natural period."""

import matplotlib.pyplot as plt
import numpy as np

import stickslip as ss

random, t = np.random.default_rng(5), np.arange(0, 20, 0.01)
period = np.linspace(0.5, 4, 40)


def earthquake():
    parts = zip(random.uniform(0.3, 6, 30), random.uniform(0, 2 * np.pi, 30))
    waves = sum(np.sin(2 * np.pi * f * t + p) / f**0.5 for f, p in parts)
    shape = waves * (t / 4) ** 2 * np.exp(-(((t - 4) / 4) ** 2))
    return ss.Record(0.4 * shape / np.abs(shape).max(), time_step=0.01, unit="g")


suite = [earthquake() for _ in range(12)]
axes = plt.figure(layout="constrained").gca()
for mu, colour in ((0.03, "tab:blue"), (0.1, "tab:orange")):
    body = {"period": period, "friction_coefficient": mu, "damping_ratio": 0.02}
    each = np.array([ss.spectrum(record, **body).max_displacement for record in suite])
    low, middle, high = np.quantile(each * 1e3, (0.16, 0.5, 0.84), axis=0)
    axes.plot(period, middle, color=colour, label=f"µ = {mu:g}")
    axes.fill_between(period, low, high, color=colour, alpha=0.25)
axes.set(xlabel="natural period (s)", ylabel="greatest displacement (mm)")
axes.legend()
assert each.shape == (12, 40) and np.all(low <= high)
