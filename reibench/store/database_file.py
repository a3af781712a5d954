"""A SQLite file: connections per thread, whole transactions, and errors in one sentence."""

import sqlite3
import threading
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from sqlite_utils import Database

from reibench.errors import StoreUnavailable
from reibench.store.schema import migrate


class DatabaseFile:
    """One SQLite file; safe to use from several threads and processes."""

    def __init__(self, path: Path | str) -> None:
        """Open or make the database; raises StoreUnavailable."""
        self.path = Path(path)
        self._local = threading.local()
        with self._guarded("open"):
            self.path.parent.mkdir(parents=True, exist_ok=True)
            with self.writing() as database:
                migrate(database)

    def _database(self) -> Database:
        """Return this thread's connection: SQLite connections must not cross threads."""
        if not hasattr(self._local, "database"):
            connection = sqlite3.connect(self.path, timeout=30, isolation_level=None)
            connection.row_factory = sqlite3.Row
            database = Database(connection)
            database.execute("pragma journal_mode=wal")
            database.execute("pragma synchronous=normal")
            database.execute("pragma foreign_keys=on")
            self._local.database = database
        found: Database = self._local.database
        return found

    @contextmanager
    def _guarded(self, doing: str) -> Iterator[None]:
        try:
            yield
        except (sqlite3.Error, OSError) as problem:
            hint = _HINTS.get(_kind_of(problem), "")
            raise StoreUnavailable(
                f"Cannot {doing} the database {self.path}: {problem}.{hint}"
            ) from problem

    @contextmanager
    def writing(self) -> Iterator[Database]:
        """Hold one transaction: all of it is kept, or nothing."""
        with self._guarded("write to"):
            database = self._database()
            database.execute("begin immediate")
            try:
                yield database
            except BaseException:
                if database.conn.in_transaction:
                    database.execute("rollback")
                raise
            database.execute("commit")

    def query(self, sql: str, parameters: Iterable[object] = ()) -> list[dict[str, Any]]:
        """Return the rows of a query."""
        with self._guarded("read"):
            rows = self._database().execute(sql, list(parameters)).fetchall()
        return [dict(row) for row in rows]


def _kind_of(problem: Exception) -> str:
    text = str(problem)
    return next((kind for kind in _HINTS if kind in text), "")


_HINTS = {
    "file is not a database": " It is no SQLite file; move it away or name another with --db.",
    "malformed": " It is damaged; keep a copy of it and try `sqlite3 FILE .recover`.",
    "disk is full": " Free some space and try again: nothing recorded is lost.",
    "full": " Free some space and try again: nothing recorded is lost.",
    "readonly": " Make the file writable or name another with --db.",
    "unable to open": " Check that the folder exists and may be written to.",
}
