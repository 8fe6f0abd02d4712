"""Law: in a browser, the page of a scene says where `assur solve` has its outputs, on every branch at
every step; its keys and buttons do what they say; and the console has no error."""

import csv
import io
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
browser = shutil.which("chromium")
if browser is None:
    print("chromium is not installed: pages are not tested in a browser")
    sys.exit(SKIPPED)

ASK = """
<pre id="answer"></pre>
<script>
addEventListener("load", () => setTimeout(() => {
  const page = window.page;
  const key = (name, shift) =>
    document.dispatchEvent(new KeyboardEvent("keydown", {key: name, shiftKey: Boolean(shift)}));
  const answer = {told: [], keys: []};
  page.play(false);
  for (const branch of page.film.branches) {
    page.choose(branch.number);
    for (let step = 0; step < page.film.count; step += 7) {
      page.seek(step);
      const cells = [...document.querySelectorAll("#readout tr")].map(
        (row) => [...row.cells].map((cell) => cell.textContent));
      answer.told.push([branch.number, step, page.film.parameterAt(step), cells.slice(1)]);
    }
  }
  const note = () => answer.keys.push([page.place, page.chosen, page.isPlaying, page.options.all]);
  key("Home"); note();
  key("ArrowRight"); note();
  key("ArrowRight", true); note();
  key("ArrowLeft"); note();
  key("End"); note();
  key("2"); note();
  key("a"); note();
  key(" "); note();
  document.getElementById("answer").textContent = JSON.stringify(answer);
}, 100));
</script>
</body>
"""

failures = 0


def expect(holds, what):
    global failures
    if not holds:
        failures += 1
        print("FAILED:", what)


def run(*words):
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    return done.stdout, done.stderr


def answer_of(assur, scene, folder):
    page = folder / "page.html"
    run(assur, "draw", str(scene), "--output", str(page))
    expect(page.stat().st_size < 1_000_000, f"{scene.stem}: below a megabyte")
    text = page.read_text()
    expect(not re.search(r"(src|href)=\"(?!data:)|https?://|url\(", text), "no other file")
    page.write_text(text.replace("</body>\n", ASK))
    dom, log = run(browser, "--headless", "--no-sandbox", "--disable-gpu", "--enable-logging=stderr",
                   f"--user-data-dir={folder}/profile", "--virtual-time-budget=2000", "--dump-dom",
                   page.as_uri())
    expect("CONSOLE" not in log, f"{scene.stem}: " + "".join(re.findall(".*CONSOLE.*", log)))
    found = re.search(r'<pre id="answer">(.*?)</pre>', dom, re.S)
    expect(found and found[1], f"{scene.stem}: the page answers")
    return json.loads(found[1]) if found and found[1] else {"told": [], "keys": []}


def rows_of(assur, scene):
    table, _ = run(assur, "solve", str(scene), "--format", "csv")
    return {(row["branch"], int(row["step"])): row for row in csv.DictReader(io.StringIO(table))
            if not row["event"]}


def check(assur, scene, folder, output, parameter):
    answer = answer_of(assur, scene, folder)
    rows = rows_of(assur, scene)
    compared = 0
    for branch, step, value, cells in answer["told"]:
        row = rows.get((str(branch), step))
        told = next(line for line in cells if line[0] == output)
        if row is None:
            expect(told[1] == "–", f"{scene.stem}: branch {branch} is not at step {step}")
            continue
        expect(abs(float(row[parameter]) - value) < 1e-12, "the parameter")
        for cell, column in zip(told[1:3], ("x", "y")):
            solved = float(row[f"{output}.{column}"])
            expect(abs(float(cell) - solved) <= 6e-6 * max(abs(solved), 1), f"{cell} is {solved}")
            compared += 1
    expect(compared > 100, f"{scene.stem}: {compared} numbers are compared")
    last = max(step for _, step in rows)
    expect(answer["keys"] == [[0, answer["keys"][0][1], False, True],
                              [1, answer["keys"][0][1], False, True],
                              [11, answer["keys"][0][1], False, True],
                              [10, answer["keys"][0][1], False, True],
                              [last, answer["keys"][0][1], False, True],
                              [last, 2, False, True], [last, 2, False, False],
                              [last, 2, True, False]], f"{scene.stem}: keys {answer['keys']}")
    print(f"{scene.stem}: {compared} numbers of the page are those of assur solve")


def main():
    assur, examples = sys.argv[1], pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        check(assur, examples / "jansen_leg.json", pathlib.Path(folder), "foot", "phi")
        check(assur, examples / "quintero_2011_rrp_rrr.json", pathlib.Path(folder), "E", "phi")
    sys.exit(1 if failures else 0)


main()
