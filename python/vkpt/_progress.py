"""Progress on stderr, in place."""

import sys
import time

# Seconds between two lines where nothing can be overwritten, as in the command line.
_PAUSE = 5.0


class Bar:
    """Called with the fraction done, in [0, 1], and a text."""

    def __init__(self) -> None:
        self._in_place = sys.stderr.isatty() or "ipykernel" in sys.modules
        self._last = time.monotonic()
        self._width = 0

    def __call__(self, fraction: float, words: str) -> None:
        line = f"{100 * fraction:3.0f} %, {words}"
        if self._in_place:
            sys.stderr.write("\r" + line.ljust(self._width))
            self._width = len(line)
        elif time.monotonic() - self._last >= _PAUSE:
            self._last = time.monotonic()
            sys.stderr.write(line + "\n")
        sys.stderr.flush()

    def finish(self) -> None:
        """Clears the line for later output."""
        if self._width:
            sys.stderr.write("\r" + " " * self._width + "\r")
            sys.stderr.flush()
