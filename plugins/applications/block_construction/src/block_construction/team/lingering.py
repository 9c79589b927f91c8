"""When a robot that has placed its block is done: once there is more to do, or another block waits for this one."""

from __future__ import annotations

from typing import AbstractSet, Mapping, NamedTuple, Sequence, Tuple

from block_construction.team.peers import Dock, Peer
from block_construction.team.turns import nearest_pairs

__all__ = ["Placement", "is_done"]


class Placement(NamedTuple):
    """One task of the build.

    Attributes:
        block: number of the block.
        before: numbers of the blocks that must be placed before.
        dock: from which it is placed.
    """

    block: int
    before: Tuple[int, ...]
    dock: Dock


def is_done(
    own: Tuple[str, str, Tuple[float, float]],
    tasks: Mapping[str, Placement],
    placed: AbstractSet[int],
    peers: Sequence[Peer],
    *,
    is_aside: bool,
) -> bool:
    """Tell whether a robot should say that its task is done.

    As long as it has not, it can go where it is in nobody's way; once it has, it stands until it gets another task. So
    where there are more robots without anything to do than tasks that nobody carries out, it goes aside first.

    Args:
        own: ids of the robot and of its task, and where it is [m].
        tasks: of the build, by id.
        placed: numbers of the blocks that are placed, its own among them.
        peers: its teammates.
        is_aside: whether it is in nobody's way, or has tried for long enough.
    """
    robot, task, here = own
    left = {name: each for name, each in tasks.items() if each.block not in placed}
    mine = tasks[task].block if task in tasks else None
    ready = {name: each for name, each in left.items() if all(number in placed for number in each.before)}
    if not left:
        return True
    taken = {peer.task for peer in peers if not peer.lingers}
    open_tasks = {each.block: each.dock.place for name, each in ready.items() if name not in taken}
    free = {peer.id: (peer.way[-1].x, peer.way[-1].y) for peer in peers if peer.idle or peer.lingers}
    if len(open_tasks) <= len(free) and not is_aside:
        return False
    if any(mine in each.before for each in ready.values()):
        return True
    return robot in nearest_pairs({**free, robot: here}, open_tasks)
