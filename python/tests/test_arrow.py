"""Tables of Arrow against arrays."""

import numpy as np
import pytest

import stickslip as ss
import stickslip.arrow

pa = pytest.importorskip("pyarrow")


def points(n=1000, seed=5):
    random = np.random.default_rng(seed)
    return np.exp(random.uniform(-2, 2, n)), np.exp(random.uniform(-0.5, 3, n))


def test_a_table_has_the_numbers_of_the_arrays_and_nulls_where_there_are_none():
    omega, alpha = points()
    found = pa.table(stickslip.arrow.response(pa.table({"alpha": alpha, "omega": omega})))
    expected = ss.response(omega, alpha)
    assert found.num_rows == 1000 and found.column_names[:2] == ["alpha", "omega"] and len(found.column_names) == 12
    assert found["regime"].to_pylist() == list(expected.regime)
    for name in ("max_displacement", "contraction", "min_force_ratio"):
        numbers = getattr(expected, name)
        assert found[name].null_count == np.isnan(numbers).sum()
        np.testing.assert_array_equal(found[name].to_numpy(), numbers)


def test_chunks_stay_in_order_and_a_batch_gives_a_batch():
    omega, alpha = points()
    whole = pa.table({"omega": omega, "alpha": alpha})
    chunks = pa.concat_tables([whole.slice(0, 10), whole.slice(10, 0), whole.slice(10)])
    found = pa.table(stickslip.arrow.response(chunks, ["max_velocity"]))
    np.testing.assert_array_equal(found["max_velocity"].to_numpy(), ss.response(omega, alpha, outputs=["max_velocity"]).max_velocity)
    batch = pa.record_batch(stickslip.arrow.response(whole.to_batches()[0]))
    assert batch.num_rows == 1000


def test_steady_states_and_damping():
    omega, alpha = points(100)
    found = pa.table(stickslip.arrow.steady(pa.table({"omega": omega, "alpha": alpha})))
    expected = ss.steady(omega, alpha)
    np.testing.assert_array_equal(found["max_displacement"].to_numpy(), expected.max_displacement)
    counts = [None if n != n else int(n) for n in expected.sticks_per_cycle.tolist()]
    assert found["sticks_per_cycle"].to_pylist() == counts
    damped = pa.table(stickslip.arrow.response(pa.table({"omega": omega, "alpha": alpha, "damping_ratio": np.full(100, 0.1)})))
    np.testing.assert_array_equal(damped["max_displacement"].to_numpy(), ss.response(omega, alpha, 0.1).max_displacement)


def test_nulls_and_other_numbers_go_in():
    table = pa.table({"omega": pa.array([0.7, None, 1.5]), "alpha": pa.array([3, 3, 4], pa.int32())})
    found = pa.table(stickslip.arrow.response(table))
    assert found["regime"].to_pylist() == ["non-sticking", None, "non-sticking"]
    assert found["min_force_ratio"].null_count == 1
    empty = pa.table(stickslip.arrow.response(table.slice(0, 0)))
    assert empty.num_rows == 0 and len(empty.column_names) == 12


def test_bad_tables_are_refused_in_words():
    with pytest.raises(ss.Error, match="column alpha: is missing"):
        stickslip.arrow.response(pa.table({"omega": [1.0]}))
    with pytest.raises(ss.Error, match="must be numbers"):
        stickslip.arrow.response(pa.table({"omega": ["1"], "alpha": [2.0]}))
    with pytest.raises(ss.Error, match="must be one of"):
        stickslip.arrow.response(pa.table({"omega": [1.0], "alpha": [2.0]}), ["speed"])
    with pytest.raises(TypeError, match="as tables of Arrow and polars have, not list"):
        stickslip.arrow.response([1, 2])
    with pytest.raises(ss.Error, match="column margin: is in the table, too"):
        stickslip.arrow.response(pa.table({"omega": [1.0], "alpha": [2.0], "margin": [3.0]}), ["margin"])
    with pytest.raises(ss.Error, match="must be a batch of rows"):
        stickslip.arrow.response(pa.array([1.0]))


def test_the_other_columns_are_kept_and_any_library_serves():
    polars = pytest.importorskip("polars")
    frame = polars.DataFrame({"name": ["a", "b"], "omega": [0.4, 1.5], "alpha": [6, 3]})
    found = polars.DataFrame(stickslip.arrow.steady(frame, ["transmissibility", "sticks_per_cycle", "symmetric", "multipliers"]))
    assert found.columns[:5] == ["name", "omega", "alpha", "transmissibility", "sticks_per_cycle"]
    assert found["name"].to_list() == ["a", "b"] and found["sticks_per_cycle"].to_list() == [2, 0]
    assert found["symmetric"].dtype == polars.Boolean
    expected = ss.steady(frame["omega"], frame["alpha"])
    np.testing.assert_array_equal(found["transmissibility"], expected.transmissibility)
    np.testing.assert_array_equal(found["multipliers_2_re"], expected.multipliers[:, 1].real)
    # Bits of memory are given back: the columns of a result outlive it.
    column = pa.table(stickslip.arrow.response(pa.table({"omega": np.full(1000, 0.7), "alpha": np.full(1000, 2.0)})))["max_displacement"]
    assert column.to_pylist() == [ss.response(0.7, 2.0).max_displacement] * 1000