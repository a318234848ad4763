"""Scenes that a program builds."""

from pathlib import Path

import numpy as np
import pytest
import vkpt

CUBE = np.array([[x, y, z] for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
# Two triangles a side, counterclockwise from outside.
SIDES = [
    [0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
    [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3],
]  # fmt: skip


def start() -> vkpt.Scene:
    return vkpt.Scene(40, 30).camera(eye=(3, -4, 2.5), target=(0.5, 0.5, 0.5), fov=30).background((0.5, 0.6, 0.7))


def test_each_method_is_a_line() -> None:
    scene = (
        vkpt.Scene(4, 3)
        .camera((0, 0, 5), orientation="x 90 z 30", fov=90)
        .lens(0.1, 5)
        .background(0.5)
        .background("sky.hdr", scale=2, orientation="x 90")
        .fresnel("exact")
        .distribution("beckmann")
        .diffuse(0.5)
        .mirror()
        .gloss((0.9, 0.8, 0.7), 0.2)
        .glass(ior=3, kt=(0.9, 0.5, 0.9), alpha=0.1)
        .sphere((1, 2, 3), 4)
        .light(2)
        .box((0, 0, 0), (1, 1, -1))
        .cylinder((0, 0, 0), (0, 0, 1), 0.25)
        .mesh("a b.ply", translate=(1, 0, 0), scale=2, orientation=(1, 0, 0, 0))
        .line("# as it stands")
    )
    assert scene.text.splitlines() == [
        "screen 4 3",
        "camera 0.0 0.0 5.0 0.9999999999999999 x 90 z 30",
        "lens 0.1 5.0",
        "background 0.5 0.5 0.5",
        "background sky.hdr 2.0 x 90",
        "fresnel exact",
        "distribution beckmann",
        "brdf 0.5 0.5 0.5 0.0 0.0 0.0 1.0",
        "brdf 0.0 0.0 0.0 1.0 1.0 1.0 0.0",
        "brdf 0.0 0.0 0.0 0.9 0.8 0.7 0.2",
        "brdf 0.0 0.0 0.0 0.25 0.25 0.25 0.1 0.9 0.5 0.9 3.0",
        "sphere 1.0 2.0 3.0 4.0",
        "light 2.0 2.0 2.0",
        "box 0.0 0.0 0.0 1.0 1.0 -1.0",
        "cylinder 0.0 0.0 0.0 0.0 0.0 1.0 0.25",
        "mesh a b.ply 1.0 0.0 0.0 2.0 q 1.0 0.0 0.0 0.0",
        "# as it stands",
    ]


@pytest.mark.parametrize(
    ("eye", "target", "up"),
    [
        ((3, -4, 2), (0, 0, 0), (0, 0, 1)),
        ((0, 0, 5), (0, 0, 0), (0, 1, 0)),
        ((0, 0, -5), (0, 0, 0), (0, 1, 0)),
        ((4, 0, 0), (0, 0, 0), (0, 0, 1)),
    ],
)
def test_the_camera_looks_at_its_target(eye: tuple[float, ...], target: tuple[float, ...], up: tuple[float, ...]) -> None:
    """A lamp at the target is in the middle, one above it is above the middle."""
    above = np.add(target, np.multiply(up, 0.8))
    scene = (
        vkpt.Scene(41, 41)
        .camera(eye, target, up=up, fov=60)
        .light((1, 0, 0))
        .sphere(target, 0.2)
        .light((0, 1, 0))
        .sphere(above, 0.2)
    )
    rgb = vkpt.render(scene, spp=4, progress=False).rgb
    rows, columns = np.nonzero(rgb[..., 0])
    assert (rows.mean(), columns.mean()) == pytest.approx((20, 20), abs=0.5)
    rows, columns = np.nonzero(rgb[..., 1])
    assert columns.mean() == pytest.approx(20, abs=0.5) and rows.mean() < 15


def test_a_mesh_of_arrays_is_the_box() -> None:
    box = start().diffuse(0.7).box((0, 0, 0), (1, 1, 1))
    mesh = start().diffuse(0.7).mesh(vertices=CUBE, faces=SIDES)
    box_picture, mesh_picture = (vkpt.render(scene, spp=256, aov="stderr", progress=False) for scene in (box, mesh))
    assert vkpt.compare(mesh_picture, box_picture)["z_test_passes"]
    # That a mesh of another size is noticed:
    other = start().diffuse(0.7).mesh(vertices=0.9 * CUBE, faces=SIDES)
    other_picture = vkpt.render(other, spp=256, aov="stderr", progress=False)
    assert not vkpt.compare(other_picture, box_picture)["z_test_passes"]


def test_a_scene_is_saved_with_its_meshes(tmp_path: Path) -> None:
    scene = start().diffuse(0.7).mesh(vertices=CUBE, faces=SIDES)
    scene.save(tmp_path / "scene.txt")
    saved = vkpt.render(tmp_path / "scene.txt", progress=False)
    assert np.array_equal(saved.rgb, vkpt.render(scene, progress=False).rgb)


def test_a_colour_has_three_channels() -> None:
    with pytest.raises(ValueError, match="three numbers"):
        start().diffuse((0.5, 0.5))


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"vertices": CUBE}, "either a file, or vertices and faces"),
        ({"vertices": CUBE, "faces": [[0, 1, 8]]}, "vertices from 0 to 7"),
        ({"vertices": CUBE[:, :2], "faces": SIDES}, r"shape \(n, 3\)"),
        ({"vertices": CUBE, "faces": SIDES, "normals": CUBE[:3]}, "a normal for each"),
    ],
)
def test_arrays_that_are_no_mesh(wrong: dict[str, object], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        start().mesh(**wrong)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="whole numbers"):
        start().mesh(vertices=CUBE, faces=np.array(SIDES) + 0.5)
