#!/usr/bin/env python3
"""Turns sources and the tests that hold them into a list of mutants and of those that survive.

mutate.py BUILD SUBJECT [--count N] [--seed S] [--harmless FILE] [--output FILE]

A mutant is one operator, comparison, sign or constant changed in one place. SUBJECT is `derivation`
or `runtime`. Each mutant is compiled in BUILD, whose sources are changed and put back, so that it
should be a clone of its own; what does not compile, or changes no program, is not counted. Its
killers run, one after the other, until one of them fails: that kills it. The exit status is 1 if
one survives that FILE does not list with the reason why it is harmless, a line each:
`PATH | LINE AS IT IS | LINE AS IT WAS MUTATED | REASON`. Whoever interrupts this has one changed
line left, which git tells.
"""
import argparse
import hashlib
import pathlib
import random
import re
import resource
import signal
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

# What is mutated, and what kills: programs with the arguments that they are run with, the quick ones
# first, for each is built only where those before it have not killed.
SUBJECTS = {
    "derivation": (
        ["generator/equations/*.cpp", "generator/derivatives/*.cpp", "generator/elimination/*.cpp",
         "generator/pivoting/*.cpp", "generator/special_points/*.cpp", "generator/structure/*.cpp"],
        [("assur", "assur", [["emit", "--all", "--output", "{source}/generated", "--check"],
                             ["catalogue", "--format", "json"]]),
         ("derive_test", "tests/generator/derive_test", [["--gtest_brief=1"]]),
         ("generator_tests", "tests/generator/generator_tests",
          [["--gtest_brief=1", "--gtest_filter=*Catalogue*:AllModels/AuditOfModel*"]])]),
    "runtime": (
        ["runtime/include/assur/*.hpp", "runtime/include/assur/detail/*.hpp",
         "runtime/include/assur/numeric/*.hpp"],
        [(name, "tests/runtime/" + name, [["--gtest_brief=1"]])
         for name in ("trigonometric_roots_test", "special_points_test", "status_tests",
                      "body_motion_tests", "closed_search_test", "matrix4_test",
                      "invariance_test", "configurations_test", "verdicts_test",
                      "float_groups_test")]),
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
    """What a command that may use some seconds of a processor did; none if it took too long. The
    clock would count what other programs take, too; it ends what waits."""
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
    try:
        result = subprocess.run(command, capture_output=True, text=True, preexec_fn=limit,
                                timeout=10 * seconds)
    except subprocess.TimeoutExpired:
        return None
    return None if result.returncode in (-signal.SIGXCPU, -signal.SIGKILL) else result


def verdict_of(build, killers, originals=None):
    """How a mutant fares: `stillborn`, `same` where no program changes, or what killed it, or
    `survives`. Without the originals' contents programs are run in any case, and remembered."""
    changed = originals is None
    contents = {}
    for target, path, calls in killers:
        made = run(["cmake", "--build", str(build), "--target", target], 900)
        if made is None or made.returncode != 0:
            return "stillborn", contents
        contents[target] = hashlib.sha256((build / path).read_bytes()).digest()
        if originals is not None and contents[target] == originals[target]:
            continue
        changed = True
        for call in calls:
            words = [str(build / path)] + [word.format(source=SOURCE) for word in call]
            result = run(words, 120)
            if result is None:
                return "killed: takes too long: " + target, contents
            if result.returncode != 0:
                return "killed: " + " ".join([target, *call[:1]]), contents
    return ("survives" if changed else "same"), contents


def harmless_of(file):
    """What is known to survive, as (path, line, mutated line)."""
    entries = set()
    for entry in file.read_text().splitlines() if file else []:
        if entry and not entry.startswith("#"):
            path, line, mutated, _ = entry.split(" | ", 3)
            entries.add((path, line, mutated))
    return entries


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("subject", choices=SUBJECTS)
    parser.add_argument("--count", type=int, default=150)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--harmless", type=pathlib.Path)
    parser.add_argument("--output", type=pathlib.Path)
    options = parser.parse_args()
    patterns, killers = SUBJECTS[options.subject]
    build = options.build.resolve()
    verdict, originals = verdict_of(build, killers)
    if verdict != "survives":
        sys.exit("the sources as they are do not build and pass; nothing was mutated")
    harmless = harmless_of(options.harmless)
    sites = sites_of(patterns)
    random.Random(options.seed).shuffle(sites)
    counts = {"killed": 0, "survives": 0, "harmless": 0, "stillborn": 0, "same": 0}
    began = time.monotonic()
    lines = []
    for path, number, (begin, end), by in sites:
        if counts["killed"] + counts["survives"] + counts["harmless"] == options.count:
            break
        text = path.read_text()
        mutated = text.split("\n")
        line = mutated[number]
        mutated[number] = line[:begin] + by + line[end:]
        try:
            path.write_text("\n".join(mutated))
            verdict, _ = verdict_of(build, killers, originals)
        finally:
            path.write_text(text)
        own = str(path.relative_to(SOURCE))
        if verdict == "survives" and (own, line.strip(), mutated[number].strip()) in harmless:
            verdict = "harmless"
        counts[verdict.split(":")[0]] += 1
        place = f"{own}:{number + 1}"
        lines.append(f"{verdict}\t{place}\t{line.strip()}\t{mutated[number].strip()}")
        print(lines[-1], flush=True)
    minutes = (time.monotonic() - began) / 60
    lines.append(f"# {options.subject}, seed {options.seed}, {len(sites)} places: "
                 f"{counts['killed']} killed, {counts['harmless']} harmless, "
                 f"{counts['survives']} survive, {counts['stillborn']} do not compile, "
                 f"{counts['same']} change no program; "
                 f"{minutes:.0f} minutes")
    print(lines[-1])
    if options.output:
        options.output.write_text("\n".join(lines) + "\n")
    return 1 if counts["survives"] else 0


if __name__ == "__main__":
    sys.exit(main())
