"""Law: forces are those of the command, bit for bit: of a configuration in JSON, of sweeps and
samples in the tables; those of the rows of a batch are those of its items."""

import csv
import json
import pickle

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

import assur

SCENES = [("crane", "cylinder"), ("four_bar_torque", "A")]
STEPS = {"crane": np.linspace(2.3, 3.2, 6), "four_bar_torque": np.linspace(1, 5, 6)}


def loaded(example, name, steps=13, **more):
    scene = example(name, steps=steps, **more)
    scene["want"] = [*scene["want"], "sensitivity"]
    return scene


def flat(forces):
    """Every array and float of a dictionary of forces, in the order of its names."""
    for name, part in forces.items():
        if isinstance(part, dict):
            yield from flat(part)
        elif name not in ("on", "reason"):
            yield part


def expect_rows(several, place, one):
    """One row of forces is that of one configuration."""
    assert several["reason"][place] == one["reason"]
    numbers, expected = list(flat(several)), list(flat(one))
    assert len(numbers) == len(expected) > 0
    for array, number in zip(numbers, expected):
        assert_array_equal(array[place], number)


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


def expect_table(columns, rows):
    """The columns of forces in a table of the command are these."""
    for name, numbers in columns.items():
        assert_array_equal(numbers, [float(row[name] or "nan") for row in rows], err_msg=name)


def columns_of(forces, deviation=""):
    columns = {f"{name}.{deviation}effort": effort for name, effort in forces["efforts"].items()}
    for name, part in (*forces["joints"].items(), ("ground", forces["ground"])):
        for of, force in part.get("forces", {"": part.get("force")}).items():
            of = f"{name}.{of}" if of else name
            columns[f"{of}.{deviation}fx"], columns[f"{of}.{deviation}fy"] = force.T
        if "moment" in part:
            columns[f"{name}.{deviation}moment"] = part["moment"]
    return columns


@pytest.mark.parametrize("name, driver", SCENES)
def test_forces_are_those_of_the_command(example, name, driver):
    scene = loaded(example, name)
    solution = assur.Plan(assur.parse_scene(scene)).solve()
    printed = json.loads(solution.to_json())["configurations"]
    for place, one in enumerate(printed):
        found = solution[place].forces
        assert found["reason"] == ""
        expect_same(found, one, [driver])
        expect_rows(solution.forces, place, found)
        for parameter in scene["parameters"]:
            told = found["sensitivity"][parameter]
            expected = one["drivers"][driver]["sensitivity"][parameter]["effort"]
            assert told["efforts"][driver] == expected
            assert_array_equal(told["ground"]["force"],
                               one["ground"]["sensitivity"][parameter]["force"])
        for deviation in ("worst_case", "rss"):
            expected = one["drivers"][driver][deviation]["effort"]
            assert found[deviation]["efforts"][driver] == expected


@pytest.mark.parametrize("name, driver", SCENES)
def test_forces_of_sweeps_are_those_of_the_table(command, example, name, driver):
    scene = loaded(example, name)
    sweep = assur.Plan(assur.parse_scene(scene)).sweep()
    rows = [row for row in command.rows(scene) if not row["event"]]
    for number, branch in sweep.branches.items():
        own = [row for row in rows if row["branch"] == str(number)]
        assert len(own) == len(branch) == len(branch.forces["reason"]) > 0
        expect_table(columns_of(branch.forces), own)
        for deviation in ("worst_case", "rss"):
            expect_table(columns_of(branch.forces[deviation], deviation + "_"), own)
        assert np.isfinite(branch.forces["efforts"][driver]).any()


@pytest.mark.parametrize("name, driver", SCENES)
def test_a_branch_alone_has_the_forces_of_its_values(example, name, driver):
    plan = assur.Plan(assur.parse_scene(loaded(example, name)))
    parameter, link, other = ("stroke", "boom", "payload") if name == "crane" else (
        "phi", "rocker", "coupler_mass")
    branch = plan.sweep_branch(1, {other: 3.0})
    items = plan.sweep({parameter: STEPS[name], other: 3.0}).branches
    for swept, values in ((branch, branch.parameter), *((one, STEPS[name][one.step])
                                                        for one in items.values())):
        for place, value in enumerate(values):
            alone = plan.solve({parameter: value, other: 3.0})
            [same] = [one for one in alone
                      if np.allclose(one.links[link].pose, swept.links[link].pose[place])]
            for array, number in zip(flat(swept.forces), flat(same.forces)):
                assert_allclose(array[place], number, rtol=1e-10, atol=1e-9)
    assert len(branch) > 0 and len(items) == 2


@pytest.mark.parametrize("name, driver", SCENES)
def test_forces_of_batches_are_those_of_their_items(example, name, driver):
    plan = assur.Plan(assur.parse_scene(loaded(example, name)))
    parameter = plan.sweep().parameter
    values = STEPS[name]
    batch = plan.solve_batch({parameter: values})
    for row, (item, number) in enumerate(zip(batch.item, batch.configuration)):
        alone = plan.solve({parameter: values[item]})[int(number) - 1]
        expect_rows(batch.forces, row, alone.forces)
    copied = pickle.loads(pickle.dumps(batch)).forces
    assert copied["reason"] == batch.forces["reason"]
    for array, expected in zip(flat(copied), flat(batch.forces), strict=True):
        assert_array_equal(array, expected)
    walk = plan.solve_batch({parameter: [*values, np.nan]}, branch=1)
    assert list(walk.gap) == [False] * 6 + [True]
    for row, number in enumerate(walk.configuration[:6]):
        alone = plan.solve({parameter: values[row]})[int(number) - 1].forces
        assert_allclose(walk.forces["efforts"][driver][row], alone["efforts"][driver], rtol=1e-10)
        assert_allclose(walk.forces["ground"]["force"][row], alone["ground"]["force"], rtol=1e-10,
                        atol=1e-9)
    assert all(np.isnan(array[6]).all() for array in flat(walk.forces))


@pytest.mark.parametrize("name, driver", SCENES)
def test_forces_of_samples_are_those_of_the_command(command, example, name, driver):
    scene = example(name)
    table = command.folder / "samples.csv"
    told = command.run("sample", command.file(scene), "--count", 50, "--seed", 3, "--output",
                       table, "--format", "json", "--quiet")
    rows = list(csv.DictReader(line for line in table.read_text().splitlines()
                               if not line.startswith("#")))
    samples = assur.sample(assur.parse_scene(scene), 50, 3)
    columns = columns_of(samples.forces)
    assert f"{driver}.effort" in columns and len(columns) > 4
    expect_table(columns, rows)
    assert samples.forces["joints"].keys() == samples.nominal_forces["joints"].keys()
    printed = json.loads(told.stdout)["forces"]
    for key, forces in (("nominal", samples.nominal_forces),
                        ("worst_case", samples.nominal_forces["worst_case"]),
                        ("rss", samples.nominal_forces["rss"])):
        for column, number in columns_of({part: forces[part] for part in
                                          ("efforts", "joints", "ground")}).items():
            assert printed[column][key] == number, (column, key)


def test_a_pin_of_three_links_has_the_forces_on_each():
    scene = {"points": {"A": [0, 0], "B": [1, 0.5], "C": [2, 0], "D": [1.5, 1.5], "E": [3, 1],
                        "F": [2.5, 0.5]},
             "links": {"ground": ["A", "E", "C"], "crank": ["A", "B"], "one": ["B", "D"],
                       "two": ["D", "E"], "three": ["D", "F"], "four": ["F", "C"]},
             "drivers": {"A": {}}, "masses": {"three": {"mass": 1, "at": "F"}},
             "gravity": [0, -9.81], "want": ["position", "forces"]}
    solution = assur.Plan(assur.parse_scene(scene)).solve()
    forces = solution.forces["joints"]["D"]["forces"]
    assert sorted(forces) == ["one", "three", "two"]
    total = sum(forces.values())
    assert total.shape == (len(solution), 2) and len(solution) > 0
    largest = max(np.abs(force).max() for force in forces.values())
    assert np.abs(total).max() < 1e-12 * largest
    printed = json.loads(solution.to_json())["configurations"]
    for place, one in enumerate(printed):
        for link, force in one["joints"]["D"]["forces"].items():
            assert_array_equal(forces[link][place], force)


def test_what_is_not_determined_is_nan(parallelogram):
    parallelogram["masses"] = {"coupler": {"mass": 1, "at": "P"}}
    parallelogram["gravity"] = [0, -9.81]
    parallelogram["want"] = ["position", "velocity", "forces"]
    solution = assur.Plan(assur.parse_scene(parallelogram)).solve(phi=0.0)
    assert np.isnan(solution.forces["joints"]["B"]["force"]).all()
    assert solution.forces["reason"][0] == solution[0].forces["reason"] != ""
    events = assur.Plan(assur.parse_scene(parallelogram)).sweep().events
    assert len(events) > 0 and np.isnan(events.forces["efforts"]["A"]).all()


@pytest.mark.parametrize("name", ["crane", "four_bar_torque"])
def test_tables_of_pandas_have_the_columns_of_the_command(command, example, name):
    pytest.importorskip("pandas", reason="pandas is not installed")
    scene = loaded(example, name)
    header = command.run("solve", command.file(scene), "--format", "csv").stdout.split("\n")[0]
    frame = assur.Plan(assur.parse_scene(scene)).sweep().to_frame()
    expected = [one for one in header.split(",") if "." in one and "solution" not in one]
    of_slides = (".displacement", ".velocity", ".acceleration")  # the command's table has none
    assert [one for one in frame.columns
            if "." in one and not one.endswith(of_slides)] == expected
    samples = assur.sample(assur.parse_scene(scene), 5, 1).to_frame()
    assert "ground.moment" in samples.columns


def test_a_load_without_a_value_is_refused_at_its_item(example):
    scene = example("crane")
    scene["loads"]["hook"]["force"] = [0, "-1e3*sqrt(payload)"]
    plan = assur.Plan(assur.parse_scene(scene))
    with pytest.raises(assur.SceneError, match=r"values\[1\]"):
        plan.solve_batch(payload=[2000.0, -1.0])


def test_forces_that_are_not_wanted_are_refused(example):
    scene = assur.parse_scene(example("slider_crank"))
    plan = assur.Plan(scene)
    for result in (plan.solve(), plan.solve()[0], plan.sweep_branch(1)):
        with pytest.raises(assur.NotWanted, match="forces"):
            result.forces
    tolerated = assur.parse_scene(example("four_bar_coupler_curve"))
    with pytest.raises(assur.NotWanted, match="forces"):
        assur.sample(tolerated, 5, 1).forces
