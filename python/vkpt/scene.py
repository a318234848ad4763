"""Scenes built by a program: each method adds a line of the scene language and returns the scene."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from . import _ply

Vector = Sequence[float]
Color = float | Sequence[float]
Orientation = str | Sequence[float] | None


class Scene:
    """A scene of `width` by `height` pixels.

    A material or light applies to the shapes that follow it, up to the next one. Lengths are in units of the scene,
    radiance is in W/(sr m2) of linear RGB; a colour is three numbers, or one for all of them. `text` is the text of the
    scene file.

    >>> scene = (
    ...     Scene(400, 300)
    ...     .camera(eye=(0, -4, 1), target=(0, 0, 0), fov=40)
    ...     .background(0.5)
    ...     .glass(ior=1.5, kt=(0.9, 0.5, 0.9), alpha=0.1)
    ...     .sphere((0, 0, 0), 1)
    ... )
    """

    def __init__(self, width: int, height: int) -> None:
        self._lines = [f"screen {width} {height}"]
        self._meshes: dict[str, bytes] = {}

    @property
    def text(self) -> str:
        """The scene file."""
        return "\n".join(self._lines) + "\n"

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return f"<vkpt.Scene of {len(self._lines)} lines>"

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the scene file, and next to it a PLY file for each mesh that was given as arrays."""
        path = Path(path)
        for name, ply in self._meshes.items():
            path.with_name(name).write_bytes(ply)
        path.write_text(self.text, encoding="utf-8")

    def line(self, text: str) -> Scene:
        """Adds a line of the scene language verbatim."""
        self._lines.append(text)
        return self

    # View and background.

    def camera(
        self,
        eye: Vector,
        target: Vector | None = None,
        *,
        up: Vector = (0, 0, 1),
        fov: float = 40,
        orientation: Orientation = None,
    ) -> Scene:
        """Looks from `eye` to `target`; `fov` is the vertical field of view in degrees.

        Instead of `target`, `orientation` turns a camera that looks along -Z with Y up: words such as "x 90 z 30", or a
        quaternion (w, x, y, z).
        """
        if (target is None) == (orientation is None):
            raise ValueError("a camera takes either a target or an orientation")
        if target is not None:
            orientation = _looking(eye, target, up)
        half = math.tan(math.radians(fov) / 2)
        return self._add("camera", eye, half, _oriented(orientation))

    def lens(self, radius: float, focus: float) -> Scene:
        """A thin lens of that radius; points at the distance `focus` along the view are sharp."""
        return self._add("lens", radius, focus)

    def background(
        self,
        what: Color | str | os.PathLike[str],
        *,
        scale: float = 1,
        orientation: Orientation = None,
    ) -> Scene:
        """Radiance from outside the scene: a colour, or a picture in latitude and longitude (EXR or HDR)."""
        if isinstance(what, (str, os.PathLike)):
            name = os.fspath(what)
            return self._add("background", name, scale, _oriented(orientation))
        return self._add("background", _color(what))

    # Materials.

    def light(self, radiance: Color) -> Scene:
        """An emitter of that radiance, black otherwise."""
        return self._add("light", _color(radiance))

    def diffuse(self, kd: Color) -> Scene:
        """Lambert's surface of albedo `kd`."""
        return self.brdf(kd, 0, 1)

    def mirror(self, ks: Color = 1) -> Scene:
        """A smooth mirror that reflects `ks` at normal incidence."""
        return self.brdf(0, ks, 0)

    def gloss(self, ks: Color, alpha: float, kd: Color = 0) -> Scene:
        """A rough mirror: `alpha` up to 1 is a width, above 1 a Phong exponent."""
        return self.brdf(kd, ks, alpha)

    def glass(
        self,
        ior: float = 1.5,
        kt: Color = 1,
        alpha: float = 0,
        ks: Color | None = None,
    ) -> Scene:
        """Glass with the transmittance `kt` per unit of length; `ks` is its reflectance at normal incidence, by default
        from its index of refraction.
        """
        if ks is None:
            ks = ((ior - 1) / (ior + 1)) ** 2
        return self.brdf(0, ks, alpha, kt, ior)

    def brdf(
        self,
        kd: Color,
        ks: Color,
        alpha: float,
        kt: Color | None = None,
        ior: float = 1,
    ) -> Scene:
        """Any material: colours of diffuse, specular and transmitted light, roughness, index of refraction."""
        glass = [] if kt is None else [_color(kt), ior]
        return self._add("brdf", _color(kd), _color(ks), alpha, *glass)

    def distribution(self, name: str) -> Scene:
        """Micro-normals of the materials that follow: auto, phong, beckmann or ggx."""
        return self._add("distribution", name)

    def fresnel(self, form: str) -> Scene:
        """Reflectance of the materials that follow: schlick or exact."""
        return self._add("fresnel", form)

    # Shapes.

    def sphere(self, center: Vector, radius: float) -> Scene:
        """A sphere by its centre and radius."""
        return self._add("sphere", center, radius)

    def box(self, corner: Vector, diagonal: Vector) -> Scene:
        """Axis-aligned, from one corner to that at `corner` + `diagonal`."""
        return self._add("box", corner, diagonal)

    def cylinder(self, base: Vector, axis: Vector, radius: float) -> Scene:
        """A closed cylinder: the centre of its base, and the vector from there to the centre of its top."""
        return self._add("cylinder", base, axis, radius)

    def mesh(
        self,
        file: str | os.PathLike[str] | None = None,
        *,
        vertices: Any = None,
        faces: Any = None,
        normals: Any = None,
        translate: Vector = (0, 0, 0),
        scale: float = 1,
        orientation: Orientation = None,
    ) -> Scene:
        """Triangles from a file (OBJ, PLY, glTF), or from arrays.

        `vertices` has the shape (n, 3), `faces` the shape (m, 3): indices of vertices, counterclockwise seen from outside.
        `normals`, shading normals, has the shape (n, 3). A mesh is turned, then scaled, then moved.
        """
        if (file is None) == (vertices is None or faces is None):
            raise ValueError("a mesh takes either a file, or vertices and faces")
        if file is None:
            name = f"mesh-{len(self._meshes) + 1}.ply"
            self._meshes[name] = _ply.encoded(vertices, faces, normals)
        else:
            name = os.fspath(file)
        return self._add("mesh", name, translate, scale, _oriented(orientation))

    def _add(self, command: str, *parts: Any) -> Scene:
        return self.line(" ".join([command, *map(_words, parts)]).rstrip())


def _words(part: Any) -> str:
    if isinstance(part, str):
        return part
    # Up to seventeen digits: the fewest that give the same number.
    return " ".join(repr(float(x)) for x in np.atleast_1d(part))


def _color(color: Color) -> Sequence[float]:
    channels = np.atleast_1d(np.asarray(color, float))
    if channels.shape not in [(1,), (3,)]:
        raise ValueError(f"a colour is three numbers, or one for all of them, not {color}")
    return np.broadcast_to(channels, 3).tolist()  # type: ignore[no-any-return]


def _oriented(orientation: Orientation) -> str:
    if orientation is None or isinstance(orientation, str):
        return orientation or ""
    return "q " + _words(orientation)


def _looking(eye: Vector, target: Vector, up: Vector) -> Sequence[float]:
    """The quaternion that turns -Z to the target and Y to `up`, as far as that is perpendicular."""
    z = _unit(np.subtract(eye, target), "eye and target are the same point")
    x = _unit(np.cross(up, z), "the camera looks along `up`")
    y = np.cross(z, x)
    # The eigenvector of the largest eigenvalue of Bar-Itzhack's matrix (New method for extracting the quaternion from a
    # rotation matrix, 2000) is (x, y, z, w).
    (a, b, c), (d, e, f), (g, h, i) = np.column_stack([x, y, z])
    k = np.array(
        [
            [a - e - i, d + b, g + c, h - f],
            [d + b, e - a - i, h + f, c - g],
            [g + c, h + f, i - a - e, d - b],
            [h - f, c - g, d - b, a + e + i],
        ]
    )
    qx, qy, qz, qw = np.linalg.eigh(k)[1][:, -1]
    return (qw, qx, qy, qz)


def _unit(v: Any, wrong: str) -> Any:
    length = np.linalg.norm(v)
    if not length > 0:
        raise ValueError(wrong)
    return v / length
