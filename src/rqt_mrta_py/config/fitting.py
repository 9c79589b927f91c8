"""Whether an architecture can share out an application's tasks, as its taxonomy has it.

Only one thing of a task contradicts a taxonomy: a need for several robots where each task goes to one (SR). Tasks
for one robot suit either kind of architecture. Predecessors and expected durations suit allocations of either kind
(IA, TA): a robot's host lets no task begin before its predecessors are done, whoever allocates it.
"""

from __future__ import annotations

from typing import Iterator, Sequence

from rqt_mrta_py.config.yaml.lines import YamlLines
from rqt_mrta_py.errors import Problem
from rqt_mrta_py.model import ArchitectureSpec, Task, TaskType

__all__ = ["misfit_problems"]


def misfit_problems(architecture: ArchitectureSpec, tasks: Sequence[Task], text: str, path: str) -> Iterator[Problem]:
    """Find tasks that an architecture does not solve.

    Args:
        architecture: one whose type of tasks is unknown solves them all.
        tasks: of the application, in the order of their file.
        text: of the tasks.yaml; empty if there is none, and then each task is for one robot.
        path: by which problems name it.

    Yields:
        One problem for each such task, in the order of the file.
    """
    if architecture.taxonomy.tasks is not TaskType.SINGLE_ROBOT:
        return
    lines = YamlLines(text)
    for index, task in enumerate(tasks):
        if task.robots > 1:
            element = f"tasks[{index}]/robots"
            message = (
                f"is {task.robots}, but {architecture.package} ({architecture.taxonomy}) gives each task to one robot; "
                "give 1, or choose an architecture for tasks of several robots (mrta list architectures --type=-MR-)"
            )
            yield Problem(path, lines.of(element), element, message)
