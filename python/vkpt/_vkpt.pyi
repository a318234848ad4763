import os
from collections.abc import Callable, Iterator, Sequence
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

__version__: str

Array: TypeAlias = npt.NDArray[np.float32]
Progress: TypeAlias = Callable[[float, str], object] | None

class ErrorAt:
    """The estimated error of a picture at one time."""

    @property
    def spp(self) -> int:
        """Samples per pixel at that time."""
    @property
    def seconds(self) -> float:
        """Seconds of rendering until then."""
    @property
    def rel_mse(self) -> float | None:
        """Mean of (x - r)^2/(r^2 + 0.01) over pixels and channels, r the truth; `None` for one sample."""
    @property
    def low(self) -> float | None:
        """Lower end of its 95 % interval; `None` if most of the error is in a few pixels."""
    @property
    def high(self) -> float | None:
        """Upper end of its 95 % interval."""

class Picture:
    """A picture, its layers, and how it was rendered. Its arrays are read-only."""

    @property
    def rgb(self) -> Array:
        """Linear radiance in W/(sr m2), shape (height, width, 3), row 0 at the top. Not a copy."""
    @property
    def stderr(self) -> Array | None:
        """Standard errors of `rgb`, of the same shape: with `aov="stderr"`."""
    @property
    def denoised(self) -> Array | None:
        """The denoised picture, of the same shape: with `denoise=True`."""
    @property
    def layers(self) -> dict[str, Array]:
        """Layers by their EXR names, shape (height, width) or (height, width, n): with `aov=["albedo", "depth"]`."""
    @property
    def error(self) -> ErrorAt | None:
        """The estimated error of the picture."""
    @property
    def errors(self) -> list[ErrorAt]:
        """The same after 1, 2, 4 ... samples per pixel and after the last."""
    @property
    def seconds(self) -> float:
        """Seconds of rendering, without reading and compiling; `record["seconds"]` has all."""
    @property
    def spp(self) -> int:
        """Samples per pixel."""
    @property
    def ended(self) -> str | None:
        """`complete`, `time`, `target-error` or `interrupted`; `None` if more samples follow."""
    @property
    def device(self) -> str:
        """The name of the device."""
    @property
    def warnings(self) -> list[str]:
        """Warnings about the scene."""
    @property
    def record(self) -> dict[str, Any]:
        """The contents of `vkpt SCENE --json FILE`."""
    def save(self, path: str | os.PathLike[str], exposure: float = 0.0) -> None:
        """Writes the file that the command line would write: .exr and .hdr linear, .png brightened by `exposure` stops."""
    def png(self, exposure: float = 0.0) -> bytes:
        """The bytes of a PNG, brightened by `exposure` stops."""
    def _repr_png_(self) -> bytes: ...

class Growing(Iterator[Picture]):
    def __new__(cls, scene: Any, words: Sequence[str], pause: float) -> Growing: ...
    def __iter__(self) -> Growing: ...
    def __next__(self) -> Picture: ...

def render(scene: Any, words: Sequence[str], progress: Progress) -> Picture: ...
def converge(scene: Any, words: Sequence[str], progress: Progress) -> str: ...
def compare(a: Any, b: Any, exposure: float) -> dict[str, Any]: ...
def read(path: str, layer: str | None) -> Array: ...
def run(words: Sequence[str]) -> int: ...
def command_flags() -> dict[str, dict[str, bool]]: ...
