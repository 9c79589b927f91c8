"""Questions on a terminal: each with what to enter, its default and its check, asked again after a bad answer."""

from __future__ import annotations

import sys
from typing import Callable, Optional

__all__ = ["ask", "can_ask"]


def can_ask() -> bool:
    """Tell whether somebody sits there: questions go to standard error, for standard output is for data."""
    return sys.stdin is not None and sys.stdin.isatty() and sys.stderr.isatty()


def ask(tool_tip: str, name: str, default: str, wrong_with: Callable[[str], Optional[str]]) -> str:
    """Ask one question until the answer will do.

    Args:
        tool_tip: what to enter.
        name: of what is asked for.
        default: taken where nothing is entered; empty if there is none.
        wrong_with: says what is wrong with an answer; None if nothing is.

    Returns:
        The answer, without blanks around it.

    Raises:
        KeyboardInterrupt: whoever is asked leaves, by Ctrl-C or Ctrl-D.
    """
    while True:
        shown = f" [{default}]" if default else ""
        print(f"{tool_tip}\n{name}{shown}: ", end="", file=sys.stderr, flush=True)
        line = sys.stdin.readline()
        if not line:
            print(file=sys.stderr)
            raise KeyboardInterrupt
        answer = line.strip() or default
        message = wrong_with(answer)
        if message is None:
            return answer
        print(message, file=sys.stderr)
