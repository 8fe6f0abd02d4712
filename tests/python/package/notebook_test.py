"""Law: the cells of the notebooks run, with what they assert, and so do the lines of the page on
the package and of the README, which has what they print; the campaign runs the notebooks in a
kernel."""

import json
import os
import pathlib

import pytest

SOURCE = pathlib.Path(os.environ["ASSUR_SOURCE"])
NOTEBOOKS = sorted((SOURCE / "examples/python").glob("*.ipynb"))


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_cells(notebook, monkeypatch):
    monkeypatch.chdir(notebook.parent)
    cells = json.loads(notebook.read_text())["cells"]
    code = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
    assert len(code) > 3 and any("assert" in cell for cell in code)
    assert all(not cell["outputs"] for cell in cells if cell["cell_type"] == "code")
    if any("scipy" in cell for cell in code):
        pytest.importorskip("scipy", reason="SciPy is not installed")
    names = {}
    for cell in code:
        exec(compile(cell, notebook.name, "exec"), names)


def test_the_pages(monkeypatch):
    monkeypatch.chdir(SOURCE)
    guide = (SOURCE / "docs/guide/python.md").read_text()
    reference = (SOURCE / "docs/reference/python.md").read_text()
    code = "\n".join(block.split("```")[0] for block in guide.split("```python\n")[1:])
    names = {}
    exec(compile(code.replace("100_000", "1_000"), "python.md", "exec"), names)
    assert not names["walk"].gap.any() and len(names["more"]) == 2 and len(names["both"].branches) == 2
    assert len(names["given"]) == 3
    assert names["batch"].outputs["P"].sensitivity.shape[1:] == (2, len(names["plan"].parameters))
    for name in names["assur"].__all__:
        if name[0].islower() or name in ("Scene", "Plan", "Solution", "Batch", "Sweep", "Samples"):
            assert "`" + name in reference, name


def test_the_readme(monkeypatch, capsys):
    monkeypatch.chdir(SOURCE)
    code, printed = (SOURCE / "README.md").read_text().split("```python\n")[1].split("```")[0:3:2]
    exec(compile(code, "README.md", "exec"), {})
    assert "text\n" + capsys.readouterr().out == printed


def test_there_are_four():
    assert [path.stem for path in NOTEBOOKS] == [
        "coupler_curve_fit", "four_bar_without_dead_centres", "press_and_crane", "tolerance_study"]
