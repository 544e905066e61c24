#!/usr/bin/env python3
"""Steady motions of a chain of two masses with cubic springs by harmonic balance, beside tests/data/cubic_chain.json: fails where one differs.

    python3 tests/data/cubic_chain.py           # needs numpy and scipy; `.ci/slow references` runs it
    python3 tests/data/cubic_chain.py --write

The machine is the example 02 of NLvib (Krack and Gross, Harmonic Balance for Nonlinear Vibration Problems, 2019): masses 1 and 0.05, springs 1 and
0.0453, dampers 0.002 and 0.013, cubic springs 1 x^3 at the first mass and 0.0042 x^3 between both, the force 0.11 cos(Omega t) on the first.
Its curve of amplitudes is that of these equations; here they have 31 harmonics in place of 7.
"""

import json
import pathlib
import sys

import numpy as np
from scipy.optimize import fsolve

HARMONICS, SAMPLES = 31, 1024
MASS = np.diag([1.0, 0.05])
DAMPING = np.array([[0.015, -0.013], [-0.013, 0.013]])
STIFFNESS = np.array([[1.0453, -0.0453], [-0.0453, 0.0453]])
FREQUENCIES = [0.8, 0.95, 1.35, 1.4]


def forces(q):
    """The cubic springs at samples of the displacements."""
    first, between = q[0] ** 3, 0.0042 * (q[0] - q[1]) ** 3
    return np.array([first + between, -between])


def balance(omega):
    """The displacements over a period, by their Fourier coefficients."""
    orders = np.arange(HARMONICS + 1)
    dynamic = [STIFFNESS - (k * omega) ** 2 * MASS + 1j * k * omega * DAMPING for k in orders]
    load = np.zeros((HARMONICS + 1, 2), complex)
    load[1, 0] = 0.11

    def samples(parts):
        spectrum = np.zeros((SAMPLES // 2 + 1, 2), complex)
        spectrum[: HARMONICS + 1] = parts * SAMPLES / 2
        return np.fft.irfft(spectrum, axis=0, n=SAMPLES).T

    def unpack(x):
        return (x[: x.size // 2] + 1j * x[x.size // 2 :]).reshape(HARMONICS + 1, 2)

    def residual(x):
        parts = unpack(x)
        inner = np.fft.rfft(forces(samples(parts)).T, axis=0)[: HARMONICS + 1] / SAMPLES * 2
        out = np.array([d @ p for d, p in zip(dynamic, parts)]) + inner - load
        # Symmetric springs have odd harmonics only.
        out[::2] = parts[::2]
        out = out.ravel()
        return np.concatenate([out.real, out.imag])

    start = np.zeros((HARMONICS + 1, 2), complex)
    start[1] = np.linalg.solve(dynamic[1], load[1])
    if abs(start[1]).max() > 1:
        start[1] /= abs(start[1]).max()
    x, _, code, why = fsolve(residual, np.concatenate([start.ravel().real, start.ravel().imag]), xtol=1e-14, full_output=True)
    assert abs(residual(x)).max() < 1e-13, why
    parts = unpack(x)
    times = np.linspace(0, 2 * np.pi, 200001)
    angles = np.exp(1j * np.outer(orders, times))
    q = (parts.T @ angles).real
    v = ((1j * omega * orders[:, None] * parts).T @ angles).real
    return {"frequency": omega, "max_displacement": list(q.max(axis=1)), "max_velocity": list(v.max(axis=1))}


def main():
    file = pathlib.Path(__file__).with_suffix(".json")
    found = [balance(omega) for omega in FREQUENCIES]
    if "--write" in sys.argv:
        file.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    worst = 0.0
    for case, due in zip(found, json.loads(file.read_text(encoding="utf-8"))):
        for name in ("max_displacement", "max_velocity"):
            worst = max(worst, *(abs(a / b - 1) for a, b in zip(case[name], due[name])))
    print(f"cubic chain: {worst:.1e}")
    sys.exit(worst > 1e-8)


main()
