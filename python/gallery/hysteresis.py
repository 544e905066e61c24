"""The hysteresis loop of a machine that stops twice a cycle: the force of spring and friction over the displacement, whose area is the energy of
a cycle."""

import matplotlib.pyplot as plt
import numpy as np

import stickslip as ss

machine = ss.Machine(mass="12 kg", stiffness="30 kN/m", friction="15 N", units="N,mm")
axes = plt.figure(layout="constrained").gca()
for force in (25, 40, 60):
    found = machine.steady(ss.Drive(force=f"{force} N", frequency="2.5 Hz"))
    x, total = found.waveform(400).loop(spring=True)
    axes.plot(x, total, label=f"{force} N, {found.sticks_per_cycle} stops a cycle")
    # The displacements of the last sample are those of the first; the trapezoidal rule gives the area.
    area = float(np.sum((total[1:] + total[:-1]) / 2 * np.diff(x)))
    assert abs(area - found.energy_out) < 1e-2 * found.energy_out
axes.set(xlabel="displacement (mm)", ylabel="force on the ground (N)")
axes.legend()
