"""Runs as processes of their own, and planners in trouble."""

import json
import os
import signal
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path

import pytest

from reibench.store import Store

ROOT = Path(__file__).parents[2]
TROUBLED = Path(__file__).parent / "troubled"


class Run:
    """A `run` command of the troubled planner, as a process group of its own."""

    def __init__(self, database, trouble, *options):
        self.database = database
        self._command = [
            sys.executable, "-m", "reibench", "run", "--db", str(database), "--json",
            "--planner", "troubled", *options,
        ]  # fmt: skip
        self._mark = Path(f"{database}.mark")
        self.environment = os.environ | {
            "PYTHONPATH": os.pathsep.join((str(TROUBLED), str(ROOT))),
            "TROUBLE": trouble,
            "TROUBLE_MARK": str(self._mark),
        }
        self.process = None

    def start(self):
        """Start it, to be watched by its lines of progress."""
        self.process = subprocess.Popen(
            self._command, cwd=ROOT, env=self.environment, stderr=subprocess.PIPE,
            stdout=subprocess.PIPE, text=True, start_new_session=True,
            # where the tests themselves run in the background, Ctrl-C would be ignored
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
        )  # fmt: skip
        return self.process.stderr

    def whole(self, trouble=None):
        """Run it to its end; return status, the rows of its JSON, and what it said."""
        environment = self.environment | ({} if trouble is None else {"TROUBLE": trouble})
        done = subprocess.run(
            self._command, cwd=ROOT, env=environment, capture_output=True, text=True, check=False,
            timeout=120,
        )  # fmt: skip
        return done.returncode, json.loads(done.stdout or "[]"), done.stderr

    def hangs(self):
        """Wait until its planner hangs."""
        limit = time.monotonic() + 60
        while not self._mark.exists():
            assert time.monotonic() < limit, "the planner did not come to hang"
            time.sleep(0.02)

    @property
    def records(self):
        store = Store(self.database)
        return store.query("select * from records order by started")

    def end(self):
        if self.process:
            with suppress(ProcessLookupError):
                os.killpg(self.process.pid, 9)
            self.process.communicate()


@pytest.fixture
def troubled(tmp_path):
    made = []

    def make(trouble, *options):
        made.append(Run(tmp_path / "records.db", trouble, *options))
        return made[-1]

    yield make
    for run in made:
        run.end()


def group_is_gone(process):
    """Whether nothing is left of a process group; a killed orphan takes a moment to go."""
    limit = time.monotonic() + 5
    while time.monotonic() < limit:
        try:
            os.killpg(process.pid, 0)
        except ProcessLookupError:
            return True
        time.sleep(0.02)
    return False
