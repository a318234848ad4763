"""vkpt and Mitsuba: each renders a seed and tells the seconds, without those of compiling."""

import json
import subprocess
import tempfile
import time
from pathlib import Path

import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_rgb")
import drjit as dr  # after the variant is chosen


def read(path):
    """A picture's linear RGB."""
    picture = mi.Bitmap(str(path))
    return np.array(picture.convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.Float32, False), dtype=np.float64)


class Vkpt:
    """A scene's text, rendered in the folder where its meshes are."""

    def __init__(self, program, scene, text, size, roulette):
        self.program, self.folder, self.text = str(Path(program).resolve()), scene.parent, text
        self.size, self.roulette = size, roulette

    def render(self, spp, seed):
        with tempfile.TemporaryDirectory() as folder:
            picture, report = Path(folder, "a.exr"), Path(folder, "a.json")
            flags = ["--quiet", "--size", self.size, "--spp", spp, "--seed", seed, "--integrator", "path"]
            flags += ["--roulette", self.roulette, "-o", picture, "--json", report]
            command = [self.program, "-", *map(str, flags)]
            subprocess.run(command, input=self.text, text=True, cwd=self.folder, check=True, stderr=subprocess.DEVNULL)
            return read(picture), json.loads(report.read_text())["seconds"]["render"]


class Mitsuba:
    """The same scene by `vkpt export`; its first picture is spent on compiling."""

    def __init__(self, program, scene, size, spp):
        with tempfile.TemporaryDirectory() as folder:
            xml = Path(folder, "scene.xml")
            command = [program, "export", scene, "--to", "mitsuba", "--size", size, "-o", xml]
            subprocess.run([str(word) for word in command], check=True)
            self.has_media = "volpathmis" in xml.read_text()
            self.scene = mi.load_file(str(xml))
        self.render(spp, 2**31 - 1)

    def render(self, spp, seed):
        start = time.perf_counter()
        picture = mi.render(self.scene, spp=spp, seed=seed)
        dr.eval(picture)
        dr.sync_thread()
        seconds = time.perf_counter() - start
        return np.array(picture, dtype=np.float64), seconds
