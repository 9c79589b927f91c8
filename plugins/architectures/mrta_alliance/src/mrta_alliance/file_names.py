"""Names of files made of the ids of robots and tasks, which may hold anything."""

from __future__ import annotations

import re
from typing import Set

__all__ = ["FileNames"]

_LONGEST = 120


class FileNames:
    """Gives names that differ, on file systems that fold case too."""

    def __init__(self) -> None:
        self._taken: Set[str] = set()

    def unique(self, wanted: str) -> str:
        """Give a name that nobody has yet.

        Args:
            wanted: without ending. Letters, digits, ``_`` and ``-`` stay, slashes become ``-`` as in the files of the
                package alliance, anything else ``_``; names beyond 120 characters are cut.

        Returns:
            The name; if somebody has it, with ``_2``, ``_3``, ... behind it.
        """
        stem = re.sub(r"[^A-Za-z0-9_-]", "_", wanted.lstrip("/").replace("/", "-"))[:_LONGEST] or "_"
        name, number = stem, 1
        while name.lower() in self._taken:
            number += 1
            name = f"{stem}_{number}"
        self._taken.add(name.lower())
        return name
