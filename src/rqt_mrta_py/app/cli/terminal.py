"""What a terminal is sent: text, whatever it was made of, and no commands but our own."""

from __future__ import annotations

import json
import sys
from contextlib import contextmanager
from typing import Any, Iterator, Mapping, Optional, TextIO, cast

from rqt_mrta_py.wording import printable

__all__ = ["as_json", "commanded", "guard_streams", "guarded_streams"]

_KEPT = "\n\t"


class _TextOnly:
    """A text stream that takes no commands: what is not printable is written escaped.

    Args:
        stream: where to write; whatever else a stream can do, it does.
    """

    def __init__(self, stream: TextIO) -> None:
        self.stream = stream

    def write(self, text: str) -> int:
        """Write a text; gives its length."""
        if text.isprintable():
            return self.stream.write(text)
        self.stream.write("\n".join(printable(line, _KEPT) for line in text.split("\n")))
        return len(text)

    def __getattr__(self, name: str) -> Any:
        return getattr(self.stream, name)


@contextmanager
def guarded_streams() -> Iterator[None]:
    """Write text only to standard output and standard error within."""
    before = sys.stdout, sys.stderr
    guard_streams()
    try:
        yield
    finally:
        sys.stdout, sys.stderr = before


def guard_streams() -> None:
    """Write text only to what standard output and standard error are now, until somebody puts others there."""
    sys.stdout, sys.stderr = _text_only(sys.stdout), _text_only(sys.stderr)


def commanded(stream: TextIO) -> TextIO:
    """Give the stream behind a guarded one, for whoever draws on a terminal and escapes names itself."""
    return stream.stream if isinstance(stream, _TextOnly) else stream


def as_json(document: Mapping[str, Any], indent: Optional[int] = None) -> str:
    """Write a JSON document in which only printable characters stand as they are.

    Args:
        document: of builtins, without NaN.
        indent: blanks a level; None for one line.
    """
    text = json.dumps(document, indent=indent, ensure_ascii=False, allow_nan=False)
    if text.isprintable():
        return text
    return "".join(
        character if character.isprintable() or character == "\n" else json.dumps(character)[1:-1] for character in text
    )


def _text_only(stream: TextIO) -> TextIO:
    # A program without a console has no streams.
    return cast(TextIO, _TextOnly(stream)) if stream is not None else stream
