"""Starting the app: a mistake is one clear sentence and exit status 2."""

import socket
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]


def start(*arguments):
    return subprocess.run(
        [sys.executable, "app.py", *arguments],
        cwd=ROOT,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )


def test_a_taken_port_is_said(tmp_path):
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = str(taken.getsockname()[1])
        done = start("--port", port, "--db", str(tmp_path / "demo.db"))
    assert done.returncode == 2
    assert f"Cannot serve on 127.0.0.1, port {port}: " in done.stderr
    assert "choose another port with --port" in done.stderr
    assert len(done.stderr.strip().splitlines()) == 1


def test_a_world_that_cannot_be_had_is_said_with_what_to_install(tmp_path):
    db, nowhere = str(tmp_path / "demo.db"), tmp_path / "thor"
    done = start("--port", "0", "--db", db, "--world", f"ai2thor:{nowhere}")
    assert done.returncode == 2
    assert f"There is no Unity executable {nowhere}" in done.stderr
    assert "REIBENCH_UNITY" in done.stderr
    assert "stand-in" in done.stderr
    assert len(done.stderr.strip().splitlines()) == 1
    done = start("--port", "0", "--db", db, "--world", "ai2thorx")
    assert done.returncode == 2
    assert "Did you mean 'ai2thor'?" in done.stderr


def test_a_file_that_is_no_database_is_said_and_left_alone(tmp_path):
    path = tmp_path / "notes.db"
    path.write_text("no database, just notes " * 50)
    done = start("--port", "0", "--db", str(path))
    assert done.returncode == 2
    assert "notes.db: file is not a database" in done.stderr
    assert path.read_text().startswith("no database")
