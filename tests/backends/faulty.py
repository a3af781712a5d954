"""A small OpenAI-compatible server on loopback that answers as a test tells it to."""

import json
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from threading import Event, Lock, Thread

from reibench.backends.openai import Connection
from reibench.backends.patience import Patience
from reibench.backends.remote import RemoteModel

KEY = "sk-very-secret-1234567890"


@dataclass(frozen=True)
class Reply:
    """What is sent back, or half of it, or nothing while the client waits."""

    content: object = None
    status: int = 200
    headers: dict[str, str] = field(default_factory=dict)
    half: bool = False
    stall: bool = False
    reset: bool = False


@dataclass
class Faulty:
    """What was asked, and what is answered next; once that is used up, `proper` answers."""

    address: str
    proper: Callable[[str, dict], Reply]
    next: list[Reply] = field(default_factory=list)
    asked: list[tuple[str, dict]] = field(default_factory=list)
    keys: set[str | None] = field(default_factory=set)
    lock: Lock = field(default_factory=Lock)
    over: Event = field(default_factory=Event)

    def reply(self, path: str, body: dict, key: str | None) -> Reply:
        with self.lock:
            self.keys.add(key)
            self.asked.append((path, body))
            return self.next.pop(0) if self.next else self.proper(path, body)


def said(text: str, **more: object) -> Reply:
    """Answer a chat."""
    choice = {"message": {"role": "assistant", "content": text}, "finish_reason": "stop"}
    usage = {"prompt_tokens": 100, "completion_tokens": 10}
    return Reply({"choices": [{**choice, **more}], "usage": usage})


def error(status: int, message: str = "trouble", headers: dict | None = None, **more) -> Reply:
    return Reply({"error": {"message": message, **more}}, status, headers or {})


def obliging(path: str, body: dict) -> Reply:
    """Answer as OpenAI does: no other fields than its own, enums kept to, chat only."""
    if path == "/v1/completions":
        return error(404, "This is a chat model")
    for known in ("grammar", "structured_outputs", "guided_choice"):
        if known in body:
            return error(400, f"Unrecognized request argument supplied: {known}")
    if "response_format" not in body:
        return said("a free answer, and more")
    choice = body["response_format"]["json_schema"]["schema"]["properties"]["choice"]
    return said(json.dumps({"choice": choice["enum"][0]}))


@contextmanager
def serving(proper: Callable[[str, dict], Reply] = obliging) -> Iterator[Faulty]:
    class Handler(BaseHTTPRequestHandler):
        def do_GET(self):
            self.send(Reply({"data": [{"id": "m"}]}))

        def do_POST(self):
            body = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
            self.send(state.reply(self.path, body, self.headers.get("Authorization")))

        def send(self, reply):
            if reply.stall:
                state.over.wait(30)
            if reply.stall or reply.reset:
                self.close_connection = True
                return
            body = json.dumps(reply.content).encode()
            self.send_response(reply.status)
            for name, value in reply.headers.items():
                self.send_header(name, value)
            self.send_header("Content-Type", "application/json")
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body[: len(body) // 2] if reply.half else body)
            self.close_connection = True

        def log_message(self, *_):
            pass

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    server.daemon_threads = True
    state = Faulty(f"http://127.0.0.1:{server.server_address[1]}/v1", proper)
    thread = Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01})
    thread.start()
    try:
        yield state
    finally:
        state.over.set()
        server.shutdown()
        server.server_close()
        thread.join()


def model_of(server: Faulty, name: str = "m", *, seconds: float = 20, **limits) -> RemoteModel:
    """Make a backend that waits little between its tries."""
    patience = Patience(**{"first": 0.01, **limits})
    return RemoteModel(name, Connection(server.address, KEY, seconds=seconds, patience=patience))
