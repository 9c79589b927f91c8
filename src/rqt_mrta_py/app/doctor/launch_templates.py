"""The ``launches`` of an rqt_mrta.xml: mrta configure would write launch files of them."""

from __future__ import annotations

from pathlib import Path
from typing import Iterator, List, Sequence, Tuple

from lxml import etree

from rqt_mrta_py.app.doctor.dependencies import package_problem
from rqt_mrta_py.app.doctor.flaws import flaws_of
from rqt_mrta_py.app.doctor.launch_files import check_inclusion
from rqt_mrta_py.app.doctor.launch_text import Inclusion, packages_in
from rqt_mrta_py.app.doctor.subject import Subject
from rqt_mrta_py.config.generated.launches import launch_files
from rqt_mrta_py.config.substitution import PACKAGE_TOKEN
from rqt_mrta_py.config.xml.text import joined, line_of, lines_of
from rqt_mrta_py.errors import ConfigError, Problem

__all__ = ["check_launch_templates"]

_ELEMENT = "launches/launch/includes/include"


def check_launch_templates(subject: Subject) -> Iterator[Problem]:
    """Find templates that include what is not there, and arguments that would have no value."""
    for architecture in subject.architectures:
        if architecture.spec is not None:
            yield from _templates(subject, architecture.path, architecture.problems)
    for application in subject.applications:
        if application.file is not None:
            yield from _templates(subject, application.path, application.file.problems)
        team = application.team
        if team is None or not team.at_home or team.gaps.robots or team.gaps.launches:
            continue
        try:
            launch_files(team)
        except ConfigError as error:
            yield from error.problems


def _templates(subject: Subject, path: Path, problems: Sequence[Problem]) -> Iterator[Problem]:
    told: List[str] = []
    for include in subject.root(path).iterfind("launches/*/includes/*"):
        file = include.find("file")
        text = joined(file.text if file is not None else "")
        if not text:
            continue
        arguments = dict(_arguments(include))
        inclusion = Inclusion(text, arguments, False, line_of(file if file is not None else include))
        if not flaws_of(lines_of(include), problems):
            yield from check_inclusion(subject, inclusion, path, _ELEMENT, {PACKAGE_TOKEN: subject.name})
        for node in include.iter():
            for package in packages_in(node.text or ""):
                if "@" not in package and package not in told:
                    told.append(package)
                    yield from package_problem(subject, package, path, line_of(node), _ELEMENT)


def _arguments(include: etree._Element) -> Iterator[Tuple[str, int]]:
    for name in include.iterfind("args/*/name"):
        if joined(name.text):
            yield joined(name.text), line_of(name)
