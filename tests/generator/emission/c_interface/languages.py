"""Programs in C and Fortran, and calls from ctypes, that print the configurations of an emitted
solver, with every number of each, for each step of the drivers."""

import ctypes
import subprocess


def run(command, **options):
    done = subprocess.run(command, capture_output=True, text=True, **options)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


def given(header):
    return [word for word in ("drivers", "parameters") if header.has(word)]


def drivers_of(header):
    return [member.name for member in header.structures.get("drivers", [])]


def by_c(header, implementation, steps, settings, work):
    """A program in C99, linked by the C compiler with the mathematics library alone."""
    p = header.prefix
    lines = [f'#include "{implementation.stem}.h"', "#include <stdio.h>", "int main(void) {",
             f"  static {p}_solution found;"]
    lines += [f"  {p}_{word} {word};" for word in given(header)]
    handed = "".join(f"&{word}, " for word in given(header))
    for step in steps:
        if given(header):
            lines.append(f"  {p}_defaults({handed[:-2]});")
        lines += [f"  drivers.{name}.position += {step};" for name in drivers_of(header)]
        lines += [f"  parameters.{name} = {value!r};" for name, value in settings.items()]
        lines += [f"  if ({p}_solve({handed}&found) != {p}_status_ok) {{ return 1; }}",
                  '  printf("%d\\n", found.count);',
                  "  for (int i = 0; i < found.count; ++i) {"]
        lines += [f'    printf("%.17g\\n", found.states[i].{leaf});'
                  for leaf in header.leaves("state")]
        lines.append("  }")
    source = work / "by_c.c"
    source.write_text("\n".join(lines + ["  return 0;", "}", ""]))
    program = work / "by_c"
    run(["gcc", "-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic",
         f"-I{implementation.parent}", source, work / "solver.o", "-lm", "-o", program])
    return run([program]).split()


def ctypes_of(header):
    """The header's structures, by their names."""
    types = {"double": ctypes.c_double, "int": ctypes.c_int,
             f"{header.prefix}_status": ctypes.c_int}
    for name, members in header.structures.items():
        fields = []
        for member in members:
            type_ = types[member.type]
            for size in reversed(member.shape):
                type_ = type_ * size
            fields.append((member.name, type_))
        types[f"{header.prefix}_{name}"] = type(name, (ctypes.Structure,), {"_fields_": fields})
    return types


class CtypesSolver:
    """A solver's library by Python's own foreign functions."""

    def __init__(self, header, work):
        self.header = header
        self.types = ctypes_of(header)
        self.library = ctypes.CDLL(str(work / "solver.so"))

    def made(self, name):
        return self.types[f"{self.header.prefix}_{name}"]()

    def call(self, name, *arguments):
        return getattr(self.library, f"{self.header.prefix}_{name}")(
            *(ctypes.byref(argument) for argument in arguments))

    def given(self, step, settings):
        arguments = [self.made(word) for word in given(self.header)]
        if arguments:
            self.call("defaults", *arguments)
        for name in drivers_of(self.header):
            getattr(arguments[0], name).position += step
        for name, value in settings.items():
            setattr(arguments[-1], name, value)
        return arguments


def by_ctypes(header, steps, settings, work):
    solver = CtypesSolver(header, work)
    found = solver.made("solution")
    printed = []
    for step in steps:
        if solver.call("solve", *solver.given(step, settings), found) != 0:
            raise SystemExit("ctypes: not ok")
        printed.append(str(found.count))
        for index in range(found.count):
            scope = {"state": found.states[index]}
            printed += [f"{eval('state.' + leaf, scope):.17g}" for leaf in header.leaves("state")]
    return printed


def nearest_by_ctypes(header, step, settings, work):
    """The number of the nearest, from 1, its distance and that of the runner-up."""
    solver = CtypesSolver(header, work)
    state, distance = solver.made("state"), solver.made("distance")
    if solver.call("nearest", *solver.given(step, settings), state, distance) != 0:
        raise SystemExit("ctypes: nearest is not ok")
    return distance.configuration + 1, distance.nearest, distance.runner_up


def by_fortran(header, implementation, steps, settings, work):
    """Fortran's iso_c_binding; arrays are stored the other way round, and indices begin at one."""
    p = header.prefix
    kinds = {"double": "real(c_double)", "int": "integer(c_int)", f"{p}_status": "integer(c_int)"}
    lines = ["module solver", "  use iso_c_binding", "  implicit none"]
    for name, members in header.structures.items():
        lines.append(f"  type, bind(c) :: {p}_{name}")
        for member in members:
            kind = kinds.get(member.type, f"type({member.type})")
            shape = ", ".join(str(size) for size in reversed(member.shape))
            lines.append(f"    {kind} :: {member.name}" + (f"({shape})" if shape else ""))
        lines.append(f"  end type {p}_{name}")
    lines.append("  interface")
    words = given(header)
    if words:
        lines.append(f"    subroutine {p}_defaults({', '.join(words)}) bind(c)")
        lines.append("      import")
        lines += [f"      type({p}_{word}) :: {word}" for word in words]
        lines.append("    end subroutine")
    lines.append(f"    integer(c_int) function {p}_solve({', '.join(words + ['found'])}) bind(c)")
    lines.append("      import")
    lines += [f"      type({p}_{word}), intent(in) :: {word}" for word in words]
    lines += [f"      type({p}_solution) :: found", "    end function", "  end interface",
              "end module", "program by_fortran", "  use solver", "  implicit none",
              "  integer :: i", f"  type({p}_solution) :: found"]
    lines += [f"  type({p}_{word}) :: {word}" for word in words]
    for step in steps:
        if words:
            lines.append(f"  call {p}_defaults({', '.join(words)})")
        lines += [f"  drivers%{name}%position = drivers%{name}%position + ({step}d0)"
                  for name in drivers_of(header)]
        lines += [f"  parameters%{name} = {value!r}d0" for name, value in settings.items()]
        lines += [f"  if ({p}_solve({', '.join(words + ['found'])}) /= 0) error stop",
                  "  print '(i0)', found%count", "  do i = 1, found%count"]
        for leaf in header.leaves("state"):
            name, *places = leaf.replace("]", "").split("[")
            place = ", ".join(str(int(index) + 1) for index in reversed(places))
            name = name.replace(".", "%") + (f"({place})" if place else "")
            lines.append(f"    print '(es25.16e3)', found%states(i)%{name}")
        lines.append("  end do")
    source = work / "by_fortran.f90"
    source.write_text("\n".join(lines + ["end program", ""]))
    program = work / "by_fortran"
    run(["gfortran", "-std=f2008", "-Wall", "-Werror", "-ffree-line-length-none", source,
         work / "solver.o", "-o", program], cwd=work)
    return run([program]).split()
