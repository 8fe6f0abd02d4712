"""Law: samples are those of `assur sample` with the same seed, whatever the number of threads."""

import csv
import json

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

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


def moments(scene, **how):
    samples = assur.sample(scene, 20_000, 5, **how)
    deviation = samples.parameters - [assur.Plan(scene).solve().parameters[name]
                                      for name in samples.deviations]
    return samples, deviation


def test_normal_deviations(example):
    """The standard deviation is a third of the tolerance; the nominal covariance is of that law."""
    scene = assur.parse_scene(example("four_bar_coupler_curve"))
    samples, deviation = moments(scene, deviations="normal")
    tolerances = np.array(list(samples.deviations.values()))
    # Four standard errors, 1 / sqrt(2 n) of a standard deviation.
    assert np.abs(deviation.std(axis=0) / (tolerances / 3) - 1).max() < 4 / 200
    assert np.abs(deviation.mean(axis=0) / (tolerances / 3)).max() < 4 / 141
    kurtosis = (deviation ** 4).mean(axis=0) / deviation.var(axis=0) ** 2
    assert np.abs(kurtosis - 3).max() < 4 * np.sqrt(24 / 20_000)
    off = np.corrcoef(deviation.T) - np.eye(len(tolerances))
    assert np.abs(off).max() < 4 / 141
    uniform = assur.sample(scene, 10, 5)
    assert_allclose(samples.nominal["P"].covariance, uniform.nominal["P"].covariance / 3, rtol=1e-12)
    assert np.cov(samples.positions["P"].T) == pytest.approx(samples.nominal["P"].covariance,
                                                             rel=0.05)


def test_a_covariance(example):
    matrix = np.array([[4e-4, 3e-4], [3e-4, 9e-4]])
    scene = assur.parse_scene(example("four_bar_coupler_curve", covariance={
        "parameters": ["crank", "coupler"], "matrix": matrix}))
    samples, deviation = moments(scene, deviations="covariance")
    assert list(samples.deviations) == ["crank", "coupler"]
    assert_allclose(list(samples.deviations.values()), np.sqrt(np.diag(matrix)))
    assert np.abs(np.cov(deviation.T) / matrix - 1).max() < 0.06
    assert_allclose(samples.nominal["P"].covariance,
                    assur.Plan(scene).solve()[0].outputs["P"].covariance, rtol=1e-9)
    # Of rank one, so that the parameters vary together.
    scene = assur.parse_scene(example("four_bar_coupler_curve", covariance={
        "parameters": ["crank", "coupler"], "matrix": [[4e-4, 6e-4], [6e-4, 9e-4]]}))
    _, deviation = moments(scene, deviations="covariance")
    # The root of an eigenvalue of zero has half of the digits.
    assert_allclose(deviation[:, 1], 1.5 * deviation[:, 0], atol=1e-8)
    with pytest.raises(assur.SceneError, match="has no covariance"):
        assur.sample(assur.parse_scene(example("four_bar_coupler_curve")), 3, 1,
                     deviations="covariance")


def test_given_deviations(example):
    """Every sample is the solution with its deviations."""
    scene = assur.parse_scene(example("four_bar_coupler_curve"))
    given = np.random.default_rng(3).normal(0, 0.05, (2, 25))
    samples = assur.sample(scene, 25, 0, branch=2, threads=2,
                           deviations={"crank": given[0], "phi": given[1]})
    plan = assur.Plan(scene)
    own = plan.solve().parameters
    values = {"crank": own["crank"] + given[0], "phi": own["phi"] + given[1]}
    start = plan.solve()[1]
    batch = plan.solve_batch(values, from_=start)
    assert_allclose(samples.positions["P"], batch.outputs["P"].position, rtol=1e-12)
    assert_allclose(samples.parameters, np.column_stack([values["crank"], values["phi"]]))
    with pytest.raises(assur.SceneError, match="give one that is not"):
        assur.sample(scene, 2, 1, deviations={"crank": [0, 0]})


def test_values_of_samples(example):
    scene = example("four_bar_coupler_curve")
    changed = assur.sample(assur.parse_scene(scene, crank=37, phi="2/3"), 30, 1)
    for samples in (assur.sample(assur.parse_scene(scene), 30, 1, crank=37, phi="2/3"),
                    assur.sample(assur.parse_scene(scene), 30, 1, values={"crank": 37}, phi="2/3")):
        assert (samples.positions["P"] == changed.positions["P"]).all()
