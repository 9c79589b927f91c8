"""The grammars that come with the package: ``<kind>.rng`` of XML files, ``<kind>.schema.json`` of YAML files."""

from __future__ import annotations

from typing import Dict

from rqt_mrta_py.config.scenario.form import SCENARIO_FILE
from rqt_mrta_py.config.schema.application_form import APPLICATION_FILE
from rqt_mrta_py.config.schema.architecture_form import ARCHITECTURE_FILE
from rqt_mrta_py.config.schema.json_schema import json_schema
from rqt_mrta_py.config.schema.relax_ng import relax_ng
from rqt_mrta_py.config.tasks.tasks_file import TASKS_FILE
from rqt_mrta_py.config.tolerances import TOLERANCES_FILE

__all__ = ["XML_FORMS", "YAML_FORMS", "grammars"]

XML_FORMS = (ARCHITECTURE_FILE, APPLICATION_FILE)
"""The kinds of rqt_mrta.xml."""

YAML_FORMS = (TASKS_FILE, SCENARIO_FILE, TOLERANCES_FILE)
"""The YAML files that have tables."""


def grammars() -> Dict[str, str]:
    """Write all grammars.

    Returns:
        Their texts by the names of their files, which lie beside this module.
    """
    texts = {f"{form.name}.rng": relax_ng(form) for form in XML_FORMS}
    return {**texts, **{f"{table.name.partition('.')[0]}.schema.json": json_schema(table) for table in YAML_FORMS}}
