"""Law: imports are those of `assur import`, byte for byte, with the same remarks and errors."""

import json

import pytest

import assur
from conftest import EXAMPLES


def imported(command, source, *more):
    file = command.folder / "imported.json"
    told = command.run("import", source, "--output", file, "--force", *more)
    notes = tuple(line.partition(f"note: {source}: ")[2] for line in told.stderr.splitlines())
    return file.read_text(), notes, told.returncode == 0


@pytest.mark.parametrize("name", ["press.linkage2", "quick_return.pyslvs", "slider_crank.pmks"])
def test_files(command, name):
    source = EXAMPLES / "import" / name
    scene = assur.import_scene(source)
    assert (scene.text, scene.remarks, scene.complete) == imported(command, source)
    assert assur.import_scene(str(source)).text == scene.text
    assert assur.Plan(assur.parse_scene(scene.text)).solve().status == assur.Status.OK


def test_texts_in_place_of_files(command):
    source = (EXAMPLES / "import" / "quick_return.pyslvs").read_text().strip()
    assert assur.import_scene(source).text == imported(command, source)[0]
    driven = assur.import_scene(source, driver="P0")
    assert driven.text == imported(command, source, "--driver", "P0")[0]
    assert json.loads(driven.text)["drivers"]


def test_what_cannot_be_read(command):
    file = command.folder / "no.linkage2"
    file.write_text("<nothing/>")
    with pytest.raises(assur.SceneError) as raised:
        assur.import_scene(file)
    told = command.run("import", file, "--output", command.folder / "out.json")
    assert told.stderr == f"error: {raised.value}\n"
    with pytest.raises(assur.SceneError, match="nowhere"):
        assur.import_scene("nowhere.linkage2")
