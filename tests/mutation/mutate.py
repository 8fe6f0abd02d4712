#!/usr/bin/env python3
"""Turns sources and the tests that hold them into a list of mutants and of those that survive.

mutate.py BUILD SUBJECT [--count N] [--seed S] [--output FILE]

A mutant is one operator, comparison, sign or constant changed in one place. SUBJECT is `derivation`
or `runtime`. Each mutant is compiled in BUILD, whose sources are changed and put back, so that it
should be a clone of its own; what does not compile, or compiles to nothing new, is not counted.
Then its killers run, one after the other, until one of them fails: that kills it. Whoever
interrupts this has one changed line left, which git tells.
"""
import argparse
import pathlib
import random
import re
import subprocess
import sys
import time

SOURCE = pathlib.Path(__file__).resolve().parents[2]

# The formatter sets binary operators between blanks, and the brackets of templates without.
CHANGES = [
    (r" \+ ", " - "), (r" - ", " + "), (r" \* ", " / "), (r" / ", " * "),
    (r" \+= ", " -= "), (r" -= ", " += "),
    (r" < ", " <= "), (r" <= ", " < "), (r" > ", " >= "), (r" >= ", " > "),
    (r" < ", " > "), (r" > ", " < "), (r" == ", " != "), (r" != ", " == "),
    (r" && ", " || "), (r" \|\| ", " && "), (r"(?<=[(=,] )-(?=[a-z])", ""), (r"(?<=return )-", ""),
    (r"(?<=\()!(?=[a-z])", ""), (r"(?<=[ (])0(?=[;,)])", "1"), (r"(?<=[ (])1(?=[;,)])", "2"),
    (r"\btrue\b", "false"), (r"\bfalse\b", "true"),
    (r"\.cos\b", ".sin"), (r"\.sin\b", ".cos"), (r"std::min\b", "std::max"),
    (r"std::max\b", "std::min"),
]

# What is mutated, what is built, and the commands that kill, the quick ones first.
SUBJECTS = {
    "derivation": (
        ["generator/equations/*.cpp", "generator/derivatives/*.cpp", "generator/elimination/*.cpp",
         "generator/pivoting/*.cpp", "generator/special_points/*.cpp", "generator/structure/*.cpp"],
        ["assur"],
        [["{build}/assur", "emit", "--all", "--output", "{source}/generated", "--check"],
         ["{build}/assur", "catalogue", "--format", "json"]]),
    "runtime": (
        ["runtime/include/assur/*.hpp", "runtime/include/assur/detail/*.hpp",
         "runtime/include/assur/numeric/*.hpp"],
        ["configurations_test", "verdicts_test", "trigonometric_roots_test", "status_tests",
         "body_motion_tests"],
        [["{build}/tests/runtime/" + name, "--gtest_brief=1"]
         for name in ("trigonometric_roots_test", "configurations_test", "verdicts_test",
                      "status_tests", "body_motion_tests")]),
}


def code_of(line):
    """The part of a line that is code: without its comment; nothing for directives and strings."""
    stripped = line.strip()
    if stripped.startswith(("//", "#", "/*", "*", "template", "static_assert")) or '"' in line:
        return ""
    return line.split("//")[0]


def sites_of(patterns):
    sites = []
    for pattern in patterns:
        for path in sorted(SOURCE.glob(pattern)):
            for number, line in enumerate(path.read_text().split("\n")):
                code = code_of(line)
                for what, by in CHANGES:
                    for found in re.finditer(what, code):
                        sites.append((path, number, found.span(), by))
    return sites


def run(command, seconds):
    try:
        return subprocess.run(command, capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return None


def verdict_of(build, targets, killers):
    """How a mutant fares: `stillborn`, or what killed it, or `survives`."""
    made = run(["cmake", "--build", str(build), "--target", *targets], 900)
    if made is None or made.returncode != 0:
        return "stillborn"
    for killer in killers:
        words = [word.format(build=build, source=SOURCE) for word in killer]
        result = run(words, 300)
        if result is None:
            return "killed: takes too long: " + pathlib.Path(words[0]).name
        if result.returncode != 0:
            return "killed: " + " ".join([pathlib.Path(words[0]).name, *words[1:2]])
    return "survives"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("subject", choices=SUBJECTS)
    parser.add_argument("--count", type=int, default=150)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--output", type=pathlib.Path)
    options = parser.parse_args()
    patterns, targets, killers = SUBJECTS[options.subject]
    build = options.build.resolve()
    if verdict_of(build, targets, killers) != "survives":
        sys.exit("the sources as they are do not build and pass; nothing was mutated")
    sites = sites_of(patterns)
    random.Random(options.seed).shuffle(sites)
    counts = {"killed": 0, "survives": 0, "stillborn": 0}
    began = time.monotonic()
    lines = []
    for path, number, (begin, end), by in sites:
        if counts["killed"] + counts["survives"] == options.count:
            break
        text = path.read_text()
        mutated = text.split("\n")
        line = mutated[number]
        mutated[number] = line[:begin] + by + line[end:]
        try:
            path.write_text("\n".join(mutated))
            verdict = verdict_of(build, targets, killers)
        finally:
            path.write_text(text)
        counts[verdict.split(":")[0]] += 1
        place = f"{path.relative_to(SOURCE)}:{number + 1}"
        lines.append(f"{verdict}\t{place}\t{line.strip()}\t{mutated[number].strip()}")
        print(lines[-1], flush=True)
    minutes = (time.monotonic() - began) / 60
    lines.append(f"# {options.subject}, seed {options.seed}, {len(sites)} places: "
                 f"{counts['killed']} killed, {counts['survives']} survive, "
                 f"{counts['stillborn']} do not compile; {minutes:.0f} minutes")
    print(lines[-1])
    if options.output:
        options.output.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
