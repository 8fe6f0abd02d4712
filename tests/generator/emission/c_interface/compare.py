"""Compares the results of solvers' C interfaces in C, Python's ctypes and Fortran with `assur
solve`: every number of every configuration.

compare.py ASSUR COMPILER WORK EXAMPLES FLAGS"""

import json
import math
import pathlib
import shlex
import shutil
import sys

import c_header
import languages

assur, compiler, work, examples = sys.argv[1:5]
flags = shlex.split(sys.argv[5])
work, examples = pathlib.Path(work), pathlib.Path(examples)
# Relative to the largest number of its sort in the configuration.
agreement = 1e-12

# A scene, the options of its solver, and the values of parameters that these leave variable.
tasks = [("four_bar_coupler_curve", [], {}),
         ("jansen_leg", [], {}),
         ("excavator_arm", [], {}),
         ("gripper", [], {}),
         ("four_bar_coupler_curve", ["--variable", "all"], {"coupler": 99.5, "rocker": 101.25}),
         ("four_bar_coupler_curve", ["--want", "position"], {})]
steps = [0, 0.0625, -0.03125]


def solved(scene, step, settings, *options):
    """What `assur solve` says where the drivers stand a step further."""
    described = json.loads((examples / f"{scene}.json").read_text())
    for driver in described["drivers"].values():
        driver["position"] = f"({driver['position']}) + {step}"
    moved = work / "moved.json"
    moved.write_text(json.dumps(described))
    sets = [word for name, value in settings.items() for word in ("--set", f"{name}={value}")]
    return json.loads(
        languages.run([assur, "solve", moved, "--format", "json", *sets, *options]))


def expected_numbers(header, scene, step, settings):
    """The numbers of a state that `assur solve` gives, in the header's order, and their sorts."""
    columns = sorted((place, name) for name, place in header.constants.items()
                     if name.startswith(header.prefix + "_column_"))
    parameters = [name.removeprefix(header.prefix + "_column_") for _, name in columns]
    configurations = []
    for state in solved(scene, step, settings)["configurations"]:
        numbers = []
        for leaf in header.leaves("state"):
            sort, name, field = leaf.split(".")
            field, *places = field.replace("]", "").split("[")
            places = [int(place) for place in places]
            part = state["joints" if sort == "slides" else sort][name]
            if sort == "links" and field == "position":
                value = part["xy"[places[0]]]
            elif field == "direction":
                value = [math.cos, math.sin][places[0]](part["theta"])
            elif field == "sensitivity":
                value = part[field][parameters[places[1]]][places[0]]
                field += "_" + parameters[places[1]]
            else:
                value = part[field][places[0]] if places else part[field]
            numbers.append((leaf, sort + field, value))
        configurations.append(numbers)
    return configurations


def compare(header, scene, settings, printed):
    """The largest relative difference, and how many numbers were compared."""
    printed = iter(printed)
    largest, count = 0, 0
    for step in steps:
        configurations = expected_numbers(header, scene, step, settings)
        listed = int(next(printed))
        if listed != len(configurations) or listed == 0:
            raise SystemExit(f"{scene} at {step}: {listed} and not {len(configurations)}")
        for numbers in configurations:
            sizes = {}
            for _, sort, value in numbers:
                sizes[sort] = max(sizes.get(sort, 0), abs(value))
            for leaf, sort, value in numbers:
                error = abs(float(next(printed)) - value) / (sizes[sort] or 1)
                if not error <= agreement:
                    raise SystemExit(f"{scene} at {step}: {leaf} differs by {error}")
                largest, count = max(largest, error), count + 1
    if next(printed, None) is not None:
        raise SystemExit(f"{scene}: more was printed")
    return largest, count


def compare_nearest(header, scene, settings, here):
    for step in steps:
        expected = solved(scene, step, settings, "--nearest")["nearest"].values()
        for one, other in zip(languages.nearest_by_ctypes(header, step, settings, here), expected,
                              strict=True):
            if not abs(one - other) <= agreement * max(1, abs(other)):
                raise SystemExit(f"{scene} at {step}: nearest gives {one} and not {other}")
    print(f"{scene}: the nearest configuration agrees at {len(steps)} positions")


shutil.rmtree(work, ignore_errors=True)
for number, (scene, options, settings) in enumerate(tasks):
    here = work / str(number)
    here.mkdir(parents=True)
    languages.run([assur, "emit", "--scene", examples / f"{scene}.json", "--output", here,
                   "--interface", "c", *options])
    implementation = here / "assur" / "scenes" / f"{scene}.cpp"
    header = c_header.read_header(implementation.with_suffix(".h"))
    warnings = ["-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror"]
    # One object for all languages: it holds the solver, with C names.
    languages.run([compiler, "-std=c++17", "-O1", "-fPIC", "-fno-exceptions", *warnings, *flags,
                   "-c", implementation, "-o", here / "solver.o"])
    languages.run(["gcc", "-shared", here / "solver.o", "-lm", "-o", here / "solver.so"])
    same_branch = pathlib.Path(__file__).with_name("same_branch.cpp")
    struct = "".join(word.capitalize() for word in scene.split("_"))
    languages.run([compiler, "-std=c++17", "-O1", *warnings, *flags, f"-I{here}",
                   f"-DASSUR_PREFIX={header.prefix}_", f"-DASSUR_SOLVER={struct}",
                   f"-DASSUR_HAS_PARAMETERS={int(header.has('parameters'))}",
                   f'-DASSUR_C_HEADER="{scene}.h"', f'-DASSUR_CPP_HEADER="{scene}.hpp"',
                   f"-I{implementation.parent}", same_branch, here / "solver.o",
                   "-o", here / "same_branch"])
    print(scene, *options, languages.run([here / "same_branch"]).strip())
    in_c = languages.by_c(header, implementation, steps, settings, here)
    ways = {"C": in_c,
            "ctypes": languages.by_ctypes(header, steps, settings, here)}
    if header.has("distance"):
        compare_nearest(header, scene, settings, here)
    if shutil.which("gfortran"):
        ways["Fortran"] = languages.by_fortran(header, implementation, steps, settings, here)
    else:
        print("gfortran is not installed: no comparison with Fortran")
    for language, printed in ways.items():
        largest, count = compare(header, scene, settings, printed)
        if [float(one) for one in printed] != [float(one) for one in in_c]:
            raise SystemExit(f"{scene}: C and {language} differ")
        print(f"{' '.join([scene, *options])}, {language}: largest relative difference "
              f"{largest:.1e} over {count} numbers")
