from __future__ import annotations

import logging
import sys

from rqt_mrta_py.app.cli.log_format import LogFormatter


def record_of_a_failure() -> logging.LogRecord:
    try:
        raise RuntimeError("no")
    except RuntimeError:
        return logging.LogRecord("rqt_mrta_py.hooks", logging.ERROR, "f.py", 1, "plugin=%s", ("x",), sys.exc_info())


def test_an_exception_is_one_line_unless_tracebacks_are_asked_for() -> None:
    assert LogFormatter(tracebacks=False).format(record_of_a_failure()) == (
        "ERROR rqt_mrta_py.hooks: plugin=x: RuntimeError: no"
    )
    text = LogFormatter(tracebacks=True).format(record_of_a_failure())
    assert text.startswith("ERROR rqt_mrta_py.hooks: plugin=x\nTraceback (most recent call last):")


def test_a_record_without_exception_is_written_as_it_is() -> None:
    record = logging.LogRecord("rqt_mrta_py.sim", logging.WARNING, "f.py", 1, "robot=%s", ("robot1",), None)
    assert LogFormatter(tracebacks=False).format(record) == "WARNING rqt_mrta_py.sim: robot=robot1"
