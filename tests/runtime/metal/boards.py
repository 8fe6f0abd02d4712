"""Builds programs without an operating system and runs them under QEMU, which counts their
instructions; and builds the same programs for the host."""

import pathlib
import re
import shutil
import subprocess
from dataclasses import dataclass

here = pathlib.Path(__file__).resolve().parent
project = here.parent.parent.parent
example = project / "examples" / "bare_metal"
# The numbers of two machines are the same where neither fuses products and sums.
common = ["-std=c++17", "-O2", "-ffp-contract=off", "-fno-exceptions", "-fno-rtti",
          "-ffunction-sections", "-fdata-sections", f"-I{example}", f"-I{here}"]
forbidden = re.compile("__cxa_|__assert|abort|malloc|_sbrk|operator new|guard variable|"
                       "_GLOBAL__sub_I")


@dataclass
class Board:
    name: str
    tools: str      # what the compiler's and its tools' names begin with
    compiler: str
    flags: list
    start: pathlib.Path
    memory: pathlib.Path
    qemu: list
    off: float = 0.0  # by how much its arithmetic may change a number

    def missing(self):
        tools = (self.tools + self.compiler, self.qemu[0])
        return [tool for tool in tools if not shutil.which(tool)]

    def build(self, sources, elf, flags):
        run([self.tools + self.compiler, *common, *self.flags, "-fno-threadsafe-statics",
             # assur_add_solver does so for a machine without an operating system.
             "-DEIGEN_NO_DEBUG", "-nostartfiles", "-Wl,--gc-sections", f"-T{self.memory}",
             "-Wl,--defsym=stack_size=0x40000", *flags, *sources, self.start, "-lm", "-o", elf],
            cwd=elf.parent)
        found = [line for line in run([self.tools + "nm", "-C", elf]).splitlines()
                 if forbidden.search(line)]
        if found:
            raise SystemExit(f"{elf.name} links\n" + "\n".join(found))

    def run(self, elf, answers, given=subprocess.DEVNULL):
        """What the program writes to its console."""
        with open(answers, "wb") as out:
            done = subprocess.run(
                [*self.qemu, "-nographic", "-monitor", "none", "-serial", "none",
                 "-semihosting-config", "enable=on,target=native", "-kernel", elf],
                stdin=given, stdout=out, check=False)
        if done.returncode != 0:
            raise SystemExit(f"{self.name}: {elf.name} ends with {done.returncode}")


def run(command, **options):
    done = subprocess.run(command, capture_output=True, text=True, **options)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


def cortex(name, core, unit, machine, off=0.0):
    return Board(name, "arm-none-eabi-", "g++",
                 [f"-mcpu={core}", "-mthumb", "-mfloat-abi=hard", f"-mfpu={unit}", "-Wno-psabi"],
                 example / "start_cortex_m.cpp", example / "mps2.ld",
                 ["qemu-system-arm", "-M", machine, "-icount", "shift=3"], off)


def library_headers():
    """Debian has no C++ library for a RISC-V without an operating system. The headers of ARM's,
    made for the same C library and the same compiler, serve: nothing of that library is linked."""
    headers = sorted(pathlib.Path("/usr/include/newlib/c++").glob("*"))
    if not headers:
        return []
    return ["-nostdinc++", "-isystem", headers[-1],
            "-isystem", headers[-1] / "arm-none-eabi" / "thumb" / "nofp"]


# The compiler's software for ARM rounds some differences of doubles to the farther neighbour, such
# as that of 0x1.0000000000017p+0 and 0x1.ed753c74a7438p-33. Then numbers may differ by the
# 18 roundings that polishing leaves of the closures.
boards = {
    "m7": cortex("Cortex-M7", "cortex-m7", "fpv5-d16", "mps2-an500"),
    "m4f": cortex("Cortex-M4F", "cortex-m4", "fpv4-sp-d16", "mps2-an386", 18 * 2.0**-52),
    "rv32": Board("rv32imac", "riscv64-unknown-elf-", "gcc",
                  ["--specs=picolibc.specs", "-march=rv32imac", "-mabi=ilp32", "-mcmodel=medany",
                   *library_headers()],
                  here / "start_riscv.cpp", here / "virt.ld",
                  ["qemu-system-riscv32", "-M", "virt", "-bios", "none", "-icount", "shift=0"])}
