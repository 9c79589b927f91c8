"""Small teams made by hand."""

from __future__ import annotations

from pathlib import Path
from typing import Tuple

from rqt_mrta_py.config.parameters.team import Team
from rqt_mrta_py.model import (
    ApplicationRobot,
    ApplicationSpec,
    ArchitectureSpec,
    ArrayTemplate,
    ConfigTemplate,
    IncludeSpec,
    LaunchArgument,
    LaunchTemplate,
    MapTemplate,
    ParameterTemplate,
    ParameterType,
    Task,
    Taxonomy,
)

ALLIANCE_LAUNCH = LaunchTemplate(
    "alliance",
    (
        IncludeSpec(
            "$(find alliance)/launch/alliance.launch",
            (
                LaunchArgument("robot_id", "@robot_id@"),
                LaunchArgument("robot_params", "$(find @package@)/config/@robot_id@_alliance_params.yaml"),
                LaunchArgument("tasks_params", "$(find @package@)/config/tasks_alliance_params.yaml"),
                LaunchArgument("layers_params", default="$(find @package@)/config/layers_alliance_params.yaml"),
            ),
        ),
    ),
)
"""As the original's final file has it (reference, section 2.7)."""

ROBOT_CONFIG = ConfigTemplate(
    "alliance_params",
    (
        ParameterTemplate("name", ParameterType.STRING, default="@robot_id@"),
        ParameterTemplate("spin_rate", ParameterType.DOUBLE, default="5"),
        MapTemplate(
            "behaviour_sets",
            (
                ParameterTemplate("size", ParameterType.INT, value="@array_size@", default="0"),
                ArrayTemplate(
                    "behaviour_set@index@",
                    (
                        ParameterTemplate("task_id", ParameterType.STRING, value="@task_id@"),
                        ParameterTemplate("motivational_behaviour/threshold", ParameterType.DOUBLE, default="30.0"),
                        ParameterTemplate(
                            "motivational_behaviour/impatience/fast_rate", ParameterType.DOUBLE, default="1.5"
                        ),
                    ),
                ),
            ),
        ),
    ),
)
TASKS_CONFIG = ConfigTemplate(
    "tasks_alliance_params", (ParameterTemplate("enabled", ParameterType.BOOL, default="true"),)
)
LAYERS_CONFIG = ConfigTemplate("layers_alliance_params", ())


def make_team(
    robots: Tuple[str, ...] = ("robot1", "robot2"),
    configs: Tuple[ConfigTemplate, ...] = (ROBOT_CONFIG, TASKS_CONFIG, LAYERS_CONFIG),
    launches: Tuple[LaunchTemplate, ...] = (ALLIANCE_LAUNCH,),
) -> Team:
    """Make a team of the package ``yard`` with the tasks patrol and inspect."""
    spec = ApplicationSpec("yard", "Yard", "alliance", tuple(ApplicationRobot(robot) for robot in robots))
    architecture = ArchitectureSpec(
        package="alliance",
        name="ALLIANCE",
        taxonomy=Taxonomy.parse("ST-SR-IA"),
        robot_config_id=configs[0].id if configs else None,
        robot_launch_id="alliance",
        configs=configs,
        launches=launches,
    )
    tasks = (Task("patrol", "wander"), Task("inspect", "wander"))
    return Team(spec, Path("/nowhere/yard/rqt_mrta.xml"), architecture, Path("/nowhere/alliance/rqt_mrta.xml"), tasks)
