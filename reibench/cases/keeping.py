"""Tags and notes people put on episodes."""

from collections.abc import Mapping

from reibench.errors import ReibenchError
from reibench.store import Store
from reibench.store.schema import now

LONGEST_TAG = 40
MOST_TAGS = 20
LONGEST_NOTE = 4000


class Keeping:
    """Tags and notes of one database, by the digest of the episode they are about."""

    def __init__(self, store: Store) -> None:
        self._store = store

    def tags(self) -> Mapping[str, tuple[str, ...]]:
        """Return the tags of every episode that has some."""
        found: dict[str, tuple[str, ...]] = {}
        for row in self._store.query("select episode_digest, tag from tags order by tag"):
            found[row["episode_digest"]] = (*found.get(row["episode_digest"], ()), row["tag"])
        return found

    def note(self, digest: str) -> str:
        """Return the note about an episode; empty if there is none."""
        rows = self._store.query("select text from notes where episode_digest = ?", [digest])
        return rows[0]["text"] if rows else ""

    def keep(self, digest: str, tags: str, note: str) -> None:
        """Put these tags, with commas, and this note in the place of those there are.

        Raises:
            ReibenchError: for tags or a note that are too long, and for too many tags.
        """
        named = list(dict.fromkeys(" ".join(tag.split()) for tag in tags.split(",") if tag.strip()))
        if long := next((tag for tag in named if len(tag) > LONGEST_TAG), ""):
            raise ReibenchError(
                f"The tag {long[:LONGEST_TAG]!r}… has {len(long)} characters; at most"
                f" {LONGEST_TAG} fit."
            )
        if len(named) > MOST_TAGS:
            raise ReibenchError(f"{len(named)} tags are too many; at most {MOST_TAGS} fit.")
        if len(note) > LONGEST_NOTE:
            raise ReibenchError(f"The note has {len(note)} characters; at most {LONGEST_NOTE} fit.")
        with self._store.writing() as database:
            database.execute("delete from tags where episode_digest = ?", [digest])
            for tag in named:
                database.execute("insert into tags values (?, ?, ?)", [digest, tag, now()])
            database.execute("delete from notes where episode_digest = ?", [digest])
            if note.strip():
                database.execute(
                    "insert into notes values (?, ?, ?)", [digest, note.strip(), now()]
                )
