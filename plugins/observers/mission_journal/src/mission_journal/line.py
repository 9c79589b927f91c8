"""Facts as one line of log: ``key=value``, whatever the value holds."""

from __future__ import annotations

import json
import re

__all__ = ["line"]

_BARE = re.compile(r"[\w./:+-]+\Z", re.ASCII)


def line(**facts: object) -> str:
    """Write facts down.

    Args:
        **facts: by key; None and empty texts are left out, times and other floats are written to the millisecond,
            texts with anything but letters, digits and ``_./:+-`` in quotes, so that none can feign another fact or
            begin a new line.
    """
    return " ".join(f"{key}={_written(value)}" for key, value in facts.items() if value is not None and value != "")


def _written(value: object) -> str:
    text = f"{value:.3f}" if isinstance(value, float) else str(value)
    return text if _BARE.match(text) else json.dumps(text)
