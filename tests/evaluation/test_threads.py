"""Workers that share a model that is a server: real connections, several under way at once."""

import json
import time
from threading import Lock

from reibench.__main__ import main
from tests.backends.faulty import error, obliging, serving


class Crowded:
    """A server that answers after a moment, one question in ten with a 429 or a 500."""

    def __init__(self):
        self.lock, self.under_way, self.most, self.asked = Lock(), 0, 0, 0

    def __call__(self, path, body):
        with self.lock:
            self.asked += 1
            troubled = {0: 429, 5: 500}.get(self.asked % 20)
        if troubled:
            return error(troubled, "later", {"Retry-After": "0"})
        return obliging(path, body)


def test_eight_workers_ask_a_server_at_once_and_nothing_is_lost(capsys, tmp_path, monkeypatch):
    crowded = Crowded()
    with serving(crowded) as server:
        held = server.reply

        def slowly(*asked):
            with crowded.lock:
                crowded.under_way += 1
                crowded.most = max(crowded.most, crowded.under_way)
            time.sleep(0.02)
            try:
                return held(*asked)
            finally:
                with crowded.lock:
                    crowded.under_way -= 1

        server.reply = slowly
        monkeypatch.setenv("OPENAI_BASE_URL", server.address)
        monkeypatch.delenv("OPENAI_API_KEY", raising=False)
        status = main(
            ["run", "--model", "openai:m", "--method", "none,tocc", "--workers", "8", "--json",
             "--limit", "16", "--max-steps", "3", "--db", str(tmp_path / "records.db")]
        )  # fmt: skip
    rows = json.loads(capsys.readouterr().out)
    assert status == 0
    assert [(r["episodes"], r["unfinished"], r["breakdown"]) for r in rows] == [(16, 0, 0)] * 2
    assert all(row["mean_steps"] == 3 for row in rows)
    assert crowded.most > 2
