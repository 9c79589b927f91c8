"""What tells a message from all others, and points at it."""

from __future__ import annotations

from typing import Tuple

from rqt_mrta_py.hooks import Heard
from rqt_mrta_py.model import Evidence

__all__ = ["MessageKey", "evidence", "heard_of", "key_of"]

MessageKey = Tuple[str, float, int]
"""Topic, receipt [s], and ordinal among the messages of the topic."""


def key_of(heard: Heard) -> MessageKey:
    """Give the key of a message."""
    return heard.topic, heard.receipt, heard.ordinal


def heard_of(message: MessageKey) -> Heard:
    """Give a message by its key, for who only points at it: without type and content."""
    topic, receipt, ordinal = message
    return Heard(topic, "", receipt, {}, ordinal=ordinal)


def evidence(heard: Heard) -> Evidence:
    """Point at a message."""
    return Evidence(heard.topic, heard.receipt, heard.ordinal)
