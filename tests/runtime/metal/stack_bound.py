"""Bound on the stack of a program for a Cortex-M: frame sizes from the compiler
(-fcallgraph-info=su) and, for libraries, from their instructions; calls from the program's
instructions.

A call through a pointer may reach every function of which the program, linked with its relocations
(-Wl,-q), takes the address. Root isolation calls itself at most as deep as `max_depth` of
trigonometric_roots.hpp says; a program with any other circle of calls is refused."""

import re
import subprocess
import sys

sys.setrecursionlimit(10000)
recursive = re.compile(r"TrigonometricRootSearch.*(isolate|cut)")


def frames_of_compiler(files):
    """Bytes by mangled name."""
    frames = {}
    for file in files:
        nodes = re.findall(r'node: \{ title: "([^"]*)" label: "([^"]*)"', file.read_text())
        for title, label in nodes:
            size = re.search(r"(\d+) bytes \((\w+)", label)
            if size:
                if size[2] != "static":
                    raise SystemExit(f"stack: the frame of {title} is {size[2]}")
                frames[title.split(":")[-1]] = int(size[1])
    return frames


def bytes_taken(instruction, operands):
    """The bytes that an instruction takes from the stack."""
    if instruction in ("push", "stmdb", "vpush", "vstmdb") and (
            "push" in instruction or operands.startswith("sp!")):
        registers = 0
        for part in operands[operands.index("{") + 1:operands.index("}")].split(","):
            ends = [int(re.sub(r"\D", "", end) or 0) for end in part.strip().split("-")]
            registers += ends[-1] - ends[0] + 1
        return registers * (8 if "{d" in operands else 4)
    taken = re.match(r"sp(?:, sp)?, #(\d+)", operands)
    return int(taken[1]) if instruction in ("sub", "sub.w", "subw") and taken else 0


def output_of(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def pointed_at(elf, prefix):
    """The functions whose address is taken, but for what the table of exceptions names."""
    names = set(re.findall(r"R_ARM_(?:ABS32|MOVW\w*|MOVT\w*)\s+\w+\s+(\S+)",
                           output_of(prefix + "readelf", "-rW", elf)))
    functions = {line.split()[-1] for line in output_of(prefix + "nm", elf).splitlines()
                 if line.split()[-2] in "tTwW"}
    return names & functions - {"reset", "fault"}


def functions_of(elf, prefix):
    """For each function by its mangled name: the bytes that its instructions take, its calls."""
    text = output_of(prefix + "objdump", "-d", "--no-show-raw-insn", elf)
    pointed = pointed_at(elf, prefix)
    functions = {}
    name = None
    for line in text.splitlines():
        if begin := re.match(r"[0-9a-f]+ <(.+)>:$", line):
            name = begin[1]
            functions[name] = [0, set()]
        elif name and (found := re.match(r"\s+[0-9a-f]+:\s+(\S+)\s*(.*)", line)):
            instruction, operands = found[1], found[2]
            functions[name][0] += bytes_taken(instruction, operands)
            target = re.search(r"<([^>+]+)(\+0x[0-9a-f]+)?>", operands)
            if re.match(r"(bl?|b[a-z]{2})(\.[nw])?$|blx$|cbn?z$", instruction) and target:
                if target[1] != name:
                    functions[name][1].add(target[1])
                elif instruction in ("bl", "blx") and not target[2]:
                    functions[name][1].add(name)
            elif instruction in ("blx", "bx") and operands.split()[0] != "lr":
                functions[name][1] |= pointed
    return functions


def circles(functions):
    """The strongly connected parts, callees first (Tarjan)."""
    order, low, stack, parts = {}, {}, [], []

    def visit(name):
        order[name] = low[name] = len(order)
        stack.append(name)
        for callee in functions.get(name, (0, ()))[1]:
            if callee not in order:
                visit(callee)
                low[name] = min(low[name], low[callee])
            elif callee in stack:
                low[name] = min(low[name], order[callee])
        if low[name] == order[name]:
            part = []
            while not part or part[-1] != name:
                part.append(stack.pop())
            parts.append(part)

    for name in functions:
        if name not in order:
            visit(name)
    return parts


def stack_bound(elf, callgraphs, max_depth, root="main", prefix="arm-none-eabi-"):
    compiled = frames_of_compiler(callgraphs)
    functions = functions_of(elf, prefix)
    deepest = {}
    for part in circles(functions):
        frames = sum(compiled.get(name, functions.get(name, (0,))[0]) for name in part)
        if len(part) > 1 or part[0] in functions.get(part[0], (0, ()))[1]:
            if not all(recursive.search(name) for name in part):
                raise SystemExit(f"stack: a circle of calls without a bound: {part}")
            frames *= max_depth + 1
        below = max((deepest.get(callee, 0) for name in part
                     for callee in functions.get(name, (0, ()))[1] if callee not in part),
                    default=0)
        for name in part:
            deepest[name] = frames + below
    return deepest[root]
