"""Siconos on the case file: friction as a relay, time stepping with a complementarity problem in each step.

Static friction widens the relay while the body is at rest. Needs Siconos 4.4 with its Python modules, which are in Debian 12:

    apt-get install --no-install-recommends python3-siconos
    /usr/bin/python3 benches/peers/cases/by_siconos.py tests/data/cases.json
"""

import numpy as np
import siconos.kernel as sk

from common import main, settled, stops_of

#: The parameter theta of the scheme (1 is implicit Euler, 1/2 the trapezoidal rule) and the steps of a period of the drive or of the
#: body, the shorter of the two.
SCHEMES = {"default": (1.0, 1000), "tight": (0.5, 4000)}
AT_REST = 1e-12


def relay(omega, alpha, zeta, eta, setting):
    """A stop is two successive steps or more at rest: a reversal is at rest in one step at most."""
    theta, steps = SCHEMES[setting]
    steps *= int(np.ceil(max(1 / omega, 1)))
    h = 2 * np.pi / omega / steps
    body = sk.FirstOrderLinearTIDS([0.0, 0.0], [[0.0, 1.0], [-1.0, -2 * zeta]], [0.0, 0.0])
    law = sk.RelayNSL(1, -1.0, 1.0)
    friction = sk.Interaction(law, sk.FirstOrderLinearTIR([[0.0, 1.0]], [[0.0], [1.0]]))
    model = sk.NonSmoothDynamicalSystem(0.0, 1e9)
    model.insertDynamicalSystem(body)
    model.link(friction, body)
    simulation = sk.TimeStepping(model, sk.TimeDiscretisation(0.0, h), sk.EulerMoreauOSI(theta), sk.Relay())
    loads = alpha * np.sin(2 * np.pi * np.arange(steps + 1) / steps)
    loads = theta * loads[1:] + (1 - theta) * loads[:-1]

    def period(n):
        velocities, greatest = [], 0.0
        for load in loads:
            body.setbPtr([0.0, load])
            simulation.computeOneStep()
            x, v = body.x()
            simulation.nextStep()
            bound = eta if abs(v) < AT_REST else 1.0
            law.setLb(-bound)
            law.setUb(bound)
            velocities.append(v)
            greatest = max(greatest, abs(x))
        return greatest, stops_of(velocities, AT_REST, 2)

    return settled(period, setting, 300)


main("Siconos", {"relay": relay})
