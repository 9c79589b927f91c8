"""Finds what is wrong with packages before a robot moves; runs nothing, changes nothing.

* ``examination``: the table of checks, and all of them on all subjects; the place to begin
* ``finding``: from what the user names to the packages that are meant
* ``subject``: one package and its files, each read when a check asks for it
* one module for each kind of thing that is checked; a check is a function that gives problems of a subject
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
