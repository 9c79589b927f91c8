"""Applications in which everything goes wrong that a scenario can make go wrong, at random but from a seed."""

from __future__ import annotations

import random
from pathlib import Path
from typing import Any, Dict, List, Sequence, Set, Tuple

import yaml

from rqt_mrta_py.model import ScenarioEventKind as Kind

DURATION = 25

_MANIFEST = """<package format="3">
  <name>fault_yard</name> <version>0.1.0</version> <description>Everything goes wrong.</description>
  <maintainer email="a@b.c">m</maintainer> <license>Apache-2.0</license>
  <exec_depend>rqt_mrta_py</exec_depend>
  <export>
    <rqt_mrta_py application="${prefix}/rqt_mrta.xml" tasks="${prefix}/tasks.yaml" scenario="${prefix}/scenario.yaml"/>
  </export>
</package>
"""
_STARTS = [(-2.5, -1.5), (-2.5, 1.5), (0.0, -1.5), (0.0, 1.5), (2.5, -1.5), (2.5, 1.5)]
_SENSORS = [
    {"kind": "localiser", "topic": "pose", "rate": 10},
    {"kind": "odometry", "topic": "odom", "rate": 10},
    {"kind": "range_finder", "topic": "scan", "rate": 10, "rays": 36, "max_range": 4.0},
]

Event = Dict[str, Any]


def write_fault_yard(folder: Path, seed: int) -> Set[Kind]:
    """Write an application to a folder; gives the kinds of events in it."""
    chance = random.Random(seed)
    robots = [f"robot{number + 1}" for number in range(chance.randint(2, len(_STARTS)))]
    tasks, later = _tasks(chance)
    events = _events(chance, robots, [task["id"] for task in tasks], later)
    scenario = {
        "world": "bullet" if seed % 8 == 0 else "planar",
        "duration": DURATION,
        "arena": {"min_x": -4.0, "min_y": -3.0, "max_x": 4.0, "max_y": 3.0},
        "obstacles": [{"id": "crate", "x": 1.2, "y": 0.2, "yaw": 0.4, "size": [0.6, 0.5, 0.4]}],
        "radio": _radio(chance),
        "robot_defaults": {"sensors": _SENSORS},
        "robots": [{"id": robot, "start": {"x": x, "y": y}} for robot, (x, y) in zip(robots, _STARTS)],
        "events": events,
    }
    folder.mkdir(parents=True)
    (folder / "package.xml").write_text(_MANIFEST)
    (folder / "rqt_mrta.xml").write_text(_application(robots))
    (folder / "tasks.yaml").write_text(yaml.safe_dump({"tasks": tasks}, sort_keys=False))
    (folder / "scenario.yaml").write_text(yaml.safe_dump(scenario, sort_keys=False))
    return {Kind(event["kind"]) for event in events}


def _application(robots: Sequence[str]) -> str:
    members = "".join(f"<robot_{number}><id>{robot}</id></robot_{number}>" for number, robot in enumerate(robots))
    return (
        '<rqt_mrta format="application"><application><name>Fault yard</name><architecture>mrta_alliance</architecture>'
        f"<robots>{members}</robots></application><configs/></rqt_mrta>"
    )


def _tasks(chance: random.Random) -> Tuple[List[Event], List[str]]:
    """Give tasks that end and tasks that do not, and the ids of those that appear later."""
    tasks: List[Event] = [
        {"id": "wander", "kind": "wander", "perpetual": True},
        {"id": "report", "kind": "report", "perpetual": True, "place": {"x": 3.0, "y": 2.2}},
    ]
    for number in range(chance.randint(1, 3)):
        place = {"x": chance.uniform(-3.0, 3.0), "y": chance.choice([-2.4, 2.4])}
        task: Event = {"id": f"visit{number + 1}", "kind": "go_to_place", "place": place}
        if number and chance.random() < 0.5:
            task["predecessors"] = ["visit1"]
        tasks.append(task)
    later = [task["id"] for task in tasks[2:] if chance.random() < 0.4]
    return tasks, later


def _radio(chance: random.Random) -> Event:
    if chance.random() < 0.3:
        return {"kind": "perfect"}
    return {
        "kind": "lossy",
        "loss": chance.choice([0.0, 0.1, 0.5, 1.0]),
        "delay": chance.choice([0.0, 0.1, 1.5]),
        "jitter": chance.choice([0.0, 0.3]),
        "duplicates": chance.choice([0.0, 0.2]),
        "reordering": chance.random() < 0.5,
        "range": chance.choice([0.5, 3.0, 50.0]),
    }


_ALWAYS = (
    Kind.ROBOT_STOPS,
    Kind.ROBOT_STICKS,
    Kind.RADIO_FAILS,
    Kind.ROBOT_SLOWS,
    Kind.ROBOT_CLOCK_SHIFTS,
    Kind.RADIO_PARTITIONS,
    Kind.RADIO_CHANGES,
)


def _events(chance: random.Random, robots: Sequence[str], tasks: Sequence[str], later: Sequence[str]) -> List[Event]:
    """Give events of which each is possible when it comes."""
    times = sorted(round(chance.uniform(0.0, DURATION - 1.0), 2) for _ in range(chance.randint(5, 14)))
    away = list(later)
    open_troubles: List[Event] = []
    events: List[Event] = []
    for time in times:
        there = [task for task in tasks if task not in away]
        kind = chance.choice(
            [
                *_ALWAYS,
                *([None] * 4 if open_troubles else []),
                *([Kind.TASK_APPEARS] * 3 if away else []),
                *([Kind.TASK_WITHDRAWN, Kind.TASK_REASSIGNED] if there else []),
            ]
        )
        if kind is None:
            event = open_troubles.pop(chance.randrange(len(open_troubles)))
        else:
            event = _event(chance, kind, robots, away if kind is Kind.TASK_APPEARS else there)
        events.append({"time": time, **event})
        _remember(event, open_troubles, away)
    # Whatever appears later must appear, or nobody would say that it was not there.
    never = [task for task in later if not any(event.get("task") == task for event in events)]
    appears = {"time": DURATION - 0.5, "kind": Kind.TASK_APPEARS.value}
    events += [{**appears, "task": task} for task in never]
    if chance.random() < 0.3:
        # For good, so after all that might happen to it.
        events.append({"time": DURATION - 0.4, "kind": Kind.ROBOT_REMOVED.value, "robot": chance.choice(robots)})
    return events


def _event(chance: random.Random, kind: Kind, robots: Sequence[str], tasks: Sequence[str]) -> Event:
    """Give an event of a kind, about any robot or any of some tasks."""
    event: Event = {"kind": kind.value}
    if kind in (Kind.TASK_APPEARS, Kind.TASK_WITHDRAWN, Kind.TASK_REASSIGNED):
        event["task"] = chance.choice(tasks)
    if kind.value.startswith("robot_") or kind in (Kind.RADIO_FAILS, Kind.TASK_REASSIGNED):
        event["robot"] = chance.choice(robots)
    if kind is Kind.ROBOT_SLOWS:
        event["parameters"] = {"factor": chance.choice([0.0, 0.3, 1.0])}
    elif kind is Kind.ROBOT_CLOCK_SHIFTS:
        event["parameters"] = {"offset": chance.choice([-5.0, -0.3, 0.0, 2.0, 100.0])}
    elif kind is Kind.RADIO_PARTITIONS:
        event["parameters"] = {"groups": _groups(chance, robots)}
    elif kind is Kind.RADIO_CHANGES:
        event["parameters"] = _radio(chance)
    return event


_ENDS = {
    Kind.ROBOT_STOPS.value: Kind.ROBOT_RETURNS.value,
    Kind.ROBOT_STICKS.value: Kind.ROBOT_COMES_FREE.value,
    Kind.RADIO_FAILS.value: Kind.RADIO_RETURNS.value,
}


def _remember(event: Event, open_troubles: List[Event], away: List[str]) -> None:
    kind = event["kind"]
    if kind in _ENDS:
        open_troubles.append({"kind": _ENDS[kind], "robot": event["robot"]})
    elif kind == Kind.RADIO_PARTITIONS.value:
        heals = {"kind": Kind.RADIO_HEALS.value}
        if heals not in open_troubles:
            open_troubles.append(heals)
    elif kind == Kind.TASK_WITHDRAWN.value:
        away.append(event["task"])
    elif kind == Kind.TASK_APPEARS.value:
        away.remove(event["task"])


def _groups(chance: random.Random, robots: Sequence[str]) -> List[List[str]]:
    shuffled = list(robots)
    chance.shuffle(shuffled)
    cut = chance.randint(0, len(shuffled))
    return [group for group in (shuffled[:cut], shuffled[cut:]) if group]
