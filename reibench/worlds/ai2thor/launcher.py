"""Starts Unity in a process group of its own that cannot outlive its parent.

Run as a program, `launcher.py PARENT LIBRARY COMMAND …`, which then becomes the command. A group
can be ended with all it has started, and Linux kills the command when the thread that started it
is gone, even if that was killed without a chance to clean up.
"""

import ctypes
import os
import signal
import sys

PR_SET_PDEATHSIG = 1


def main() -> None:
    """Become the command of the arguments."""
    parent, library, *command = sys.argv[1:]
    os.setsid()
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
    if os.getppid() != int(parent):
        return  # It ended before it could be bound to.
    # The stand-in is a module of this library, wherever the program was started from.
    paths = filter(None, (library, os.environ.get("PYTHONPATH")))
    os.environ["PYTHONPATH"] = os.pathsep.join(paths)
    os.execvp(command[0], command)


if __name__ == "__main__":
    main()
