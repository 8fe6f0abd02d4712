"""Reads the structures in the C header of an emitted solver, for declaration in other languages."""

import re
from dataclasses import dataclass


@dataclass
class Member:
    type: str
    name: str
    shape: list


@dataclass
class Header:
    prefix: str
    constants: dict
    structures: dict  # by name without the prefix, in order: members
    functions: dict   # by name without the prefix: (type, name) of the arguments

    def has(self, structure):
        return structure in self.structures

    def leaves(self, structure, path="", offset=()):
        """The numbers of a structure in order: the path to each, spelled as in C."""
        for member in self.structures[structure]:
            places = [()]
            for size in member.shape:
                places = [place + (index,) for place in places for index in range(size)]
            for place in places:
                here = path + member.name + "".join(f"[{index}]" for index in place)
                inner = member.type.removeprefix(self.prefix + "_")
                if inner in self.structures:
                    yield from self.leaves(inner, here + ".")
                elif member.type == "double":
                    yield here


def read_header(file):
    text = re.sub(r"//[^\n]*", "", file.read_text())
    prefix = re.search(r"(\w+)_status_ok", text)[1]
    constants = {name: int(value) for name, value in re.findall(r"(\w+) = (\d+)", text)}
    structures = {}
    for name, body in re.findall(r"typedef struct \w+ \{([^}]*)\} (\w+);", text, re.S):
        name, body = body, name
        members = []
        for type_, member, sizes in re.findall(r"(\w+) (\w+)((?:\[\w+\])*);", body):
            shape = [constants[s] if s in constants else int(s)
                     for s in re.findall(r"\[(\w+)\]", sizes)]
            members.append(Member(type_, member, shape))
        structures[name.removeprefix(prefix + "_")] = members
    functions = {}
    for name, body in re.findall(r"(?:void|\w+_status) (\w+)\(([^)]*)\);", text):
        functions[name.removeprefix(prefix + "_")] = re.findall(r"(\w+)\*? (\w+)(?:,|$)", body)
    return Header(prefix, constants, structures, functions)
