"""The study on two worker processes, one of them killed mid-run, against one process."""

import functools
import importlib.util
import os
import signal
import time
from pathlib import Path

import pytest

distributed = pytest.importorskip("distributed", reason="the study runs on Dask")

PATH = Path(__file__).parent.parent / "studies" / "steady_map.py"


def load():
    spec = importlib.util.spec_from_file_location("steady_map", PATH)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def slowly(number, options):
    """A part that takes long enough to be killed in."""
    time.sleep(0.3)
    return load().part(number, *options)


def test_a_killed_worker_does_not_change_a_bit(tmp_path):
    study = load()
    alone, spread = tmp_path / "alone", tmp_path / "spread"
    alone.mkdir(), spread.mkdir()
    expected = study.whole([study.part(n, 12, 48, 40, str(alone)) for n in range(12)])
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        with distributed.Client(cluster) as client:
            options = (12, 48, 40, str(spread))
            tasks = client.map(functools.partial(slowly, options=options), range(12), pure=False)
            while not any(task.done() for task in tasks):
                time.sleep(0.05)
            victim = next(iter(client.scheduler_info()["workers"].values()))
            pids = client.run(os.getpid)
            os.kill(next(iter(pids.values())), signal.SIGKILL)
            assert victim
            found = study.whole(client.gather(tasks))
    assert found == expected
    names = sorted(path.name for path in alone.iterdir())
    assert sorted(path.name for path in spread.iterdir() if path.suffix == ".npz") == names
    for name in names:
        assert (alone / name).read_bytes() == (spread / name).read_bytes(), name
