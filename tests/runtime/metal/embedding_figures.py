"""Rewrites the tables of docs/guide/embedding.md: size, memory and instructions on a Cortex-M7
of every example and of the campaign's groups, by compiler, linker and QEMU.

embedding_figures.py ASSUR WORK FLAGS BOARD=FIGURES...: what the campaign wrote of each board"""

import array
import json
import pathlib
import re
import shlex
import sys

import boards
from stack_bound import stack_bound

assur, work, flags = sys.argv[1:4]
work, flags = pathlib.Path(work), shlex.split(flags)
work.mkdir(parents=True, exist_ok=True)
page = boards.project / "docs/guide/embedding.md"
board = boards.boards["m7"]
roots = (boards.project / "runtime/include/assur/numeric/trigonometric_roots.hpp").read_text()
max_depth = int(re.search(r"max_depth = (\d+)", roots)[1])
counts = [*flags, "-fcallgraph-info=su", "-Wl,-q"]


def sizes(elf):
    """Flash, and static memory without the stack."""
    of = {}
    for name, size in re.findall(r"^(\.\w+)\s+(\d+)", boards.run([board.tools + "size", "-A", elf]),
                                 re.M):
        of[name] = int(size)
    return of[".text"] + of.get(".exidx", 0) + of[".data"], of[".data"] + of[".bss"]


def built(name, source, defines):
    """The program in a folder of its own, where the compiler tells its frames."""
    folder = work / name
    folder.mkdir(exist_ok=True)
    elf = folder / f"{name}.elf"
    board.build([source], elf, [*counts, *defines])
    flash, memory = sizes(elf)
    return elf, {"flash": flash, "memory": memory,
                 "bound": stack_bound(elf, folder.glob("*.ci"), max_depth)}


def figures_of_example(scene):
    folder = work / "solvers"
    boards.run([assur, "emit", "--scene", scene, "--output", folder])
    header = f"assur/scenes/{scene.stem}.hpp"
    struct = "".join(word.capitalize() for word in scene.stem.split("_"))
    elf, figures = built(scene.stem, boards.here / "solver_campaign.cpp",
                         [f"-I{folder}", f"-DASSUR_HEADER=<{header}>", f"-DASSUR_SOLVER={struct}"])
    board.run(elf, work / "answer.bin")
    answer = array.array("d", (work / "answer.bin").read_bytes())
    words = ["places", "configurations", "followed", "solve", "solve_stack", "track", "track_stack"]
    figures.update(zip(words, map(int, answer), strict=True))
    figures["painted"] = max(figures["solve_stack"], figures["track_stack"])
    if figures["painted"] > figures["bound"]:
        raise SystemExit(f"{scene.stem}: {figures['painted']} bytes of stack were used, and the bound "
                         f"is {figures['bound']}")
    return figures


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "".join("| " + " | ".join(map(str, line)) + " |\n" for line in lines)


def table_of_examples(examples):
    keys = ["flash", "memory", "bound", "painted", "solve", "track", "configurations"]
    return table(["scene", "flash", "static RAM", "stack, at most", "stack, painted",
                  "instructions of `solve`", "of `track`", "configurations found"],
                 [[name, *(one[key] for key in keys)] for name, one in examples.items()])


def title(campaign):
    """`m4f_float`: a board, and the scalar where that is not double."""
    name, _, scalar = campaign.partition("_")
    return boards.boards[name].name + (f", {scalar}" if scalar else "")


def table_of_campaign(campaigns):
    keys = ["groups", "configurations", "lost", "invented", "other_verdicts"]
    return table(["processor", "groups", "configurations", "lost", "invented", "other verdicts",
                  "groups bit for bit"],
                 [[title(name), *(one[key] for key in keys),
                   one["groups"] - one["unlike"]] for name, one in campaigns.items()])


def table_of_groups(campaigns):
    head, rows = ["group"], []
    for name in campaigns:
        head += [f"{title(name)}: general", "special", "stack"]
    for model in next(iter(campaigns.values()), {"models": {}})["models"]:
        of_model = [one["models"][model] for one in campaigns.values()]
        rows.append([model, *(one[key] for one in of_model for key in ("general", "special",
                                                                       "stack"))])
    return table(head, rows)


def write_tables(tables):
    text = page.read_text()
    for mark, lines in tables.items():
        begin, end = f"<!-- {mark} -->\n", f"<!-- end of {mark} -->"
        before, rest = text.split(begin)
        text = before + begin + lines + end + rest.split(end)[1]
    page.write_text(text)


campaigns = {}
for given in sys.argv[4:]:
    board_name, file = given.split("=")
    if pathlib.Path(file).exists():
        campaigns[board_name] = json.loads(pathlib.Path(file).read_text())
    else:
        print(f"{board_name}: the campaign has not run, no {file}")
examples = {}
for scene in sorted((boards.project / "examples").glob("*.json")):
    examples[scene.stem] = figures_of_example(scene)
    print(scene.stem, examples[scene.stem], flush=True)
elf, group = built("tetrad", boards.here / "tetrad.cpp", [])
print("RRR-RRR", group)
write_tables({"campaign": table_of_campaign(campaigns), "groups": table_of_groups(campaigns),
              "examples": table_of_examples(examples),
              "group": table(["program", "flash", "static RAM", "stack, at most"],
                             [["RRR-RRR, all configurations and sensitivities", *group.values()]])})
