"""vkpt, a headless path tracer on Vulkan compute: a scene goes in, a picture comes out.

>>> import vkpt
>>> picture = vkpt.render("scene.txt", spp=256)
>>> picture.rgb.shape, picture.error.rel_mse
((300, 400, 3), 0.0021)

A scene is a path, the text of a scene file, or a `Scene` that a program builds. Settings are the flags of the command
line, with `_` for `-`: `max_depth=5`, `integrator="bidirectional"`, `size=(400, 300)`; `vkpt --help` explains them.
Errors raise an exception of `vkpt.errors`, whose text is the command line's; warnings are Python's.
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

    `spp` is the number of samples per pixel, or its upper limit if `time` or `target_error` is set: 64 by default, without
    limit if one of those is set. `device` is a Vulkan device by index or name, or "cpu-f32" or "cpu-f64", the reference; by
    default the best one. `progress` shows a bar on stderr, or is a function called with the fraction done, in [0, 1], and a
    text.

    Ctrl-c ends the rendering with the samples done: `picture.ended` is then "interrupted".
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
    """Renders a scene and yields the picture as it grows, each time with all samples so far; the last is the finished one.

    A picture is made only when the loop requests the next one, and `pause` seconds after the last at the earliest. The
    rendering continues in a separate thread meanwhile; leaving the loop ends it. Only the last picture has layers, except
    `stderr`, which all have.

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
    """Measures how fast a scene converges: independent renderings of 1, 2, 4 … samples per pixel, against a reference.

    `time` is the total sampling time in seconds, without the reference. `vary` maps settings to lists of values, as in
    `{"connect": ["mis", "light"]}`: all combinations are measured. Returns the contents of `vkpt converge --json`; the
    steps of a variant become a table with `pandas.json_normalize(result["variants"][0]["steps"])`.
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
    """Compares picture `a` with the reference `b`.

    Pictures are those of `render`, arrays of shape (height, width, 3) in linear RGB, or files (EXR, HDR, PNG). Returns mse,
    rmse, rel_mse, smape and flip, each also without the worst 1 % of pixels; the means of both; and whether a z-test of
    blocks passes if both have standard errors (`aov="stderr"`), else the reason why there is no test. FLIP brightens both
    pictures by `exposure` stops.
    """
    return _vkpt.compare(_picture(a), _picture(b), exposure)


def read(path: str | os.PathLike[str], layer: str | None = None) -> npt.NDArray[np.float32]:
    """Reads any renderer's picture (EXR, HDR, PNG), or a layer of an EXR: linear RGB, shape (height, width, 3)."""
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
    """The scene as a path, or as a text in a tuple; a text has more than one line."""
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
