"""All checks on all subjects."""

from __future__ import annotations

from typing import Callable, Iterable, Iterator, List, Tuple

from rqt_mrta_py.app.doctor.architecture import check_panels, check_taxonomy
from rqt_mrta_py.app.doctor.clashes import check_clashes
from rqt_mrta_py.app.doctor.dependencies import check_dependencies
from rqt_mrta_py.app.doctor.files import check_files
from rqt_mrta_py.app.doctor.installation import check_installation
from rqt_mrta_py.app.doctor.launch_files import check_launch_files
from rqt_mrta_py.app.doctor.launch_templates import check_launch_templates
from rqt_mrta_py.app.doctor.manifests import check_manifest
from rqt_mrta_py.app.doctor.parameters import check_parameters
from rqt_mrta_py.app.doctor.scenario import check_scenario
from rqt_mrta_py.app.doctor.subject import Subject
from rqt_mrta_py.app.doctor.tasks import check_tasks
from rqt_mrta_py.app.doctor.team import check_agents, check_tasks_of_robots, check_taxonomy_of_tasks
from rqt_mrta_py.app.doctor.topics import check_topics
from rqt_mrta_py.app.doctor.yaml_files import check_yaml_files
from rqt_mrta_py.errors import ConfigError, MrtaError, Problem

__all__ = ["CHECKS", "Check", "examine"]

Check = Callable[[Subject], Iterator[Problem]]
"""Gives what is wrong with a subject; may raise a ConfigError too, whose problems then count."""

CHECKS: Tuple[Check, ...] = (
    check_files,
    check_manifest,
    check_dependencies,
    check_installation,
    check_launch_templates,
    check_launch_files,
    check_yaml_files,
    check_clashes,
    check_taxonomy,
    check_topics,
    check_panels,
    check_agents,
    check_tasks_of_robots,
    check_taxonomy_of_tasks,
    check_tasks,
    check_parameters,
    check_scenario,
)
"""In the order in which they are asked."""


def examine(subjects: Iterable[Subject], checks: Iterable[Check] = CHECKS) -> Tuple[Problem, ...]:
    """Ask every check about every subject; one that fails on one subject lets the others go on.

    Args:
        subjects: packages and files.
        checks: what to look at.

    Returns:
        Everything that is wrong, each once, sorted by path, line and element.
    """
    wanted = tuple(checks)
    return tuple(sorted({problem for subject in subjects for check in wanted for problem in _asked(check, subject)}))


def _asked(check: Check, subject: Subject) -> List[Problem]:
    found: List[Problem] = []
    try:
        found.extend(check(subject))
    except ConfigError as error:
        found.extend(error.problems)
    except MrtaError as error:
        # A plugin that does not keep the contract, told by its name.
        found.append(Problem(str(subject.place), 0, "", str(error)))
    return found
