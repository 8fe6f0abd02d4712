"""Law: the forces of a configuration are those of `assur solve --format json`."""

import json

import pytest
from numpy.testing import assert_array_equal

import assur


def expect_same(found, printed, drivers):
    for name in drivers:
        assert found["efforts"][name] == printed["drivers"][name]["effort"]
    assert sorted(found["joints"]) == sorted(printed["joints"])
    for name, joint in printed["joints"].items():
        assert found["joints"][name]["on"] == joint["on"]
        assert_array_equal(found["joints"][name]["force"], joint["force"])
        assert found["joints"][name].get("moment") == joint.get("moment")
    assert_array_equal(found["ground"]["force"], printed["ground"]["force"])
    assert found["ground"]["moment"] == printed["ground"]["moment"]


@pytest.mark.parametrize("name, driver", [("crane", "cylinder"), ("four_bar_torque", "A")])
def test_forces_are_those_of_the_command(example, name, driver):
    scene = example(name)
    scene["want"] = [*scene["want"], "sensitivity"]
    solution = assur.Plan(assur.parse_scene(scene)).solve()
    printed = json.loads(solution.to_json())["configurations"]
    for place, one in enumerate(printed):
        found = solution[place].forces
        assert found["reason"] == ""
        expect_same(found, one, [driver])
        for parameter in scene["parameters"]:
            told = found["sensitivity"][parameter]
            expected = one["drivers"][driver]["sensitivity"][parameter]["effort"]
            assert told["efforts"][driver] == expected
            assert_array_equal(told["ground"]["force"],
                               one["ground"]["sensitivity"][parameter]["force"])
        for deviation in ("worst_case", "rss"):
            expected = one["drivers"][driver][deviation]["effort"]
            assert found[deviation]["efforts"][driver] == expected


def test_forces_that_are_not_wanted_are_refused(example):
    solution = assur.Plan(assur.parse_scene(example("slider_crank"))).solve()
    with pytest.raises(assur.NotWanted, match="forces"):
        solution[0].forces
