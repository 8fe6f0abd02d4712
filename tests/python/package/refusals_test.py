"""Law: arguments that no function takes are refused in one plain line."""

import numpy as np
import pytest

import assur


@pytest.fixture
def plan(example):
    return assur.Plan(assur.parse_scene(example("four_bar_coupler_curve", steps=7)))


CALLS = {
    "Plan()": lambda plan: assur.Plan(),
    "Plan(x)": lambda plan: assur.Plan("four_bar.json"),
    "solve": lambda plan: plan.solve({}, 3),
    "solve_one": lambda plan: plan.solve_one(),
    "solve_batch": lambda plan: plan.solve_batch(1, 2),
    "sweep_branch": lambda plan: plan.sweep_branch(),
    "svg": lambda plan: plan.scene.svg(1, 2, 3),
    "svg keyword": lambda plan: plan.scene.svg(colour="red"),
    "page": lambda plan: plan.scene.page(1, 2),
    "index": lambda plan: plan.solve()["P"],
    "links": lambda plan: plan.solve().links.keys(1),
    "reason": lambda plan: assur.sample(plan.scene, 2, 1).reason(),
    "scene_schema": lambda plan: assur.scene_schema(1),
    "sample": lambda plan: assur.sample(plan.scene),
    "sample(x)": lambda plan: assur.sample("scene", 3, 1),
    "read_scene": lambda plan: assur.read_scene(),
    "parse_scene": lambda plan: assur.parse_scene(),
    "reason(x)": lambda plan: plan.solve_batch(phi=[1], branch=1).reason(),
}
VALUES = {
    "links[0]": lambda plan: plan.solve().links[0],
    "nearest": lambda plan: plan.scene.svg(nearest=1),
    "configuration": lambda plan: plan.scene.svg(configuration="1"),
    "item": lambda plan: plan.solve_batch(phi=[1], branch=1).reason("0"),
    "values": lambda plan: plan.solve(3),
    "number": lambda plan: plan.solve_one("2"),
    "count": lambda plan: assur.sample(plan.scene, 2.5, 1),
    "law": lambda plan: assur.sample(plan.scene, 3, 1, deviations="gauss"),
    "law of a type": lambda plan: assur.sample(plan.scene, 3, 1, deviations=4),
    "given": lambda plan: assur.sample(plan.scene, 3, 1, deviations={"crank": [0, 1]}),
    "given NaN": lambda plan: assur.sample(plan.scene, 1, 1, deviations={"crank": [np.nan]}),
}


def expect_plain(error):
    line = str(error)
    assert line and "\n" not in line and "incompatible" not in line
    assert not any(word in line for word in ("assur._assur", "std::", "py::", "Invoked", "0x"))


@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)
def test_arguments(plan, call):
    with pytest.raises(TypeError) as raised:
        call(plan)
    expect_plain(raised.value)


@pytest.mark.parametrize("call", VALUES.values(), ids=VALUES)
def test_values(plan, call):
    with pytest.raises(assur.ShapeError) as raised:
        call(plan)
    expect_plain(raised.value)


def test_the_line(plan):
    with pytest.raises(TypeError) as raised:
        plan.scene.svg(2, colour="red")
    assert str(raised.value) == ("Scene.svg: expected svg(self, configuration=0, nearest=False), "
                                 "not the arguments (int, colour=str)")
