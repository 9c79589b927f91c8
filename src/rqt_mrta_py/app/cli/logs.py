"""Log lines on a terminal, as loud as the user wants them."""

from __future__ import annotations

import logging
import sys

from rqt_mrta_py.app.cli.log_format import LogFormatter

__all__ = ["start_logging"]


def start_logging(verbose: int, quiet: int) -> None:
    """Log to stderr from now on, unless somebody has arranged for logs already.

    Args:
        verbose: how often the user asked for more.
        quiet: how often for less.
    """
    handler = logging.StreamHandler(sys.stderr)
    handler.setFormatter(LogFormatter(tracebacks=verbose >= 2))
    level = logging.WARNING + 10 * quiet - 10 * verbose
    logging.basicConfig(level=max(level, logging.DEBUG), handlers=[handler])
