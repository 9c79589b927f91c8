"""The missions of ``block_construction``."""

from __future__ import annotations

from pathlib import Path

from block_construction.errors import ConstructionError
from block_construction.execution.arena import Arena
from block_construction.mission.drawing import Drawn, draw
from block_construction.mission.fetching import check_stands, ready_blocks
from block_construction.mission.limits import check_arena, check_levels
from block_construction.mission.lying import check_lying
from block_construction.mission.scenario_text import MODEL, scenario_text
from block_construction.mission.settings import SETTINGS, BuildSettings, read_build_settings
from block_construction.mission.starts import start_poses
from block_construction.mission.tasks_text import expected_total, tasks_text
from rqt_mrta_py.hooks import ArmModel, MadeMission, MissionMaker, MissionRequest, RobotModel, Structure

__all__ = ["BUILDING", "make_build"]


def make_build(request: MissionRequest) -> MadeMission:
    """Make the mission of building what is set.

    Args:
        request: of the host.

    Raises:
        MrtaError: what is set makes no sense, or cannot be built; names setting, file, voxel or block.
    """
    settings = read_build_settings(request.settings, request.given, len(request.team))
    model: RobotModel = request.registered("mrta_register_robot_models")[MODEL]
    arm = _arm(model)

    def check(structure: Structure) -> None:
        check_levels(structure, arm, MODEL)

    def check_place(arena: Arena) -> None:
        check_arena(Path(settings.plan or settings.supply).name, arena, model)

    drawn = draw(settings, request.registered("mrta_register_assembly_planners"), check, check_place)
    ready = ready_blocks(drawn.problem)
    check_stands(drawn.problem, ready)
    check_lying(drawn.problem, ready)
    starts = start_poses(drawn.problem, ready, len(request.robots))
    return MadeMission(
        tasks_text(drawn, ready, _about(drawn, settings), len(request.team)),
        scenario_text(
            drawn.problem.arena.side,
            ready,
            starts,
            request.robots,
            expected=expected_total(drawn),
            pose_noise=settings.pose_noise,
            pose_hold=settings.pose_hold,
            sight_noise=settings.sight_noise,
        ),
    )


def _arm(model: RobotModel) -> ArmModel:
    if model.arm is None:
        raise ConstructionError(f"robot model {model.name}: has no arm, so it cannot build")
    return model.arm


def _about(drawn: Drawn, settings: BuildSettings) -> str:
    diagram = drawn.problem.diagram
    order = "any order that their predecessors leave" if drawn.plan is None else "the order of a plan"
    supply = "" if settings.plan else f", supply {settings.supply}"
    return f"{diagram.structure.name}: {len(diagram.blocks)} blocks in {order}{supply}."


BUILDING = MissionMaker(SETTINGS, make_build, robots=1)
