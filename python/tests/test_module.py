"""The installed module: its command, its types, the cost of importing it."""

import subprocess
import sys
from pathlib import Path
from typing import get_type_hints

import vkpt
from conftest import Command
from vkpt import _words, settings


def test_the_wheel_brings_the_command(command: Command) -> None:
    run = command("--version")
    assert (run.returncode, run.stdout) == (0, f"vkpt {vkpt.__version__}\n")
    assert command("--spp", "x").returncode == 2
    assert command("none.txt").returncode == 3


def test_types_name_the_settings_that_there_are() -> None:
    own = {"spp", "device"}
    known = settings.Settings.__annotations__.keys() | settings.ModelSettings.__annotations__.keys()
    assert known | own == _words.names("render")
    known = settings.ConvergeSettings.__annotations__.keys() | settings.ModelSettings.__annotations__.keys()
    assert known | {"time", "vary", "device"} == _words.names("converge")


def test_types_and_documentation_are_complete() -> None:
    root = Path(__file__).parents[2]
    package = Path(vkpt.__file__).parent
    run = subprocess.run(
        [sys.executable, "-m", "mypy", "--config-file", root / "pyproject.toml", package],
        capture_output=True,
        text=True,
    )
    assert run.returncode == 0, run.stdout
    for name in vkpt.__all__:
        if name != "__version__":
            assert getattr(vkpt, name).__doc__ or name in ("Picture", "ErrorAt"), name
    assert get_type_hints(vkpt.Scene.sphere)
