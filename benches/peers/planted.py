"""Errors for the comparison to notice: a scene's text with some numbers changed."""


def _changed(text, is_meant, change):
    """The text with the words of those lines changed."""
    lines = [line.split() for line in text.splitlines()]
    lines = [change(words) if is_meant(words) else words for words in lines]
    return "\n".join(" ".join(words) for words in lines) + "\n"


# brdf, Kd 1 to 3, Ks 4 to 6, alpha 7; for glass Kt 8 to 10, the index 11.
def _is_glass(words):
    return words[:1] == ["brdf"] and len(words) == 12


def _is_opaque(words):
    return words[:1] == ["brdf"] and len(words) == 8


def _scaled(first, factor):
    def change(words):
        return [repr(factor * float(w)) if first <= i < first + 3 else w for i, w in enumerate(words)]

    return change


def _denser(words):
    # An index of 1 is no surface.
    return words if float(words[11]) == 1 else [*words[:11], repr(float(words[11]) + 0.05)]


def _is_lens(words):
    return words[:1] == ["lens"]


def errors(text):
    """Each error's name and the scene that has it: an error of the lens, else of glass, else of everything."""
    if any(_is_lens(line.split()) for line in text.splitlines()):
        return {"lens +10 %": _changed(text, _is_lens, lambda words: [words[0], repr(1.1 * float(words[1])), words[2]])}
    if not any(_is_glass(line.split()) for line in text.splitlines()):
        return {"Kd −1 %": _changed(text, _is_opaque, _scaled(1, 0.99))}
    return {"Kt −5 %": _changed(text, _is_glass, _scaled(8, 0.95)), "n + .05": _changed(text, _is_glass, _denser)}
