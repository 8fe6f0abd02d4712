"""Law: a sweep holds every row and event of `assur solve --format csv`."""

import numpy as np
import pytest
from numpy.testing import assert_array_equal

import assur


def number(cell):
    return float(cell) if cell else np.nan


def column(rows, name):
    return np.array([number(row[name]) for row in rows])


def columns(rows, part, names):
    return np.stack([column(rows, part + "." + name) for name in names], axis=-1)


def expect_rows(found, rows, parameter):
    assert len(found) == len(rows)
    assert_array_equal(found.step, [int(row["step"]) for row in rows])
    assert_array_equal(found.parameter, column(rows, parameter))
    assert_array_equal(found.residual, column(rows, "solution.residual"))
    assert_array_equal(found.regular, [row["solution.regularity"] == "regular" for row in rows])
    for name, link in found.links.items():
        if name != "ground":
            assert_array_equal(link.pose, columns(rows, name, ["x", "y", "theta"]))
            assert_array_equal(link.velocity, columns(rows, name, ["vx", "vy", "omega"]))
            assert_array_equal(link.acceleration, columns(rows, name, ["ax", "ay", "alpha"]))
    for name, point in found.outputs.items():
        assert_array_equal(point.position, columns(rows, name, ["x", "y"]))
        assert_array_equal(point.velocity, columns(rows, name, ["vx", "vy"]))
        assert_array_equal(point.acceleration, columns(rows, name, ["ax", "ay"]))
        assert_array_equal(point.tangential, column(rows, name + ".a_tangential"))
        assert_array_equal(point.normal, column(rows, name + ".a_normal"))
        assert_array_equal(point.worst_case, columns(rows, name, ["worst_case_x", "worst_case_y"]))
        assert_array_equal(point.rss, columns(rows, name, ["rss_x", "rss_y"]))


def expect_sweep(sweep, rows):
    plain = [row for row in rows if not row["event"]]
    assert {int(row["branch"]) for row in plain if row["branch"]} == set(sweep.branches)
    for key, branch in sweep.branches.items():
        own = [row for row in plain if row["branch"] == str(key)]
        assert branch.number == key and branch.ends_at is None
        assert {row["circuit"] for row in own} == {str(branch.circuit)}
        expect_rows(branch, own, sweep.parameter)
        assert_array_equal(branch.configuration, [int(row["configuration"]) for row in own])
    expect_rows(sweep.unassigned, [row for row in plain if not row["branch"]], sweep.parameter)
    events = [row for row in rows if row["event"]]
    assert sweep.events.event == tuple(row["event"] for row in events)
    expect_rows(sweep.events, events, sweep.parameter)


@pytest.mark.parametrize("name, has_events", [
    ("four_bar_coupler_curve", False), ("excavator_arm", False), ("quintero_2011_rrp_rrr", True),
    ("slider_crank", False)])
def test_examples(command, example, name, has_events):
    scene = example(name, steps=5 if name == "excavator_arm" else 13)
    sweep = assur.Plan(assur.parse_scene(scene)).sweep()
    expect_sweep(sweep, command.rows(scene))
    assert sweep.branches and (len(sweep.events) > 0) >= has_events


def test_through_the_flat_parallelogram(command, parallelogram):
    sweep = assur.Plan(assur.parse_scene(parallelogram)).sweep()
    expect_sweep(sweep, command.rows(parallelogram))
    assert sweep.events.event == ("crossing 1 2",)
    assert np.isnan(sweep.events.outputs["P"].velocity).all()
    assert all(np.isfinite(one.outputs["P"].velocity).all() for one in sweep.branches.values())


def test_other_parameters(command, example):
    scene = example("four_bar_coupler_curve", steps=9)
    sweep = assur.Plan(assur.parse_scene(scene)).sweep(crank=35)
    expect_sweep(sweep, command.rows(scene, "--set", "crank=35"))


def test_one_branch(example):
    plan = assur.Plan(assur.parse_scene(example("jansen_leg", steps=9)))
    branch, other = plan.sweep_branch(2), plan.sweep().branches[2]
    assert branch.number == 2
    if branch.ends_at is None:
        assert_array_equal(branch.step, other.step)
    for name, point in branch.outputs.items():
        np.testing.assert_allclose(point.position, other.outputs[name].position[:len(branch)],
                                   rtol=1e-9, atol=1e-9)


def test_without_a_sweep(example):
    scene = example("slider_crank")
    scene.pop("sweep", None)
    with pytest.raises(assur.SceneError, match="^scene: sweep"):
        assur.Plan(assur.parse_scene(scene)).sweep()
