"""Allocators whose failures and answers carry their name."""

from __future__ import annotations

from typing import Any, Dict, Mapping, Sequence, Tuple

from rqt_mrta_py.app.guard.asking import guarded
from rqt_mrta_py.errors import HookError
from rqt_mrta_py.hooks import AllocationProblem, Allocator
from rqt_mrta_py.wording import shown

__all__ = ["guarded_allocators"]


def guarded_allocators(allocators: Mapping[str, Allocator]) -> Dict[str, Allocator]:
    """Give allocators that check what they answer, so that no agent is blamed for it.

    Args:
        allocators: by name.
    """

    def checked(name: str, allocator: Allocator) -> Allocator:
        def allocate(problem: AllocationProblem) -> Sequence[Tuple[str, str]]:
            pairs: Any = guarded(f"allocator {name}", allocator, problem)
            if not (isinstance(pairs, (list, tuple)) and _are_pairs(pairs, problem)):
                raise HookError(
                    f"allocator {name}: answered {shown(pairs)}; pairs of a task's and a robot's id of the problem are "
                    "needed, each robot once"
                )
            return pairs

        return allocate

    return {name: checked(name, allocator) for name, allocator in allocators.items()}


def _are_pairs(pairs: Sequence[object], problem: AllocationProblem) -> bool:
    tasks, free = {task.id for task in problem.tasks}, set(problem.robots)
    for pair in pairs:
        if not (isinstance(pair, (list, tuple)) and len(pair) == 2 and all(isinstance(each, str) for each in pair)):
            return False
        task, robot = pair
        if task not in tasks or robot not in free:
            return False
        free.remove(robot)
    return True
