"""The study's tables, beside those of records in the same database."""

from sqlite_utils import Database

from reibench.store.schema import migration


@migration
def studies_and_participants(database: Database) -> None:
    """Make the study's tables."""
    for statement in (
        "create table studies (name text primary key, version text not null, state text not null,"
        " created text not null)",
        "create table study_versions (study text not null, version text not null, json text not"
        " null, created text not null, primary key (study, version))",
        "create table participants (token text primary key, code text not null unique,"
        " study text not null, version text not null, slot integer not null, seed integer not null,"
        " stage text not null, place integer not null default 0, state text not null,"
        " reason text not null default '', invite text, submission text,"
        " parameters text not null default '{}', simulated integer not null default 0,"
        " quiz_tries integer not null default 0, arrived text not null, seen text not null,"
        " ended text)",
        "create unique index one_participant_per_invite on participants(study, invite)"
        " where invite not null",
        "create unique index one_participant_per_submission on participants(study, submission)"
        " where submission not null",
        "create table invites (study text not null, code text not null, created text not null,"
        " primary key (study, code))",
        "create table assignments (participant text not null references participants(code),"
        " kind text not null, place integer not null, episode text not null, task text not null,"
        " level text not null, record text, primary key (participant, kind, place),"
        " unique (participant, kind, task))",
        "create table answers (participant text not null references participants(code),"
        " stage text not null, place integer not null, question text not null,"
        " attempt integer not null default 1, answer text not null, right integer,"
        " created text not null, primary key (participant, stage, place, question, attempt))",
        "create table page_times (participant text not null references participants(code),"
        " stage text not null, place integer not null, step integer not null, shown real,"
        " left real, hidden real not null default 0, created text not null)",
        "create table study_log (study text not null, participant text, what text not null,"
        " reason text not null default '', created text not null)",
    ):
        database.execute(statement)


@migration
def what_was_decided_about_participants(database: Database) -> None:
    """Keep what somebody was before they were turned away, and when they were accepted."""
    database.execute("alter table participants add column before text")
    database.execute("alter table participants add column accepted text")
    database.execute(
        "update participants set before = case stage when 'over' then 'finished' else 'active' end"
        " where state = 'rejected'"
    )
