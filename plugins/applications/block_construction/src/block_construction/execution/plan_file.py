"""Execution plans as files: JSON that can be read again, and a table for people."""

from __future__ import annotations

import csv
import io
import json
import math
import reprlib
from typing import Any, Dict, List, Tuple

from block_construction.diagram.table import diagram_document, read_diagram
from block_construction.documents import parsed_document
from block_construction.errors import ConstructionError
from block_construction.execution.approach import SIDES, Side, approach_from
from block_construction.execution.arena import site_of
from block_construction.execution.feasibility import check_plan
from block_construction.execution.plan import BuildPlan, PlannedStep, build_plan, problem_of
from block_construction.execution.problem import Step
from block_construction.execution.supply_file import Supply, supply_document, supply_of

__all__ = ["SCHEMA", "plan_csv", "plan_document", "read_plan"]

SCHEMA = "rqt_mrta_py/build_plan/1"
_KEYS = ("diagram", "supply", "steps")
_STEP_KEYS = ("place", "block", "heading_deg")
_SIDE_OF: Dict[int, Side] = {side.heading_deg: side for side in SIDES}


def plan_document(plan: BuildPlan) -> Dict[str, Any]:
    """Give a plan as plain JSON; ``read_plan`` reads it. Ways are in metres."""
    return {
        "schema": SCHEMA,
        "method": plan.method,
        "structure": plan.diagram.structure.name,
        "length": round(plan.cost.total, 6),
        "fetching": round(plan.cost.fetching, 6),
        "placing": round(plan.cost.placing, 6),
        "steps": [
            {
                "place": step.place,
                "block": step.block,
                "heading_deg": step.side.heading_deg,
                "fetching": round(step.fetching, 6),
                "placing": round(step.placing, 6),
            }
            for step in plan.steps
        ],
        "supply": supply_document(Supply(plan.arena, plan.places)),
        "diagram": diagram_document(plan.diagram),
    }


def plan_csv(plan: BuildPlan) -> str:
    """Write a plan as a table: each step with place, block, middle of its slot [m], the robot's pose, ways [m]."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(
        ("step", "place", "block", "type", "x", "y", "z", "orientation_deg")
        + ("robot_x", "robot_y", "heading_deg", "fetching", "placing")
    )
    site = site_of(plan.arena, plan.diagram.structure)
    for number, step in enumerate(plan.steps, 1):
        block = plan.diagram.blocks[step.block - 1]
        robot = approach_from(block, step.side, plan.arena, site).point
        slot = (f"{site.left + block.x:.3f}", f"{site.bottom + block.y:.3f}", f"{block.z:.3f}")
        pose = (f"{robot.x:.3f}", f"{robot.y:.3f}", step.side.heading_deg)
        ways = (f"{step.fetching:.3f}", f"{step.placing:.3f}")
        writer.writerow(
            (number, step.place, step.block, block.units, *slot, round(math.degrees(block.yaw)), *pose, *ways)
        )
    return stream.getvalue()


def read_plan(name: str, text: str) -> BuildPlan:
    """Read what ``plan_document`` gives; ways are measured anew.

    Args:
        name: of the file, for errors.
        text: JSON.

    Raises:
        ConstructionError: it is no such document, or its plan cannot be carried out; says where.
    """
    document = parsed_document(name, text, SCHEMA, _KEYS)
    diagram = read_diagram(f"{name}: diagram", json.dumps(document["diagram"]))
    supply = supply_of(f"{name}: supply", document["supply"])
    steps = _steps(name, document["steps"])
    plan = BuildPlan(_method(name, document.get("method", "")), diagram, supply.arena, supply.places, steps)
    try:
        check_plan(plan)
        return build_plan(plan.method, problem_of(plan), [Step(step.place, step.block) for step in steps])
    except ConstructionError as error:
        raise ConstructionError(f"{name}: {error}") from error


def _method(name: str, found: object) -> str:
    if not isinstance(found, str):
        raise ConstructionError(f"{name}: method: must be a text (found {reprlib.repr(found)})")
    return found


def _steps(name: str, found: object) -> Tuple[PlannedStep, ...]:
    if not isinstance(found, list):
        raise ConstructionError(f"{name}: steps: must be a list (found {type(found).__name__})")
    steps: List[PlannedStep] = []
    for number, each in enumerate(found):
        values: List[Any] = [each.get(key) for key in _STEP_KEYS] if isinstance(each, dict) else []
        if not values or any(type(value) is not int for value in values):
            raise ConstructionError(f"{name}: steps[{number}]: must have whole numbers {', '.join(_STEP_KEYS)}")
        place, block, heading = values
        if heading not in _SIDE_OF:
            known = ", ".join(map(str, sorted(_SIDE_OF)))
            raise ConstructionError(f"{name}: steps[{number}]: heading_deg: found {heading}; accepted are {known}")
        steps.append(PlannedStep(place, block, _SIDE_OF[heading], 0.0, 0.0))
    return tuple(steps)
