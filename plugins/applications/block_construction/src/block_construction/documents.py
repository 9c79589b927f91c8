"""Files that users give: bounded in size, and where they are JSON, of the schema that is wanted."""

from __future__ import annotations

import json
import reprlib
from pathlib import Path
from typing import Any, Dict, Tuple

from block_construction.errors import ConstructionError

__all__ = ["bounded_bytes", "bounded_text", "one_line", "parsed_document"]


def one_line(given: object) -> str:
    """Write a name or path in one line, with ``?`` for what cannot be shown: a file may be called anything."""
    return "".join(each if each.isprintable() else "?" for each in str(given))


def bounded_bytes(path: Path, most: int) -> bytes:
    """Read a file.

    Args:
        path: of it.
        most: it may have so many bytes; of a device, whose size says nothing, no more than these are read.

    Raises:
        ConstructionError: it is larger, or cannot be read.
    """
    try:
        with path.open("rb") as stream:
            content = stream.read(most + 1)
        if len(content) > most:
            size = max(path.stat().st_size, len(content))
            raise ConstructionError(f"{one_line(path)}: {size} bytes; at most {most} are accepted")
    except OSError as error:
        raise ConstructionError(f"{one_line(path)}: cannot be read: {error.strerror or error}") from error
    return content


def bounded_text(path: Path, most: int) -> str:
    """Read a text file.

    Args:
        path: of it.
        most: it may have so many bytes.

    Raises:
        ConstructionError: it is larger, or cannot be read, or is no text.
    """
    try:
        # Some editors begin a text with a byte-order mark.
        return bounded_bytes(path, most).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise ConstructionError(f"{one_line(path)}: byte {error.start} is not UTF-8; text is expected") from error


def parsed_document(name: str, text: str, schema: str, keys: Tuple[str, ...]) -> Dict[str, Any]:
    """Read a document of JSON.

    Args:
        name: of the file, for errors.
        text: its content.
        schema: that it must name.
        keys: that it must have.

    Raises:
        ConstructionError: it is no JSON, of another schema, or lacks a key.
    """
    try:
        document = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise ConstructionError(f"{name}: no JSON ({error})") from error
    if not isinstance(document, dict) or document.get("schema") != schema:
        found = document.get("schema") if isinstance(document, dict) else type(document).__name__
        raise ConstructionError(f"{name}: schema: found {reprlib.repr(found)}; accepted is {schema!r}")
    missing = next((key for key in keys if key not in document), None)
    if missing is not None:
        raise ConstructionError(f"{name}: {missing}: missing; accepted is a document with {', '.join(keys)}")
    return document
