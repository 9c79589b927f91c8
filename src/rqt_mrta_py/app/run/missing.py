"""What a mission needs of plugins and nobody provides, in the words of ``mrta run`` and ``mrta doctor`` alike."""

from __future__ import annotations

from typing import Any, Mapping, Optional, Tuple

from rqt_mrta_py.model import Task
from rqt_mrta_py.wording import accepted

__all__ = ["missing_agents", "missing_behaviour", "missing_layers", "missing_planner"]


def missing_agents(package: str, factories: Mapping[str, Any]) -> Optional[str]:
    """Say that nobody provides agents for an architecture; None if somebody does.

    Args:
        package: of the architecture.
        factories: of agents, by package.
    """
    if package in factories:
        return None
    known = accepted(package, sorted(factories))
    return f"no plugin provides agents for this architecture (plugins are found on ROS_PACKAGE_PATH); {known}"


def missing_behaviour(task: Task, factories: Mapping[str, Any]) -> Optional[str]:
    """Say that nobody provides a behaviour for a task's kind; None if somebody does.

    Args:
        task: to be carried out.
        factories: of behaviours, by kind.
    """
    if task.kind in factories:
        return None
    return f"no plugin provides a behaviour for its kind {task.kind!r}; {accepted(task.kind, sorted(factories))}"


def missing_layers(task: Task, factories: Mapping[str, Any]) -> Tuple[str, ...]:
    """Say for which of a task's layers nobody provides a behaviour.

    Args:
        task: to be carried out.
        factories: of behaviours, by kind.

    Returns:
        One line for each, in the task's order.
    """
    return tuple(
        f"no plugin provides a behaviour for its layer {layer!r}; {accepted(layer, sorted(factories))}"
        for layer in task.layers
        if layer not in factories
    )


def missing_planner(name: str, factories: Mapping[str, Any]) -> Optional[str]:
    """Say that nobody provides the planner that a scenario names; None if somebody does.

    Args:
        name: of the planner.
        factories: of planners, by name.
    """
    return None if name in factories else f"no plugin provides {name!r}; {accepted(name, sorted(factories))}"
