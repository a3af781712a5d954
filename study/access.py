"""Who is a researcher: whoever has the password, or, where there is none, whoever sits here."""

import hashlib
import hmac
import os
import secrets

from starlette.requests import Request

PASSWORD = "REIBENCH_ADMIN_PASSWORD"
"""Environment variable; without it the researchers' page is closed to everybody."""
LEAST = 8
COOKIE = "reibench-researcher"
"""Tells the pages outside the researchers' own that somebody has given the password there."""
_HERE = ("127.0.0.1", "::1", "localhost")
_FORWARDED = ("x-forwarded-for", "forwarded", "x-real-ip")


def password() -> str:
    """Return the password; empty if there is none, or one too short to be any."""
    kept = os.environ.get(PASSWORD, "")
    return kept if len(kept) >= LEAST else ""


def signed(what: str) -> str:
    """Return what only somebody with the password can have been given."""
    return hmac.new(password().encode(), what.encode(), hashlib.sha256).hexdigest()


def is_researcher(request: Request) -> bool:
    """Whether a request comes from somebody who may see what participants did, and keep notes."""
    if password():
        given = request.cookies.get(COOKIE, "")
        return secrets.compare_digest(given.encode(), signed(COOKIE).encode())
    here = request.client is not None and request.client.host in _HERE
    # a page from elsewhere can have its name resolved to this machine, but not say so
    named = (request.url.hostname or "") in _HERE
    return here and named and not any(name in request.headers for name in _FORWARDED)
