"""Log lines on a terminal: one line each, tracebacks only where the user asked for them."""

from __future__ import annotations

import logging

from rqt_mrta_py.wording import printable

__all__ = ["LogFormatter"]


class LogFormatter(logging.Formatter):
    """Writes level, logger and message, and of an exception its type and text.

    Args:
        tracebacks: show where an exception came from, too.
    """

    def __init__(self, *, tracebacks: bool) -> None:
        super().__init__("%(levelname)s %(name)s: %(message)s")
        self._tracebacks = tracebacks

    def formatMessage(self, record: logging.LogRecord) -> str:  # noqa: N802 - logging's name
        """Write all but the exception, in one line."""
        return printable(super().formatMessage(record))

    def format(self, record: logging.LogRecord) -> str:
        """Write one record."""
        if self._tracebacks or not record.exc_info:
            return super().format(record)
        kind, error, _ = record.exc_info
        short = logging.makeLogRecord({**record.__dict__, "exc_info": None, "exc_text": None})
        return f"{super().format(short)}: {kind.__name__ if kind else ''}: {printable(str(error))}"
