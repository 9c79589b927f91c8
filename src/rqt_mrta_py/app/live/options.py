"""What a supervisor node is told by its private parameters; what is of a wrong type is reported and not used."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Callable, List, Optional, Tuple

from rqt_mrta_py.app.live.interest import TopicChoice
from rqt_mrta_py.wording import shown

__all__ = ["LiveOptions", "ParameterReader", "read_options"]

_MEGABYTE = 2**20


@dataclass(frozen=True)
class LiveOptions:
    """How to supervise.

    Attributes:
        application: a registered name or path; None: what somebody says on /mrta/mission.
        architecture: a registered name or path; None: the application's own.
        topics: what to hear besides, or not.
        record: bag, or folder for bags; None: nothing is recorded.
        pictures: seconds of the stream's time between pictures; 0 for none [s].
        snapshots: folder for bags of what led to an error; None: they are written only when asked for.
        snapshot_seconds: how far back they reach; 0: nothing is kept for them [s].
        snapshot_bytes: what the kept messages may take in memory [bytes].
        out: folder for the outputs of a run; None: there are none.
    """

    application: Optional[str] = None
    architecture: Optional[str] = None
    topics: TopicChoice = field(default_factory=TopicChoice)
    record: Optional[Path] = None
    pictures: float = 1.0
    snapshots: Optional[Path] = None
    snapshot_seconds: float = 30.0
    snapshot_bytes: int = 64 * _MEGABYTE
    out: Optional[Path] = None


class ParameterReader:
    """Reads private parameters; an empty text counts as not given, as launch files write it.

    Attributes:
        problems: what was not used and why, a line each.

    Args:
        parameter: gives a parameter by name, or a default.
    """

    def __init__(self, parameter: Callable[[str, Any], Any]) -> None:
        self._parameter = parameter
        self.problems: List[str] = []

    def text(self, name: str) -> Optional[str]:
        """Read a text; None if it is not given."""
        value = self._given(name)
        if value is None or isinstance(value, str):
            return value
        self._refuse(name, value, "a text", None)
        return None

    def path(self, name: str) -> Optional[Path]:
        """Read the path of a file or folder; None if it is not given."""
        text = self.text(name)
        return None if text is None else Path(text).expanduser()

    def number(self, name: str, default: float) -> float:
        """Read a number of 0 or more."""
        value = self._given(name)
        if value is None:
            return default
        try:
            number = math.nan if isinstance(value, bool) else float(value)
        except (TypeError, ValueError):
            number = math.nan
        if 0.0 <= number < math.inf:
            return number
        self._refuse(name, value, "a number of 0 or more", default)
        return default

    def texts(self, name: str) -> Tuple[str, ...]:
        """Read texts: a list, or one text with blanks or commas between."""
        value = self._given(name)
        if value is None:
            return ()
        if isinstance(value, str):
            return tuple(value.replace(",", " ").split())
        if isinstance(value, list) and all(isinstance(each, str) for each in value):
            return tuple(value)
        self._refuse(name, value, "a text, or a list of texts", ())
        return ()

    def _given(self, name: str) -> Any:
        value = self._parameter(f"~{name}", None)
        return None if value == "" else value

    def _refuse(self, name: str, value: object, accepted: str, default: object) -> None:
        used = "nothing" if default in (None, ()) else shown(default)
        self.problems.append(f"parameter ~{name}: must be {accepted} (got {shown(value)}); {used} is used")


def read_options(reader: ParameterReader) -> LiveOptions:
    """Read all parameters of a supervisor node.

    Args:
        reader: of its private parameters; collects what is wrong with them.
    """
    return LiveOptions(
        application=reader.text("application"),
        architecture=reader.text("architecture"),
        topics=TopicChoice.of(reader.texts("topics")),
        record=reader.path("record"),
        pictures=reader.number("pictures", LiveOptions.pictures),
        snapshots=reader.path("snapshots"),
        snapshot_seconds=reader.number("snapshot_seconds", LiveOptions.snapshot_seconds),
        snapshot_bytes=round(_MEGABYTE * reader.number("snapshot_megabytes", LiveOptions.snapshot_bytes / _MEGABYTE)),
        out=reader.path("out"),
    )
