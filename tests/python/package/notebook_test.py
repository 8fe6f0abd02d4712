"""Law: the cells of the notebooks run, with what they assert, and so do the lines of the page on
the package; the campaign runs the notebooks in a kernel."""

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
    names = {}
    for cell in code:
        exec(compile(cell, notebook.name, "exec"), names)


def test_the_pages(monkeypatch):
    monkeypatch.chdir(SOURCE)
    guide = (SOURCE / "docs/guide/python.md").read_text()
    reference = (SOURCE / "docs/reference/python.md").read_text()
    code = guide.split("```python\n")[1].split("```")[0]
    names = {}
    exec(compile(code.replace("100_000", "1_000"), "python.md", "exec"), names)
    assert names["batch"].outputs["P"].sensitivity.shape[1:] == (2, len(names["plan"].parameters))
    for name in names["assur"].__all__:
        if name[0].islower() or name in ("Scene", "Plan", "Solution", "Batch", "Sweep", "Samples"):
            assert "`" + name in reference, name


def test_there_are_two():
    assert [path.stem for path in NOTEBOOKS] == ["coupler_curve_fit", "tolerance_study"]
