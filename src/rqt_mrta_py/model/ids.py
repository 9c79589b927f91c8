"""Ids of robots and tasks: one spelling inside, the wire's spelling outside."""

from __future__ import annotations

__all__ = ["normalise_id", "wire_id"]


def normalise_id(text: str) -> str:
    """Drop one leading slash, so that ``/robot1`` on the wire and ``robot1`` in a file are one robot.

    Args:
        text: the id as a message, topic or file spells it.

    Returns:
        The id without its leading slash.
    """
    return text[1:] if text.startswith("/") else text


def wire_id(robot_id: str) -> str:
    """Spell a robot's id as messages carry it in ``header.frame_id``, with a leading slash.

    Args:
        robot_id: the id, with or without the slash.

    Returns:
        The id with exactly one leading slash added where it has none.
    """
    return robot_id if robot_id.startswith("/") else f"/{robot_id}"
