"""Law: arrays are read-only views of the results, and keep them alive."""

import gc
import sys
import threading

import numpy as np
import pytest
from numpy.testing import assert_array_equal

import assur


@pytest.fixture
def plan(example):
    return assur.Plan(assur.parse_scene(example("four_bar_coupler_curve", steps=9)))


def arrays_of(states):
    for part in (*states.links.values(), *states.joints.values(), *states.outputs.values()):
        for name in dir(part):
            if not name.startswith("_") and hasattr(part, name):
                yield getattr(part, name)
    yield from (states.residual, states.regular)


def every_array(plan):
    samples = assur.sample(plan.scene, 5, 1)
    sweep = plan.sweep()
    batch = plan.solve_batch(phi=[1, 2])
    for states in (plan.solve(), batch, *sweep.branches.values(), sweep.events):
        yield from arrays_of(states)
    yield from (sweep.branches[1].step, sweep.branches[1].parameter,
                sweep.branches[1].configuration, sweep.events.step, batch.item, batch.offsets,
                batch.status, batch.configuration, samples.outcome, *samples.positions.values())


def test_nothing_can_be_written(plan):
    count = 0
    for array in every_array(plan):
        assert isinstance(array, np.ndarray)
        assert not array.flags.writeable and not array.flags.owndata
        with pytest.raises(ValueError):
            array[...] = 0
        with pytest.raises(ValueError):
            array.flags.writeable = True
        count += 1
    assert count > 100
    with pytest.raises(AttributeError):
        plan.solve().residual = 0


def test_what_is_told_lives_as_long_as_it_is_looked_at(plan):
    solution = plan.solve()
    arrays = list(arrays_of(solution)) + [solution[1].outputs["P"].position]
    copies = [array.copy() for array in arrays]
    del solution, plan
    gc.collect()
    heap = [np.full(200, 1e300) for _ in range(2000)]  # would stand in freed memory
    for array, copy in zip(arrays, copies):
        assert_array_equal(array, copy)
    assert len(heap) == 2000


def test_the_same_memory_for_one_and_for_all(plan):
    solution = plan.solve()
    assert np.shares_memory(solution.outputs["P"].position, solution[1].outputs["P"].position)
    assert np.shares_memory(solution.outputs["P"].position, solution.outputs["P"].position)
    assert_array_equal(solution.links["rocker"].sensitivity[1],
                       solution[1].links["rocker"].sensitivity)


def test_nothing_leaks(plan):
    solution = plan.solve()
    before = sys.getrefcount(solution), sys.getrefcount(plan)
    held = [solution.outputs["P"].position for _ in range(10)] + [solution[0] for _ in range(10)]
    del held
    gc.collect()
    assert (sys.getrefcount(solution), sys.getrefcount(plan)) == before


def test_shapes(plan):
    solution, count = plan.solve(), len(plan.parameters)
    assert len(solution) == 2
    assert solution.links["rocker"].pose.shape == (2, 3)
    assert solution.outputs["P"].sensitivity.shape == (2, 2, count)
    assert solution.outputs["P"].tangential.shape == (2,)
    assert solution[0].links["rocker"].sensitivity.shape == (3, count)
    assert solution[-1].outputs["P"].rss.shape == (2,)
    assert isinstance(solution[0].outputs["P"].normal, float)
    assert isinstance(solution[0].regular, bool) and isinstance(solution[0].residual, float)
    assert solution.outputs["P"].position.dtype == np.float64
    assert [one.number for one in solution] == [1, 2]
    with pytest.raises(IndexError, match="the number of configurations is 2"):
        solution[2]


def test_mappings(plan):
    outputs = plan.solve().outputs
    assert list(outputs) == outputs.keys() == ["P", "C"] and len(outputs) == 2
    assert "P" in outputs and "Q" not in outputs and 3 not in outputs
    assert [name for name, _ in outputs.items()] == ["P", "C"] and len(outputs.values()) == 2
    assert dict(outputs).keys() == {"P", "C"}


def test_threads_share_a_plan(plan):
    angles = np.linspace(0, 6, 150)
    expected = plan.solve_batch(phi=angles).outputs["P"].position
    found = [None] * 4

    def work(place):
        found[place] = np.concatenate([plan.solve(phi=a).outputs["P"].position for a in angles])

    threads = [threading.Thread(target=work, args=(place,)) for place in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for one in found:
        assert_array_equal(one, expected)
