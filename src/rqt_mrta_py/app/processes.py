"""What processes that share work have in common."""

from __future__ import annotations

import os
import pickle

__all__ = ["cores", "sendable"]


def cores() -> int:
    """Count the cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def sendable(error: BaseException) -> BaseException:
    """Give an exception that arrives in another process as it was, or its text where it would not."""
    try:
        if type(pickle.loads(pickle.dumps(error))) is type(error):
            return error
    except Exception:  # noqa: BLE001 - whatever a class does with its arguments
        pass
    return RuntimeError(f"{type(error).__name__}: {error}")
