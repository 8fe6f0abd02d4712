"""Law: a batch equals the solutions of its items one by one, bit for bit."""

import numpy as np
import pytest
from numpy.testing import assert_array_equal

import assur


@pytest.fixture
def plan(example):
    return assur.Plan(assur.parse_scene(example("four_bar_coupler_curve", unit="mm")))


def expect_items(plan, batch, items):
    assert len(batch) == len(items) == len(batch.offsets) - 1
    for place, values in enumerate(items):
        rows = slice(batch.offsets[place], batch.offsets[place + 1])
        alone = plan.solve(values)
        assert batch.status[place] == alone.status
        assert (batch.item[rows] == place).all()
        assert_array_equal(batch.configuration[rows], np.arange(1, len(alone) + 1))
        assert_array_equal(batch.residual[rows], alone.residual)
        assert_array_equal(batch.regular[rows], alone.regular)
        for kind in ("links", "joints", "outputs"):
            for name, state in getattr(batch, kind).items():
                for number in ("pose", "position", "velocity", "acceleration", "sensitivity",
                               "rss"):
                    if hasattr(state, number):
                        assert_array_equal(getattr(state, number)[rows],
                                           getattr(getattr(alone, kind)[name], number))


def test_items_one_by_one(plan):
    # Some of the links cannot reach with a coupler of 20.
    phi = np.linspace(0, 6, 24)
    coupler = np.where(np.arange(24) % 3 == 0, 20.0, 100.0)
    batch = plan.solve_batch(phi=phi, coupler=coupler)
    expect_items(plan, batch, [{"phi": a, "coupler": b} for a, b in zip(phi, coupler)])
    assert set(batch.status) == {assur.Status.OK, assur.Status.NO_ASSEMBLY}


def test_shared_numbers_and_every_form_of_array(plan):
    numbers = np.linspace(1, 2, 8)
    every_second = np.repeat(numbers, 2)[::2]
    backwards = np.ascontiguousarray(numbers[::-1])[::-1]
    expected = plan.solve_batch({"phi": numbers}, crank=38.0).outputs["P"].position
    for phi in (every_second, backwards, list(numbers), numbers.astype("f8").astype(">f8"),
                np.broadcast_to(numbers[:, None], (8, 3))[:, 1],
                np.frombuffer(b"?" + numbers.tobytes(), dtype="u1")[1:].view("f8")):
        assert_array_equal(plan.solve_batch(phi=phi, crank=np.array(38)).outputs["P"].position,
                           expected)
    assert_array_equal(plan.solve_batch(phi=np.array([1, 2])).outputs["P"].position,
                       plan.solve_batch(phi=np.array([1.0, 2.0])).outputs["P"].position)


def test_no_items(plan):
    batch = plan.solve_batch(phi=[])
    assert len(batch) == 0 and list(batch.offsets) == [0]
    assert batch.outputs["P"].sensitivity.shape == (0, 2, len(plan.parameters))
    assert batch.residual.shape == batch.regular.shape == (0,)


def test_what_cannot_be_solved_is_told_with_its_item(plan):
    with pytest.raises(assur.SceneError) as raised:
        plan.solve_batch(phi=[0, 1, np.nan, 2])
    assert str(raised.value) == ("scene: values[2]: parameters.phi: "
                                 "the value is not a finite number")
    assert len(plan.solve_batch(phi=[0, 1])) == 2
