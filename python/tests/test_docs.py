"""The examples in docs/python.md and python/README.md run."""

import re
from pathlib import Path

import pytest
import vkpt
from test_scene import CUBE, SIDES

ROOT = Path(__file__).parents[2]


@pytest.mark.parametrize("page", ["docs/python.md", "python/README.md"])
def test_every_block_runs(page: str, scene: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(scene.parent)
    blocks = re.findall(r"```python\n(.*?)```", (ROOT / page).read_text(encoding="utf-8"), re.DOTALL)
    assert blocks
    # Names that the pages do not define.
    names = {"vkpt": vkpt, "vertices": CUBE, "faces": SIDES}
    for block in blocks:
        exec(block, names)
    assert Path("scene.exr").exists()
