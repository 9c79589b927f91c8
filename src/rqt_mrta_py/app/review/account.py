"""The account of a review: which bags it read, why so, and what could not be read."""

from __future__ import annotations

from typing import Any, Dict

from rqt_mrta_py.app.review.recordings import Recordings
from rqt_mrta_py.app.review.request import ReviewRequest
from rqt_mrta_py.app.review.subject import Subject

__all__ = ["review_account"]


def review_account(recordings: Recordings, subject: Subject, request: ReviewRequest, messages: int) -> Dict[str, Any]:
    """Say where the outputs come from.

    Args:
        recordings: the bags, read.
        subject: what they are about.
        request: what the user asked for.
        messages: how many were taken in.

    Returns:
        The content of ``review.json``, keys in their documented order.
    """
    return {
        "schema": "rqt_mrta_py/review_account/1",
        "bags": [
            {
                "name": bag.path.name,
                "messages": bag.info.messages,
                "indexed": bag.indexed,
                "bytes_lost": bag.faults.lost,
                "bytes_missing": bag.faults.missing,
                "faults": [str(fault) for fault in bag.faults.told],
            }
            for bag in recordings.bags
        ],
        "mission": {"source": subject.source, "why": subject.why or None},
        "excerpt": {
            "from": request.start,
            "to": request.end,
            "topics": [*request.topics.named, *(f"!{topic}" for topic in request.topics.left_out)],
        },
        "messages": messages,
    }
