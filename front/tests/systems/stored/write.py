#!/usr/bin/env python3
"""Files of matrices by SciPy and NumPy, for `front/tests/systems/stored.rs`: `write.py` writes them beside itself.

Needs `pip install numpy scipy`. The matrices are M = tridiagonal (1, 4, 1)/6 and K = tridiagonal (−1, 2, −1) of five coordinates, and an
unsymmetric G with G[i, j] = 10 i + j.
"""

from pathlib import Path

import numpy as np
import scipy.io
import scipy.sparse

HERE = Path(__file__).parent
K = np.diag(np.full(5, 2.0)) - np.eye(5, k=1) - np.eye(5, k=-1)
M = np.diag(np.full(5, 4.0)) + np.eye(5, k=1) + np.eye(5, k=-1)
G = 10.0 * np.arange(5)[:, None] + np.arange(5)

for name, matrix, others in (
    ("k_coordinate.mtx", scipy.sparse.coo_array(K), {"symmetry": "general"}),
    ("k_symmetric.mtx", scipy.sparse.coo_array(K), {"symmetry": "symmetric"}),
    ("k_array.mtx", K, {"symmetry": "symmetric"}),
    ("g_array.mtx", G, {"symmetry": "general"}),
    ("g_coordinate.mtx", scipy.sparse.coo_array(G.astype(int)), {"field": "integer"}),
    ("skew.mtx", scipy.sparse.coo_array(G - G.T), {"symmetry": "skew-symmetric"}),
):
    scipy.io.mmwrite(HERE / name, matrix, comment="by SciPy", **others)
for kind in ("csr", "csc", "coo", "dia"):
    scipy.sparse.save_npz(HERE / f"g_{kind}.npz", scipy.sparse.coo_array(G).asformat(kind), compressed=kind != "csc")
np.savez(HERE / "model.npz", M=M, K=K, G=np.asfortranarray(G), wide=np.ones((5, 3)), z=K * 1j, ints=G.astype(">i2"), small=G.astype("f4"), flags=G > 3)
np.savez_compressed(HERE / "one.npz", G=G)
np.save(HERE / "g.npy", G.astype(np.int8))
