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


class Refused(Exception):
    """A scene that the other program cannot have, and why."""


class Vkpt:
    """A scene's text, rendered in the folder where its meshes are, by the faster of a CPU's driver and the reference.

    vkpt's own choice counts the seconds of compiling, which are left out here; the bits are the same.
    """

    DEVICES = ["llvmpipe", "cpu-f32"]

    def __init__(self, program, scene, text, size, roulette):
        self.program, self.folder, self.text = str(Path(program).resolve()), scene.parent, text
        self.size, self.roulette = size, roulette
        self.device = min(self.DEVICES, key=lambda device: self.render(16, 2**31 - 1, device)[1])

    def render(self, spp, seed, device=None):
        with tempfile.TemporaryDirectory() as folder:
            picture, report = Path(folder, "a.exr"), Path(folder, "a.json")
            flags = ["--quiet", "--size", self.size, "--spp", spp, "--seed", seed, "--integrator", "path"]
            flags += ["--device", device or self.device, "--roulette", self.roulette, "-o", picture, "--json", report]
            command = [self.program, "-", *map(str, flags)]
            subprocess.run(command, input=self.text, text=True, cwd=self.folder, check=True, stderr=subprocess.DEVNULL)
            return read(picture), json.loads(report.read_text())["seconds"]["render"]


class Mitsuba:
    """The same scene by `vkpt export`; its first picture is spent on compiling."""

    def __init__(self, program, scene, size, spp):
        with tempfile.TemporaryDirectory() as folder:
            xml = Path(folder, "scene.xml")
            command = [program, "export", scene, "--to", "mitsuba", "--size", size, "-o", xml]
            run = subprocess.run([str(word) for word in command], text=True, capture_output=True)
            if run.returncode == 3:
                raise Refused("; ".join(run.stderr.replace("error: ", "").split("\n")[:-1]))
            run.check_returncode()
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
