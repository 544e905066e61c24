"""The study on Ray Data, a worker of which dies while it writes a part, against one process."""

import importlib
import os
import signal
from pathlib import Path

import pytest

pytest.importorskip("ray", reason="the study runs on Ray")


def test_a_worker_that_dies_does_not_change_a_bit(tmp_path, monkeypatch):
    studies = str(Path(__file__).parent.parent / "studies")
    monkeypatch.syspath_prepend(studies)
    # Workers import the studies, too.
    monkeypatch.setenv("PYTHONPATH", studies)
    study, engines = importlib.import_module("steady_map"), importlib.import_module("engines")
    alone, spread = tmp_path / "alone", tmp_path / "spread"
    alone.mkdir(), spread.mkdir()
    options = (6, 24, 40)
    expected = engines.whole([study.part(n, *options, str(alone)) for n in range(6)])
    whole_part = study.part

    def deadly(number, parts, rows, columns, out):
        died = Path(out) / "died.tmp"
        if number == 3 and not died.exists():
            died.write_bytes(b"half a part")
            os.kill(os.getpid(), signal.SIGKILL)
        return whole_part(number, parts, rows, columns, out)

    found = engines.whole(engines.on_ray(2, deadly, (*options, str(spread))))
    assert (spread / "died.tmp").exists()
    assert found == expected
    for path in sorted(alone.iterdir()):
        assert path.read_bytes() == (spread / path.name).read_bytes(), path.name
