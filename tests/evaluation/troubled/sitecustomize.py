"""Python imports this at its start, so that processes of a run know a planner in trouble."""

import ctypes
import os
import signal
import time
from pathlib import Path

from reibench.planners import planners
from reibench.planners.expert import Expert

KINDS = dict(pair.split("=") for pair in os.environ.get("TROUBLE", "").split(",") if pair)
"""What happens after the first step by the type of the goal's object; `*` is any other."""


@planners.register("troubled")
class Troubled:
    """The expert, but for some goals its process dies, hangs in foreign code, or takes long."""

    reads_goal = True

    def __init__(self, goal):
        self._goal = goal

    def plan(self, instruction, start, skills):
        plan = Expert(self._goal).plan(instruction, start, skills)
        event = yield next(plan)
        self._suffer(KINDS.get(self._goal.object, KINDS.get("*", "")))
        while True:
            try:
                decision = plan.send(event)
            except StopIteration as end:
                return end.value
            event = yield decision

    def _suffer(self, kind):
        if kind == "dies":
            os.kill(os.getpid(), signal.SIGKILL)
        if kind == "dies-once":
            mark = Path(os.environ["TROUBLE_MARK"])
            if not mark.exists():
                mark.touch()
                os.kill(os.getpid(), signal.SIGKILL)
        if kind == "raises":
            raise ValueError("this planner is in trouble")
        if kind == "slow":
            time.sleep(0.4)
        if kind == "hangs":
            # a lock taken twice in C code: no signal gets Python out of it
            library, lock = ctypes.CDLL(None), ctypes.create_string_buffer(256)
            library.pthread_mutex_lock(lock)
            # until the second call, Ctrl-C would still end Python as usual
            signal.signal(signal.SIGINT, lambda *_: None)
            Path(os.environ["TROUBLE_MARK"]).touch()
            library.pthread_mutex_lock(lock)
