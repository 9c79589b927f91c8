"""The incidents that last, as their messages tell them."""

from __future__ import annotations

import logging
from typing import Any, Dict, List, Mapping

from rqt_mrta_py.model import Severity

__all__ = ["OpenIncidents"]

_log = logging.getLogger("rqt_mrta_py.app")


class OpenIncidents:
    """Keeps what is wrong now.

    Args:
        aloud: whether each is logged when it begins.
    """

    def __init__(self, *, aloud: bool = True) -> None:
        self._aloud = aloud
        self._open: Dict[object, Mapping[str, Any]] = {}
        self._error = ""

    def note(self, fields: Mapping[str, Any]) -> None:
        """Take in the message that an incident has begun or ended.

        Args:
            fields: of the message.
        """
        key = (fields["rule"], fields["start"], tuple(fields["robots"]), tuple(fields["tasks"]))
        if fields["end"]:
            self._open.pop(key, None)
            return
        self._open[key] = fields
        if self._aloud:
            _log.warning("incident=%s robots=%s tasks=%s %s", *key[:1], *key[2:], fields["text"])
        if fields["severity"] == Severity.ERROR.rank:
            self._error = str(fields["rule"])

    def listed(self) -> List[Mapping[str, Any]]:
        """Give them as fields of their messages, by start."""
        return sorted(self._open.values(), key=lambda fields: float(fields["start"]))

    def take_error(self) -> str:
        """Give the rule of the newest error that nobody has asked for; empty if there is none."""
        error, self._error = self._error, ""
        return error
