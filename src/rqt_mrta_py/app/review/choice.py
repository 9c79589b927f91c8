"""Which messages of recordings a review takes."""

from __future__ import annotations

from typing import Tuple

from rqt_mrta_py.app.review.recordings import Recordings
from rqt_mrta_py.app.review.request import ReviewRequest
from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.transport import Excerpt

__all__ = ["edges_of", "excerpt_of"]

_NS = 1_000_000_000


def excerpt_of(recordings: Recordings, request: ReviewRequest) -> Excerpt:
    """Say which messages are wanted.

    Args:
        recordings: the bags.
        request: what the user asks for.

    Raises:
        UsageError: none are.
    """
    choice, start_ns = request.topics, recordings.start_ns
    topics = None
    if choice.named or choice.left_out:
        known = {connection.topic for connection in recordings.connections}
        topics = {topic for topic in known if choice.keeps(topic)}
        if not topics:
            raise UsageError(f"--topics: names no topic of {recordings.where}; there are: {', '.join(sorted(known))}")
    if start_ns is None:
        return Excerpt(topics)
    edges = [None if edge is None else start_ns + round(edge * _NS) for edge in (request.start, request.end)]
    begin, end = edges
    last = recordings.end_ns or start_ns
    if begin is not None and (begin > last or (end is not None and begin > end)):
        length = (last - start_ns) / _NS
        raise UsageError(
            f"--from {request.start:g}: leaves nothing to review; there are {length:g} s, and --to must not be less"
        )
    return Excerpt(topics, begin, end)


def edges_of(recordings: Recordings, excerpt: Excerpt) -> Tuple[int, int]:
    """Say from when to when a review goes at most [ns].

    Args:
        recordings: the bags.
        excerpt: which of their messages are wanted.
    """
    start_ns, end_ns = recordings.start_ns or 0, recordings.end_ns or 0
    first = start_ns if excerpt.start_ns is None else max(start_ns, excerpt.start_ns)
    return first, end_ns if excerpt.end_ns is None else min(end_ns, excerpt.end_ns)
