"""Bodies on springs with a contact at the first by Siconos (Moreau–Jean time stepping): time a period, and the error of the state.

The system is `chain(n, 0, 1.0, 1.5)` of benches/systems.rs. The contact's normal load is 1 with a coefficient of 1: a relay with the velocity
as its input. Run with Debian's python3-siconos: /usr/bin/python3 benches/peers/systems/by_siconos.py N STEPS STATE…
STEPS is the number of steps a period, STATE the exact state after the periods.
"""

import sys
import time

import numpy as np
import siconos.kernel as kernel
import siconos.numerics as numerics

OMEGA, FORCE, FRICTION, PERIODS = 0.9, 1.5, 1.0, 100


def matrices(n):
    stiffness = np.zeros((n, n))
    for i in range(n):
        k = 2.0 if i == 0 else 1.0
        stiffness[i, i] += k
        if i > 0:
            stiffness[i - 1, i - 1] += k
            stiffness[i - 1, i] -= k
            stiffness[i, i - 1] -= k
    return np.diag([1.0] + [0.5] * (n - 1)), 0.02 * stiffness, stiffness


def simulate(n, steps):
    mass, damping, stiffness = matrices(n)
    period = 2 * np.pi / OMEGA
    h = period / steps
    # x = (q, v) as a first-order system, with the relay λ = −sgn v of the first velocity.
    inverse = np.linalg.inv(mass)
    a = np.block([[np.zeros((n, n)), np.eye(n)], [-inverse @ stiffness, -inverse @ damping]])
    # The load is the state of an oscillator, so that the system is linear without a plugin.
    whole = np.zeros((2 * n + 2, 2 * n + 2))
    whole[: 2 * n, : 2 * n] = a
    whole[2 * n - 1, 2 * n] = FORCE * inverse[n - 1, n - 1]
    whole[2 * n, 2 * n + 1], whole[2 * n + 1, 2 * n] = OMEGA, -OMEGA
    start = np.zeros(2 * n + 2)
    start[-1] = 1.0
    system = kernel.FirstOrderLinearTIDS(start, whole)
    c = np.zeros((1, 2 * n + 2))
    c[0, n] = 1.0
    b = np.zeros((2 * n + 2, 1))
    b[n, 0] = FRICTION * inverse[0, 0]
    relation = kernel.FirstOrderLinearTIR(c, b)
    law = kernel.RelayNSL(1, -1.0, 1.0)
    interaction = kernel.Interaction(law, relation)
    model = kernel.NonSmoothDynamicalSystem(0.0, PERIODS * period)
    model.insertDynamicalSystem(system)
    model.link(interaction, system)
    simulation = kernel.TimeStepping(model, kernel.TimeDiscretisation(0.0, h), kernel.EulerMoreauOSI(0.5), kernel.Relay(numerics.SICONOS_RELAY_LEMKE))
    simulation.setComputeResiduY(False)
    simulation.setComputeResiduR(False)
    count = 0
    began = time.process_time()
    while simulation.hasNextEvent() and count < PERIODS * steps:
        simulation.computeOneStep()
        simulation.nextStep()
        count += 1
    took = (time.process_time() - began) / PERIODS * 1e6
    return np.array(system.x())[: 2 * n], took


def main():
    n, steps = int(sys.argv[1]), int(sys.argv[2])
    exact = np.array([float(x) for x in sys.argv[3:]])
    state, took = simulate(n, steps)
    print(f"Siconos, n = {n}, {steps} steps a period: {took:.0f} µs a period, error {np.abs(state - exact).max():.1e}", state)


if __name__ == "__main__":
    main()
