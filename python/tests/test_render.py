"""Pictures equal those of the command line, to the bit."""

import json
from pathlib import Path

import numpy as np
import pytest
import vkpt
from conftest import SCENE, Command

# Flags of the command line, and the same settings in Python.
SETTINGS = [
    ([], {}),
    (["--spp", "5", "--seed", "3"], {"spp": 5, "seed": 3}),
    (["--device", "cpu-f64"], {"device": "cpu-f64"}),
    (["--device", "0"], {"device": 0}),
    (["--integrator", "bidirectional"], {"integrator": "bidirectional"}),
    (["--radiance-scaling", "off"], {"radiance_scaling": False}),
    (["--size", "20x10", "--crop", "2,3,11,9"], {"size": (20, 10), "crop": (2, 3, 11, 9)}),
    (["--roulette", "0.8", "--max-depth", "3"], {"roulette": 0.8, "max_depth": 3}),
    (
        ["--aov", "stderr,albedo,depth,light:EL"],
        {"aov": ["stderr", "albedo", "depth", "light:EL"]},
    ),
]  # fmt: skip


@pytest.mark.parametrize(("words", "settings"), SETTINGS)
def test_the_file_is_the_command_lines(
    scene: Path, command: Command, words: list[str], settings: dict[str, object]
) -> None:
    run = command("scene.txt", *words, "-o", "theirs.exr", "-o", "theirs.png")
    assert run.returncode == 0, run.stderr
    picture = vkpt.render(scene, progress=False, **settings)  # type: ignore[arg-type]
    for ending in ["exr", "png"]:
        picture.save(scene.with_name(f"ours.{ending}"))
        ours, theirs = (vkpt.read(scene.with_name(f"{who}.{ending}")) for who in ("ours", "theirs"))
        assert np.array_equal(ours, theirs)
    assert np.array_equal(picture.rgb, vkpt.read(scene.with_name("theirs.exr")))
    for name in picture.layers:
        layer = vkpt.read(scene.with_name("theirs.exr"), layer=name)
        ours_layer = picture.layers[name]
        if ours_layer.ndim == 2:
            ours_layer = np.repeat(ours_layer[..., None], 3, axis=2)
        assert np.array_equal(ours_layer, layer), name
    if picture.stderr is not None:
        theirs_stderr = vkpt.read(scene.with_name("theirs-stderr.exr"))
        assert np.array_equal(picture.stderr, theirs_stderr)


def test_the_bytes_are_the_command_lines_where_the_scene_has_one_name(
    scene: Path, command: Command, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(scene.parent)
    assert command("scene.txt", "-o", "theirs.exr", "--aov", "albedo").returncode == 0
    vkpt.render("scene.txt", aov="albedo", progress=False).save("ours.exr")
    assert Path("ours.exr").read_bytes() == Path("theirs.exr").read_bytes()
    # That other samples are noticed:
    vkpt.render("scene.txt", aov="albedo", seed=1, progress=False).save("ours.exr")
    assert Path("ours.exr").read_bytes() != Path("theirs.exr").read_bytes()


def test_the_record_is_that_of_json(scene: Path, command: Command) -> None:
    run = command("scene.txt", "-o", "a.exr", "--quiet", "--json", "-")
    theirs = json.loads(run.stdout)
    ours = vkpt.render(scene, progress=False).record
    assert ours.keys() == theirs.keys()
    for part in ["size", "spp", "ended", "seed", "settings", "samples", "rays"]:
        assert ours[part] == theirs[part], part
    assert [e["rel_mse"] for e in ours["error"]] == [e["rel_mse"] for e in theirs["error"]]


def test_a_text_and_a_path_are_the_same_scene(scene: Path) -> None:
    pictures = [vkpt.render(s, progress=False) for s in (scene, str(scene), SCENE)]
    for picture in pictures[1:]:
        assert np.array_equal(picture.rgb, pictures[0].rgb)


def test_pixels_are_shared_and_cannot_be_written_to(scene: Path) -> None:
    picture = vkpt.render(scene, progress=False)
    assert (picture.rgb.shape, picture.rgb.dtype) == ((30, 40, 3), np.float32)
    assert picture.rgb is picture.rgb
    assert not picture.rgb.flags.owndata, "a view of vkpt's own memory"
    with pytest.raises(ValueError, match="read-only"):
        picture.rgb[0, 0] = 0


def test_a_picture_knows_its_error(scene: Path) -> None:
    picture = vkpt.render(scene, spp=64, progress=False)
    assert [error.spp for error in picture.errors] == [1, 2, 4, 8, 16, 32, 64]
    assert picture.errors[0].rel_mse is None, "one sample gives no estimate of its error"
    error = picture.error
    assert error is not None and error.rel_mse is not None
    assert error.low is not None and error.high is not None
    assert error.low < error.rel_mse < error.high
    # Compared with a picture of many more samples with another seed.
    truth = vkpt.render(scene, spp=4096, seed=1, progress=False)
    assert error.low / 2 < vkpt.compare(picture, truth)["rel_mse"] < error.high * 2


def test_what_ends_a_rendering(scene: Path) -> None:
    assert vkpt.render(scene, progress=False).ended == "complete"
    assert vkpt.render(scene, time=0.2, progress=False).ended == "time"
    picture = vkpt.render(scene, target_error=1e-2, progress=False)
    assert picture.ended == "target-error"
    assert picture.error is not None and picture.error.high is not None
    assert picture.error.high < 1e-2


def test_what_says_nothing_is_left_out(scene: Path) -> None:
    plain = vkpt.render(scene, progress=False)
    nothing = vkpt.render(scene, time=None, aov=[], strict=False, denoise=False, progress=False)  # type: ignore[arg-type]
    assert np.array_equal(plain.rgb, nothing.rgb)
    assert nothing.layers == {}


def test_progress_is_shown(scene: Path) -> None:
    seen: list[tuple[float, str]] = []
    vkpt.render(scene, time=0.5, progress=lambda part, words: seen.append((part, words)))
    assert seen and all(0 <= part <= 1 for part, _ in seen)
    assert "samples per pixel" in seen[-1][1]

    def broken(part: float, words: str) -> None:
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        vkpt.render(scene, time=60, progress=broken)


def test_a_notebook_shows_the_picture(scene: Path) -> None:
    png = vkpt.render(scene, spp=1, progress=False)._repr_png_()
    assert png.startswith(b"\x89PNG\r\n\x1a\n")
