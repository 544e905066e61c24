"""A block on a belt whose friction falls with the speed: from rest on the belt the motion goes to its limit cycle of sticking and slipping."""

import matplotlib.pyplot as plt
import numpy as np

import stickslip as ss

block = (
    ss.System(units="N,mm")
    .mass("block", "2 kg", start="1 mm")
    .spring("ground", "block", "0.8 N/mm")
    .contact(
        "ground", "block", name="belt", moves={"velocity": "40 mm/s"}, peak=1.2,
        law=[["0 mm/s", "10 N"], ["100 mm/s", "6 N"]],
    )
)
motion = block.simulate("3 s")
states, steady = motion.states(2000), block.steady()
axes = plt.figure(layout="constrained").gca()
states.plot("block.velocity", over="block.displacement", ax=axes, color="0.7")
steady.states(800).plot("block.velocity", over="block.displacement", ax=axes)
assert steady.kind == "periodic" and steady.elements["belt"].time_at_rest > 0.2 * steady.duration
assert np.isclose(steady.max_velocity[0], 40)  # it travels with the belt
