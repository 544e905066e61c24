"""A map of an isolator: how much of the floor's acceleration reaches the machine, over frequency and friction, stops included."""

import matplotlib.pyplot as plt
import numpy as np

import stickslip as ss

hertz, friction = np.linspace(0.3, 3, 160), np.geomspace(0.005, 0.12, 120)[:, None]
isolator = ss.Machine(mass="800 kg", period="2.2 s", friction_coefficient=friction, damping_ratio="3%")
found = isolator.steady(ss.Drive(base_acceleration="0.15 g", frequency=hertz), outputs=["transmissibility"])
axes = plt.figure(layout="constrained").gca()
lines = axes.contourf(hertz, friction[:, 0], found.transmissibility, levels=np.linspace(0, 2, 21), extend="max")
axes.figure.colorbar(lines, label="transmissibility")
axes.set(yscale="log", xlabel="frequency (Hz)", ylabel="coefficient of friction")
# Above resonance friction spoils the isolation.
assert found.transmissibility[-1, -1] > 5 * found.transmissibility[0, -1]
