"""Scenes without colours: pbrt's spectra are then constant over all wavelengths, and their products those of RGB."""

# Where the colours of a command begin.
COLOURS = {"brdf": (1, 4, 8), "light": (1,), "background": (1,)}


def _mean(words, first):
    """The words with three of them replaced by their mean."""
    three = words[first : first + 3]
    # A picture of the surroundings has a name instead.
    if len(three) < 3 or not all(word.replace(".", "").isdigit() for word in three):
        return words
    mean = repr(sum(map(float, three)) / 3)
    return [*words[:first], mean, mean, mean, *words[first + 3 :]]


def grey(text):
    """The text with each colour replaced by grey."""
    lines = []
    for line in text.splitlines():
        words = line.split()
        for first in COLOURS.get(words[0] if words else "", ()):
            words = _mean(words, first)
        lines.append(" ".join(words))
    return "\n".join(lines) + "\n"
