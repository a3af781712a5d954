"""The stand-in as a program: started by AI2-THOR's client in place of the Unity build."""

import os
import sys
from argparse import ArgumentParser, Namespace, RawDescriptionHelpFormatter

from reibench.household.unity.build import Build
from reibench.household.unity.channel import Channel, end_with_parent
from reibench.household.unity.faults import NO_FAULT, Fault

DESCRIPTION = """\
The embedded household simulator behind AI2-THOR 5's FIFO and WSGI protocols.

It is started by ai2thor's client, which passes how to reach it in the environment:

  Controller(local_executable_path="python -m reibench.household.unity", x_display=":0")
"""
EPILOG = """\
Faults, for testing what drives it. N counts the actions answered before it happens; a start
answers three (GetScenesInBuild, Reset, Initialize), one more below 300 pixels (ChangeResolution).

  exit-at-start   end with status 3 before saying anything
  hang-at-start   never say anything
  die-after:N     end with status 3 at the next action
  crash-after:N   die of SIGABRT at the next action, as a crashing Unity does
  hang-after:N    never answer the next action
  spin-after:N    never answer the next action, and keep a processor busy
"""


def parse(arguments: list[str] | None = None) -> Namespace:
    """Read the command line; what Unity takes and this does not need is let pass."""
    parser = ArgumentParser(
        prog="python -m reibench.household.unity",
        description=DESCRIPTION,
        epilog=EPILOG,
        formatter_class=RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    parser.add_argument("--fault", type=Fault.parse, default=NO_FAULT, help="break on purpose")
    parser.add_argument("-screen-width", dest="width", type=int, default=300, help="pixels")
    parser.add_argument("-screen-height", dest="height", type=int, default=300, help="pixels")
    return parser.parse_known_args(arguments)[0]


def connect() -> Channel:
    """Open the channel that the client's environment variables describe."""
    if os.environ.get("AI2THOR_SERVER_TYPE") == "WSGI":
        from reibench.household.unity.wsgi import WsgiChannel

        port = int(os.environ["AI2THOR_PORT"])
        token = os.environ.get("AI2THOR_CLIENT_TOKEN", "")
        return WsgiChannel(os.environ["AI2THOR_HOST"], port, token)
    from reibench.household.unity.fifo import FifoChannel

    return FifoChannel(
        os.environ["AI2THOR_FIFO_SERVER_PIPE_PATH"], os.environ["AI2THOR_FIFO_CLIENT_PIPE_PATH"]
    )


def serve(build: Build, channel: Channel, fault: Fault) -> None:
    """Answer actions until the client is gone."""
    channel.send(build.hello())
    answered = 0
    while (request := channel.receive()) is not None:
        fault.strike(answered)
        channel.send(build.answer(request))
        answered += 1


def main(arguments: list[str] | None = None) -> int:
    """Run until the client is gone."""
    options = parse(arguments)
    if "AI2THOR_SERVER_TYPE" not in os.environ:
        sys.stderr.write("This program is started by ai2thor's Controller; --help says how.\n")
        return 2
    end_with_parent()
    options.fault.strike_at_start()
    try:
        serve(Build((options.width, options.height)), connect(), options.fault)
    except ConnectionError:
        return 0  # The client went away while it was being answered.
    return 0


if __name__ == "__main__":
    sys.exit(main())
