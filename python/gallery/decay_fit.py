"""Friction and damping from a measured decay: the peaks of a free vibration with 1 % of noise, the fit, and what it says about the machine."""

import matplotlib.pyplot as plt
import numpy as np

import stickslip as ss

machine = ss.Machine(mass="2 kg", stiffness="800 N/m", friction="0.6 N", damping_ratio=0.02, units="N,mm")
rest = ss.Record([0.0, 0.0], time_step=3.0, of="force", unit="N")
motion = machine.motion(rest, displacement="40 mm", interval=0.002)
x = motion.displacement
peaks = np.concatenate([[x[0]], x[1:-1][(x[1:-1] > x[:-2]) & (x[1:-1] >= x[2:]) & (x[1:-1] > 1)]])
measured = peaks * (1 + 0.01 * np.random.default_rng(2).standard_normal(peaks.size))
found = ss.identify_decay(measured, every="cycle")
low, high = found.damping_ratio.interval
assert low < 0.02 < high
friction = found.friction_displacement.value * machine.stiffness
again = machine.replace(friction=friction, damping_ratio=found.damping_ratio.value)
axes = plt.figure(layout="constrained").gca()
axes.plot(motion.time, x, color="0.7", label="motion")
fitted = again.motion(rest, displacement=f"{measured[0]} mm", interval=0.002)
axes.plot(fitted.time, fitted.displacement, "--", label=f"fit: ζ = {found.damping_ratio.value:.3f}")
period = machine.period / np.sqrt(1 - machine.damping_ratio**2)
axes.plot(np.arange(measured.size) * period, measured, "o", label="measured peaks")
axes.set(xlabel="time (s)", ylabel="displacement (mm)")
axes.legend()
