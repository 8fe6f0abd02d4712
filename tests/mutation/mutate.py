#!/usr/bin/env python3
"""Mutation testing: runs the tests of given sources on every mutant, and lists the survivors.

mutate.py BUILD SUBJECT [--count N] [--seed S] [--jobs J] [--harmless FILE] [--output FILE]

A mutant is one operator, comparison, sign, constant or component changed in one place. SUBJECT is
`derivation` or `runtime`. All mutants are compiled at once: each stands beside the expression that
it changes, behind a switch that an environment variable turns on, so that the tests are built once
for all of them. The sources of BUILD are changed and put back, so it should belong to a clone of
its own. Each mutant runs the tests that reach it, the quick ones first, until one of them fails:
that kills it. What does not compile, or no test reaches, is listed and not counted. The exit status
is 1 if a mutant survives that FILE does not list with the reason why it is harmless, one per line:
`PATH | LINE AS IT IS | LINE AS IT WAS MUTATED | REASON`. It needs Debian's python3-clang.
"""
import argparse
import collections
import concurrent.futures
import dataclasses
import os
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile
import time

from mutants import SOURCE, SWITCH, chosen, mutants_of, without_errors, write, write_headers

# What is mutated, and what kills: programs with the arguments that they are run with.
SUBJECTS = {
    "derivation": (
        ["generator/equations/*.cpp", "generator/derivatives/*.cpp", "generator/elimination/*.cpp",
         "generator/pivoting/*.cpp", "generator/special_points/*.cpp", "generator/structure/*.cpp"],
        [("assur", "assur", ["emit", "--all", "--output", "{source}/generated", "--check"]),
         ("assur", "assur", ["catalogue", "--format", "json"]),
         ("derive_test", "tests/generator/derive_test", ["--gtest_brief=1"]),
         ("generator_tests", "tests/generator/generator_tests",
          ["--gtest_brief=1", "--gtest_filter=*Catalogue*:AllModels/AuditOfModel*:*Undetermined*:"
           "OwnModel.ARootThatTwoFunctionsShareNamesBoth"])]),
    "runtime": (
        ["runtime/include/assur/*.hpp", "runtime/include/assur/detail/*.hpp",
         "runtime/include/assur/detail/batch/*.hpp", "runtime/include/assur/numeric/*.hpp"],
        [(name, "tests/runtime/" + name, ["--gtest_brief=1"])
         for name in ("trigonometric_roots_test", "special_points_test", "status_tests",
                      "body_motion_tests", "closed_search_test", "search_parts_test",
                      "matrix4_test", "magnitude_test", "batch_test", "batch_kinematics_test",
                      "invariance_test", "configurations_test", "verdicts_test",
                      "float_groups_test", "stability_tests")]),
}


def run(command, seconds, mutant=None, reached=None):
    """The status of a command that may use `seconds` of processor time, or None if it takes more.
    Elapsed time would include other programs; a longer limit on it ends commands that wait."""
    environment = dict(os.environ)
    if mutant is not None:
        environment["ASSUR_MUTANT"] = str(mutant)
    if reached is not None:
        environment["ASSUR_REACHED"] = reached

    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
        resource.setrlimit(resource.RLIMIT_AS, (8 << 30, 8 << 30))
    try:
        status = subprocess.run(command, env=environment, preexec_fn=limit, timeout=20 * seconds,
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode
    except subprocess.TimeoutExpired:
        return None
    return None if status in (-signal.SIGXCPU, -signal.SIGKILL) else status


@dataclasses.dataclass
class Killer:
    """A call of a program, the mutants that it reaches, and its seconds without mutants."""
    name: str
    command: list
    reaches: set
    seconds: float


def measured(name, command):
    with tempfile.NamedTemporaryFile() as file:
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        status = run(command, 900, reached=file.name)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if status != 0:
            sys.exit(f"without a mutant {name} has the status {status}; nothing was judged")
        reaches = {int(line) for line in pathlib.Path(file.name).read_text().split()}
    return Killer(name, command, reaches, after.ru_utime - before.ru_utime)


def verdict_of(number, killers):
    """How a mutant fares: what killed it, `survives`, or `unreached`."""
    reaching = [killer for killer in killers if number in killer.reaches]
    for killer in reaching:
        status = run(killer.command, int(5 * killer.seconds) + 20, mutant=number)
        if status is None:
            return f"killed: {killer.name} takes too long"
        if status != 0:
            return f"killed: {killer.name}"
    return "survives" if reaching else "unreached"


def harmless_of(file):
    """What is known to survive, as (path, line, mutated line)."""
    entries = set()
    for entry in file.read_text().splitlines() if file else []:
        if entry and not entry.startswith("#"):
            path, line, mutated, _ = entry.split(" | ", 3)
            entries.add((path, line, mutated))
    return entries


def judge(options, build, patterns, calls):
    began = time.monotonic()
    all_mutants = mutants_of(patterns, build)
    originals = {mutant.path: mutant.path.read_bytes() for mutant in all_mutants}
    # Twice as many, since some do not compile and others are reached by no test.
    mutants = chosen(all_mutants, 2 * options.count, options.seed)
    switch = build / "mutant.hpp"
    switch.write_text(SWITCH % (len(mutants), len(mutants)))
    targets = sorted({target for target, _, _ in calls})
    lines = []
    counts = collections.Counter()
    try:
        planted_count = len(mutants)
        # Assertions kill mutants that read beyond an array.
        subprocess.run(["cmake", "-B", str(build), f"-DCMAKE_CXX_FLAGS=-include {switch}",
                        "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -D_GLIBCXX_ASSERTIONS"],
                       check=True, stdout=subprocess.DEVNULL, cwd=SOURCE)
        write_headers(build, targets)
        mutants = without_errors(mutants, originals, build, targets, options.jobs)
        subprocess.run(["cmake", "--build", str(build), "--target", *targets, "-j",
                        str(options.jobs)], check=True, stdout=subprocess.DEVNULL)
        write(originals)
        killers = [measured(target, [str(build / path)] +
                            [word.format(source=SOURCE) for word in words])
                   for target, path, words in calls]
        killers.sort(key=lambda killer: killer.seconds)
        print(f"# {planted_count} planted, {len(mutants)} compile; built and measured after "
              f"{(time.monotonic() - began) / 60:.0f} minutes", flush=True)
        harmless = harmless_of(options.harmless)
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            for number, verdict in zip(mutants, pool.map(lambda one: verdict_of(one, killers),
                                                         mutants)):
                mutant = mutants[number]
                path = str(mutant.path.relative_to(SOURCE))
                place, line, mutated = mutant.lines(originals[mutant.path])
                if verdict == "survives" and (path, line, mutated) in harmless:
                    verdict = "harmless"
                counts[verdict.split(":")[0]] += 1
                lines.append(f"{verdict}\t{path}:{place}\t{line}\t{mutated}")
                print(lines[-1], flush=True)
                if counts["killed"] + counts["survives"] + counts["harmless"] == options.count:
                    pool.shutdown(wait=False, cancel_futures=True)
                    break
    finally:
        write(originals)
    lines.append(f"# {options.subject}, seed {options.seed}, {len(all_mutants)} mutants in all: "
                 f"{counts['killed']} killed, {counts['harmless']} harmless, "
                 f"{counts['survives']} survive, {planted_count - len(mutants)} of "
                 f"{planted_count} do not compile, {counts['unreached']} are not reached; "
                 f"{(time.monotonic() - began) / 60:.0f} minutes")
    print(lines[-1])
    return lines, counts["survives"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("subject", choices=SUBJECTS)
    parser.add_argument("--count", type=int, default=150)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--harmless", type=pathlib.Path)
    parser.add_argument("--output", type=pathlib.Path)
    options = parser.parse_args()
    lines, survivors = judge(options, options.build.resolve(), *SUBJECTS[options.subject])
    if options.output:
        options.output.write_text("\n".join(lines) + "\n")
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
