"""Reads what users and packages write, and knows the line of every value.

* ``mission``: all of it joined; the place to begin
* ``discovery``: package.xml to what is registered, and where; what the user calls it to its files
* ``xml``: both flavours of rqt_mrta.xml, read and written
* ``schema``: what all files may hold, as data; grammars and docs/config.md are written from it
* ``yaml``: YAML text to values with lines, checked by tables that are also the documentation
* ``tasks``, ``scenario``: the files with these tables
* ``parameters``: templates and what is given to each robot's parameters
* ``fitting``: whether an architecture can share out the tasks
* ``substitution``: tokens such as ``@robot_id@``, in parameters and launch files
* ``loading``: application, architecture, tasks and scenario, checked against one another
* ``generated``: parameter files and launch files written from an rqt_mrta.xml
* ``editing``: changes of an application that keep what they do not change
* ``packages``: new packages, from answers to files
* ``gaps``: what of an application's file could not be read, from whose absence nothing may be concluded
* ``problems``: all problems of a file at once, each with where, what is wrong, what is accepted
* ``files``: read whole; written whole or not at all
"""

from __future__ import annotations

from rqt_mrta_py.config.discovery.manifest import Manifest, read_manifest
from rqt_mrta_py.config.discovery.registration import Registration, RegistrationKind, Registry
from rqt_mrta_py.config.discovery.search import discover, own_packages
from rqt_mrta_py.config.files import write_whole
from rqt_mrta_py.config.mission import load_mission, load_observed, mission_from_texts
from rqt_mrta_py.config.parameters.context import ParameterContext
from rqt_mrta_py.config.parameters.parameter_file import dump_parameters, parse_parameters
from rqt_mrta_py.config.parameters.resolving import ResolvedParameters, locate_problems, resolve_parameters
from rqt_mrta_py.config.parameters.team import ParameterChecks, Team, config_name, resolve_shared, resolve_team
from rqt_mrta_py.config.scenario.scenario_file import read_scenario
from rqt_mrta_py.config.tasks.task_text import dump_task, read_task
from rqt_mrta_py.config.tasks.tasks_file import read_tasks
from rqt_mrta_py.config.xml.application import read_application
from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.config.xml.writing import write_application, write_architecture

__all__ = [
    "Manifest",
    "ParameterChecks",
    "ParameterContext",
    "Registration",
    "RegistrationKind",
    "Registry",
    "ResolvedParameters",
    "Team",
    "config_name",
    "discover",
    "dump_parameters",
    "dump_task",
    "load_mission",
    "load_observed",
    "locate_problems",
    "mission_from_texts",
    "own_packages",
    "parse_parameters",
    "read_application",
    "read_architecture",
    "read_manifest",
    "read_scenario",
    "read_task",
    "read_tasks",
    "resolve_parameters",
    "resolve_shared",
    "resolve_team",
    "write_application",
    "write_architecture",
    "write_whole",
]
