"""What every package says of itself."""

from __future__ import annotations

from typing import NamedTuple, Tuple

from rqt_mrta_py.config.packages.answers import Answers
from rqt_mrta_py.config.packages.checks import question

__all__ = ["PackageDescription", "describe"]


class PackageDescription(NamedTuple):
    """The head of a manifest, and the name for people."""

    package: str
    name: str
    version: str
    description: str
    maintainer: str
    email: str
    license: str
    run_depends: Tuple[str, ...] = ()


def describe(answers: Answers) -> PackageDescription:
    """Take from answers without problems what a package says of itself; defaults where they say nothing."""
    package = answers.text("package")
    words = package.replace("_", " ").strip()
    version, license_name = (answers.text(key) or str(question(answers.kind, key).default) for key in _DEFAULTED)
    return PackageDescription(
        package,
        answers.text("name") or words[:1].upper() + words[1:],
        version,
        answers.text("description"),
        answers.text("maintainer"),
        answers.text("email"),
        license_name,
        tuple(answers.value("run_depends", ())),
    )


_DEFAULTED = ("version", "license")
