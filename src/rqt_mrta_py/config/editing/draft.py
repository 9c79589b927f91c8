"""An application as it is being edited: its texts, and what they say at this point."""

from __future__ import annotations

from pathlib import Path
from typing import Dict, Optional, Tuple

from rqt_mrta_py.config.discovery.source import Source
from rqt_mrta_py.config.editing.parameter_nodes import ParameterNodes
from rqt_mrta_py.config.editing.xml_document import XmlDocument
from rqt_mrta_py.config.editing.yaml_document import YamlDocument
from rqt_mrta_py.config.files import read_file
from rqt_mrta_py.config.scenario.scenario_file import read_scenario
from rqt_mrta_py.config.tasks.tasks_file import read_tasks
from rqt_mrta_py.config.xml.application import read_application
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.model import ApplicationSpec, ArchitectureSpec, ConfigTemplate, ScenarioSpec, Task

__all__ = ["Draft", "refused"]


class Draft:
    """The files of an application on their way to another state; nothing is written.

    Args:
        source: where they are.
        architecture: the application's own.

    Attributes:
        xml: the rqt_mrta.xml.
        tasks: the tasks.yaml; None if there is none.
        scenario: the scenario.yaml; None if there is none.
        nodes: configs within the rqt_mrta.xml.
        sources: content of these files, as it was read.

    Raises:
        ConfigError: one of the files cannot be read.
    """

    def __init__(self, source: Source, architecture: ArchitectureSpec) -> None:
        self.source = source
        self.architecture = architecture
        paths = [path for path in (source.file, source.tasks, source.scenario) if path is not None]
        self.sources: Dict[Path, bytes] = {path: read_file(path) for path in paths}
        self.xml = XmlDocument(self.sources[source.file], str(source.file))
        self.tasks = self._document(source.tasks)
        self.scenario = self._document(source.scenario)
        self.nodes = ParameterNodes(self.xml)
        self._given = self.texts()

    def texts(self) -> Dict[Path, str]:
        """Give the texts as they are now."""
        texts = {self.source.file: self.xml.text()}
        for path, document in ((self.source.tasks, self.tasks), (self.source.scenario, self.scenario)):
            if path is not None and document is not None:
                texts[path] = document.text
        return texts

    def changed(self) -> Dict[Path, str]:
        """Give those texts that edits changed."""
        return {path: text for path, text in self.texts().items() if text != self._given[path]}

    def application(self) -> ApplicationSpec:
        """Read the application as it is now."""
        return read_application(self.xml.text(), self.xml.path, self.source.package)

    def task_specs(self) -> Tuple[Task, ...]:
        """Read the tasks as they are now; without a file those that robots name."""
        if self.tasks is not None:
            return read_tasks(self.tasks.text, self.tasks.path)
        named = dict.fromkeys(task for robot in self.application().robots for task in robot.tasks)
        return tuple(Task(name, kind=name) for name in named)

    def scenario_spec(self) -> Optional[ScenarioSpec]:
        """Read the scenario as it is now, without comparing it with the application; None without one."""
        return read_scenario(self.scenario.text, self.scenario.path) if self.scenario is not None else None

    def template(self) -> ConfigTemplate:
        """Give the template of the robots' parameters; an empty one if there is none."""
        wanted = self.architecture.robot_config_id
        return next((each for each in self.architecture.configs if each.id == wanted), ConfigTemplate("", ()))

    def _document(self, path: Optional[Path]) -> Optional[YamlDocument]:
        if path is None:
            return None
        raw = self.sources[path]
        try:
            return YamlDocument(raw.decode("utf-8-sig"), str(path))
        except UnicodeDecodeError as error:
            line = raw.count(b"\n", 0, error.start) + 1
            raise ConfigError([Problem(str(path), line, "", "is not UTF-8 text")]) from error


def refused(option: str, element: str, message: str) -> ConfigError:
    """Make the error of an edit that cannot be made."""
    return ConfigError([Problem(option, 0, element, message)])
