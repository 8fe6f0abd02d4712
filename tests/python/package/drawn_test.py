"""Law: a drawn scene has the same drawn configuration, and the same drawn branch, as in the
command."""

import pytest

import assur

FOUR_BAR = {
    "points": {"A": [0, 0], "B": [20, 34.6], "C": [3.1, -63.9], "D": [80, 0], "P": [-13.8, -162.5]},
    "links": {"ground": ["A", "D"], "crank": ["A", "B"], "coupler": ["B", "C", "P"],
              "rocker": ["D", "C"]},
    "parameters": {"phi": {"drawn": "A"}, "AB": {"drawn": ["A", "B"], "tolerance": 0.1}},
    "drivers": {"A": {"position": "phi", "velocity": 10}},
    "outputs": ["P"],
    "sweep": {"parameter": "phi", "from": "phi", "to": "phi + 2*pi", "count": 13},
}


@pytest.mark.parametrize("side", [1, -1])
def test_drawn_configuration_and_branch(command, side):
    scene = {**FOUR_BAR, "points": {name: [x, side * y]
                                    for name, (x, y) in FOUR_BAR["points"].items()}}
    plan = assur.Plan(assur.read_scene(command.file(scene)))
    solution = plan.solve()
    answer = command.json(scene)
    assert solution.nearest.place + 1 == answer["drawn"]["configuration"]
    assert solution.nearest.distance == answer["drawn"]["distance"]
    assert solution.to_json() == command.run("solve", command.file(scene),
                                             "--format", "json").stdout
    rows = command.rows(scene, "--nearest")
    assert {int(row["branch"]) for row in rows} == {plan.nearest_branch()}


def test_a_scene_without_reference_has_no_nearest_branch(command):
    scene = {key: value for key, value in FOUR_BAR.items() if key != "sweep"}
    with pytest.raises(assur.SceneError):
        assur.Plan(assur.read_scene(command.file(scene))).nearest_branch()
