"""What the readers of a package's files find: it is collected here, and written nowhere again."""

from __future__ import annotations

from typing import Iterator

from rqt_mrta_py.app.doctor.subject import Subject
from rqt_mrta_py.config.discovery.manifest import read_manifest
from rqt_mrta_py.errors import Problem

__all__ = ["check_files"]


def check_files(subject: Subject) -> Iterator[Problem]:
    """Collect what is wrong in manifest, rqt_mrta.xml, tasks.yaml and scenario.yaml, and of plugins' imports."""
    for registration in subject.registrations:
        yield from registration.problems
    yield from subject.problems
    if subject.manifest is not None:
        yield from (problem for problem in subject.host.problems if problem.path == str(subject.manifest))
        yield from read_manifest(subject.manifest).problems
