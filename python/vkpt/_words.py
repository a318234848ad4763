"""Keyword arguments as the words of a command line, whose parser then checks them."""

import difflib
from collections.abc import Iterable, Mapping, Sized
from typing import Any

from . import _vkpt

_FLAGS = _vkpt.command_flags()

# Flags that write files, and flags that a caller replaces by other means.
_NOT_HERE = {
    "render": {
        "output", "format", "json", "quiet", "exposure", "resume", "checkpoint",
        "samples", "trace", "view", "tev",
    },
    "converge": {"csv", "html", "json", "quiet", "svg"},
}  # fmt: skip

# Separators between the numbers of a setting, where not a comma.
_BETWEEN = {"size": "x"}


def names(command: str) -> set[str]:
    """The keyword arguments of a command."""
    flags = set(_FLAGS[command]) - _NOT_HERE[command]
    return {flag.replace("-", "_") for flag in flags}


def words(command: str, settings: Mapping[str, Any]) -> list[str]:
    """The equivalent flags of a command line; `None` and an empty list give none."""
    known = names(command)
    line: list[str] = []
    for name, value in settings.items():
        if name not in known:
            raise TypeError(_unknown(command, name, known))
        flag = name.replace("_", "-")
        is_switch = _FLAGS[command][flag]
        if name == "vary":
            line += [f"--vary={key.replace('_', '-')}={_value(name, v)}" for key, v in value.items()]
        elif _says_nothing(value) or (value is False and (is_switch or name == "denoise")):
            pass
        elif value is True and (is_switch or name == "denoise"):
            line.append(f"--{flag}")
        else:
            line.append(f"--{flag}={_value(name, value)}")
    return line


def _says_nothing(value: Any) -> bool:
    return value is None or (isinstance(value, Sized) and not isinstance(value, str) and len(value) == 0)


def _value(name: str, value: Any) -> str:
    if isinstance(value, bool):
        return "on" if value else "off"
    if isinstance(value, Iterable) and not isinstance(value, str):
        return _BETWEEN.get(name, ",").join(_value(name, part) for part in value)
    return str(value)


def _unknown(command: str, name: str, known: set[str]) -> str:
    message = f"{command}() got an unexpected keyword argument '{name}'"
    close = difflib.get_close_matches(name, known, 1)
    return f"{message}; did you mean '{close[0]}'?" if close else message
