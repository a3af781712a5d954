"""The process: quick to start, silent, gone with its client, and broken exactly when asked to."""

import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

PROGRAM = [sys.executable, "-m", "reibench.household.unity"]


def state_of(process: int) -> str:
    """Return what a process is doing, as one letter; nothing once it is gone."""
    try:
        stat = Path(f"/proc/{process}/stat").read_text()
    except OSError:
        return ""
    return stat.rpartition(")")[2].split()[0]


def soon(condition, seconds: float = 5.0) -> bool:
    limit = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > limit:
            return False
        time.sleep(0.02)
    return True


def test_it_says_who_starts_it_when_a_person_does(monkeypatch):
    monkeypatch.delenv("AI2THOR_SERVER_TYPE", raising=False)
    run = subprocess.run(PROGRAM, capture_output=True, text=True, check=False)
    assert run.returncode == 2
    assert "ai2thor's Controller" in run.stderr


def test_nothing_slow_is_loaded_before_a_frame_is_wanted():
    code = "import sys, reibench.household.unity.__main__ as m, reibench.household.unity.fifo;"
    code += "print({'numpy', 'PIL', 'ai2thor', 'torch'} & sys.modules.keys())"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "set()"


def test_help_says_what_can_break():
    run = subprocess.run([*PROGRAM, "--help"], capture_output=True, text=True, check=True)
    for fault in ("exit-at-start", "hang-at-start", "die-after:N", "hang-after:N", "spin-after:N"):
        assert fault in run.stdout
    run = subprocess.run([*PROGRAM, "--fault", "sulk"], capture_output=True, text=True, check=False)
    assert run.returncode == 2
    assert "'sulk'" in run.stderr


def test_it_prints_nothing(connect, server):
    client = connect(server)
    client.step("RotateRight")
    with pytest.raises(ValueError, match="FlyToMoon"):
        client.step("FlyToMoon")
    assert Path.home().joinpath(".ai2thor/log/unity.log").read_text() == ""


OWNER = """
import sys, time
from ai2thor.controller import Controller
from ai2thor.fifo_server import FifoServer
from ai2thor.wsgi_server import WsgiServer
server = {"fifo": FifoServer, "wsgi": WsgiServer}[sys.argv[1]]
build = f"{sys.executable} -m reibench.household.unity " + sys.argv[2]
class Told(Controller):
    def _start_unity_thread(self, *arguments):
        super()._start_unity_thread(*arguments)
        print(self.unity_pid, flush=True)
client = Told(local_executable_path=build, x_display=":0", server_class=server,
              server_timeout=None, scene="kitchen-1")
print("started", flush=True)
client.step("Pass")
time.sleep(60)
"""


@pytest.mark.parametrize(
    "arguments", ["", "--fault hang-after:3", "--fault spin-after:3", "--fault hang-at-start"]
)
def test_it_ends_when_its_client_is_killed(home, server, arguments):
    owner = subprocess.Popen(
        [sys.executable, "-c", OWNER, server, arguments], stdout=subprocess.PIPE, text=True
    )
    try:
        process = int(owner.stdout.readline())
        if "at-start" not in arguments:
            assert owner.stdout.readline() == "started\n"
        time.sleep(0.5)  # It looks who its parent is before it hangs or spins.
        assert state_of(process) in ("S", "R")
    finally:
        owner.kill()
        owner.wait()
        owner.stdout.close()
    assert soon(lambda: state_of(process) in ("", "Z"))


def test_it_ends_when_the_client_stops(connect, server):
    client = connect(server)
    process = client.server.unity_proc
    client.stop()
    assert process.wait(5) is not None


def environment(folder: Path) -> dict[str, str]:
    names = {"SERVER": folder / "server.pipe", "CLIENT": folder / "client.pipe"}
    for path in names.values():
        os.mkfifo(path)
    pipes = {f"AI2THOR_FIFO_{name}_PIPE_PATH": str(path) for name, path in names.items()}
    return {**os.environ, "AI2THOR_SERVER_TYPE": "FIFO", **pipes}


def test_it_ends_at_the_end_of_its_pipe(tmp_path):
    process = subprocess.Popen(PROGRAM, env=environment(tmp_path))
    with (tmp_path / "server.pipe").open("rb", buffering=0) as answers:
        assert answers.read(1) == b"\x01"
        (tmp_path / "client.pipe").open("wb").close()
    assert process.wait(5) == 0


def test_faults_at_start_are_real(tmp_path):
    exiting = subprocess.Popen([*PROGRAM, "--fault", "exit-at-start"], env=environment(tmp_path))
    assert exiting.wait(5) == 3
    for path in tmp_path.iterdir():
        path.unlink()
    hanging = subprocess.Popen([*PROGRAM, "--fault", "hang-at-start"], env=environment(tmp_path))
    with pytest.raises(subprocess.TimeoutExpired):
        hanging.wait(1)
    assert state_of(hanging.pid) == "S"
    hanging.kill()
    hanging.wait()


def test_dying_and_crashing_come_after_so_many_answers(connect):
    from ai2thor.exceptions import RestartError

    client = connect("fifo", arguments="--fault die-after:5")
    client.step("RotateRight")
    client.step("RotateRight")
    process = client.server.unity_proc
    with pytest.raises(RuntimeError, match="Error encountered"):
        client.step("RotateRight")
    assert process.wait(5) == 3
    client = connect("fifo", arguments="--fault crash-after:4")
    client.step("RotateRight")
    process = client.server.unity_proc
    with (
        pytest.warns(UserWarning, match="Restarting unity"),
        pytest.raises(RestartError, match="Restarting unity"),
    ):
        client.step("RotateRight")
    assert process.returncode == -6
    assert client.step("RotateRight").metadata["lastActionSuccess"]


@pytest.mark.parametrize(("fault", "state"), [("hang-after:3", "S"), ("spin-after:3", "R")])
def test_hanging_and_spinning_leave_the_client_waiting(connect, fault, state):
    client = connect("fifo", arguments=f"--fault {fault}", server_timeout=1.0)
    process = client.server.unity_proc
    states = []
    kill, client.server.stop = client.server.stop, lambda: states.append(state_of(process.pid))
    with pytest.raises(TimeoutError):
        client.step("RotateRight")
    assert process.poll() is None
    assert states == [state]
    client.server.stop = kill
