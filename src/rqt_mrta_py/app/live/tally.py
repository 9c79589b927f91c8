"""What the parts of a live supervisor have counted, for its health."""

from __future__ import annotations

from dataclasses import replace
from typing import Optional

from rqt_mrta_py.app.live.drawing import Drawing
from rqt_mrta_py.app.live.health import Counts
from rqt_mrta_py.app.live.live_pictures import LivePictures
from rqt_mrta_py.app.live.recording import Recording
from rqt_mrta_py.app.live.ring_buffer import RingBuffer

__all__ = ["with_messages_kept", "with_pictures"]


def with_pictures(counts: Counts, drawing: Drawing, pictures: LivePictures) -> Counts:
    """Add what became of pictures."""
    return replace(counts, drawn=drawing.drawn, undrawn=pictures.undrawn, picture_seconds=drawing.seconds)


def with_messages_kept(counts: Counts, recording: Optional[Recording], ring: Optional[RingBuffer]) -> Counts:
    """Add what was written to the bag, and what is held for snapshots."""
    if recording is not None:
        counts = replace(
            counts,
            recorded=recording.messages,
            backlog=recording.backlog,
            unrecorded=recording.dropped,
            recording=str(recording.path),
            failure=recording.failure,
        )
    if ring is not None:
        counts = replace(counts, kept=len(ring), kept_bytes=ring.size, kept_dropped=ring.dropped)
    return counts
