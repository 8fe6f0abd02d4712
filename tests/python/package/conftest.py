"""The command and the examples, with which every test compares the package."""

import copy
import csv
import io
import json
import os
import pathlib
import subprocess

import pytest

EXAMPLES = pathlib.Path(os.environ["ASSUR_SOURCE"]) / "examples"

PARALLELOGRAM = {
    "name": "a parallelogram at its flat position",
    "parameters": {"a": {"value": 2, "tolerance": 0.01}, "b": {"value": 5, "tolerance": 0.02},
                   "phi": 0},
    "links": {
        "ground": {"A": [0, 0], "D": ["b", 0]},
        "crank": {"A": [0, 0], "B": ["a", 0]},
        "coupler": {"B": [0, 0], "C": ["b", 0], "P": ["b/2", 1]},
        "rocker": {"D": [0, 0], "C": ["a", 0]},
    },
    "joints": {
        "A": {"type": "revolute", "between": ["ground.A", "crank.A"]},
        "B": {"type": "revolute", "between": ["crank.B", "coupler.B"]},
        "C": {"type": "revolute", "between": ["coupler.C", "rocker.C"]},
        "D": {"type": "revolute", "between": ["ground.D", "rocker.D"]},
    },
    "drivers": {"A": {"position": "phi", "velocity": 2}},
    "outputs": {"P": "coupler.P"},
    "sweep": {"parameter": "phi", "from": -1, "to": 1, "count": 21},
}


class Command:
    """Runs the command on a scene that stands in a file of its own."""

    def __init__(self, folder):
        self.folder = folder

    def file(self, scene):
        path = self.folder / "scene.json"
        path.write_text(json.dumps(scene))
        return path

    def run(self, *arguments):
        return subprocess.run([os.environ["ASSUR_COMMAND"], *map(str, arguments)],
                              capture_output=True, text=True, check=False)

    def json(self, scene, *more):
        return json.loads(self.run("solve", self.file(scene), "--format", "json", *more).stdout)

    def rows(self, scene, *more):
        text = self.run("solve", self.file(scene), "--format", "csv", *more).stdout
        return list(csv.DictReader(io.StringIO(text)))


@pytest.fixture
def command(tmp_path):
    return Command(tmp_path)


@pytest.fixture
def example():
    """A scene of examples/ as a dictionary; its sweep, if any, has `steps` steps."""

    def read(name, steps=25, **more):
        scene = json.loads((EXAMPLES / (name + ".json")).read_text())
        scene.setdefault("sweep", {}).update(count=steps) if "sweep" in scene else None
        scene.update(more)
        return scene

    return read


@pytest.fixture
def parallelogram():
    return copy.deepcopy(PARALLELOGRAM)
