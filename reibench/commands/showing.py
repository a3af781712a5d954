"""`gallery`: the runs that come along: what there are, made anew from databases, and verified."""

from argparse import ArgumentParser, Namespace
from contextlib import closing
from pathlib import Path
from tempfile import TemporaryDirectory

from reibench import gallery
from reibench.commands.options import add_json
from reibench.commands.output import say, say_json, table, tell
from reibench.errors import ReibenchError
from reibench.replay import replay
from reibench.run import RunSpec, make_world
from reibench.store import Store


def add(command: ArgumentParser) -> None:
    """Add the command's options."""
    ways = command.add_subparsers(dest="way", required=True, metavar="WAY")
    shown = ways.add_parser("list", help="what comes along, and how it came out")
    add_json(shown)
    shown.set_defaults(command=_list)
    verified = ways.add_parser("verify", help="replay every run; exit 1 if anything differs")
    verified.set_defaults(command=_verify)
    saved = ways.add_parser("save", help="write the gallery from databases of runs")
    saved.add_argument("choice", type=Path, help="CSV: episode, model, method; the best first")
    saved.add_argument("--db", type=Path, action="append", required=True, help="several times")
    saved.add_argument("--out", type=Path, default=gallery.FILE)
    saved.set_defaults(command=_save)


def _list(arguments: Namespace) -> int:
    with TemporaryDirectory() as folder:
        rows = [list(row) for row in _rows(_loaded(folder))]
    heads = ["episode", "model", "method", "plain", "with method"]
    if arguments.json:
        say_json([dict(zip(heads, row, strict=True)) for row in rows])
    else:
        say(table(rows, heads))
    return 0


def _rows(store: Store) -> list[tuple[str, ...]]:
    found: list[tuple[str, ...]] = []
    for case in gallery.cases():
        told = store.query(
            "select model, method, status from records join runs on runs.id = run"
            " where records.id = ?",
            [case.told],
        )[0]
        plain = store.query("select status from records where id = ?", [case.plain])[0]
        found.append((case.episode, told["model"], told["method"], plain["status"], told["status"]))
    return found


def _loaded(folder: str) -> Store:
    store = Store(Path(folder) / "gallery.db")
    gallery.load(store)
    return store


def _verify(arguments: Namespace) -> int:
    with TemporaryDirectory() as folder:
        store = _loaded(folder)
        entries = store.entries()
        differing = 0
        for entry in entries:
            with closing(make_world(RunSpec(rules=entry.rules, world=entry.world))) as world:
                found = replay(store.record(entry.id), world).differences
            differing += bool(found)
            for difference in found:
                tell(f"{entry.id} {entry.episode}, {difference}")
    say(f"{len(entries)} runs replayed: {len(entries) - differing} came out the same.")
    return 1 if differing else 0


def _save(arguments: Namespace) -> int:
    stores = [Store(path) for path in arguments.db if path.exists()]
    if len(stores) < len(arguments.db):
        missing = next(path for path in arguments.db if not path.exists())
        raise ReibenchError(f"There is no database {missing}.")
    chosen = []
    for episode, model, method in gallery.read_choice(arguments.choice):
        found = ((store, gallery.matching(store, episode, model, method)) for store in stores)
        pair = next(((store, case) for store, case in found if case), None)
        if pair is None:
            raise ReibenchError(
                f"No database has finished runs of {episode} with {model}, without a method and"
                f" with {method}."
            )
        chosen.append(pair)
    size = gallery.save(chosen, arguments.out)
    say(f"{len(chosen)} cases in {arguments.out}, {size:,} bytes")
    return 0
