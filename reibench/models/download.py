"""Downloading one large file over HTTP, going on where a broken attempt stopped."""

from http.client import HTTPException, HTTPMessage
from pathlib import Path
from typing import IO
from urllib.error import HTTPError, URLError
from urllib.request import HTTPRedirectHandler, Request, build_opener

from reibench.errors import ModelUnavailable
from reibench.models import Progress, in_megabytes

CHUNK = 1 << 20
TIMEOUT = 60.0
"""Seconds without a byte after which a source counts as unreachable."""


class _NoteChecksum(HTTPRedirectHandler):
    """Follow redirects, keeping the checksum that the hub states before it sends us elsewhere."""

    checksum = ""

    def redirect_request(
        self, req: Request, fp: IO[bytes], code: int, msg: str, headers: HTTPMessage, newurl: str
    ) -> Request | None:
        self.note(headers)
        return super().redirect_request(req, fp, code, msg, headers, newurl)

    def note(self, headers: HTTPMessage) -> None:
        stated = headers.get("X-Linked-Etag", "").strip('"')
        if len(stated) == 64:  # a sha256; other tags say nothing about the content
            self.checksum = stated


def download(url: str, partial: Path, progress: Progress) -> str:
    """Download `url` into `partial`, going on from what is there.

    Returns:
        the sha256 the source states (`X-Linked-Etag`, for large files of the hub), or nothing.

    Raises:
        ModelUnavailable: when the source cannot be reached, or breaks off.
    """
    noting = _NoteChecksum()
    done = partial.stat().st_size if partial.exists() else 0
    request = Request(url, headers={"Range": f"bytes={done}-"} if done else {})
    try:
        with build_opener(noting).open(request, timeout=TIMEOUT) as response:
            noting.note(response.headers)
            if response.status != 206:
                done = 0  # the source ignored the range and sends the whole file
            total = done + int(response.headers.get("Content-Length") or 0)
            with partial.open("ab" if done else "wb") as file:
                while block := response.read(CHUNK):
                    file.write(block)
                    done += len(block)
                    progress(done, total)
    except HTTPError as error:
        if error.code == 416 and done:
            return noting.checksum  # nothing is left to download; the checksum will tell
        raise ModelUnavailable(f"{url} answers {error.code} {error.reason}.") from error
    except (URLError, HTTPException, ConnectionError, TimeoutError) as error:
        raise ModelUnavailable(
            f"{url} cannot be reached ({getattr(error, 'reason', error)}); check the connection,"
            " and ask again to go on from what has been downloaded."
        ) from error
    if done < total:
        raise ModelUnavailable(
            f"The download of {url} broke off after {in_megabytes(done)} of {in_megabytes(total)};"
            " ask again to go on from there."
        )
    return noting.checksum
