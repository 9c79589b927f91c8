"""What operators tell of robots that they have taken off the floor."""

from __future__ import annotations

from typing import Sequence

from rqt_mrta_py.hooks import Heard, Subscription

__all__ = ["REMOVALS", "removed_robots"]

REMOVALS = Subscription("/mrta/robot_removed", "std_msgs/String", ("data",))


def removed_robots(heard: Heard) -> Sequence[str]:
    """Read the ids of all robots that were removed so far; blanks part them."""
    return str(heard.fields["data"]).split()
