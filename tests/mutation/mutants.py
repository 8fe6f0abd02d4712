"""Mutants of C++ sources, all compiled into one program, each behind a switch."""
import collections
import concurrent.futures
import dataclasses
import json
import pathlib
import random
import re
import shlex
import subprocess
import sys

import clang.cindex
from clang.cindex import CursorKind

SOURCE = pathlib.Path(__file__).resolve().parents[2]

BINARY = {"+": ["-"], "-": ["+"], "*": ["/"], "/": ["*"], "+=": ["-="], "-=": ["+="],
          "<": ["<=", ">"], "<=": ["<"], ">": [">=", "<"], ">=": [">"], "==": ["!="],
          "!=": ["=="], "&&": ["||"], "||": ["&&"]}
LITERALS = {"0": "1", "1": "2", "true": "false", "false": "true"}
COMPONENTS = {".cos": ".sin", ".sin": ".cos"}
CALLS = {"std::min(": "std::max(", "std::max(": "std::min("}

SWITCH = """\
#pragma once
#include <cstdio>
#include <cstdlib>
namespace assur_mutant {
/// Which mutants a process has reached, written to the file that ASSUR_REACHED names.
struct Reached {
  bool flags[%d];
  ~Reached() {
    const char* name = std::getenv("ASSUR_REACHED");
    std::FILE* file = name == nullptr ? nullptr : std::fopen(name, "a");
    for (int mutant = 0; file != nullptr && mutant < %d; ++mutant) {
      if (flags[mutant]) {
        std::fprintf(file, "%%d\\n", mutant);
      }
    }
    if (file != nullptr) {
      std::fclose(file);
    }
  }
};
inline Reached reached;
inline bool is_active(int mutant) {
  static const char* const name = std::getenv("ASSUR_MUTANT");
  static const int active = name == nullptr ? -1 : std::atoi(name);
  reached.flags[mutant] = true;
  return mutant == active;
}
}  // namespace assur_mutant
#define ASSUR_MUTANT(n) (__builtin_is_constant_evaluated() ? false : ::assur_mutant::is_active(n))
"""


@dataclasses.dataclass(frozen=True)
class Mutant:
    """The bytes [begin, end) of a file, the text that replaces them, and the operator alone."""
    path: pathlib.Path
    begin: int
    end: int
    text: str
    operator: tuple  # its first byte, its length, and what stands there instead

    def is_on(self, line, content):
        """Whether a line of the file holds a part of the expression."""
        return (content.count(b"\n", 0, self.begin) < line <=
                content.count(b"\n", 0, self.end) + 1)

    def lines(self, content):
        """The number of the changed line, as it is and as it is mutated."""
        start, length, by = self.operator
        first = content.rfind(b"\n", 0, start) + 1
        last = content.find(b"\n", start)
        mutated = content[first:start] + by.encode() + content[start + length:last]
        return (content.count(b"\n", 0, start) + 1, content[first:last].decode().strip(),
                mutated.decode().strip())


def changes_of(cursor, content, path):
    """The mutants of one expression."""
    begin, end = cursor.extent.start.offset, cursor.extent.end.offset
    text = content[begin:end].decode()
    if "//" in text or "#" in text or "ASSUR_" in text:
        return

    def mutant(start, length, by):
        changed = text[:start] + by + text[start + length:]
        return Mutant(path, begin, end, changed, (begin + start, length, by))

    if cursor.kind in (CursorKind.BINARY_OPERATOR, CursorKind.COMPOUND_ASSIGNMENT_OPERATOR,
                       CursorKind.CALL_EXPR):
        children = list(cursor.get_children())
        if len(children) >= 2:
            gap = (children[0].extent.end.offset - begin, children[-1].extent.start.offset - begin)
            between = text[gap[0]:gap[1]]
            for by in BINARY.get(between.strip(), []):
                start = gap[0] + len(between) - len(between.lstrip())
                yield mutant(start, len(between.strip()), by)
    if cursor.kind == CursorKind.CALL_EXPR:
        for call, by in CALLS.items():
            if text.startswith(call):
                yield mutant(0, len(call), by)
    if cursor.kind == CursorKind.UNARY_OPERATOR and text[:1] in "-!":
        yield mutant(0, 1, "")
    if cursor.kind == CursorKind.MEMBER_REF_EXPR and text[-4:] in COMPONENTS:
        yield mutant(len(text) - 4, 4, COMPONENTS[text[-4:]])
    if (cursor.kind in (CursorKind.INTEGER_LITERAL, CursorKind.CXX_BOOL_LITERAL_EXPR) and
            text in LITERALS):
        yield mutant(0, len(text), LITERALS[text])


def include_flags(build):
    """Where the compilations of a build look for headers."""
    commands = json.loads((build / "compile_commands.json").read_text())
    words = [word for command in commands for word in shlex.split(command["command"])]
    flags = {(word,) for word in words if word.startswith("-I")}
    flags |= set(zip(["-isystem"] * len(words),
                     (path for option, path in zip(words, words[1:]) if option == "-isystem")))
    return [word for flag in sorted(flags) for word in flag]


def mutants_of(patterns, build):
    """All mutants of some files."""
    paths = sorted(path for pattern in patterns for path in SOURCE.glob(pattern))
    contents = {str(path): path.read_bytes() for path in paths}
    flags = ["-x", "c++", "-std=c++20", *include_flags(build)]
    index = clang.cindex.Index.create()
    found = []
    skipped = (CursorKind.STATIC_ASSERT, CursorKind.TEMPLATE_NON_TYPE_PARAMETER,
               CursorKind.ENUM_DECL)

    def visit(cursor):
        for child in cursor.get_children():
            file = child.extent.start.file
            if file is not None and file.name in contents and child.kind not in skipped:
                found.extend(changes_of(child, contents[file.name], pathlib.Path(file.name)))
                visit(child)
            elif child.kind == CursorKind.NAMESPACE:
                visit(child)

    # Headers are read together, since their includes take longer to read than they do.
    headers = "".join(f'#include "{path}"\n' for path in paths if path.suffix == ".hpp")
    if headers:
        visit(index.parse("headers.cpp", flags, [("headers.cpp", headers)]).cursor)
    for path in paths:
        if path.suffix == ".cpp":
            visit(index.parse(str(path), flags).cursor)
    return found


def planted(mutants, originals):
    """The text of every file with all its mutants behind switches; lines keep their numbers."""
    by_file = collections.defaultdict(list)
    for number, mutant in mutants.items():
        by_file[mutant.path].append((mutant.begin, number))
    texts = {}
    for path, content in originals.items():
        for _, number in sorted(by_file[path], reverse=True):
            mutant = mutants[number]
            changed = " ".join(mutant.text.split()).encode()
            original = content[mutant.begin:mutant.end]
            if original.startswith(b"!"):
                # Both alternatives are of one type; without it an empty optional would become full.
                changed = b"bool(" + changed + b")"
            content = (content[:mutant.begin] + b"(ASSUR_MUTANT(%d) ? (" % number + changed +
                       b") : (" + original + b"))" + content[mutant.end:])
        texts[path] = content
    return texts


def write(texts):
    for path, content in texts.items():
        if path.read_bytes() != content:
            path.write_bytes(content)


def syntax_commands(build, targets):
    """The compilations of targets, as checks of syntax that write nothing."""
    made = subprocess.run(["ninja", "-C", str(build), "-t", "commands", *targets],
                          capture_output=True, text=True, check=True)
    commands = []
    for line in made.stdout.splitlines():
        # The compilation comes last; commands before it configure or prepare headers.
        command = line.split(" && ")[-1]
        if " -c " in command:
            command = re.sub(r" -MD -MT \S+ -MF \S+| -o \S+", " ", command)
            commands.append(command + " -fsyntax-only -w -fmax-errors=0")
    return commands


def write_headers(build, targets):
    """Writes the headers that are made while targets are built, since checks of syntax read them."""
    subprocess.run(["ninja", "-C", str(build)] +
                   ["cmake_object_order_depends_target_" + target for target in targets],
                   check=True, stdout=subprocess.DEVNULL)


def without_errors(mutants, originals, build, targets, jobs):
    """The mutants that compile. The others are found by the lines of the compiler's errors."""
    commands = syntax_commands(build, targets)
    while commands:
        write(planted(mutants, originals))
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            results = list(pool.map(lambda command: subprocess.run(
                shlex.split(command), cwd=build, capture_output=True, text=True), commands))
        commands = [one for one, result in zip(commands, results) if result.returncode != 0]
        # An error in a template may be reported where it is used, and not where it is defined.
        wrong = []
        for kind in (" error:", ""):
            # A compiler's cache may print paths relative to the build.
            places = {((build / match[1]).resolve(), int(match[2])) for result in results
                      for match in re.finditer(rf"^(\S+?):(\d+):\d+:{kind}", result.stderr, re.M)}
            wrong = wrong or [number for number, mutant in mutants.items()
                              if any(path == mutant.path and mutant.is_on(line, originals[path])
                                     for path, line in places)]
        if commands and not wrong:
            failed = next(result for result in results if result.returncode != 0)
            sys.exit("what is planted does not compile:\n" + failed.stderr[:4000])
        for number in wrong:
            del mutants[number]
    return mutants


def chosen(all_mutants, count, seed):
    """At most `count` mutants, chosen at random, none of which overlaps another."""
    order = list(all_mutants)
    random.Random(seed).shuffle(order)
    taken = collections.defaultdict(list)
    result = {}
    for mutant in order:
        if all(mutant.end <= begin or end <= mutant.begin for begin, end in taken[mutant.path]):
            taken[mutant.path].append((mutant.begin, mutant.end))
            result[len(result)] = mutant
        if len(result) == count:
            break
    return result
