"""Scenes that tests render, and the command line installed with the module."""

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

# Small, with glass and more than one path to the light.
SCENE = """screen 40 30
camera 0 -4 1  .36  x 76
background .5 .6 .7
brdf 0 0 0  .04 .04 .04  .1  .9 .5 .9  1.5
sphere 0 0 0  1
light 5 5 4
sphere 0 0 3  .5
"""

Command = Callable[..., "subprocess.CompletedProcess[str]"]


@pytest.fixture
def scene(tmp_path: Path) -> Path:
    path = tmp_path / "scene.txt"
    path.write_text(SCENE)
    return path


@pytest.fixture
def command(tmp_path: Path) -> Command:
    """Runs the installed `vkpt WORDS…` in the folder of the scene."""
    program = Path(sys.executable).with_name("vkpt")

    def run(*words: str) -> "subprocess.CompletedProcess[str]":
        return subprocess.run([str(program), *words], cwd=tmp_path, capture_output=True, text=True)

    return run
