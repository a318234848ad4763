#!/usr/bin/env python3
"""Writes the pictures of this folder by programs other than vkpt: EXR by the OpenEXR library, PNG by Pillow and OpenCV,
HDR by OpenCV. Their values are closed forms, which tests/library/image/films.rs computes again.

    pip install OpenEXR==3.5.3 pillow==13.0.0 opencv-python-headless numpy
    python3 tests/data/image/make.py
"""

from pathlib import Path

import cv2
import numpy as np
import OpenEXR
from PIL import Image, ImageCms, PngImagePlugin

HERE = Path(__file__).parent
W, H = 6, 5
X, Y = np.meshgrid(np.arange(W), np.arange(H))
V = 1 + X + 16 * Y  # 1 to 70: each pixel another

# In half, exact: powers of two times a small number, blue negative.
HALF = np.stack([V / 64, V * 4, V / -1024], axis=-1).astype(np.float16)
# In float, each rounded once.
FLOAT = np.stack([V.astype(np.float32) / d for d in (3, 7, -1000)], axis=-1)
assert FLOAT.dtype == np.float32
# One value in 4×4 pixels, which B44 keeps.
FLAT = np.stack([(1 + X // 4 + 2 * (Y // 4)) / d for d in (4, 1, -8)], axis=-1).astype(np.float16)


def exr(name, header, channels):
    header = {"compression": OpenEXR.ZIPS_COMPRESSION, "type": OpenEXR.scanlineimage} | header
    # C order: the library takes a channel's rows as they lie in memory.
    channels = {k: np.ascontiguousarray(v) for k, v in channels.items()}
    OpenEXR.File(header, channels).write(str(HERE / f"{name}.exr"))


def named(pixels, prefix=""):
    return {prefix + c: pixels[..., i] for i, c in enumerate("RGB")}


def exrs():
    alpha = {"A": np.full((H, W), 0.5, np.float16)}
    for compression in ["no", "rle", "zips", "zip", "piz", "pxr24"]:
        value = getattr(OpenEXR, f"{compression.upper()}_COMPRESSION")
        exr(f"half-rgba-{compression}", {"compression": value}, named(HALF) | alpha)
        exr(f"float-rgb-{compression}", {"compression": value}, named(FLOAT))
    for compression in ["b44", "b44a"]:
        value = getattr(OpenEXR, f"{compression.upper()}_COMPRESSION")
        exr(f"flat-half-{compression}", {"compression": value}, named(FLAT))
    # These are lossy: what the library reads again stands beside them. Large enough to be worth compressing.
    x, y = np.meshgrid(np.arange(20), np.arange(18))
    smooth = np.stack([np.sin(x / 5) + 1.5, np.cos(y / 4) + 2, (x + y) / 16 + 1], axis=-1).astype(np.float16)
    for compression in ["b44", "dwaa", "dwab", "htj2k32"]:
        value = getattr(OpenEXR, f"{compression.upper()}_COMPRESSION")
        exr(f"smooth-{compression}", {"compression": value}, named(smooth))
        read = OpenEXR.File(str(HERE / f"smooth-{compression}.exr"), separate_channels=True).channels()
        read = {c: read[c].pixels for c in "RGB"}
        if compression != "htj2k32":
            exr(f"smooth-{compression}-read", {"compression": OpenEXR.ZIP_COMPRESSION}, read)

    depth = {"depth.Z": np.ones((H, W), np.float32)}
    exr("layer-color", {}, named(FLOAT, "color.") | depth)
    exr("layers-two", {}, named(FLOAT, "diffuse.") | named(FLOAT, "specular."))
    exr("layers-and-plain", {}, named(FLOAT) | named(2 * FLOAT, "direct."))
    exr("half-and-float", {}, {"R": HALF[..., 0], "G": FLOAT[..., 1], "B": FLOAT[..., 2]})

    tiles = OpenEXR.TileDescription()
    tiles.xSize = tiles.ySize = 4
    exr("tiled", {"type": OpenEXR.tiledimage, "tiles": tiles}, named(FLOAT))
    exr("decreasing", {"lineOrder": OpenEXR.DECREASING_Y}, named(FLOAT))

    def window(x, y, w, h):
        return (np.array([x, y], np.int32), np.array([x + w - 1, y + h - 1], np.int32))

    windows = {"dataWindow": window(7, -4, W, H), "displayWindow": window(5, -3, 20, 10)}
    exr("windows", windows, named(FLOAT))

    parts = [
        OpenEXR.Part({"type": OpenEXR.scanlineimage}, {"Z": np.ones((H, W), np.float32)}, "depth"),
        OpenEXR.Part({"type": OpenEXR.scanlineimage}, named(np.ascontiguousarray(FLOAT)), "beauty"),
    ]
    for part in parts:
        for channel in part.channels.values():
            channel.pixels = np.ascontiguousarray(channel.pixels)
    OpenEXR.File(parts).write(str(HERE / "parts.exr"))

    exr("only-y", {}, {"Y": HALF[..., 0], "A": HALF[..., 1]})
    exr("uint", {}, named(np.repeat(V[..., None], 3, axis=-1).astype(np.uint32)))
    bad = HALF.copy()
    bad[1, 4, 2] = np.nan
    bad[2, 0, 0] = np.inf
    bad[4, 5, 1] = -np.inf
    exr("not-finite", windows, named(bad))
    aces = (0.7347, 0.2653, 0.0, 1.0, 0.0001, -0.077, 0.32168, 0.33767)
    exr("aces", {"chromaticities": aces}, named(FLOAT))
    rec709 = (0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290)
    exr("rec709", {"chromaticities": rec709}, named(FLOAT))

    def deep(value):
        samples = np.empty((H, W), object)
        for at in np.ndindex(H, W):
            samples[at] = np.full(1 + at[1] % 2, value, np.float32)
        return samples

    deep_channels = {c: deep(v) for c, v in zip("RGBZ", (1, 2, 3, 4))}
    OpenEXR.File({"compression": OpenEXR.ZIPS_COMPRESSION, "type": OpenEXR.deepscanline}, deep_channels).write(
        str(HERE / "deep.exr")
    )


def hdrs():
    # RGBE has 8 bits for the largest channel: V is at most 70, so V·2 and V are exact beside 128.
    for name, (w, h) in {"wide": (12, 5), "narrow": (6, 5)}.items():
        x, y = np.meshgrid(np.arange(w), np.arange(h))
        v = (1 + x + 16 * y).astype(np.float32)
        rgb = np.stack([v, 128 + 0 * v, 2 * v], axis=-1)
        # Rows of less than 8 pixels have no run lengths.
        cv2.imwrite(str(HERE / f"{name}.hdr"), rgb[..., ::-1])


def png(name, image, mode=None, chunks=(), **options):
    info = PngImagePlugin.PngInfo()
    for kind, data in chunks:
        info.add(kind, data)
    Image.fromarray(image, mode).save(HERE / f"{name}.png", pnginfo=info, **options)


def pngs():
    code = (3 * V).astype(np.uint8)  # 3 to 210
    rgb = np.stack([code, 255 - code, 0 * code], axis=-1)
    alpha = np.full((H, W), 100, np.uint8)
    png("rgb8", rgb)
    png("rgba8", np.dstack([rgb, alpha]))
    png("grey8", code)
    png("grey-alpha8", np.dstack([code, alpha]))
    png("grey16", (900 * V).astype(np.uint16))
    wide = np.stack([900 * V, 65535 - V, 0 * V], axis=-1).astype(np.uint16)
    cv2.imwrite(str(HERE / "rgb16.png"), wide[..., ::-1])
    Image.fromarray((X + Y) % 2 == 0).save(HERE / "grey1.png")
    # 16 colours: 4 bits an index, 8 bits a colour.
    palette = Image.fromarray(((X + Y) % 16).astype(np.uint8), "P")
    palette.putpalette([c for i in range(16) for c in (3 * i, 255 - i, 7 * i)])
    palette.save(HERE / "palette.png", bits=4)

    number = lambda n: int(n).to_bytes(4, "big")
    bt709 = [31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000]
    p3 = [31270, 32900, 68000, 32000, 26500, 69000, 15000, 6000]
    png("gamma-srgb", rgb, chunks=[(b"gAMA", number(45455)), (b"cHRM", b"".join(map(number, bt709)))])
    png("gamma-linear", rgb, chunks=[(b"gAMA", number(100000))])
    png("primaries-p3", rgb, chunks=[(b"cHRM", b"".join(map(number, p3)))])
    png("cicp-srgb", rgb, chunks=[(b"cICP", bytes([1, 13, 0, 1]))])
    png("cicp-pq", rgb, chunks=[(b"cICP", bytes([9, 16, 0, 1]))])
    profile = ImageCms.ImageCmsProfile(ImageCms.createProfile("sRGB")).tobytes()
    png("profile", rgb[:1, :1], icc_profile=profile)


exrs()
hdrs()
pngs()
