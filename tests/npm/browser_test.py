"""Law: the package has the same answers in a browser as the command.

browser_test.py FOLDER ASSUR SOURCE"""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

folder, assur, source = sys.argv[1:]
chromium = shutil.which("chromium")
if chromium is None:
    print("chromium is not installed")
    sys.exit(77)
sys.path.insert(0, str(pathlib.Path(source) / "tests/command"))
from browser import Browser  # noqa: E402

SCENE = pathlib.Path(source) / "examples/four_bar_coupler_curve.json"
told = subprocess.run([assur, "solve", str(SCENE), "--set", "phi=1", "--format", "json"],
                      capture_output=True, text=True, check=True).stdout
expected = [one["outputs"]["P"]["position"] for one in json.loads(told)["configurations"]]

with tempfile.TemporaryDirectory() as work:
    page = pathlib.Path(work) / "page.html"
    code = (pathlib.Path(folder) / "package/index.js").read_text()
    # Browsers load no module from another file on a disk, so its text goes through a blob.
    page.write_text(f"""<!doctype html><meta charset="utf-8"><title>assur</title>
<script id="package" type="text/plain">{code}</script>
<script>
const text = document.getElementById("package").textContent;
const assur = import(URL.createObjectURL(new Blob([text], {{ type: "text/javascript" }})));
const scene = {SCENE.read_text()};
</script>""")
    with Browser(chromium, work) as browser:
        browser.open(page.as_uri())
        found = browser.value("""assur.then(async ({ solve }) =>
            (await solve(scene, { phi: 1 })).configurations.map((one) => one.outputs.P.position))""")
        count = browser.value("assur.then(async ({ sweep }) => (await sweep(scene)).branches.length)")
        line = browser.value("""assur.then(({ solve }) => solve({ ...scene, joints: undefined })
            .then(() => "solved", (error) => error.message))""")
        errors = list(browser.errors)
away = max(abs(one - other) for pair in zip(found, expected) for one, other in zip(*pair))
print(f"largest difference {away:.1e}")
assert len(found) == len(expected) == 2 and away < 1e-9, (found, expected)
assert count == 2 and line == "scene: the key 'joints' is missing" and not errors, (count, line, errors)
