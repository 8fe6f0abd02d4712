# Law: the console blocks of pages print what the pages show; a line `...` stands for any lines.
# Whole scenes in JSON, and the C++ of the four-bar, are lines of files in docs.
import pathlib
import re
import subprocess
import sys
import tempfile

failures = 0


def expect(holds, message):
    global failures
    if not holds:
        failures += 1
        print("FAILED:", message)


def matches(printed, told):
    """Whether lines are those told, in which `...` stands for any lines."""
    if "..." in told:
        cut = told.index("...")
        rest = told[cut + 1 :]
        return printed[:cut] == told[:cut] and any(
            matches(printed[start:], rest) for start in range(cut, len(printed) + 1)
        )
    return printed == told


def run(block, directory):
    """Commands begin with `$ `; what they print stands below each."""
    for part in re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]:
        command, _, told = part.partition("\n")
        result = subprocess.run(command, shell=True, cwd=directory, capture_output=True, text=True)
        expect(result.returncode == 0, f"{command}: exit status {result.returncode}: {result.stderr}")
        expect(
            matches(result.stdout.splitlines(), told.splitlines()),
            f"{command} prints\n{result.stdout}where the page says\n{told}",
        )
    return len(re.findall(r"^\$ ", block, flags=re.MULTILINE))


def stands_in(block, file):
    lines = [line.strip() for line in block.splitlines()]
    text = [line.strip() for line in file.read_text().splitlines()]
    return any(text[start : start + len(lines)] == lines for start in range(len(text)))


def main(command, root, *pages):
    root = pathlib.Path(root)
    commands = 0
    for page in pages:
        blocks = re.findall(r"^```(\w+)\n(.*?)^```", (root / page).read_text(), re.M | re.S)
        with tempfile.TemporaryDirectory() as name:
            directory = pathlib.Path(name)
            for folder in ("docs", "examples", "runtime"):
                (directory / folder).symlink_to(root / folder)
            (directory / "build").mkdir()
            (directory / "build" / "assur").symlink_to(command)
            for language, block in blocks:
                if language == "console":
                    commands += run(block, directory)
                elif language == "json" and block.startswith("{") and '"links"' in block:
                    scenes = (root / "docs").rglob("*.json")
                    expect(any(stands_in(block, file) for file in scenes),
                           f"{page}: no file of docs has the scene\n{block}")
                elif language == "cpp" and "FourBar" in block:
                    file = root / "docs/tutorial/follow.cpp"
                    expect(stands_in(block, file), f"{page}: a program is not {file}")
    expect(commands > 0, "no page has a command")
    print(f"{len(pages)} pages, {commands} commands, {failures} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
