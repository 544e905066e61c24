"""The harmonically forced Coulomb-friction oscillator.

A body of mass m on a spring k slides over a surface whose friction carries at most r, driven by a harmonic force::

    m x'' + k x + r sgn(x') = p0 sin(w t)

The package computes whether the body sticks, how far and how fast it moves, the minimum force that keeps it from
sticking, and the friction that dissipates most. It gives closed forms where the body does not stick, and the exact
motion, stops included, everywhere.

Two ratios decide the motion: the frequency ratio ``omega = w/sqrt(k/m)`` and the force ratio ``alpha = p0/r``.
Displacements are in units of ``B = r/k``, velocities in ``B w``, energies of a cycle in ``r B``, phases in
radians of the drive. `Machine` and `Drive` convert from and to physical units.

`response`, `border` and `steady` take numbers or arrays, and broadcast as NumPy does.

>>> import stickslip as ss
>>> ss.response(omega=1.5, alpha=2.5).max_displacement
1.6329...
>>> ss.response(omega=[0.7, 1.5], alpha=2.5).regime
array(['non-sticking', 'non-sticking'], dtype='<U16')
>>> ss.steady(omega=0.4, alpha=6).sticks_per_cycle
2
"""

import os as _os

from . import _native, enclosed
from ._attractors import Attractor, Attractors, Basins, MachineAttractors, attractors, basins
from ._closed_forms import OUTPUTS, Border, MachineResponse, Response, border, response
from ._design import (
    FIGURES,
    Band,
    BandFriction,
    BestFriction,
    BestStiffness,
    DecayIdentified,
    Estimate,
    Figure,
    Identified,
    MotionIdentified,
    TargetFriction,
    figure,
    identify,
    identify_decay,
    identify_motion,
)
from ._drive import Drive
from ._labels import FileError
from ._machine import Machine
from ._motion import Decay, MachineDecay, MachinePhases, MachineSamples, Phases, Samples, decay, simulate
from ._native import Error, __version__
from ._record import Block, FloorSpectrum, Followed, Motion, Polarities, Record, Spectrum, spectrum
from ._steady import STEADY_OUTPUTS, MachineSteady, Steady, steady
from ._system import System
from ._system_results import (
    ElementMotion,
    SystemBorder,
    SystemEvents,
    SystemGrid,
    SystemMotion,
    SystemStates,
    SystemSteady,
)
from ._uncertainty import MonteCarlo, Sensitivity, monte_carlo, sensitivities

if hasattr(_os, "register_at_fork"):
    # A forked child inherits the memory of the worker threads, but not the threads themselves.
    _os.register_at_fork(after_in_child=_native.forked)

__all__ = [
    "FIGURES",
    "OUTPUTS",
    "STEADY_OUTPUTS",
    "Attractor",
    "Attractors",
    "Band",
    "BandFriction",
    "Basins",
    "BestFriction",
    "BestStiffness",
    "Block",
    "Border",
    "Decay",
    "DecayIdentified",
    "Drive",
    "ElementMotion",
    "Error",
    "Estimate",
    "Figure",
    "FileError",
    "FloorSpectrum",
    "Followed",
    "Identified",
    "Machine",
    "MachineAttractors",
    "MachineDecay",
    "MachinePhases",
    "MachineResponse",
    "MachineSamples",
    "MachineSteady",
    "MonteCarlo",
    "Motion",
    "MotionIdentified",
    "Phases",
    "Polarities",
    "Record",
    "Response",
    "Samples",
    "Sensitivity",
    "Spectrum",
    "Steady",
    "System",
    "SystemBorder",
    "SystemEvents",
    "SystemGrid",
    "SystemMotion",
    "SystemStates",
    "SystemSteady",
    "TargetFriction",
    "__version__",
    "attractors",
    "basins",
    "border",
    "decay",
    "enclosed",
    "figure",
    "identify",
    "identify_decay",
    "identify_motion",
    "monte_carlo",
    "response",
    "sensitivities",
    "simulate",
    "spectrum",
    "steady",
]
