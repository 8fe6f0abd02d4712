"""Law: the notebooks run from their first cell to their last in a kernel, and show pictures."""

import os
import pathlib

import pytest

nbformat = pytest.importorskip("nbformat", reason="nbconvert is not installed")
preprocessors = pytest.importorskip("nbconvert.preprocessors", reason="nbconvert is not installed")
pytest.importorskip("ipykernel", reason="ipykernel is not installed")

NOTEBOOKS = sorted((pathlib.Path(os.environ["ASSUR_SOURCE"]) / "examples/python").glob("*.ipynb"))


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_is_executed(notebook):
    if "scipy" in notebook.read_text():
        pytest.importorskip("scipy", reason="SciPy is not installed")
    cells = nbformat.read(notebook, as_version=4)
    nbformat.validate(cells)
    run = preprocessors.ExecutePreprocessor(timeout=120, kernel_name="python3")
    run.preprocess(cells, {"metadata": {"path": str(notebook.parent)}})
    outputs = [output for cell in cells.cells for output in cell.get("outputs", [])]
    assert not any(output.output_type == "error" for output in outputs)
    pictures = [output.data["image/svg+xml"] for output in outputs
                if "image/svg+xml" in output.get("data", {})]
    assert len(pictures) == 1 and pictures[0].startswith("<svg")
