"""The cost of a first picture in a fresh interpreter: nothing unused is imported."""

import subprocess
import sys

from conftest import SCENE

PROGRAM = """
import sys, vkpt
vkpt.render(sys.argv[1], spp=16, progress=False)
heavy = {"matplotlib", "pandas", "scipy", "IPython", "asyncio", "typing_extensions"}
print(sorted(heavy & sys.modules.keys()))
"""


def test_a_first_picture_imports_numpy_alone() -> None:
    words = [sys.executable, "-c", PROGRAM, SCENE]
    run = subprocess.run(words, capture_output=True, text=True)
    assert (run.returncode, run.stdout) == (0, "[]\n"), run.stderr
