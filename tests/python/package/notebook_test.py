"""Law: the cells of the notebooks run, with what they assert; the campaign runs them in a kernel."""

import json
import os
import pathlib

import pytest

NOTEBOOKS = sorted((pathlib.Path(os.environ["ASSUR_SOURCE"]) / "examples/python").glob("*.ipynb"))


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


def test_there_are_two():
    assert [path.stem for path in NOTEBOOKS] == ["coupler_curve_fit", "tolerance_study"]
