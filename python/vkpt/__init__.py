"""vkpt, a headless path tracer on Vulkan compute: a scene goes in, a picture comes out.

>>> import vkpt
>>> picture = vkpt.render("scene.txt", spp=256)
>>> picture.rgb.shape, picture.error.rel_mse
((300, 400, 3), 0.0021)

A scene is a path, the text of a scene file, or a `Scene` that a program builds. Settings are the flags of the command
line, with `_` for `-`: `max_depth=5`, `integrator="bidirectional"`, `size=(400, 300)`; `vkpt --help` explains them. What
is wrong raises an exception of `vkpt.errors`, whose text is the command line's; warnings are Python's.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _vkpt
from ._progress import Bar
from ._vkpt import ErrorAt, Picture, __version__
from ._words import words
from .errors import (
    ArgumentError,
    DeviceError,
    Diagnostic,
    Error,
    FileError,
    OutOfMemory,
    SceneError,
)
from .scene import Scene

if TYPE_CHECKING:
    import numpy.typing as npt
    from typing_extensions import Unpack

    from .settings import ConvergeSettings, Settings

__all__ = [
    "ArgumentError",
    "DeviceError",
    "Diagnostic",
    "Error",
    "ErrorAt",
    "FileError",
    "OutOfMemory",
    "Picture",
    "Scene",
    "SceneError",
    "__version__",
    "compare",
    "converge",
    "progressive",
    "read",
    "render",
]

AnyScene = str | os.PathLike[str] | Scene
Progress = bool | Callable[[float, str], object]


def render(
    scene: AnyScene,
    spp: int | None = None,
    device: str | int | None = None,
    progress: Progress = True,
    **settings: Unpack[Settings],
) -> Picture:
    """Renders a scene.

    `spp` are the samples per pixel, the most where `time` or `target_error` end it sooner: 64 by default, with one of
    those no end. `device` is a Vulkan device by index or name, or "cpu-f32" or "cpu-f64", the reference; by default the
    best one. `progress` shows a bar on stderr, or calls a function with the part that is done, in [0, 1], and words.

    Ctrl-c ends the rendering with the samples that are there: `picture.ended` is then "interrupted".
    """
    line = words("render", {"spp": spp, "device": device, **settings})
    with _source(scene) as source, _shown(progress) as show:
        return _vkpt.render(source, line, show)


def progressive(
    scene: AnyScene,
    spp: int | None = None,
    device: str | int | None = None,
    pause: float = 0.5,
    **settings: Unpack[Settings],
) -> Iterator[Picture]:
    """Renders a scene and yields its pictures while they grow, each with all samples so far; the last is the finished one.

    A picture is made only when the loop asks for the next one, and `pause` seconds after the last at the earliest. The
    rendering goes on in a thread of its own meanwhile; leaving the loop ends it. Layers, `stderr` aside, come with the last
    picture alone.

    >>> for picture in vkpt.progressive("scene.txt", time=10):
    ...     print(picture.spp, picture.error)
    """
    line = words("render", {"spp": spp, "device": device, **settings})
    with _source(scene) as source:
        yield from _vkpt.Growing(source, line, pause)


def converge(
    scene: AnyScene,
    time: float = 60,
    vary: Mapping[str, Sequence[Any]] | None = None,
    device: str | int | None = None,
    progress: Progress = True,
    **settings: Unpack[ConvergeSettings],
) -> dict[str, Any]:
    """Measures how fast a scene converges: independent renderings of 1, 2, 4 … samples per pixel, judged by a reference.

    `time` are the seconds of sampling in all, the reference aside. `vary` has settings and their values, such as
    `{"connect": ["mis", "light"]}`: all combinations are measured. Returned is what `vkpt converge --json` writes; the rows
    of a variant become a table by `pandas.json_normalize(result["variants"][0]["steps"])`.
    """
    given = {"time": time, "vary": vary, "device": device, **settings}
    line = words("converge", {k: v for k, v in given.items() if v is not None})
    with _source(scene) as source, _shown(progress) as show:
        return json.loads(_vkpt.converge(source, line, show))  # type: ignore[no-any-return]


def compare(
    a: Picture | npt.ArrayLike | str | os.PathLike[str],
    b: Picture | npt.ArrayLike | str | os.PathLike[str],
    exposure: float = 0,
) -> dict[str, Any]:
    """How far picture `a` is from `b`, by which it is judged.

    Pictures are those of `render`, arrays of shape (height, width, 3) in linear RGB, or files (EXR, HDR, PNG). Returned are
    mse, rmse, rel_mse, smape and flip, each also without the worst 1 % of pixels; the means of both; and whether a z-test
    of blocks passes where both have standard errors (`aov="stderr"`), else what it lacks. FLIP brightens both pictures by
    `exposure` stops.
    """
    return _vkpt.compare(_picture(a), _picture(b), exposure)


def read(path: str | os.PathLike[str], layer: str | None = None) -> npt.NDArray[np.float32]:
    """Reads a picture of any renderer (EXR, HDR, PNG), or a layer of an EXR: linear RGB, shape (height, width, 3)."""
    return _vkpt.read(os.fspath(path), layer)


def _picture(of: Any) -> Any:
    if isinstance(of, (Picture, str, os.PathLike)):
        return of
    array = np.ascontiguousarray(of, np.float32)
    if array.ndim != 3 or array.shape[2] != 3:
        raise ValueError(f"a picture has the shape (height, width, 3), not {array.shape}")
    return array


@contextmanager
def _source(scene: AnyScene) -> Iterator[Any]:
    """The scene as a path, or in a tuple as a text, which has more than one line."""
    if isinstance(scene, Scene) and scene._meshes:
        with TemporaryDirectory(prefix="vkpt-") as folder:
            path = Path(folder, "scene.txt")
            scene.save(path)
            yield path
    elif isinstance(scene, Scene):
        yield (scene.text,)
    elif isinstance(scene, str) and "\n" in scene:
        yield (scene,)
    else:
        yield Path(scene)


@contextmanager
def _shown(progress: Progress) -> Iterator[Callable[[float, str], object] | None]:
    if callable(progress):
        yield progress
    elif progress:
        bar = Bar()
        try:
            yield bar
        finally:
            bar.finish()
    else:
        yield None
