"""Convergence and comparison, against the command line and against NumPy."""

import json
from pathlib import Path

import numpy as np
import pandas
import pytest
import vkpt
from conftest import SCENE, Command


def test_a_comparison_has_the_numbers_of_its_definitions() -> None:
    a = vkpt.render(SCENE, spp=4, progress=False).rgb
    b = vkpt.render(SCENE, spp=64, seed=1, progress=False).rgb
    found = vkpt.compare(a, b)
    x, r = a.astype(float), b.astype(float)
    assert found["mse"] == pytest.approx(np.mean((x - r) ** 2), rel=1e-12)
    relative = np.mean((x - r) ** 2 / (r**2 + 0.01))
    assert found["rel_mse"] == pytest.approx(relative, rel=1e-12)
    smape = np.mean(np.abs(x - r) / (np.abs(x) + np.abs(r) + 0.01))
    assert found["smape"] == pytest.approx(smape, rel=1e-12)
    assert found["mean_a"] == pytest.approx(x.mean(axis=(0, 1)), rel=1e-12)
    assert vkpt.compare(a, a)["mse"] == 0


def test_pictures_files_and_arrays_compare_alike(scene: Path, tmp_path: Path) -> None:
    a, b = (vkpt.render(scene, seed=seed, aov="stderr", progress=False) for seed in (0, 1))
    a.save(tmp_path / "a.exr")
    b.save(tmp_path / "b.exr")
    pictures = vkpt.compare(a, b)
    files = vkpt.compare(tmp_path / "a.exr", str(tmp_path / "b.exr"))
    arrays = vkpt.compare(a.rgb, b.rgb)
    for metric in ["mse", "rel_mse", "flip", "smape_without_worst"]:
        assert pictures[metric] == files[metric] == arrays[metric]
    assert pictures["z_test_passes"]
    assert files["z_test_passes"] is None and "standard errors" in files["z_test_lacks"]
    for array in [a.rgb[..., :2], a.rgb[..., 0]]:
        with pytest.raises(ValueError, match=r"shape \(height, width, 3\)"):
            vkpt.compare(array, b)
    with pytest.raises(vkpt.ArgumentError, match="finite"):
        vkpt.compare(a, b, exposure=float("nan"))


def test_an_experiment_is_that_of_json(scene: Path, command: Command) -> None:
    ours = vkpt.converge(
        scene,
        time=1,
        vary={"connect": ["mis", "light"]},
        device="cpu-f32",
        replicates=4,
        progress=False,
    )
    run = command(
        "converge", "scene.txt", "--time", "1", "--vary", "connect=mis,light",
        "--device", "cpu-f32", "--replicates", "4", "--quiet", "--json", "-",
    )  # fmt: skip
    theirs = json.loads(run.stdout)
    assert ours.keys() == theirs.keys()
    assert [v["name"] for v in ours["variants"]] == [v["name"] for v in theirs["variants"]]
    # Each step's pictures are the same: so are their distances from the same reference.
    ours_steps, theirs_steps = (r["variants"][0]["steps"] for r in (ours, theirs))
    assert ours_steps[0]["spp"] == theirs_steps[0]["spp"] == 1
    table = pandas.json_normalize(ours_steps)
    assert len(table) == len(ours_steps) and table["spp"].tolist() == [2**k for k in range(len(table))]


def test_settings_are_varied_by_their_names_in_python() -> None:
    vary = {"radiance_scaling": [True, False]}
    result = vkpt.converge(SCENE, time=0.2, vary=vary, device="cpu-f32", progress=False)
    names = [variant["name"] for variant in result["variants"]]
    assert names == ["radiance-scaling=on", "radiance-scaling=off"]
