"""The database's tables, made by migrations that are applied in order and noted."""

from collections.abc import Callable
from datetime import UTC, datetime

from sqlite_utils import Database

Migration = Callable[[Database], None]
MIGRATIONS: list[Migration] = []


def migration(function: Migration) -> Migration:
    """Add `function` to the migrations, in the order of definition."""
    MIGRATIONS.append(function)
    return function


def now() -> str:
    """Return the server's clock, UTC, ISO 8601 to the millisecond."""
    return datetime.now(UTC).isoformat(timespec="milliseconds")


def migrate(database: Database) -> None:
    """Apply the migrations this database lacks, and note them; call it inside a transaction."""
    database.execute("create table if not exists migrations (name text primary key, applied text)")
    done = {row[0] for row in database.execute("select name from migrations")}
    for change in MIGRATIONS:
        if change.__name__ not in done:
            change(database)
            database.execute("insert into migrations values (?, ?)", [change.__name__, now()])


@migration
def runs_records_and_steps(database: Database) -> None:
    """Make the first tables."""
    for statement in (
        "create table runs (id text primary key, actor text, planner text, method text,"
        " model text, rules text, spec text not null, created text not null)",
        "create table episodes (digest text primary key, id text not null, json text not null)",
        "create table scenes (digest text primary key, json text not null)",
        "create table records (id text primary key, run text references runs(id),"
        " origin text not null, visitor text, actor text not null, episode text not null,"
        " episode_digest text not null references episodes(digest), task text, task_type text,"
        " level text, underdetermined integer not null, room text, rules text not null,"
        " max_steps integer not null,"
        " status text, error_kind text, said_done integer not null default 0,"
        " error text not null default '', steps integer not null default 0,"
        " start_scene text references scenes(digest), start_goals text, instruction text,"
        " attempts integer not null default 1, started text not null, finished text)",
        "create unique index one_record_per_run_and_episode on records(run, episode)"
        " where origin = 'run'",
        "create index records_of_visitor on records(visitor, started)",
        "create table steps (record text not null references records(id), number integer not null,"
        " skill text not null, success integer not null, message text not null, goals text,"
        " changes text not null, prompt_kept integer not null, prompt_rest blob not null,"
        " usage text not null, alternatives text not null, seconds real not null,"
        " created text not null, primary key (record, number))",
    ):
        database.execute(statement)


@migration
def what_planners_made(database: Database) -> None:
    """Keep what planners made on their way, and what led them to say done."""
    database.execute("alter table steps add column artefacts text not null default '[]'")
    database.execute("alter table records add column closing text")


@migration
def what_failures_failed_by(database: Database) -> None:
    """Keep the finer kind of failure; records made before have none until they are looked at."""
    database.execute("alter table records add column fault text")


@migration
def lamps_found_lit(database: Database) -> None:
    """Have failures under lamps judged anew: a lamp that stood lit in view is not omitted."""
    database.execute(
        "update records set fault = null where task_type = 'look_at_obj_in_light'"
        " and status in ('failure', 'truncated')"
    )


@migration
def why_failures_failed(database: Database) -> None:
    """Keep the sentence that says why, and what was taken for what was meant."""
    database.execute("alter table records add column reason text")
    database.execute("alter table records add column taken text")
    database.execute("create index records_finished on records(finished)")
    for name, condition in (
        ("without_reason", "status not null and reason is null"),
        ("without_fault", "fault is null and status in ('failure', 'truncated')"),
    ):
        database.execute(f"create index {name} on records(finished) where {condition}")


@migration
def tags_notes_and_own_words(database: Database) -> None:
    """Keep what people note about episodes, and the episodes they word themselves."""
    database.execute(
        "create table tags (episode_digest text not null, tag text not null, created text not null,"
        " primary key (episode_digest, tag))"
    )
    database.execute(
        "create table notes (episode_digest text primary key, text text not null,"
        " changed text not null)"
    )
    database.execute(
        "create table own_episodes (id text primary key, episode_digest text not null"
        " references episodes(digest), created text not null)"
    )
