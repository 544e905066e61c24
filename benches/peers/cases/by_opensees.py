"""OpenSees on the case file: the slider as an elastic-plastic spring beside the spring and the damper, stepped in time.

Static friction above kinetic friction is not in its material. Needs openseespy and, on Debian, libblas3, liblapack3 and libgfortran5:

    python benches/peers/cases/by_opensees.py tests/data/cases.json
"""

import numpy as np
import openseespy.opensees as ops

from common import main, settled, stops_of

#: The slider's stiffness over that of the spring, and the steps of a period of the drive or of the body, the shorter of the two.
MODELS = {"default": (1e4, 200), "tight": (1e7, 4000)}
#: The force that equilibrium may lack, over the friction.
UNBALANCE = 1e-6
#: Newton's method alone goes back and forth between sliding and rest. The second takes the steps that the first does not.
ALGORITHMS = (("NewtonLineSearch",), ("ModifiedNewton", "-initial"))


def stiff_slider(omega, alpha, zeta, eta, setting):
    """A stop has |v| < 2/√stiffness, since the body vibrates on the slider, for a hundredth of a period of the drive or of the body."""
    stiffness, shorter = MODELS[setting]
    turn = 2 * np.pi / omega
    steps = shorter * int(np.ceil(max(1 / omega, 1)))
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    ops.node(1, 0.0)
    ops.node(2, 0.0)
    ops.fix(1, 1)
    ops.mass(2, 1.0)
    ops.uniaxialMaterial("Elastic", 1, 1.0, 2 * zeta)
    ops.uniaxialMaterial("ElasticPP", 2, stiffness, 1 / stiffness)
    ops.element("zeroLength", 1, 1, 2, "-mat", 1, "-dir", 1, "-doRayleigh", 0)
    ops.element("zeroLength", 2, 1, 2, "-mat", 2, "-dir", 1)
    ops.timeSeries("Trig", 1, 0.0, 1e9, turn, "-factor", alpha)
    ops.pattern("Plain", 1, 1)
    ops.load(2, 1.0)
    ops.constraints("Plain")
    ops.numberer("Plain")
    ops.system("FullGeneral")
    ops.test("NormUnbalance", UNBALANCE, 500)
    ops.algorithm(*ALGORITHMS[0])
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")

    def period(n):
        velocities, greatest = [], 0.0
        for _ in range(steps):
            if ops.analyze(1, turn / steps) != 0:
                ops.algorithm(*ALGORITHMS[1])
                if ops.analyze(1, turn / steps) != 0:
                    return np.nan, -1
                ops.algorithm(*ALGORITHMS[0])
            velocities.append(ops.nodeVel(2, 1))
            greatest = max(greatest, abs(ops.nodeDisp(2, 1)))
        return greatest, stops_of(velocities, 2 / np.sqrt(stiffness), shorter // 100)

    return settled(period, setting, 300)


main("OpenSees", {"stiff slider": stiff_slider})
