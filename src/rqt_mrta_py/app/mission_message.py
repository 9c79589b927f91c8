"""A mission as its message and back, so that a bag explains itself where nothing is installed."""

from __future__ import annotations

from typing import Any, Mapping, Optional

from rqt_mrta_py.app.selection import with_robots
from rqt_mrta_py.config.mission import mission_from_texts
from rqt_mrta_py.config.parameters.parameter_file import dump_parameters
from rqt_mrta_py.hooks import Outgoing
from rqt_mrta_py.model import Mission, MissionTexts

__all__ = ["MISSION_TOPIC", "MISSION_TYPE", "mission_from_fields", "mission_message"]

MISSION_TOPIC = "/mrta/mission"
MISSION_TYPE = "rqt_mrta_py/Mission"


def mission_message(mission: Mission, now: float, duration: Optional[float]) -> Outgoing:
    """Tell a mission.

    Args:
        mission: with its texts.
        now: when it begins, on the stream's clock [s].
        duration: planned [s]; None if unknown.

    Returns:
        The latched message that begins a bag.
    """
    texts = mission.texts or MissionTexts("", "")
    fields = {
        "header": {"stamp": now, "frame_id": "map"},
        "application": mission.application.package,
        "architecture": mission.architecture.package,
        "taxonomy": str(mission.architecture.taxonomy),
        "seed": mission.seed or 0,
        "seed_known": mission.seed is not None,
        "duration": duration or 0.0,
        "robots": [robot.id for robot in mission.application.robots],
        "tasks": [task.id for task in mission.tasks],
        "application_xml": texts.application_xml,
        "architecture_xml": texts.architecture_xml,
        "tasks_yaml": texts.tasks_yaml,
        "scenario_yaml": texts.scenario_yaml,
        "parameters_yaml": dump_parameters(mission.parameters),
    }
    return Outgoing(MISSION_TOPIC, MISSION_TYPE, fields, latched=True)


def mission_from_fields(fields: Mapping[str, Any]) -> Mission:
    """Rebuild a mission from its decoded message.

    Args:
        fields: the message as nested builtins.

    Returns:
        The mission, whether or not its packages are installed here.

    Raises:
        ConfigError: a text in the message is not acceptable.
    """
    seed: Optional[int] = int(fields["seed"]) if fields["seed_known"] else None
    texts = MissionTexts(
        application_xml=fields["application_xml"],
        architecture_xml=fields["architecture_xml"],
        tasks_yaml=fields["tasks_yaml"],
        scenario_yaml=fields["scenario_yaml"],
    )
    mission = mission_from_texts(
        texts,
        application_package=fields["application"],
        architecture_package=fields["architecture"],
        parameters_yaml=fields["parameters_yaml"],
        seed=seed,
    )
    return with_robots(mission, fields["robots"])
