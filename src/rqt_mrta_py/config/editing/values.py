"""Parameters that are set, or taken back to their defaults, in an application's rqt_mrta.xml."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, Optional, Tuple

from rqt_mrta_py.config.editing.draft import Draft, refused
from rqt_mrta_py.config.parameters.context import Path
from rqt_mrta_py.config.parameters.lookup import template_at
from rqt_mrta_py.config.parameters.team import config_name, file_name
from rqt_mrta_py.config.parameters.values import parse_text
from rqt_mrta_py.config.substitution import has_token
from rqt_mrta_py.model import (
    ApplicationSpec,
    ArchitectureSpec,
    ConfigTemplate,
    ParameterType,
    normalise_id,
)
from rqt_mrta_py.wording import accepted, shown

__all__ = ["SetValue", "Target", "UnsetValue", "find_target", "type_of"]


@dataclass(frozen=True)
class SetValue:
    """A parameter gets a value.

    Attributes:
        path: ``<robot>/<parameter>`` or ``<config>/<parameter>``.
        text: the value.
    """

    path: str
    text: str

    def apply(self, draft: Draft) -> None:
        """Write the value into the config of the robot, which is made where it is missing."""
        target = find_target("--set", self.path, draft.application(), draft.architecture)
        if not self.text or not self.text.isprintable():
            message = f"must get a text of one line (got {shown(self.text)}); --unset takes a value back"
            raise refused("--set", self.path, message)
        kind = type_of(target.template, target.path)
        try:
            if not has_token(self.text):
                parse_text(self.text, kind)
        except ValueError as error:
            raise refused("--set", self.path, str(error)) from error
        draft.nodes.set_value(target.config, target.path, kind, self.text)


@dataclass(frozen=True)
class UnsetValue:
    """A parameter, or a group of them, is no longer given."""

    path: str

    def apply(self, draft: Draft) -> None:
        """Take it out of the config of the robot."""
        target = find_target("--unset", self.path, draft.application(), draft.architecture)
        config = draft.nodes.config(target.config)
        placed = draft.nodes.find(config, target.path)
        if placed is None:
            given = ["/".join(each.path) for each in draft.nodes.walk(config)] if config is not None else []
            message = f"is not given in {draft.source.file.name}; {accepted('/'.join(target.path), given)}"
            raise refused("--unset", self.path, message)
        draft.nodes.remove(placed)


@dataclass(frozen=True)
class Target:
    """What a path on the command line means.

    Attributes:
        config: name of the config, and of its file.
        path: of the parameter in it.
        template: of the config.
        robot: whose it is; None if it is nobody's own.
    """

    config: str
    path: Path
    template: ConfigTemplate
    robot: Optional[str] = None


def find_target(option: str, text: str, application: ApplicationSpec, architecture: ArchitectureSpec) -> Target:
    """Find out what a path on the command line means.

    Args:
        option: that problems name.
        text: ``<robot>/<parameter>``; or ``<config>/<parameter>``, where the config that every robot has a copy of
            means all robots.
        application: its robots.
        architecture: its configs.

    Raises:
        ConfigError: it means nothing.
    """
    whole = tuple(part.strip() for part in normalise_id(text.strip()).split("/"))
    templates = {config.id: config for config in architecture.configs}
    names: Dict[str, Tuple[str, str]] = {name: (file_name(name), name) for name in templates}
    own = architecture.robot_config_id
    robots = [robot.id for robot in application.robots]
    if own in templates:
        names.update((robot, (config_name(robot, own), own)) for robot in robots)
    for length in range(len(whole) - 1, 0, -1):
        name = "/".join(whole[:length])
        if name in names and all(whole[length:]):
            config, template = names[name]
            return Target(config, whole[length:], templates[template], name if name in robots else None)
    if len(whole) < 2 or not all(whole):
        raise refused(option, text, "must have the form <robot>/<parameter>, such as robot1/spin_rate")
    raise refused(option, text, f"{whole[0]!r} is no robot and no config; {accepted(whole[0], names)}")


def type_of(template: ConfigTemplate, path: Path) -> ParameterType:
    """Give the type that a template has for a parameter; a text where it knows none of this path."""
    found = template_at(template.items, path)
    return ParameterType.STRING if found is None else found.type
