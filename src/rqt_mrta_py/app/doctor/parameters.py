"""Whether parameters are complete, of their types, known, and such that the architecture can work with them."""

from __future__ import annotations

from typing import Iterator, List

from rqt_mrta_py.app.doctor.subject import Subject
from rqt_mrta_py.config.loading import attempt
from rqt_mrta_py.config.parameters.task_layers import layered_tasks
from rqt_mrta_py.config.parameters.team import Team, resolve_shared, resolve_team
from rqt_mrta_py.errors import Problem

__all__ = ["check_parameters"]


def check_parameters(subject: Subject) -> Iterator[Problem]:
    """Collect what is wrong with parameters of robots and of the whole team, plugins' word included."""
    for application in subject.applications:
        if application.team is not None:
            yield from _shared(application.team, subject)
            yield from _of_robots(application.team, subject)


def _shared(team: Team, subject: Subject) -> List[Problem]:
    found: List[Problem] = []
    kinds = subject.host.manager.registered("mrta_register_behaviours")
    if attempt(found, lambda: resolve_shared(team)) is not None and not (team.gaps.tasks or team.gaps.configs):
        attempt(found, lambda: layered_tasks(team, kinds))
    return found


def _of_robots(team: Team, subject: Subject) -> List[Problem]:
    found: List[Problem] = []
    attempt(found, lambda: resolve_team(team, checks=subject.host.manager))
    return found
