"""Errors: the command line's messages, as exceptions."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Diagnostic:
    """An error or a warning about a scene file, and its place."""

    severity: str
    """`error`, `warning` or `advice`."""
    message: str
    file: str
    line: int | None
    """From 1; `None` for the whole file."""
    column: int | None
    """From 1, in characters."""
    culprit: str | None
    """The text that is wrong."""
    label: str
    """Printed under the culprit."""
    help: str | None
    """How to fix it."""


class Error(Exception):
    """A command that failed. Its text is what the command line prints."""

    def __init__(
        self,
        text: str,
        messages: list[str],
        code: int,
        diagnostics: list[Diagnostic],
    ) -> None:
        super().__init__(text)
        self.messages = messages
        """Each message separately."""
        self.code = code
        """The exit code of the command line."""
        self.diagnostics = diagnostics
        """All errors of a scene file, in the order of the file."""


class ArgumentError(Error, ValueError):
    """An argument is wrong (exit code 2)."""


class SceneError(Error, ValueError):
    """The scene, one of its files or a picture is wrong (exit code 3)."""


class DeviceError(Error, RuntimeError):
    """There is no such device (4), or rendering failed (1, 7)."""


class FileError(Error, OSError):
    """A file could not be written (exit code 5)."""


class OutOfMemory(Error, MemoryError):
    """There is not enough memory (exit code 6)."""
