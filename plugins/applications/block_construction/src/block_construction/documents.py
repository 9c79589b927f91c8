"""Files of text that users give: bounded in size, and where they are JSON, of the schema that is wanted."""

from __future__ import annotations

import json
import reprlib
from pathlib import Path
from typing import Any, Dict, Tuple

from block_construction.errors import ConstructionError

__all__ = ["bounded_text", "parsed_document"]


def bounded_text(path: Path, most: int) -> str:
    """Read a text file.

    Args:
        path: of it.
        most: it may have so many bytes.

    Raises:
        ConstructionError: it is larger, or cannot be read, or is no text.
    """
    try:
        size = path.stat().st_size
        if size > most:
            raise ConstructionError(f"{path}: {size} bytes; at most {most} are accepted")
        # Some editors begin a text with a byte-order mark.
        return path.read_text(encoding="utf-8-sig")
    except OSError as error:
        raise ConstructionError(f"{path}: cannot be read: {error.strerror or error}") from error
    except UnicodeDecodeError as error:
        raise ConstructionError(f"{path}: byte {error.start} is not UTF-8; text is expected") from error


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
