"""The notebook in docs/ runs, and shows a picture and a plot."""

from pathlib import Path
from typing import Any

import nbformat
from nbclient import NotebookClient

NOTEBOOK = Path(__file__).parents[2] / "docs" / "error-over-time.ipynb"


def shown(notebook: Any) -> list[set[str]]:
    """The kinds of output of each cell."""
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    kinds = [[output.get("data", {"text": ""}).keys() for output in cell.outputs] for cell in cells]
    return [{kind for output in cell for kind in output} for cell in kinds]


def test_the_notebook_runs_and_plots() -> None:
    kept = nbformat.read(NOTEBOOK, as_version=4)
    run = nbformat.read(NOTEBOOK, as_version=4)
    # A cell that raises ends it with an exception.
    NotebookClient(run, timeout=300).execute()
    assert shown(run) == shown(kept)
    assert sum("image/png" in kinds for kinds in shown(run)) == 2, "a picture and a plot"
