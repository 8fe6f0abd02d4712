"""Law: input that cannot be used raises one exception, whose text is the command's message."""

import json
import os
import pathlib

import numpy as np
import pytest

import assur


def expect_line(command, raised, *arguments):
    told = command.run(*arguments)
    assert told.returncode == 2
    assert told.stderr == f"error: {raised.value}\n"
    assert "\n" not in str(raised.value)


def test_files_that_cannot_be_read(command):
    missing = command.folder / "missing.json"
    with pytest.raises(assur.SceneError) as raised:
        assur.read_scene(missing)
    expect_line(command, raised, "solve", missing)
    for text in ("", "[", '{"name": 3}', '{"drivrs": {}}', "\x00", '{"a": "\\ud800"}', "[" * 5000):
        missing.write_text(text)
        with pytest.raises(assur.SceneError) as raised:
            assur.read_scene(missing)
        expect_line(command, raised, "solve", missing)
    with pytest.raises(assur.SceneError):
        assur.read_scene(os.fsencode(command.folder) + b"/\xff\xfe.json")
    with pytest.raises(assur.SceneError):
        assur.read_scene(command.folder)


def broken(scene, change):
    change(scene)
    return scene


@pytest.mark.parametrize("change, error", [
    (lambda scene: scene["joints"]["B"].update(between=["crank.B", "couplr.B"]), "SceneError"),
    (lambda scene: scene["parameters"].update(a="2*"), "SceneError"),
    (lambda scene: scene["parameters"].update(a="sqrt(-1)"), "SceneError"),
    (lambda scene: scene["parameters"].update(a="b", b="a"), "SceneError"),
    (lambda scene: scene.pop("drivers"), "SceneError"),
    (lambda scene: scene["joints"].pop("D"), "SceneError"),
    (lambda scene: scene["drivers"].update(D={"position": 0}), "OverConstrained"),
    (lambda scene: scene["links"].pop("ground"), "SceneError"),
])
def test_scenes_that_cannot_be_solved(command, parallelogram, change, error):
    file = command.file(broken(parallelogram, change))
    with pytest.raises(assur.SceneError) as raised:
        assur.Plan(assur.read_scene(file)).solve()
    expect_line(command, raised, "solve", file)


def test_over_constrained(command, parallelogram):
    parallelogram["links"]["ground"]["P"] = [1, 1]
    parallelogram["joints"]["P"] = {"type": "revolute", "between": ["coupler.P", "ground.P"]}
    file = command.file(parallelogram)
    with pytest.raises(assur.OverConstrained) as raised:
        assur.Plan(assur.read_scene(file))
    expect_line(command, raised, "solve", file)
    assert raised.value.surplus > 0 and "P" in raised.value.joints
    assert isinstance(raised.value.joints, tuple)


def test_dictionaries_that_are_no_scenes(parallelogram):
    parallelogram["parameters"]["a"] = np.float32(2)
    parallelogram["links"]["crank"]["B"] = np.array([2.0, 0.0])
    parallelogram["sweep"]["count"] = np.int64(3)
    assert len(assur.Plan(assur.parse_scene(parallelogram)).solve(phi=1)) == 2
    parallelogram["parameters"]["a"] = object()
    with pytest.raises(assur.ShapeError, match="not object"):
        assur.parse_scene(parallelogram)
    parallelogram["parameters"]["a"] = float("nan")
    with pytest.raises(assur.SceneError):
        assur.parse_scene(parallelogram)
    parallelogram["parameters"]["a"] = 2
    for wrong in (None, 3, [1, 2], ""):
        with pytest.raises(assur.SceneError):
            assur.parse_scene(wrong)
    text = '{"name": "four bars"}'
    for at, place in ((0, "1:1"), (3, "1:4"), (len(text), f"1:{len(text) + 1}")):
        with pytest.raises(assur.SceneError, match=f"^scene:{place}: a NUL byte; remove it"):
            assur.parse_scene(text[:at] + "\0" + text[at:])
    with pytest.raises(assur.SceneError, match="column 2 of '2.?1'"):
        assur.parse_scene(parallelogram, a="2\x001")
    with pytest.raises(ValueError, match="embedded null byte"):
        assur.read_scene("scene.json\0")
    ring = {}
    ring["name"] = ring
    for wrong in (ring, {(1, 2): 3}, "\ud800"):
        with pytest.raises(assur.ShapeError, match="^scene: "):
            assur.parse_scene(wrong)
    for values, text in (({"a": np.nan}, "a: expected a finite number"),
                         ({"a": [1]}, "a: expected a number, not list"),
                         ({"\ud800": 1}, "a parameter's name holds a surrogate")):
        with pytest.raises(assur.ShapeError, match=text):
            assur.parse_scene(parallelogram, values)


@pytest.fixture
def plan(example):
    return assur.Plan(assur.parse_scene(example("four_bar_coupler_curve")))


@pytest.mark.parametrize("call, error, text", [
    (lambda plan: plan.solve(phy=1), "UnknownName",
     "no parameter named 'phy' (did you mean 'phi'?)"),
    (lambda plan: plan.solve_batch(x=[1]), "UnknownName",
     "no parameter named 'x' (choose from ground, crank, coupler, rocker, reach, phi)"),
    (lambda plan: plan.sweep(phi=1), "SceneError",
     "scene: phi: the sweep gives 'phi' its values; leave this out, or change the sweep"),
    (lambda plan: plan.sweep(x=1), "UnknownName",
     "no parameter named 'x' (choose from ground, crank, coupler, rocker, reach, phi)"),
    (lambda plan: plan.solve(phi=np.zeros(3)), "ShapeError",
     "phi: expected a number, not an array of shape (3,); Plan.solve_batch and Plan.sweep take arrays"),
    (lambda plan: plan.solve(phi=[1.0]), "ShapeError", "phi: expected a number, not list"),
    (lambda plan: plan.solve(phi="60*deg"), "ShapeError",
     "phi: expected a number, not str; read_scene and parse_scene take expressions"),
    (lambda plan: plan.solve(phi=1j), "ShapeError", "phi: expected a number, not complex"),
    (lambda plan: plan.solve(phi=10**400), "ShapeError", "phi: the number is too large for a double"),
    (lambda plan: plan.solve([1.0]), "ShapeError",
     "values: expected a mapping from parameters' names, not list; "
     "give {'phi': ...}, or the keyword phi=..."),
    (lambda plan: plan.solve({1: 2}), "ShapeError",
     "values: a parameter's name must be a text, not int"),
    (lambda plan: plan.solve_batch(phi=np.zeros((2, 2))), "ShapeError",
     "phi: expected one dimension, not an array of shape (2, 2); "
     "give each parameter an array of its own"),
    (lambda plan: plan.solve_batch(phi=[1, 2], crank=[1, 2, 3]), "ShapeError",
     "crank: expected 2 values, as phi has, not 3"),
    (lambda plan: plan.solve_batch(phi=[[1], [2, 3]]), "ShapeError",
     "phi: expected an array of numbers, not list"),
    (lambda plan: plan.solve_batch(phi=1), "ShapeError",
     "values: no parameter has an array of values; Plan.solve takes numbers"),
    (lambda plan: plan.solve_batch(), "ShapeError",
     "values: no parameter has an array of values; Plan.solve takes numbers"),
    (lambda plan: plan.solve(phi=float("inf")), "SceneError",
     "scene: parameters.phi: the value is not a finite number"),
    (lambda plan: plan.solve_one(3), "SceneError",
     "scene: there is no configuration 3; the highest number is 2"),
    (lambda plan: plan.solve_one(0), "SceneError",
     "scene: there is no configuration 0; they are numbered from 1"),
    (lambda plan: plan.solve_one(-1), "ShapeError",
     "number: expected a whole number from 0, not -1"),
    (lambda plan: plan.scene.svg(1.5), "ShapeError",
     "configuration: expected a whole number from 0, not float"),
    (lambda plan: plan.scene.svg(2**40), "ShapeError",
     "configuration: expected a whole number from 1 to 2147483647"),
    (lambda plan: assur.sample(plan.scene, 3, seed=-1), "ShapeError",
     "seed: expected a whole number from 0, not -1"),
    (lambda plan: plan.solve_batch(phi=np.array([1j])), "ShapeError",
     "phi: expected an array of numbers, not one of dtype complex128"),
    (lambda plan: plan.solve_batch(phi=np.array(["1"])), "ShapeError",
     "phi: expected an array of numbers, not one of dtype <U1"),
    (lambda plan: plan.solve().outputs["p"], "UnknownName",
     "no output named 'p' (did you mean 'P'?)"),
    (lambda plan: plan.solve()[0].links["crnk"], "UnknownName",
     "no link named 'crnk' (did you mean 'crank'?)"),
    (lambda plan: plan.solve().outputs["P"].covariance, "NotWanted",
     "covariance: the scene does not want it; "
     "give it a key 'covariance', and let it want 'sensitivity'"),
])
def test_calls(plan, call, error, text):
    with pytest.raises(assur.Error) as raised:
        call(plan)
    assert (type(raised.value).__name__, str(raised.value)) == (error, text)


@pytest.mark.parametrize("call, text", [
    (lambda wrong: assur.Plan(wrong),
     "scene: expected a Scene, which read_scene and parse_scene return, not "),
    (lambda wrong: assur.sample(wrong, count=10, seed=1),
     "scene: expected a Scene, which read_scene and parse_scene return, not "),
    (lambda wrong: assur.read_scene(wrong),
     "expected str, bytes or os.PathLike object, not "),
], ids=["Plan", "sample", "read_scene"])
@pytest.mark.parametrize("wrong", [None, 2.5, [1]], ids=["None", "a number", "a list"])
def test_what_is_no_scene(call, text, wrong):
    with pytest.raises(TypeError) as raised:
        call(wrong)
    assert str(raised.value) == text + type(wrong).__name__


def bound():
    """Every function, method and property of the module."""
    for name, part in vars(assur._assur).items():
        if not isinstance(part, type):
            if callable(part):
                yield name, part
            continue
        yield name, part
        for attribute, member in vars(part).items():
            member = member.fget if isinstance(member, property) else member
            if callable(member):
                yield name + "." + attribute, member


@pytest.mark.parametrize("function", dict(bound()).values(), ids=dict(bound()))
def test_none_in_place_of_everything(function):
    for count in range(5):
        try:
            function(*[None] * count)
        except (TypeError, assur.Error):
            pass


def test_every_error_is_one_kind():
    for error in (assur.SceneError, assur.ShapeError, assur.UnknownName, assur.NotWanted):
        assert issubclass(error, assur.Error)
    assert issubclass(assur.OverConstrained, assur.SceneError)
    assert issubclass(assur.NotWanted, AttributeError)  # so that hasattr tells what is there


def test_the_schema(command):
    assert json.loads(assur.scene_schema()) == json.loads(command.run("schema").stdout)
    assert pathlib.Path(assur.__file__).name == "__init__.py"
