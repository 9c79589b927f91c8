"""Bags that are still being written."""

from __future__ import annotations

from pathlib import Path
from typing import List

from rqt_mrta_py.hooks import Stamped
from rqt_mrta_py.transport import ChunkWalk

__all__ = ["written_so_far"]


def written_so_far(active: Path) -> List[Stamped]:
    """Read what stands in an unfinished bag, which may not have been begun yet."""
    if not active.exists() or not active.stat().st_size:
        return []
    return list(ChunkWalk(active))
