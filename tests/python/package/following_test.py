"""Law: a batch that follows a branch has, item by item, the configurations of one branch: those of
a sweep, and, if the signs of triangles distinguish branches, those of one sign."""

import math

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

import assur

SEED = 7


def swept_scene(example, name, steps):
    scene = example(name, steps=steps)
    return scene, assur.Plan(assur.parse_scene(scene))


@pytest.mark.parametrize("name", ["four_bar_coupler_curve", "stephenson_six_bar", "watt_six_bar",
                                  "jansen_leg", "shaper_quick_return", "geared_five_bar"])
def test_branches_of_sweeps(example, name):
    scene, plan = swept_scene(example, name, 121)
    sweep = plan.sweep()
    parameter = sweep.parameter
    followed = 0
    for branch in sweep.branches.values():
        if branch.step[0] != 0 or len(branch) < 121:
            continue
        batch = plan.solve_batch({parameter: branch.parameter}, branch=int(branch.configuration[0]))
        assert not batch.gap.any(), (branch.number, np.flatnonzero(batch.gap))
        assert_array_equal(batch.configuration, branch.configuration)
        for link in plan.links:
            assert_allclose(batch.links[link].pose[:, :2], branch.links[link].pose[:, :2],
                            rtol=0, atol=1e-9 * np.abs(branch.links[link].pose[:, :2]).max() + 1e-12)
        followed += 1
    assert followed >= 2, name


FOUR_BAR = {
    "parameters": {"a": 2, "b": 4, "c": 3.5, "d": 5, "phi": 0.3},
    "links": {"ground": {"A": [0, 0], "D": ["d", 0]}, "crank": {"A": [0, 0], "B": ["a", 0]},
              "coupler": {"B": [0, 0], "C": ["b", 0]}, "rocker": {"D": [0, 0], "C": ["c", 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]},
               "B": {"type": "revolute", "between": ["crank.B", "coupler.B"]},
               "C": {"type": "revolute", "between": ["coupler.C", "rocker.C"]},
               "D": {"type": "revolute", "between": ["ground.D", "rocker.D"]}},
    "drivers": {"A": {"position": "phi"}}, "outputs": {"C": "coupler.C"},
}


def side(batch):
    """The sign of the triangle B C D, which changes in dead centres only."""
    b, c = batch.links["coupler"].pose[:, :2], batch.outputs["C"].position
    return np.sign(np.cross(c - b, np.array([5.0, 0.0]) - c))


@pytest.mark.parametrize("want", [["position"], ["position", "velocity", "sensitivity"]])
@pytest.mark.parametrize("items", [7, 40, 400])
def test_any_parameters_at_once(want, items):
    """Lengths and the crank's angle change from item to item, in few large steps or many small."""
    plan = assur.Plan(assur.parse_scene({**FOUR_BAR, "want": want}))
    t = np.linspace(0, 1, items)
    values = {"phi": 0.3 + 14 * t, "a": 2 - 0.8 * t, "b": 4 + np.sin(9 * t), "c": 3.5 + 0.5 * t}
    for number in (1, 2):
        batch = plan.solve_batch(values, branch=number)
        assert not batch.gap.any()
        b, c = batch.links["coupler"].pose[:, :2], batch.outputs["C"].position
        assert_allclose(b, np.column_stack([values["a"] * np.cos(values["phi"]),
                                            values["a"] * np.sin(values["phi"])]), atol=1e-12)
        assert_allclose(np.hypot(*(c - b).T), values["b"], atol=1e-12)
        assert_allclose(np.hypot(*(c - [5, 0]).T), values["c"], atol=1e-12)
        assert len(set(side(batch))) == 1
    sweep = plan.sweep(values)
    assert sweep.parameter == "item" and list(sweep.branches) == [1, 2]
    for branch in sweep.branches.values():
        assert branch.ends_at is None and len(branch) == items
        assert_array_equal(branch.outputs["C"].position,
                           plan.solve_batch(values, branch=branch.number).outputs["C"].position)


def test_a_gap_where_the_links_cannot_reach():
    """With a crank of 4 there are dead centres: of the items beyond none is on the branch, those
    that come back are."""
    plan = assur.Plan(assur.parse_scene({**FOUR_BAR, "want": ["position"]}))
    phi = np.concatenate([np.linspace(1, 3.5, 30), np.linspace(1.2, 0.6, 5)])
    d2 = 16 + 25 - 40 * np.cos(phi)
    reach = (d2 <= (4 + 3.5) ** 2) & (d2 >= 0.25)
    for number in (1, 2):
        batch = plan.solve_batch(phi=phi, a=4, branch=number)
        assert_array_equal(batch.gap, ~reach)
        assert np.isnan(batch.outputs["C"].position[batch.gap]).all()
        assert np.isnan(batch.residual[batch.gap]).all() and not batch.regular[batch.gap].any()
        assert (batch.configuration[batch.gap] == 0).all()
        assert len(set(side(batch)[reach])) == 1
        assert batch.reason(int(np.flatnonzero(batch.gap)[0])) == "the links cannot reach"
        assert batch.reason(0) == ""
        assert_array_equal(batch.status[batch.gap], assur.Status.NO_ASSEMBLY)


def test_no_jump_over_a_gap_to_another_circuit():
    """A crank of 4 turns to both sides of the ground line, but not across: beyond pi the links can
    be assembled again, on another circuit than where the branch ended."""
    plan = assur.Plan(assur.parse_scene({**FOUR_BAR, "want": ["position"]}))
    phi = np.linspace(1, 2 * np.pi - 1, 41)
    batch = plan.solve_batch(phi=phi, a=4, branch=1)
    again = plan.solve(phi=phi[-1], a=4)
    assert len(again) == 2 and batch.gap[-1] and batch.status[-1] == assur.Status.OK
    assert batch.reason(40) == "no configuration continues the branch"


def test_one_bad_item_is_a_gap():
    plan = assur.Plan(assur.parse_scene(FOUR_BAR))
    batch = plan.solve_batch(phi=[1, np.nan, 1.1, np.inf, 1.2], branch=2)
    assert_array_equal(batch.gap, [False, True, False, True, False])
    assert_array_equal(batch.status, [0, assur.Status.REFUSED, 0, assur.Status.REFUSED, 0])
    assert batch.reason(1) == "parameters.phi: the value is not a finite number"
    assert_array_equal(batch.outputs["C"].position[~batch.gap],
                       plan.solve_batch(phi=[1, 1.1, 1.2], branch=2).outputs["C"].position)


def test_change_points_are_gone_through(parallelogram):
    """A parallelogram stays one, also where an item is exactly on a change point."""
    plan = assur.Plan(assur.parse_scene(parallelogram))
    for phi in (np.linspace(-1, 7, 81), np.linspace(-1, 1, 21), np.linspace(-2, 8, 12),
                np.arange(-1, 9) * (math.pi / 4)):
        start = plan.solve(phi=phi[0])
        straight = [abs(one.links["coupler"].pose[2]) < 1e-9 for one in start]
        number = straight.index(True) + 1
        batch = plan.solve_batch(phi=phi, branch=number)
        assert not batch.gap.any()
        assert_allclose(batch.outputs["P"].position,
                        np.column_stack([2 * np.cos(phi) + 2.5, 2 * np.sin(phi) + 1]), atol=1e-7)


def test_going_on_from_an_earlier_result():
    plan = assur.Plan(assur.parse_scene(FOUR_BAR))
    generator = np.random.default_rng(SEED)
    phi = np.cumsum(generator.uniform(-0.4, 0.7, 60))
    whole = plan.solve_batch(phi=phi, b=4.2, branch=2)
    first = plan.solve_batch(phi=phi[:25], b=4.2, branch=2)
    rest = plan.solve_batch(phi=phi[25:], b=4.2, from_=first)
    assert_array_equal(rest.configuration, whole.configuration[25:])
    assert_array_equal(rest.outputs["C"].position, whole.outputs["C"].position[25:])
    # From a configuration, with the length going back to its own value.
    begin = plan.solve(phi=phi[24], b=4.2)[int(first.configuration[-1]) - 1]
    more = plan.solve_batch(phi=phi[25:], from_=begin)
    assert_array_equal(side(more), side(rest))
    nearest = assur.Plan(assur.parse_scene({**FOUR_BAR, "reference": {"coupler": 0.5}}))
    from_nearest = nearest.solve_batch(phi=phi, nearest=True)
    assert from_nearest.configuration[0] == nearest.solve(phi=phi[0]).nearest.place + 1
    again = nearest.solve_batch(phi=phi, from_=nearest.solve_nearest(phi=phi[0])[0])
    assert_array_equal(again.configuration, from_nearest.configuration)


def test_a_branch_begins_at_the_first_item_that_has_it():
    plan = assur.Plan(assur.parse_scene({**FOUR_BAR, "want": ["position"]}))
    batch = plan.solve_batch(phi=[1, 1, 1.1], b=[20, 4, 4], branch=2)
    assert_array_equal(batch.gap, [True, False, False])
    assert plan.solve_batch(phi=[1, 1.1], branch=3).gap.all()
    assert plan.solve_batch(phi=[1], branch=3).reason(0) == "there is no configuration 3"
    assert len(plan.solve_batch(phi=[], branch=1)) == 0
    assert_array_equal(plan.solve_batch(phi=[1, 2], b=[20, 4]).gap, [True, False])


@pytest.mark.parametrize("keywords, line", [
    ({"branch": 0}, "branch: expected a whole number from 1; nearest=True begins at the reference"),
    ({"branch": 1.5}, "branch: expected a whole number from 0, not float"),
    ({"nearest": 1}, "nearest: expected True or False, not int"),
    ({"branch": 1, "nearest": True}, "branch, nearest, from_: give one of them"),
    ({"from_": 3}, "from_: expected a Configuration, or a Batch that follows a branch, not int"),
])
def test_refusals(keywords, line):
    plan = assur.Plan(assur.parse_scene(FOUR_BAR))
    with pytest.raises(assur.ShapeError) as raised:
        plan.solve_batch(phi=[1, 2], **keywords)
    assert str(raised.value) == line
    with pytest.raises(assur.ShapeError, match="does not follow a branch"):
        plan.solve_batch(phi=[1], from_=plan.solve_batch(phi=[1, 2]))
    other = assur.Plan(assur.parse_scene(FOUR_BAR))
    with pytest.raises(assur.ShapeError, match="another scene"):
        other.solve_batch(phi=[1], from_=plan.solve()[0])
    with pytest.raises(assur.SceneError, match="reference"):
        plan.solve_batch(phi=[1], nearest=True)
    with pytest.raises(IndexError):
        plan.solve_batch(phi=[1], branch=1).reason(1)


def test_a_parameter_with_the_name_of_a_keyword():
    scene = {**FOUR_BAR, "parameters": {**FOUR_BAR["parameters"], "branch": 2}}
    scene["links"] = {**scene["links"], "crank": {"A": [0, 0], "B": ["branch", 0]}}
    plan = assur.Plan(assur.parse_scene(scene))
    batch = plan.solve_batch({"branch": [2, 1.5]}, branch=2)
    assert_allclose(np.hypot(*batch.links["coupler"].pose[:, :2].T), [2, 1.5])


def test_values_of_sweeps(example):
    scene = example("four_bar_coupler_curve", steps=31)
    plan = assur.Plan(assur.parse_scene(scene))
    changed = assur.Plan(assur.parse_scene(scene, crank=39, reach=195))
    for branch in (1, 2):
        assert_array_equal(plan.sweep_branch(branch, {"crank": 39}, reach=195).outputs["P"].position,
                           changed.sweep_branch(branch).outputs["P"].position)
    with pytest.raises(assur.SceneError, match="the sweep gives 'phi' its values"):
        plan.sweep_branch(1, phi=1)
    through = plan.sweep(phi=np.linspace(0, 2 * np.pi, 31), crank=39, reach=195)
    whole = changed.sweep()
    assert len(through.events.event) == 0 and len(through.unassigned) == 0
    for number, branch in through.branches.items():
        assert_allclose(branch.outputs["P"].position, whole.branches[number].outputs["P"].position,
                        atol=1e-9)
    with pytest.raises(assur.SceneError, match=r"values\[1\]: parameters.phi"):
        plan.sweep(phi=[0, np.nan])


def test_branches_end_and_begin_between_items():
    plan = assur.Plan(assur.parse_scene({**FOUR_BAR, "want": ["position"]}))
    sweep = plan.sweep(phi=np.linspace(1, 2 * np.pi - 1, 41), a=4)
    assert list(sweep.branches) == [1, 2, 3, 4]
    assert [sweep.branches[number].ends_at is None for number in (1, 2, 3, 4)] == [
        False, False, True, True]
    assert sweep.branches[3].step[-1] == 40
