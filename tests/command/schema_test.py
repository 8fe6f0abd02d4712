"""Law: the schema that `assur schema` prints accepts every scene here that the reader accepts, has
every key of a scene with all keys, and refuses unknown keys in each object, as the reader does."""

import copy
import json
import pathlib
import subprocess
import sys
import tempfile

SKIPPED = 77
try:
    import jsonschema
    from jsonschema import Draft202012Validator
except ImportError:
    print("python3-jsonschema is not installed: the schema is not tested")
    sys.exit(SKIPPED)

EVERY_KEY = {
    "name": "every key",
    "unit": "mm",
    "parameters": {
        "AB": {"value": 2, "tolerance": 0.01, "velocity": 0, "acceleration": 0, "variable": True},
        "phi": "60*deg",
        "BC": 5,
        "OQ": {"drawn": ["O", "Q"]},
    },
    "points": {"O": [0, 5], "Q": [2, 6], "R": [5, 7], "V": [6, 9]},
    "links": {
        "ground": {"A": [0, 0], "guide": {"through": [0, 0], "along": [1, 0]}},
        "crank": {"A": [0, 0], "B": ["AB", 0]},
        "rod": {"B": [0, 0], "C": ["BC", 0], "chord": {"from": "B", "to": "C"}},
        "piston": {"C": [0, 0], "guide": {"through": [0, 0], "along": [1, 0]}},
        "arm": ["O", "Q"],
        "slider": ["R"],
        "tip": ["V"],
    },
    "joints": {
        "A": {"type": "revolute", "between": ["ground.A", "crank.A"]},
        "B": {"type": "revolute", "between": ["crank.B", "rod.B"]},
        "C": {"type": "revolute", "between": ["rod.C", "piston.C"]},
        "slide": {"type": "prismatic", "between": ["ground.guide", "piston.guide"],
                  "limits": [0, "2*BC"]},
        "O": {"type": "revolute", "between": ["ground.A", "arm.O"]},
        "T": {"type": "prismatic", "links": ["arm", "slider"], "along": ["O", "Q"]},
        "U": {"type": "prismatic", "links": ["slider", "tip"], "at": "R", "direction": [0, 1]},
    },
    "drivers": {"A": {"position": "phi", "velocity": 1, "acceleration": 0},
                "O": {"position": 0.5}, "T": {}, "U": {}},
    "outputs": {"C": "rod.C"},
    "masses": {"rod": {"mass": 2, "at": "C", "inertia": 0.1}},
    "gravity": [0, -9.81],
    "loads": {"push": {"at": "rod.C", "force": [1, 0], "frame": "crank"},
              "twist": {"on": "crank", "moment": 3}},
    "springs": {"coil": {"between": ["ground.A", "rod.C"], "stiffness": 1, "length": 2,
                         "damping": 0.1},
                "torsion": {"joint": "B", "stiffness": 1, "rest": 0.5, "damping": 0.1}},
    "want": ["position", "velocity", "acceleration", "sensitivity"],
    "report": {"links": ["rod"], "joints": ["slide"]},
    "reference": {"rod": "-20*deg"},
    "redundancy": {"tolerance": 0.01},
    "sweep": {"parameter": "phi", "from": 0, "to": "2*pi", "count": 11},
    "covariance": {"parameters": ["AB"], "matrix": [[1e-6]]},
}

failures = 0


def expect(holds, what):
    global failures
    if not holds:
        failures += 1
        print("FAILED:", what)


def keys_of(schema):
    """Every key that an object of the schema lists."""
    if isinstance(schema, dict):
        own = schema.get("properties", {}) if schema.get("additionalProperties") is False else {}
        return set(own).union(*(keys_of(part) for part in schema.values()))
    if isinstance(schema, list):
        return set().union(*(keys_of(part) for part in schema))
    return set()


def objects_with_keys(scene):
    """The paths of those objects of a scene whose keys the format defines, and not the scene."""
    yield ()
    for part in ("report", "sweep", "covariance"):
        if part in scene:
            yield (part,)
    for part in ("parameters", "joints", "drivers", "masses", "loads", "springs"):
        for name, value in scene.get(part, {}).items():
            if isinstance(value, dict):
                yield (part, name)
    for link, features in scene.get("links", {}).items():
        if isinstance(features, list):
            continue
        for feature, value in features.items():
            if isinstance(value, dict):
                yield ("links", link, feature)


def solves(command, scene):
    with tempfile.TemporaryDirectory() as directory:
        file = pathlib.Path(directory, "scene.json")
        file.write_text(json.dumps(scene))
        run = subprocess.run([command, "solve", str(file)], capture_output=True, text=True)
        return run.returncode == 0, run.stderr


def main(command, *folders):
    schema = json.loads(subprocess.run([command, "schema"], capture_output=True, check=True).stdout)
    Draft202012Validator.check_schema(schema)
    validator = Draft202012Validator(schema)
    files = [file for folder in folders for file in pathlib.Path(folder).rglob("*.json")
             if file.name != "CMakePresets.json"]
    expect(len(files) > 15, "scenes were found")
    scenes = {file.name: json.loads(file.read_text()) for file in files}
    scenes["every key"] = EVERY_KEY
    for name, scene in scenes.items():
        error = jsonschema.exceptions.best_match(validator.iter_errors(scene))
        expect(error is None, f"{name} is valid: {error and error.message}")
        expect(*solves(command, scene)) if name == "every key" else None
        for path in objects_with_keys(scene):
            wrong = copy.deepcopy(scene)
            part = wrong
            for key in path:
                part = part[key]
            part["unheard_of"] = 1
            expect(not validator.is_valid(wrong), f"{name}: {path} has an unknown key")
            if name == "every key":
                accepted, message = solves(command, wrong)
                expect(not accepted and "unknown key 'unheard_of'" in message, f"{path}: {message}")
    used = {key for path in objects_with_keys(EVERY_KEY) for key in part_at(EVERY_KEY, path)}
    expect(keys_of(schema) == used, f"the schema knows the keys {keys_of(schema) ^ used}")
    for key in schema["required"]:
        missing = {name: part for name, part in EVERY_KEY.items() if name != key}
        expect(not validator.is_valid(missing) and not solves(command, missing)[0], f"no {key}")
    print(f"{len(scenes)} scenes, {len(used)} keys, {failures} failures")
    return 1 if failures else 0


def part_at(scene, path):
    for key in path:
        scene = scene[key]
    return scene


sys.exit(main(*sys.argv[1:]))
