"""Law: a drawn scene has the answer of the scene whose numbers are computed from the drawing.

Positions, rates, the numbers of configurations and the drawn one are compared; derivatives with
respect to parameters are compared with differences of drawings at other values; the order of
points, links, joints and parameters changes nothing.
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

from numbers_of_drawing import Drawing
from random_drawings import RandomDrawing, shuffled

SEEDS = range(1, 401 if os.environ.get("ASSUR_WHOLE_CAMPAIGN") else 31)
STEP = 1e-5  # of a parameter, for central differences
POSITIONS = 1e-9  # of the size of the scene; rounding, where configurations are regular
RATES = 1e-7
DIFFERENCES = 1e-5

failures = 0
largest = {}


def expect(holds, message):
    global failures
    if not holds:
        failures += 1
        print("FAILED:", message)


class Solver:
    def __init__(self, command, directory):
        self.command, self.file = command, pathlib.Path(directory, "scene.json")

    def __call__(self, scene, *options):
        self.file.write_text(json.dumps(scene))
        run = subprocess.run([self.command, "solve", str(self.file), "--format", "json", *options],
                             capture_output=True, text=True)
        return json.loads(run.stdout) if run.stdout else run.stderr.replace(str(self.file), "")

    def rows(self, scene, *options):
        self.file.write_text(json.dumps(scene))
        run = subprocess.run([self.command, "solve", str(self.file), "--format", "csv", *options],
                             capture_output=True, text=True)
        return [line.split(",") for line in run.stdout.splitlines()]


def numbers_of(value, kind="position", path=""):
    """All numbers of an answer, with their kind: derivatives grow near singular positions."""
    if isinstance(value, dict):
        for key, part in sorted(value.items()):
            if key not in ("sensitivity", "worst_case", "rss", "residual", "tangential", "normal"):
                own = key if key in ("velocity", "acceleration", "theta") else kind
                yield from numbers_of(part, own, f"{path}.{key}")
    elif isinstance(value, list):
        for index, part in enumerate(value):
            yield from numbers_of(part, kind, f"{path}[{index}]")
    elif isinstance(value, (int, float)):
        yield kind, value, path
    elif value is None:
        yield kind, None, path


def compare(name, one, other):
    """Compares configurations number by number."""
    if one["regularity"] != "regular" or other["regularity"] != "regular":
        return
    mine, theirs = (list(numbers_of({key: found[key] for key in ("links", "joints", "outputs")}))
                    for found in (one, other))
    expect([path for _, _, path in mine] == [path for _, _, path in theirs], f"{name}: same parts")
    scale = {}
    for kind, value, _ in theirs:
        scale[kind] = max(scale.get(kind, 1), abs(value or 0))
    for (kind, a, path), (_, b, _) in zip(mine, theirs):
        if a is None or b is None:
            continue
        difference = abs(a - b) / scale[kind]
        if kind == "theta":
            difference = min(difference, abs(abs(a - b) - 6.283185307179586))
        within = RATES if kind in ("velocity", "acceleration") else POSITIONS
        largest[kind] = max(largest.get(kind, 0), difference)
        expect(difference <= within, f"{name}{path}: {a} and {b}")


def compare_answers(name, drawn, told):
    if isinstance(drawn, str) or isinstance(told, str):
        expect(isinstance(drawn, str) and isinstance(told, str) and
               drawn.split("; the link")[0].strip() == told.split("; the link")[0].strip(),
               f"{name}: {drawn} / {told}")
        return False
    expect(drawn["status"] == told["status"], f"{name}: {drawn['status']}, not {told['status']}")
    mine, theirs = drawn["configurations"], told["configurations"]
    expect(len(mine) == len(theirs), f"{name}: {len(mine)} configurations, not {len(theirs)}")
    for number, (one, other) in enumerate(zip(mine, theirs), 1):
        compare(f"{name}, configuration {number}", one, other)
    near = told.get("nearest")
    if near and mine:
        own = drawn["drawn"]
        tied = near["runner_up"] is not None and near["runner_up"] - near["distance"] < 1e-6
        expect(tied or own["configuration"] == near["configuration"], f"{name}: drawn {own} {near}")
        expect(abs(own["distance"] - near["distance"]) < 1e-7, f"{name}: drawn {own} {near}")
    return bool(mine)


def compare_derivatives(name, scene, answer, solve):
    """The derivatives by one parameter, against drawings at other values."""
    parameters = [name for name, entry in scene.get("parameters", {}).items()
                  if not (isinstance(entry, dict) and isinstance(entry.get("drawn"), str))]
    for parameter in parameters[:2]:
        compare_derivative(name, scene, answer, solve, parameter)


def compare_derivative(name, scene, answer, solve, parameter):
    sides = {}
    drawing = Drawing(scene, sides=sides)
    drawing.translated()
    value = drawing.parameter(parameter)
    beside = [solve(Drawing(scene, {parameter: value + step}, sides).translated())
              for step in (-STEP, STEP)]
    counts = {len(found["configurations"]) for found in (*beside, answer)
              if not isinstance(found, str)}
    if any(isinstance(found, str) for found in beside) or len(counts) != 1:
        return
    for number, configuration in enumerate(answer["configurations"]):
        if configuration["regularity"] != "regular":
            continue
        for output, point in configuration["outputs"].items():
            low, high = (found["configurations"][number]["outputs"][output]["position"]
                         for found in beside)
            for axis in (0, 1):
                own = point["sensitivity"][parameter][axis]
                slope = (high[axis] - low[axis]) / (2 * STEP)
                if own is None or abs(slope) > 50:  # beside a dead centre differences are poor
                    continue
                difference = abs(own - slope) / max(1, abs(slope)) ** 3
                largest["derivative"] = max(largest.get("derivative", 0), difference)
                expect(difference < DIFFERENCES,
                       f"{name}, configuration {number + 1}: d{output}/d{parameter} = {own}, "
                       f"differences {slope}")


def compare_sweep(name, scene, answer, solve):
    """In a sweep about the drawing, --nearest follows the branch through the drawn configuration,
    which is at its step in the middle."""
    phi = next((driver["position"] for driver in scene["drivers"].values()
                if driver.get("position") in scene.get("parameters", {})), None)
    drawn = answer["drawn"]
    # Close to another configuration, which is nearest depends on rounding.
    if phi is None or drawn["runner_up"] and drawn["runner_up"] - drawn["distance"] < 1e-3:
        return
    # At a dead centre two branches begin where the drawing stands.
    if answer["configurations"][drawn["configuration"] - 1]["regularity"] != "regular":
        return
    count = 9
    swept = {**scene, "want": ["position"], "sweep": {
        "parameter": phi, "from": f"{phi} - 0.4", "to": f"{phi} + 0.4", "count": count}}
    rows = solve.rows(swept, "--nearest")
    step, configuration = rows[0].index("step"), rows[0].index("configuration")
    middle = [row for row in rows[1:] if row[step] == str(count // 2)]
    expect([row[configuration] for row in middle] == [str(drawn["configuration"])],
           f"{name}: the drawn branch is {middle}, and the drawn configuration {drawn}")
    expect(len({row[rows[0].index("branch")] for row in rows[1:]}) == 1, f"{name}: one branch")


def main(command, *scenes):
    solved = 0
    with tempfile.TemporaryDirectory() as directory:
        solve = Solver(command, directory)
        named = {pathlib.Path(file).stem: json.loads(pathlib.Path(file).read_text())
                 for file in scenes}
        named.update({f"seed {seed}": RandomDrawing(seed).scene() for seed in SEEDS})
        for name, scene in named.items():
            told = solve(Drawing(scene).translated(), "--nearest")
            if not isinstance(told, str):  # all configurations, and the nearest one
                told["configurations"] = solve(Drawing(scene).translated())["configurations"]
            drawn = solve(scene)
            if compare_answers(name, drawn, told):
                solved += 1
                compare_derivatives(name, scene, drawn, solve)
                compare_sweep(name, scene, drawn, solve)
            compare_answers(name + ", shuffled", solve(shuffled(scene, name)), told)
    print(f"{len(named)} drawn scenes, {solved} with configurations; largest differences",
          {kind: f"{value:.1e}" for kind, value in largest.items()}, f"{failures} failures")
    expect(solved >= len(named) / 2, "enough scenes can be assembled")
    return 1 if failures else 0


sys.exit(main(*sys.argv[1:]))
