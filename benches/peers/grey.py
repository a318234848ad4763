"""A scene without colours: pbrt's spectra are the same at all wavelengths then, and their products those of RGB."""

# Where the colours of a command begin.
COLOURS = {"brdf": (1, 4, 8), "light": (1,), "background": (1,)}


def _mean(words, first):
    """The words with the mean of three in place of each."""
    three = words[first : first + 3]
    # Of a picture of the surroundings there is a name.
    if len(three) < 3 or not all(word.replace(".", "").isdigit() for word in three):
        return words
    mean = repr(sum(map(float, three)) / 3)
    return [*words[:first], mean, mean, mean, *words[first + 3 :]]


def grey(text):
    """The text with grey in place of each colour."""
    lines = []
    for line in text.splitlines():
        words = line.split()
        for first in COLOURS.get(words[0] if words else "", ()):
            words = _mean(words, first)
        lines.append(" ".join(words))
    return "\n".join(lines) + "\n"
