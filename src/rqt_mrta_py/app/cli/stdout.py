"""Standard output as it really is: a pipe whose reader may go, a disk that may be full."""

from __future__ import annotations

import os
import sys
from contextlib import contextmanager
from typing import Iterator

from rqt_mrta_py.app.outputs.folder import OutputError

__all__ = ["mute", "standard_output"]


@contextmanager
def standard_output() -> Iterator[None]:
    """Print within; on leaving, everything has been written. That the reader has gone (``| head``) is no error.

    Raises:
        OutputError: it cannot be written.
    """
    try:
        yield
        if sys.stdout is not None:
            sys.stdout.flush()
    except BrokenPipeError:
        mute()
    except OSError as error:
        mute()
        raise OutputError(f"standard output: cannot be written: {error.strerror}") from error


def mute() -> None:
    """Let what is still to be written vanish, so that the interpreter does not stumble over it at exit."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, sys.stdout.fileno())
    os.close(nowhere)
