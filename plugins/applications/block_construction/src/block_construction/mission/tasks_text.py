"""The tasks of a build as a tasks.yaml: one for each block."""

from __future__ import annotations

import math
from typing import Dict, Iterator, List, NamedTuple, Sequence, Tuple

import numpy as np

from block_construction.building.procedures import TRAVEL_SPEED
from block_construction.diagram.diagram import PlacedBlock
from block_construction.documents import one_line
from block_construction.execution.problem import START
from block_construction.mission.drawing import Drawn
from block_construction.mission.fetching import Ready
from block_construction.mission.numbers import listed, number
from block_construction.mission.precedence import precedence

__all__ = ["expected_total", "tasks_text"]

_AT_WORK = 80.0
"""Turning, fetching and placing take so long for each block, beyond driving [s] (Dantas 2017, tables 10 to 16)."""


class _Job(NamedTuple):
    """One block: what comes before, where it is fetched, how long that takes."""

    block: PlacedBlock
    before: Tuple[int, ...]
    places: Tuple[int, ...]
    duration: float


def tasks_text(drawn: Drawn, ready: Sequence[Ready], about: str, team: int) -> str:
    """Write the tasks.

    Args:
        drawn: what is built.
        ready: where blocks lie ready.
        about: a line for people.
        team: how many robots take part.

    Raises:
        ConstructionError: there is no order in which it can be built; names a block.
    """
    digits = len(str(len(drawn.problem.diagram.blocks)))
    jobs = list(_jobs(drawn))
    # Who is not alone waits for a teammate that is at work, before its block is placed or, making room, after that.
    waiting = max(job.duration for job in jobs) if team > 1 else 0.0
    lines = [f"# {one_line(about)}", "tasks:"]
    for job in jobs:
        lines += _lines(drawn, job._replace(duration=job.duration + waiting), ready, digits)
    return "\n".join(lines) + "\n"


def expected_total(drawn: Drawn) -> float:
    """Tell how long one robot is expected to build [s]."""
    return sum(job.duration for job in _jobs(drawn))


def _jobs(drawn: Drawn) -> Iterator[_Job]:
    """List the jobs in the order of the plan, else of the groups."""
    problem = drawn.problem
    if drawn.plan is not None:
        last: Tuple[int, ...] = ()
        for step in drawn.plan.steps:
            seconds = (step.fetching + step.placing) / TRAVEL_SPEED + _AT_WORK
            yield _Job(problem.block(step.block), last, (step.place,), seconds)
            last = (step.block,)
        return
    before = precedence(problem)
    lengths = problem.ways.lengths(0)
    for each in (block for group in problem.groups for block in group):
        holding = problem.holding(each)
        nearest = float(np.min(lengths[holding, each]))
        # The way to the place is much like the way from there; nobody knows yet where the robot will be.
        fetching = nearest if math.isfinite(nearest) else float(np.min(lengths[holding, START]))
        places = tuple([int(index) + 1 for index in holding])
        yield _Job(problem.block(each), tuple(sorted(before[each])), places, 2.0 * fetching / TRAVEL_SPEED + _AT_WORK)


def _lines(drawn: Drawn, job: _Job, ready: Sequence[Ready], digits: int) -> List[str]:
    problem, block = drawn.problem, job.block
    approach, site = problem.approaches[block.number - 1], problem.site
    fetched = [each for each in ready if each.place in job.places and each.units == block.units]
    supply = [listed((each.place, each.x, each.y, each.heading)) for each in fetched]
    data: Dict[str, str] = {
        "block": str(block.number),
        "units": str(block.units),
        "level": str(block.placement.z),
        "x": number(site.left + block.x),
        "y": number(site.bottom + block.y),
        "yaw": number(block.yaw),
        "heading": number(approach.heading),
        "cells": f"[{', '.join(listed((cell.x, cell.y)) for cell in block.placement.cells())}]",
        "supply": f"[{', '.join(supply)}]",
        "site": listed(site),
        "arena": number(problem.arena.side),
    }
    place = f"{{x: {number(approach.point.x)}, y: {number(approach.point.y)}, yaw: {number(approach.heading)}}}"
    before = ", ".join(_name(other, digits) for other in job.before)
    return [
        f"  - id: {_name(block.number, digits)}",
        "    kind: place_block",
        f"    place: {place}",
        "    capabilities: [magnet]",
        *([f"    predecessors: [{before}]"] if before else []),
        f"    expected_duration: {number(round(job.duration, 1))}",
        "    data:",
        *(f"      {key}: {value}" for key, value in data.items()),
    ]


def _name(block: int, digits: int) -> str:
    return f"block{block:0{digits}d}"
