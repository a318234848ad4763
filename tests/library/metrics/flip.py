"""Golden numbers for LDR-FLIP: `python3 tests/library/metrics/flip.py > tests/library/metrics/flip.csv`.

Needs NVIDIA's own evaluator and NumPy; the table stands as made with flip-evaluator 1.7, NumPy 2.4.6, Python 3.11
(`pip install flip-evaluator==1.7 numpy==2.4.6`). tests/library/metrics/flip.rs has the same formulas.
"""

from importlib.metadata import version

import flip_evaluator
import numpy as np

MASK = 0xFFFFFFFF


def hashed(x, y, c):
    h = (x * 0x9E3779B1 ^ y * 0x85EBCA77 ^ c * 0xC2B2AE3D) & MASK
    h = (h ^ h >> 15) * 0x2C1B3C6D & MASK
    h = (h ^ h >> 12) * 0x297A2D39 & MASK
    return h ^ h >> 15


def ramp(x, y):
    return [4 * x, 5 * y, 2 * (x + y)]


def noisy(x, y):
    return [min(max(v + hashed(x, y, c) % 41 - 20, 0), 255) for c, v in enumerate(ramp(x, y))]


def stripes(x, y):
    return [[255, 0, 0], [0, 255, 0], [0, 0, 255], [255, 255, 0]][x // 16]


def step(x0):
    return lambda x, y: [210, 190, 170] if x < x0 else [40, 50, 60]


def grey_but(place, value):
    return lambda x, y: value if (x, y) == place else [100, 100, 100]


def flat(r, g, b):
    return lambda x, y: [r, g, b]


# Name, width, height, pixels per degree, reference, test: 8-bit sRGB codes of column x and row y.
PAIRS = [
    ("identical", 64, 48, 67, noisy, noisy),
    ("black and white", 64, 48, 67, flat(0, 0, 0), flat(255, 255, 255)),
    ("green and blue", 64, 48, 67, flat(0, 255, 0), flat(0, 0, 255)),
    ("one code brighter", 64, 48, 67, flat(100, 100, 100), flat(101, 101, 101)),
    ("noise", 64, 48, 67, ramp, noisy),
    ("noise, seen from afar", 64, 48, 150, ramp, noisy),
    ("noise, seen closely", 64, 48, 20, ramp, noisy),
    ("a shifted edge", 64, 48, 67, step(30), step(31)),
    ("a white dot", 64, 48, 67, grey_but(None, None), grey_but((20, 17), [255, 255, 255])),
    ("a dot in the corner", 64, 48, 67, grey_but(None, None), grey_but((0, 0), [255, 60, 0])),
    ("exchanged channels", 64, 48, 67, stripes, lambda x, y: stripes(x, y)[::-1]),
    ("smaller than the filters", 5, 3, 67, ramp, noisy),
]

# Columns and rows in 64ths of the width and height.
PLACES = [(0, 0), (63, 63), (31, 10), (32, 33), (20, 24), (21, 23), (47, 60), (5, 40)]


def picture(width, height, code):
    codes = [[code(x, y) for x in range(width)] for y in range(height)]
    return np.array(codes, dtype=np.float32) / np.float32(255)


def main():
    print(f"# flip-evaluator {version('flip-evaluator')}; a row without x and y is the mean")
    print("pair,width,height,pixels_per_degree,x,y,flip")
    for name, width, height, ppd, reference, test in PAIRS:
        reference, test = (picture(width, height, code) for code in (reference, test))
        errors, _, _ = flip_evaluator.evaluate(
            reference, test, "LDR", applyMagma=False, parameters={"ppd": ppd}
        )
        # Its own mean is a sum in f32, off by 3e-5 for the constant map of "black and white".
        mean = errors[:, :, 0].mean(dtype=np.float64)
        row = f'"{name}",{width},{height},{ppd}'
        print(f"{row},,,{mean:.9g}")
        for x, y in sorted({(u * width // 64, v * height // 64) for u, v in PLACES}):
            print(f"{row},{x},{y},{errors[y, x, 0]:.9g}")


if __name__ == "__main__":
    main()
