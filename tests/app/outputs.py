"""The folder of a run or review, read back."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Dict, List, Tuple

Mrta = Callable[..., Tuple[int, List[str]]]
"""Runs a command in an empty folder; gives its status and its lines on stderr."""


@dataclass(frozen=True)
class Outputs:
    """The folder of a run or review, read back."""

    folder: Path

    @property
    def bag(self) -> Path:
        return self.folder / "mission.bag"

    @property
    def summary(self) -> Dict[str, Any]:
        return dict(json.loads((self.folder / "summary.json").read_text(encoding="utf-8")))

    def lines(self, name: str) -> List[Dict[str, Any]]:
        return [json.loads(line) for line in (self.folder / name).read_text(encoding="utf-8").splitlines()]

    def mission_seconds(self, stamp: float) -> float:
        return stamp - float(self.summary["time"]["start"])
