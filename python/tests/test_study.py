"""The studies on two worker processes, one of them killed mid-run, against one process."""

import importlib
import os
import signal
import time
from pathlib import Path

import pytest

distributed = pytest.importorskip("distributed", reason="the studies run on Dask")

STUDIES = Path(__file__).parent.parent / "studies"

#: Parts, and the options of each study.
CASES = {"steady_map": (12, 48, 40), "record_suite": (12, 3, 2, 400), "system_suite": (12, 3, 2, 400)}


def slowly(study, number, options):
    """A part that takes long enough to be killed in."""
    time.sleep(0.3)
    return importlib.import_module(study).part(number, *options)


@pytest.mark.parametrize("study", CASES)
def test_a_killed_worker_does_not_change_a_bit(study, tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(str(STUDIES))
    monkeypatch.setenv("PYTHONPATH", f"{STUDIES}:{Path(__file__).parent}")
    module, engines = importlib.import_module(study), importlib.import_module("engines")
    alone, spread = tmp_path / "alone", tmp_path / "spread"
    alone.mkdir(), spread.mkdir()
    options, parts = CASES[study], CASES[study][0]
    expected = engines.whole([module.part(number, *options, str(alone)) for number in range(parts)])
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        with distributed.Client(cluster) as client:
            there = (*options, str(spread))
            tasks = [client.submit(slowly, study, number, there, pure=False) for number in range(parts)]
            while not any(task.done() for task in tasks):
                time.sleep(0.05)
            pids = client.run(os.getpid)
            assert len(pids) == 2
            os.kill(next(iter(pids.values())), signal.SIGKILL)
            found = engines.whole(client.gather(tasks))
    assert found == expected
    names = sorted(path.name for path in alone.iterdir())
    assert sorted(path.name for path in spread.iterdir() if path.suffix == ".npz") == names
    for name in names:
        assert (alone / name).read_bytes() == (spread / name).read_bytes(), name
