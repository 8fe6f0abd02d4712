"""Compares the answers for groups of a board under QEMU with those of the host: no configuration
may be lost or invented, no verdict may differ, and every number must be bitwise equal, unless
the board's arithmetic differs from the host's. Both compute cosines, arcs and powers by
plain_mathematics.cpp.

campaign.py GROUPS_PROGRAM COMPILER WORK COUNT FLAGS BOARD[_SCALAR]: `m4f`, `m4f_float`"""

import json
import pathlib
import shlex
import subprocess
import sys

import boards
from answers import compared

# The groups in the table of exact answers: 9 kinds with 174 seeds each (campaign_groups.cpp).
special = 9 * 174
plain = ["acos", "atan", "atan2", "cos", "hypot", "pow", "sin", "sincos"]

groups_program, compiler, work, count, flags, name = sys.argv[1:7]
work, count = pathlib.Path(work), int(count)
name, _, scalar = name.partition("_")
flags = [*shlex.split(flags), f"-DASSUR_SCALAR={scalar or 'double'}",
         *(f"-fno-builtin-{one}{end}" for one in plain for end in ("", "f"))]
board = boards.boards[name]
if board.missing():
    print(f"{board.name}: left out, for {' and '.join(board.missing())} are not installed")
    sys.exit(0)
work.mkdir(parents=True, exist_ok=True)
sources = [boards.here / "campaign.cpp", boards.here / "plain_mathematics.cpp"]
groups, elf = work / "groups.bin", work / "board.elf"
with open(groups, "wb") as out:
    subprocess.run([groups_program, str(count)], stdout=out, check=True)
boards.run([compiler, *boards.common, *flags, *sources, "-o", work / "host"])
with open(groups, "rb") as given, open(work / "host.bin", "wb") as out:
    subprocess.run([work / "host"], stdin=given, stdout=out, check=True)
board.build(sources, elf, flags)
with open(groups, "rb") as given:
    board.run(elf, work / "board.bin", given)
found = compared(work / "host.bin", work / "board.bin", count, special)
(work / "figures.json").write_text(json.dumps(found, indent=1) + "\n")
print(json.dumps(found["models"], indent=1))
alike = found["groups"] - found["unlike"] - found["other_verdicts"]
print(f"{board.name}, {scalar or 'double'}: {found['groups']} groups, "
      f"{found['configurations']} configurations: {found['lost']} lost, "
      f"{found['invented']} invented, {found['other_verdicts']} other verdicts; "
      f"{alike} groups bit for bit, {found['unlike']} to {found['largest']:.1e}")
same = found["unlike"] == 0 or 0 < found["largest"] <= board.off
kept = found["lost"] + found["invented"] + found["other_verdicts"] == 0
sys.exit(0 if same and kept else 1)
