"""Reads what users and packages write, and knows the line of every value.

* ``problems``: all problems of a file at once, each with where, what is wrong, what is accepted
* ``xml_text``, ``element``: XML text to a cursor with typed getters
* ``architecture``, ``application``: both flavours of rqt_mrta.xml; ``topics``, ``templates``, ``launches``,
  ``flavour`` and ``ids`` are their parts
* ``yaml_text``, ``schema``: YAML text to values with lines, checked by tables that are also the documentation
* ``tasks``, ``task_text``, ``scenario``, ``scenario_form``, ``places``: the files with these tables; what happens in
  a scenario is in ``event_form``, ``event_order``, ``scenario_events``
* ``plain_values``: the same tables for values that no file holds
* ``manifest``, ``registration``, ``discovery``, ``source``: package.xml to what is registered, and where
* ``values``, ``layers``, ``array_sizes``, ``parameters``: templates and what is given to one robot's parameters;
  ``parameter_context`` says for whom, ``robot_parameters`` from which files, ``parameter_file`` writes them
* ``mission``: all of it joined
* ``files``: read whole; written whole or not at all
"""

from __future__ import annotations

from rqt_mrta_py.config.application import read_application
from rqt_mrta_py.config.architecture import read_architecture
from rqt_mrta_py.config.discovery import discover, own_packages
from rqt_mrta_py.config.files import write_whole
from rqt_mrta_py.config.manifest import Manifest, read_manifest
from rqt_mrta_py.config.mission import load_mission, load_observed, mission_from_texts
from rqt_mrta_py.config.parameter_context import ParameterContext
from rqt_mrta_py.config.parameter_file import dump_parameters, parse_parameters
from rqt_mrta_py.config.parameters import ResolvedParameters, locate_problems, resolve_parameters
from rqt_mrta_py.config.registration import Registration, RegistrationKind, Registry
from rqt_mrta_py.config.robot_parameters import ParameterChecks, Team, config_name, resolve_shared, resolve_team
from rqt_mrta_py.config.scenario import read_scenario
from rqt_mrta_py.config.task_text import dump_task, read_task
from rqt_mrta_py.config.tasks import read_tasks

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
    "write_whole",
]
