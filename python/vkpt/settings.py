"""The settings of functions, for type checkers; `vkpt --help` and `vkpt converge --help` explain each."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Literal, TypedDict

Size = str | tuple[int, int]
Crop = str | tuple[int, int, int, int]


class ModelSettings(TypedDict, total=False):
    """Settings of the view, of the model and of the estimator."""

    camera: str
    size: Size
    """Width and height in pixels."""
    crop: Crop
    """x0, y0, x1, y1 from the top left; the last two are excluded."""
    strict: bool
    seed: int
    oidn: str | os.PathLike[str]
    model: Literal["handout"]
    fresnel: Literal["schlick", "exact"]
    distribution: Literal["phong", "beckmann", "ggx", "auto"]
    absorption: Literal["segment", "term"]
    radiance_scaling: bool
    max_depth: int
    integrator: Literal["path", "light", "bidirectional", "auto"]
    lobe: Literal["fresnel", "norms"]
    normals: Literal["visible", "distribution"]
    roulette: Literal["throughput", "off"] | float
    connect: Literal["mis", "light", "bsdf"]
    lights: Literal["contribution", "power"]
    sampler: Literal["random", "sobol", "sobol-quarters"]


class Settings(ModelSettings, total=False):
    """The settings of `render` and `progressive`."""

    time: float
    """Seconds of rendering."""
    target_error: float
    """relMSE."""
    aov: str | Sequence[str]
    denoise: bool | Literal["auto", "oidn", "nlm"]
    kernel: Literal["composed", "full"]


class ConvergeSettings(ModelSettings, total=False):
    """The settings of `converge`."""

    spp: int
    replicates: int
    reference: str | os.PathLike[str]
    exposure: float
