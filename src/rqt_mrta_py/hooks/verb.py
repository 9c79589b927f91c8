"""Verbs of the command ``mrta`` that plugins add."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Mapping, Protocol, Union

from rqt_mrta_py.hooks.drawing import Drawing
from rqt_mrta_py.hooks.figure import Figure

__all__ = ["Verb", "VerbFolder", "VerbTools"]


class VerbFolder(Protocol):
    """A folder that a verb leaves."""

    def write(self, name: str, content: Union[str, bytes]) -> None:
        """Write a file, whole or not at all.

        Args:
            name: relative to the folder, parts joined by ``/``.
            content: of it; text is written as UTF-8.

        Raises:
            MrtaError: it cannot be written.
        """
        ...

    def draw(self, picture: Union[Figure, Drawing]) -> None:
        """Draw ``<name of the picture>.png``.

        Raises:
            MrtaError: it cannot be drawn, or not be written.
        """
        ...


class VerbTools(Protocol):
    """What a verb of a plugin can make use of."""

    def registered(self, hook: str) -> Mapping[str, Any]:
        """Give what all plugins register by one hook, by name.

        Args:
            hook: ``mrta_register_*``.
        """
        ...

    def folder(self, path: Path, *, force: bool = False) -> VerbFolder:
        """Make a folder for what the verb leaves; it goes again where the verb fails before it has left anything.

        Args:
            path: where.
            force: whether it may hold anything already.

        Raises:
            MrtaError: it is a file, is not empty, or cannot be made.
        """
        ...

    def progress(self, share: float) -> None:
        """Show which part of the work is done: a bar on a terminal, nothing away from one.

        Args:
            share: from 0 to 1.
        """
        ...


@dataclass(frozen=True)
class Verb:
    """One verb; its name is the one it is registered under: lower case letters, digits and ``-``.

    Attributes:
        help: one line, as ``mrta --help`` shows it.
        add_arguments: says what it takes; ``-v``, ``-q`` and ``--help`` are there already.
        main: does the work, with tools at hand, and gives the exit status (0 done, 1 judged bad); prints data on
            stdout. A ``UsageError`` or any other ``MrtaError`` that it raises is told in one line, with its exit
            status.
    """

    help: str
    add_arguments: Callable[[ArgumentParser], None]
    main: Callable[[Namespace, VerbTools], int]
