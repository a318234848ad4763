"""The command `vkpt`, as the wheel brings it."""

import signal
import sys

from . import _vkpt


def main() -> int:
    # vkpt has a handler of its own, after which Python's would raise an exception. Where ctrl-c is ignored, it stays so.
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    return _vkpt.run(["vkpt", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
