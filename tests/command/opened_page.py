"""Pages of scenes opened in a browser, and failures where they do not meet a test's
expectations."""

import base64
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from browser import Browser

SKIPPED = 77
MOST_BYTES = 1_500_000

# Resolves when the page has nothing left to solve.
SOLVED = """new Promise((resolve) => {
  const look = () => (page.asker.busy ? setTimeout(look, 5) : resolve(true));
  look();
})"""

SET = """(() => {
  const row = page.sliders.rows.find((one) => one.name === %s);
  row.%s.value = %s;
  row.%s.dispatchEvent(new Event("%s"));
  return page.scene.changed.get(row.name) ?? null;
})()"""

OUTPUTS = """page.film.branches.map((branch) => [branch.number,
  Array.from(branch.outputs.numbers, (one) => (Number.isNaN(one) ? null : one))])"""

failures = 0


def expect(holds, what):
    global failures
    if not holds:
        failures += 1
        print("FAILED:", what)


def expect_near(told, expected, within, what):
    away = max(abs(one - other) for one, other in zip(told, expected))
    expect(len(told) == len(expected) and away <= within, f"{what}: {told}, not {expected}")


def run(*words):
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    return done.stdout, done.stderr


def opened(chromium, assur, scene, folder, *options, **window):
    """Opens the page of a scene, at rest, and waits for its first solution."""
    page = folder / f"{scene.stem}.html"
    _, told = run(assur, "draw", str(scene), "--output", str(page), *options)
    expect(page.exists(), f"{scene.stem}: {told}")
    expect(page.stat().st_size < MOST_BYTES, f"{scene.stem}: within the bound on pages")
    expect(not re.search(r"(src|href)=\"(?!data:)|https?://|url\(", page.read_text()), "no other file")
    chromium.open(page.as_uri(), **window)
    if chromium.value("Boolean(page.asker)"):
        chromium.value(SOLVED)
    chromium.value("page.play(false)")
    print(f"{scene.stem}: {page.stat().st_size} bytes")


def set_parameter(chromium, name, value, part="field"):
    """Sets a parameter as a reader does, and waits for the solution."""
    event = "input" if part == "slider" else "change"
    told = chromium.value(SET % (f'"{name}"', part, repr(value), part, event))
    chromium.value(SOLVED)
    return told


def obstacle(chromium):
    return chromium.value("document.getElementById('obstacle').textContent")


def keep_picture(chromium, name):
    """Writes a picture to the folder ASSUR_PICTURES, for people to look at."""
    if "ASSUR_PICTURES" in os.environ:
        folder = pathlib.Path(os.environ["ASSUR_PICTURES"])
        folder.mkdir(parents=True, exist_ok=True)
        (folder / f"{name}.png").write_bytes(base64.b64decode(chromium.picture()))


def main(checks):
    """Runs `checks(chromium, assur, examples, folder)` with the command and the examples that the
    test is called with."""
    program = shutil.which("chromium")
    if program is None or subprocess.run([program, "--version"], capture_output=True).returncode != 0:
        print("chromium is not installed, or does not work: pages are not tested in a browser")
        sys.exit(SKIPPED)
    assur, examples = sys.argv[1], pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as name, Browser(program, name + "/profile") as chromium:
        checks(chromium, assur, examples, pathlib.Path(name))
        expect(not chromium.errors, f"the console says {chromium.errors}")
    sys.exit(1 if failures else 0)
