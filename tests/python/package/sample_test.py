"""Law: samples are those of `assur sample` with the same seed, whatever the number of threads."""

import csv
import json

import numpy as np
import pytest
from numpy.testing import assert_array_equal

import assur

COUNT, SEED = 700, 18446744073709551615


def test_the_commands_samples(command, example):
    scene = example("four_bar_coupler_curve")
    scene["parameters"]["coupler"] = {"value": 50, "tolerance": 1.5}  # near its dead centre
    scene["parameters"]["rocker"] = {"value": 20, "tolerance": 0.5}
    table = command.folder / "samples.csv"
    told = command.run("sample", command.file(scene), "--count", COUNT, "--seed", SEED, "--output",
                       table, "--format", "json", "--quiet")
    rows = list(csv.DictReader(line for line in table.read_text().splitlines()
                               if not line.startswith("#")))
    samples = assur.sample(assur.parse_scene(scene), COUNT, SEED)
    assert len(samples) == len(rows) == COUNT
    assert [assur.Outcome(one).word for one in samples.outcome] == [row["outcome"] for row in rows]
    assert {assur.Outcome.REGULAR, assur.Outcome.NO_ASSEMBLY} <= set(samples.outcome)
    for name, positions in samples.positions.items():
        assert positions.shape == (COUNT, 2)
        for axis, letter in enumerate("xy"):
            assert_array_equal(positions[:, axis], [float(row[name + "." + letter] or "nan")
                                                    for row in rows])
    printed = json.loads(told.stdout)["outputs"]
    for name, point in samples.nominal.items():
        for key, vector in (("nominal", point.position), ("worst_case", point.worst_case),
                            ("rss", point.rss), ("mean_shift_second_order", point.mean_shift)):
            assert printed[name][key] == list(vector)
        assert_array_equal(printed[name]["covariance_first_order"], point.covariance)
    lost = int(np.argmax(samples.outcome == assur.Outcome.NO_ASSEMBLY))
    assert "fail to close" in samples.reason(lost)
    for threads in (1, 3):
        again = assur.sample(assur.parse_scene(scene), COUNT, SEED, threads=threads)
        assert_array_equal(again.positions["P"], samples.positions["P"])


def test_each_sample_is_its_parameters_solved(example):
    scene = assur.parse_scene(example("four_bar_coupler_curve"))
    samples = assur.sample(scene, 12, seed=3, branch=2)
    assert list(samples.deviations.values()) == [0.02, 0.05, 0.05, 0.1]
    assert samples.parameters.shape == (12, 4)
    plan = assur.Plan(scene)
    batch = plan.solve_batch(dict(zip(samples.deviations, samples.parameters.T)))
    second = batch.configuration == 2
    np.testing.assert_allclose(batch.outputs["P"].position[second], samples.positions["P"],
                               rtol=1e-13)


def test_refusals(command, example):
    scene = example("four_bar_coupler_curve")
    with pytest.raises(assur.ShapeError, match="count: "):
        assur.sample(assur.parse_scene(scene), 0, 1)
    for name in scene["parameters"]:
        scene["parameters"][name] = 60 if name == "phi" else 100
    line = command.run("sample", command.file(scene), "--count", 5, "--seed", 1, "--output",
                       command.folder / "none.csv").stderr
    with pytest.raises(assur.SceneError) as raised:
        assur.sample(assur.read_scene(command.folder / "scene.json"), 5, 1)
    assert line == f"error: {raised.value}\n"
