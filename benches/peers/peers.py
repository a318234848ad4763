"""Renders scenes with vkpt and with Mitsuba or pbrt in alternation: do they agree, and how fast is each?"""

import argparse
from pathlib import Path

import numpy as np

from blocks import bound, z_scores
from grey import grey
from planted import errors
from renderers import Mitsuba, Pbrt, Refused, Vkpt

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
SCENES = sorted((ROOT / "scenes").glob("*.txt")) + sorted((HERE / "scenes").glob("*.txt"))


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scenes", nargs="*", type=Path, default=SCENES)
    parser.add_argument("--vkpt", default=ROOT / "target/release/vkpt")
    parser.add_argument("--replicates", type=int, default=16, help="pictures from each program")
    parser.add_argument("--spp", type=int, default=64, help="samples per pixel of each")
    parser.add_argument("--shrink", type=int, default=2, help="divide width and height by this")
    parser.add_argument("--pbrt", type=Path, help="compare with this program, pbrt-v4, in place of Mitsuba")
    parser.add_argument("--grey", action="store_true", help="replace the scenes' colours by grey")
    return parser.parse_args()


def size_of(text, shrink):
    """The scene's width and height, smaller."""
    line = next(line for line in text.splitlines() if line.startswith("screen"))
    return [int(side) // shrink for side in line.split()[1:3]]


def speed(pixels, seconds):
    """Million samples a second: the median, and the range."""
    rates = np.sort(pixels / np.array(seconds)) / 1e6
    return f"{np.median(rates):.2f} ({rates[0]:.2f}–{rates[-1]:.2f})"


def rel_mse(pictures, truth):
    """The mean squared error of one of them: its variance over the pictures, relative to the truth squared."""
    return np.mean(np.var(pictures, axis=0, ddof=1) / (truth**2 + 0.01))


def compare(scene, options):
    """Prints the scene's row; returns whether the programs agree and every planted error is noticed."""
    text = scene.read_text()
    if options.grey:
        text = grey(text)
    width, height = size_of(text, options.shrink)
    size, samples = f"{width}x{height}", width * height * options.spp
    try:
        theirs = (Pbrt if options.pbrt else Mitsuba)(options, scene, text, size)
    except Refused as why:
        print(f"| {scene.stem} | refused: {why} |", flush=True)
        return True
    ours = Vkpt(options.vkpt, scene, text, size, theirs.roulette)
    turns = [(ours.render(options.spp, seed), theirs.render(options.spp, seed)) for seed in range(options.replicates)]
    pictures = [[turn[side][0] for turn in turns] for side in (0, 1)]
    seconds = [[turn[side][1] for turn in turns] for side in (0, 1)]
    z = z_scores(*pictures)
    agrees = np.abs(z).max() < bound()
    row = [scene.stem, f"{np.abs(z).max():.2f}", f"{z.std():.2f}", "agree" if agrees else "DIFFER"]
    noticed = {}
    for name, wrong in errors(text).items():
        vkpt = Vkpt(options.vkpt, scene, wrong, size, theirs.roulette)
        planted = [vkpt.render(options.spp, seed)[0] for seed in range(options.replicates)]
        noticed[name] = np.abs(z_scores(planted, pictures[1])).max()
    row += [", ".join(f"{name}: {worst:.1f}" for name, worst in noticed.items())]
    truth = np.mean(pictures, axis=(0, 1))
    # Both fall as 1/samples, so their product with the seconds is the same for any number of samples.
    costs = [rel_mse(pictures[side], truth) * np.median(seconds[side]) for side in (0, 1)]
    row += [speed(samples, seconds[0]), speed(samples, seconds[1]), f"{costs[1] / costs[0]:.2f}", ours.device, theirs.roulette]
    print("| " + " | ".join(row) + " |", flush=True)
    return agrees and all(worst > bound() for worst in noticed.values())


def main():
    options = arguments()
    print(f"largest |z| of 10×10 blocks in three channels, below {bound():.2f} by chance with probability 0.999\n")
    print("| scene | largest z | deviation of z | verdict | planted errors | vkpt M samples/s | the other | its time for vkpt's error | device | roulette |")
    print("|" + "---|" * 10)
    results = [compare(scene, options) for scene in options.scenes]
    return 0 if all(results) else 1


if __name__ == "__main__":
    raise SystemExit(main())
