"""vkpt, Mitsuba and pbrt: each renders a seed and returns the seconds, for vkpt and Mitsuba without those of compiling."""

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
    """A scene that cannot be exported to the other program, and why."""


def export(program, scene, text, size, to, peer):
    """Writes the scene in the peer's format; returns vkpt's messages."""
    command = [program, "export", "-", "--to", peer, "--size", size, "-o", to]
    run = subprocess.run([str(word) for word in command], input=text, text=True, cwd=scene.parent, capture_output=True)
    if run.returncode == 3:
        raise Refused("; ".join(run.stderr.replace("error: <stdin>:", "line ").split("\n")[:-1]))
    run.check_returncode()
    return run.stderr


class Vkpt:
    """A scene's text, rendered in the folder of its meshes, by the faster of a CPU's driver and the reference.

    vkpt's own choice counts the seconds of compiling, which are excluded here; the bits are the same.
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
    """The same scene from `vkpt export`; its first picture only compiles."""

    def __init__(self, options, scene, text, size):
        with tempfile.TemporaryDirectory() as folder:
            xml = Path(folder, "scene.xml")
            export(options.vkpt, scene, text, size, xml, "mitsuba")
            # Mitsuba's roulette is right without media (README.md), and then the same as vkpt's.
            self.roulette = "off" if "volpathmis" in xml.read_text() else "throughput"
            self.scene = mi.load_file(str(xml))
        self.render(options.spp, 2**31 - 1)

    def render(self, spp, seed):
        start = time.perf_counter()
        picture = mi.render(self.scene, spp=spp, seed=seed)
        dr.eval(picture)
        dr.sync_thread()
        seconds = time.perf_counter() - start
        return np.array(picture, dtype=np.float64), seconds


class Pbrt:
    """The same scene from `vkpt export --to pbrt`, with a process for each picture."""

    roulette = "throughput"

    def __init__(self, options, scene, text, size):
        self.program = str(options.pbrt.resolve())
        self.folder = tempfile.TemporaryDirectory()
        self.scene = Path(self.folder.name, "scene.pbrt")
        export(options.vkpt, scene, text, size, self.scene, "pbrt")

    def render(self, spp, seed):
        with tempfile.TemporaryDirectory() as folder:
            picture = Path(folder, "a.exr")
            command = [self.program, "--quiet", "--seed", seed, "--spp", spp, "--outfile", picture, self.scene]
            start = time.perf_counter()
            subprocess.run([str(word) for word in command], check=True)
            return read(picture), time.perf_counter() - start
