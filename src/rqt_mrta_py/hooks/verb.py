"""Verbs of the command ``mrta`` that plugins add."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from dataclasses import dataclass
from typing import Callable

__all__ = ["Verb"]


@dataclass(frozen=True)
class Verb:
    """One verb; its name is the one it is registered under: lower case letters, digits and ``-``.

    Attributes:
        help: one line, as ``mrta --help`` shows it.
        add_arguments: says what it takes; ``-v``, ``-q`` and ``--help`` are there already.
        main: does the work and gives the exit status (0 done, 1 judged bad); prints data on stdout. A ``UsageError``
            or any other ``MrtaError`` that it raises is told in one line, with its exit status.
    """

    help: str
    add_arguments: Callable[[ArgumentParser], None]
    main: Callable[[Namespace], int]
