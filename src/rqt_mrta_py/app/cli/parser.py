"""Command lines that are read strictly: no abbreviated options, wrong usage told in one line."""

from __future__ import annotations

import argparse
import sys
from typing import Any, Callable, NoReturn, Optional, Tuple

__all__ = ["CommandParser", "VerbParser", "verbosity"]


def verbosity() -> argparse.ArgumentParser:
    """Make a parser of what every verb takes."""
    parser = CommandParser(prog="mrta", add_help=False)
    parser.add_argument("-v", "--verbose", action="count", default=0, help="say more on stderr; -vv with tracebacks")
    parser.add_argument("-q", "--quiet", action="count", default=0, help="say less on stderr")
    return parser


class CommandParser(argparse.ArgumentParser):
    """Wants options in full, so that one added later never changes what a script means.

    Attributes:
        appendix: writes what follows the help page, when that is asked for; None for nothing.
    """

    def __init__(self, **settings: Any) -> None:
        super().__init__(**{"allow_abbrev": False, **settings})
        self.appendix: Optional[Callable[[], str]] = None

    def format_help(self) -> str:
        """Write the help page."""
        return super().format_help() + (self.appendix() if self.appendix else "")

    def error(self, message: str) -> NoReturn:
        """Exit with status 2 and one line."""
        self.exit(2, f"{self.prog}: {message}; see {self.prog} --help\n")

    def exit(self, status: int = 0, message: Optional[str] = None) -> NoReturn:
        """Exit once what was printed (a help page) has been written."""
        if sys.stdout is not None:
            sys.stdout.flush()
        super().exit(status, message)


class VerbParser(CommandParser):
    """Reads what follows a verb, and complains about what it does not know in the verb's own name."""

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> Tuple[Any, Any]:
        """Read all arguments; none may be left."""
        options, rest = super().parse_known_args(args, namespace)
        if rest:
            self.error(f"unrecognized arguments: {' '.join(rest)}")
        return options, rest
