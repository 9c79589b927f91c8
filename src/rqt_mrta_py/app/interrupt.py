"""Ctrl-C as a wish to end soon, so that files are complete and no step is torn apart."""

from __future__ import annotations

import signal
import threading
from types import FrameType
from typing import Any, Optional

__all__ = ["Interrupt"]


class Interrupt:
    """While entered, the first SIGINT only sets ``requested``; a second one interrupts as usual.

    Outside the main thread, where Python takes no signals, it does nothing.

    Attributes:
        requested: True once the user wants to end.
    """

    def __init__(self) -> None:
        self.requested = False
        self._before: Any = None

    def __enter__(self) -> Interrupt:
        if threading.current_thread() is threading.main_thread():
            self._before = signal.signal(signal.SIGINT, self._note)
        return self

    def __exit__(self, *_exception: object) -> None:
        self._restore()

    def _note(self, _number: int, _frame: Optional[FrameType]) -> None:
        self.requested = True
        self._restore()

    def _restore(self) -> None:
        if self._before is not None:
            signal.signal(signal.SIGINT, self._before)
            self._before = None
