"""What the process's environment says of plugins."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Mapping, Optional, Tuple

from rqt_mrta_py.errors import UsageError

__all__ = ["BLOCK", "PATIENCE", "TRACE", "PluginSettings", "plugin_settings"]

TRACE = "RQT_MRTA_PY_TRACE_HOOKS"
BLOCK = "RQT_MRTA_PY_BLOCK_PLUGINS"
PATIENCE = "RQT_MRTA_PY_PATIENCE"

_MOST_PATIENCE = 1e6


@dataclass(frozen=True)
class PluginSettings:
    """How plugins are treated.

    Attributes:
        trace: write each hook call down.
        blocked: names of plugins' modules or packages that are neither imported nor registered.
        patience: how long one answer may take; 0: no limit; None: as ever [s].
    """

    trace: bool = False
    blocked: Tuple[str, ...] = ()
    patience: Optional[float] = None


def plugin_settings(environ: Mapping[str, str]) -> PluginSettings:
    """Read the settings.

    Args:
        environ: the environment.

    Raises:
        UsageError: a variable has a value that makes no sense; names it and what is accepted.
    """
    blocked = (name.strip() for name in environ.get(BLOCK, "").split(","))
    return PluginSettings(
        trace=_switch(environ.get(TRACE, "")),
        blocked=tuple(dict.fromkeys(name for name in blocked if name)),
        patience=_seconds(environ.get(PATIENCE, "")),
    )


def _switch(text: str) -> bool:
    if text not in ("", "0", "1"):
        raise UsageError(f"{TRACE}: {text!r} is neither 1 nor 0")
    return text == "1"


def _seconds(text: str) -> Optional[float]:
    if not text:
        return None
    try:
        seconds = float(text)
    except ValueError:
        seconds = math.nan
    if not 0.0 <= seconds <= _MOST_PATIENCE:
        raise UsageError(f"{PATIENCE}: {text!r} is no number of seconds from 0 (no limit) to {_MOST_PATIENCE:.0f}")
    return seconds
