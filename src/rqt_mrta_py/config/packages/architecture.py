"""The files of a new architecture."""

from __future__ import annotations

from pathlib import Path
from typing import Dict, Iterator, List, Tuple

from rqt_mrta_py.config.packages.answers import Answers
from rqt_mrta_py.config.packages.answers_form import MEANINGS
from rqt_mrta_py.config.packages.cmake import cmake_text
from rqt_mrta_py.config.packages.description import PackageDescription
from rqt_mrta_py.config.packages.manifest import manifest_text
from rqt_mrta_py.config.xml.writing import write_architecture
from rqt_mrta_py.model import (
    ROBOT_TOKEN,
    TASK_TOKEN,
    AllocationType,
    ArchitectureSpec,
    ConfigTemplate,
    MonitoredTopic,
    ParameterTemplate,
    ParameterType,
    RobotType,
    TaskType,
    Taxonomy,
)

__all__ = ["architecture_files"]

_SKELETON = Path(__file__).parent / "skeleton"

_PARAMETERS = (
    ParameterTemplate(
        "rate",
        ParameterType.DOUBLE,
        default="5.0",
        tool_tip="Enter how often the robot decides and tells what it holds, from 1 to 100 [Hz].",
    ),
    ParameterTemplate(
        "timeout",
        ParameterType.DOUBLE,
        default="2.0",
        tool_tip="Enter for how long another robot's claim counts [s]; at least two cycles.",
    ),
)
"""What the skeleton's agent is told."""


def architecture_files(answers: Answers, described: PackageDescription) -> Dict[str, str]:
    """Write everything that a new architecture consists of.

    Args:
        answers: without problems.
        described: what the package says of itself.

    Returns:
        Text by path relative to the package, sorted.

    Raises:
        ConfigError: something in the answers cannot stand in an rqt_mrta.xml; names the elements.
    """
    package = described.package
    with_plugin = bool(answers.value("plugin", True))
    exported = {"architecture": "${prefix}/rqt_mrta.xml"}
    dependencies: List[Tuple[str, List[str]]] = [("buildtool_depend", ["catkin"])]
    needed = [*described.run_depends, "rqt_mrta_py", *(name.partition("/")[0] for name in _types(answers))]
    files: Dict[str, str] = {}
    if with_plugin:
        exported["plugin"] = f"{package}.plugin"
        dependencies[0][1].append("python3-setuptools")
        needed.append("std_msgs")
        files.update(_skeleton(described))
    dependencies.append(("exec_depend", needed))
    if with_plugin:
        dependencies.append(("test_depend", ["python3-numpy", "python3-pytest"]))
    files["package.xml"] = manifest_text(described, dependencies, exported)
    files["CMakeLists.txt"] = cmake_text(package, ["rqt_mrta.xml"], python=with_plugin)
    files["rqt_mrta.xml"] = write_architecture(_specification(answers, described, with_plugin))
    return {path: files[path] for path in sorted(files)}


def _types(answers: Answers) -> Iterator[str]:
    """Give the types of messages that are read, those of joins too."""
    for entry in answers.topics:
        yield entry.topic.type
        if entry.topic.join is not None:
            yield entry.topic.join.type


def _specification(answers: Answers, described: PackageDescription, with_plugin: bool) -> ArchitectureSpec:
    topics: Dict[str, List[MonitoredTopic]] = {meaning: [] for meaning in MEANINGS}
    if with_plugin:
        claim = MonitoredTopic(
            f"/{ROBOT_TOKEN}/{described.package}/claim/{TASK_TOKEN}", "std_msgs/Float64", queue_size=10
        )
        topics["busy_robots"].append(claim)
        topics["allocated_tasks"].append(claim)
        idle = MonitoredTopic(f"/{ROBOT_TOKEN}/{described.package}/idle", "std_msgs/Empty", queue_size=10)
        topics["idle_robots"].append(idle)
    for entry in answers.topics:
        topics[entry.meaning].append(entry.topic)
    parameters = [*(_PARAMETERS if with_plugin else ()), *(entry.template for entry in answers.templates)]
    config = f"{described.package}_params" if parameters else None
    return ArchitectureSpec(
        described.package,
        described.name,
        Taxonomy(
            RobotType.parse(answers.text("robots_type")),
            TaskType.parse(answers.text("tasks_type")),
            AllocationType.parse(answers.text("allocations_type")),
        ),
        robot_config_id=config,
        configs=(ConfigTemplate(config, tuple(parameters)),) if config else (),
        busy_robots=tuple(topics["busy_robots"]),
        idle_robots=tuple(topics["idle_robots"]),
        incoming_tasks=tuple(topics["incoming_tasks"]),
        allocated_tasks=tuple(topics["allocated_tasks"]),
        completed_tasks=tuple(topics["completed_tasks"]),
        failed_tasks=tuple(topics["failed_tasks"]),
    )


def _skeleton(described: PackageDescription) -> Dict[str, str]:
    """Write the plugin to start from, with its test."""
    package = described.package
    source = f"src/{package}"
    places = {
        "init.py": f"{source}/__init__.py",
        "agent.py": f"{source}/agent.py",
        "plugin.py": f"{source}/plugin.py",
        "test_agent.py": "tests/test_agent.py",
        "setup.py": "setup.py",
        "pytest.ini": "pytest.ini",
    }
    values = {
        "@package@": package,
        "@Class@": "".join(part.capitalize() for part in package.split("_")),
        "@name@": described.name.replace("\\", "\\\\").replace('"', "'"),
    }
    files = {}
    for template, path in places.items():
        text = (_SKELETON / f"{template}.in").read_text(encoding="utf-8")
        for token, value in values.items():
            text = text.replace(token, value)
        files[path] = text
    return files
