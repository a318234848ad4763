"""The command `vkpt` of the wheel."""

import signal
import sys

from . import _vkpt


def main() -> int:
    # vkpt has its own handler, after which Python's would raise an exception. If ctrl-c is ignored, it stays ignored.
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    return _vkpt.run(["vkpt", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
