# Law: docs/reference/command.md has a section for each subcommand of `assur --help`, whose table
# has all its own options and no others; options that all subcommands share are named above the
# sections.
import pathlib
import re
import subprocess
import sys


def printed(command, *arguments):
    command = [command, *arguments, "--help"]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def main(command, page):
    text = pathlib.Path(page).read_text()
    sections = dict(re.findall(r"^## ([^\n]+)\n(.*?)(?=^## |\Z)", text, re.M | re.S))
    listed = printed(command).partition("Subcommands:")[2]
    subcommands = re.findall(r"^  (\w+) ", listed, re.M)
    failures = []
    if set(sections) - {"Exit statuses"} != set(subcommands):
        failures.append(f"sections {sorted(sections)}, subcommands {sorted(subcommands)}")
    options_of = {
        name: set(re.findall(r"^ +(?:-h,)?(--[\w-]+)", printed(command, name), re.M)) - {"--help"}
        for name in subcommands}
    shared = set.intersection(*options_of.values())
    failures += [f"{option} is not told above the sections"
                 for option in shared if f"`{option}`" not in text.partition("\n## ")[0]]
    options = len(shared)
    for name in subcommands:
        known = options_of[name] - shared
        told = re.findall(r"^\| `(--[\w-]+)", sections.get(name, ""), re.M)
        options += len(known)
        if sorted(told) != sorted(known):
            failures.append(f"{name}: the page tells {sorted(told)}, the command {sorted(known)}")
        if f"[`{name}`](#{name})" not in text:
            failures.append(f"{name} is missing in the table of subcommands")
    print(*failures, f"{len(subcommands)} subcommands, {options} options", sep="\n")
    return 1 if failures or not options else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
