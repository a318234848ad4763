"""Whether two sets of pictures have the same mean: a test of blocks."""

import numpy as np
from scipy.stats import norm, t

ALPHA = 1e-3
BLOCKS = 10
# The most by which rounding to single precision may separate two means without noise, relative to them.
ROUNDING = 2.0**-18


def means(pictures):
    """Means of BLOCKS x BLOCKS blocks: pictures x blocks x channels."""
    rows = [np.array_split(picture, BLOCKS, axis=0) for picture in pictures]
    blocks = [[np.array_split(row, BLOCKS, axis=1) for row in picture] for picture in rows]
    return np.array([[[b.mean((0, 1)) for b in row] for row in picture] for picture in blocks]).reshape(len(pictures), -1, 3)


def z_scores(ours, theirs):
    """One z a block and channel, of the same probability as Welch's t-test over the pictures of either side."""
    a, b = means(ours), means(theirs)
    squares = [x.var(0, ddof=1) / len(x) for x in (a, b)]
    floor = (ROUNDING * np.abs(b.mean(0))) ** 2 + 1e-30
    variance = squares[0] + squares[1] + floor
    freedom = variance**2 / ((squares[0] ** 2) / (len(a) - 1) + (squares[1] ** 2) / (len(b) - 1) + 1e-60)
    score = (a.mean(0) - b.mean(0)) / np.sqrt(variance)
    return np.sign(score) * norm.isf(np.maximum(t.sf(np.abs(score), freedom), 1e-300))


def bound():
    """The bound that the largest of all |z| stays below with probability 1 - ALPHA (Sidak)."""
    tests = 3 * BLOCKS**2
    return norm.isf(0.5 * -np.expm1(np.log1p(-ALPHA) / tests))
