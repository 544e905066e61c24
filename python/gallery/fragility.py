"""The fragility of a slider by Monte-Carlo: the probability that it moves by more than 150 mm under an earthquake that grows, with Wilson's
intervals. Friction and damping are uncertain."""

import matplotlib.pyplot as plt
import numpy as np

import stickslip as ss

t = np.arange(0, 15, 0.01)
quake = ss.Record(np.exp(-(((t - 6) / 3) ** 2)) * np.sin(6 * t) * np.cos(t), time_step=0.01, unit="g")
slider = ss.Machine(mass="800 kg", period="2.5 s", friction_coefficient=0.06, damping_ratio="5%", units="N,mm")
shares, scale = [], np.linspace(0.2, 0.42, 15)
for factor in scale:
    drawn = ss.monte_carlo(slider, factor * quake, {"friction": 0.25, "damping_ratio": 0.3}, draws=400, seed=3)
    shares.append(drawn.probability(lambda answer: answer.peak_displacement > 150))
axes = plt.figure(layout="constrained").gca()
axes.plot(scale, [share.value for share in shares])
axes.fill_between(scale, *np.transpose([share.interval for share in shares]), alpha=0.25)
axes.set(xlabel="peak ground acceleration (g)", ylabel="probability of more than 150 mm")
assert shares[0].value == 0 and shares[-1].value == 1
