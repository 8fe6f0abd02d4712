"""Law: pickled and copied objects equal the original, bit for bit; every object describes itself in
one line, and tables of pandas hold the numbers of the arrays."""

import copy
import pickle

import numpy as np
import pytest

import assur
from threads_test import told

PHI = np.linspace(0.2, 5, 9)


@pytest.fixture(scope="module")
def results():
    import json
    from conftest import EXAMPLES
    scene = json.loads((EXAMPLES / "four_bar_coupler_curve.json").read_text())
    scene["sweep"]["count"] = 11
    scene["reference"] = {"coupler": 1}
    scene = assur.parse_scene(scene, crank="38")
    plan = assur.Plan(scene)
    rack = assur.Plan(assur.read_scene(EXAMPLES / "rack_press.json"))
    deviations = {"crank": np.linspace(-1, 1, 7), "reach": np.zeros(7)}
    return {
        "Scene": scene, "Plan": plan, "Solution": plan.solve(phi=1.0),
        "solve_one": plan.solve_one(2, phi=1.0), "solve_nearest": plan.solve_nearest(phi=1.0),
        "Configuration": plan.solve(phi=1.0)[1], "slides": rack.solve(),
        "Batch": plan.solve_batch(phi=PHI), "empty": plan.solve_batch(phi=[]),
        "following": plan.solve_batch(phi=[*PHI, np.nan], branch=2),
        "Sweep": plan.sweep(), "Branch": plan.sweep_branch(1), "items": plan.sweep(phi=PHI),
        "Events": plan.sweep().events, "Samples": assur.sample(scene, 40, 3),
        "given": assur.sample(scene, 7, 1, deviations=deviations)}


NAMES = ["Scene", "Plan", "Solution", "solve_one", "solve_nearest", "Configuration", "slides",
         "Batch", "empty", "following", "Sweep", "Branch", "items", "Events", "Samples", "given"]


@pytest.mark.parametrize("name", NAMES)
def test_copies(results, name):
    original = results[name]
    ways = [copy.copy, copy.deepcopy]
    ways += [lambda one, protocol=protocol: pickle.loads(pickle.dumps(one, protocol))
             for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1)]
    for way in ways:
        copied = way(original)
        assert copied is not original and type(copied) is type(original)
        assert told_of(copied) == told_of(original)


def told_of(result):
    if isinstance(result, assur.Scene):
        return result.file, result.name, result.parameters, result.svg()
    if isinstance(result, assur.Plan):
        return told_of(result.scene), result.parameters, told(result.solve(phi=1.1))
    if isinstance(result, assur.Samples):
        return told([result.positions, result.outcome, result.parameters, result.deviations,
                     {name: [point.position, point.rss] for name, point in result.nominal.items()}])
    if isinstance(result, assur.Batch):
        return told(result), [result.reason(item) for item in range(len(result))]
    if isinstance(result, assur.Configuration):
        return result.number, told(result.outputs), result.svg()
    if isinstance(result, assur.Solution):
        parts = [result.links, result.joints, result.outputs, result.residual, result.families]
        return told(parts), result.to_json(), str(result), result.parameters
    return told(result)


def test_a_copied_batch_can_be_continued(results):
    plan = results["Plan"]
    batch = pickle.loads(pickle.dumps(results["following"]))
    again = assur.Plan(results["Scene"])
    with pytest.raises(assur.ShapeError, match="another scene"):
        again.solve_batch(phi=[5.1], from_=batch)
    pair = pickle.loads(pickle.dumps((plan, results["following"])))
    assert pair[0].solve_batch(phi=[5.1], from_=pair[1]).configuration == (
        plan.solve_batch(phi=[5.1], from_=results["following"]).configuration)


@pytest.mark.parametrize("name, text", [
    ("Scene", "<assur.Scene scene: Hoeken"), ("Plan", "<assur.Plan of scene: 1 group, at most 2"),
    ("Solution", "<assur.Solution: 2 configurations"), ("Configuration", "<assur.Configuration 2: re"),
    ("Batch", "<assur.Batch: 9 items, 18 rows, 0 gaps>"),
    ("following", "<assur.Batch: 10 items, 10 rows, 1 gap>"),
    ("Sweep", "<assur.Sweep over phi: 2 branches, 0 events>"),
    ("Branch", "<assur.Branch 1: 11 rows>"), ("Events", "<assur.Events>"),
    ("Samples", "<assur.Samples: 40 samples, 40 regular>")])
def test_representations(results, name, text):
    shown = repr(results[name])
    assert shown.startswith(text) and "\n" not in shown and "0x" not in shown


def test_representations_of_parts(results):
    solution = results["Solution"]
    assert repr(solution.links) == "<assur.Links: ground, crank, coupler, rocker>"
    assert repr(solution.outputs["P"]).startswith("<assur.OutputState P: position, velocity")


def test_frames(results, command, example):
    pandas = pytest.importorskip("pandas", reason="pandas is not installed")
    scene = example("four_bar_coupler_curve", steps=11, reference={"coupler": 1})
    header = command.run("solve", command.file(scene), "--format", "csv").stdout.split("\n")[0]
    for name in ("Solution", "Batch", "following", "Sweep", "Branch", "items", "Events", "Samples"):
        result = results[name]
        frame = result.to_frame()
        assert isinstance(frame, pandas.DataFrame)
        if name in ("Sweep", "Branch"):
            numbers = [one for one in header.split(",") if "." in one and "solution" not in one]
            assert [one for one in frame.columns if "." in one] == numbers
        if name == "Samples":
            assert list(frame.columns)[:2] == ["outcome", next(iter(result.deviations))]
            assert (frame["P.x"].to_numpy() == result.positions["P"][:, 0]).all()
        elif name not in ("Sweep", "items"):
            assert np.array_equal(frame["P.y"].to_numpy(), result.outputs["P"].position[:, 1],
                                  equal_nan=True)
    sweep = results["Sweep"]
    frame = sweep.to_frame()
    assert len(frame) == sum(map(len, sweep.branches.values()))
    second = frame[frame["branch"] == 2]
    assert (second["coupler.theta"].to_numpy() ==
            sweep.branches[2].links["coupler"].pose[:, 2]).all()
