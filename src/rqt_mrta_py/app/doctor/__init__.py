"""Finds what is wrong with packages before a robot moves; runs nothing, changes nothing.

* ``examination``: the table of checks, and all of them on all subjects; the place to begin
* ``finding``: from what the user names to the packages that are meant
* ``subject``: one package and its files, each read when a check asks for it
* ``flaws``: what a reader finds within one element, so that no check tells of it again
* ``files``: what the readers find; ``manifests``, ``dependencies``, ``clashes``: what a package says of others
* ``installation``: what an installation would lack; ``install_rules``: what is installed, by ``cmake_commands``
* ``launch_files``, ``launch_templates``: inclusions and arguments; ``launch_text``: roslaunch's XML
* ``yaml_files``: parameter files against rqt_mrta.xml
* ``architecture``, ``topics``, ``team``, ``parameters``, ``tasks``, ``scenario``, ``scenario_places``: files held
  against one another, and against plugins and message types
"""

from __future__ import annotations

from rqt_mrta_py.app.doctor.examination import CHECKS, Check, examine
from rqt_mrta_py.app.doctor.finding import Found, find_subjects
from rqt_mrta_py.app.doctor.subject import ApplicationFiles, ArchitectureFile, Subject

__all__ = [
    "CHECKS",
    "ApplicationFiles",
    "ArchitectureFile",
    "Check",
    "Found",
    "Subject",
    "examine",
    "find_subjects",
]
