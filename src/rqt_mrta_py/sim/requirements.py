"""What a scenario needs and whether somebody brings it."""

from __future__ import annotations

from typing import Collection, Dict, Iterable, Iterator, Mapping

from rqt_mrta_py.hooks import LinkFactory, RobotModel, WorldFactory
from rqt_mrta_py.model import ScenarioEventKind, ScenarioSpec
from rqt_mrta_py.sim.faults import FREEZING
from rqt_mrta_py.sim.grippers import GRIPPER
from rqt_mrta_py.sim.sensing.mount import Mount, where_it_is
from rqt_mrta_py.wording import accepted

__all__ = ["blind_sensors", "missing_capabilities", "missing_links", "missing_names"]


def missing_names(
    scenario: ScenarioSpec,
    models: Mapping[str, RobotModel],
    sensors: Collection[str],
    worlds: Mapping[str, WorldFactory],
) -> Iterator[str]:
    """Find the world, models and kinds of sensors that a scenario names but nobody registers.

    Yields:
        One line for each, in file order, with what there is.
    """
    if scenario.world not in worlds:
        yield f"scenario: no world {scenario.world!r}; {accepted(scenario.world, sorted(worlds))}"
    for robot in scenario.robots:
        if robot.model not in models:
            yield f"robot {robot.id}: no robot model {robot.model!r}; {accepted(robot.model, sorted(models))}"
        for sensor in robot.sensors:
            if sensor.kind not in sensors:
                known = accepted(sensor.kind, sorted(sensors))
                yield f"robot {robot.id}: no sensor {sensor.kind!r} for {sensor.topic}; {known}"


def missing_links(scenario: ScenarioSpec, links: Mapping[str, LinkFactory]) -> Iterator[str]:
    """Find the radios that a scenario names but nobody registers; its events are sound.

    Yields:
        One line for each, in file order, with what there is.
    """
    if scenario.radio.kind not in links:
        yield f"scenario: no radio {scenario.radio.kind!r}; {accepted(scenario.radio.kind, sorted(links))}"
    for event in scenario.events:
        if event.kind is ScenarioEventKind.RADIO_CHANGES and event.parameters["kind"] not in links:
            kind = event.parameters["kind"]
            yield f"event {event.kind.value} at {event.time:g} s: no radio {kind!r}; {accepted(kind, sorted(links))}"


def missing_capabilities(
    scenario: ScenarioSpec, models: Mapping[str, RobotModel], capabilities: Collection[str]
) -> Iterator[str]:
    """Find what a scenario asks of its world beyond the capabilities of that.

    Yields:
        One line for each, in file order, with what the world can do.
    """
    needs: Dict[str, str] = {}
    for robot in scenario.robots:
        needs.setdefault(f"drive:{models[robot.model].drive}", f"robot {robot.id}")
        if models[robot.model].arm is not None:
            needs.setdefault("arms", f"robot {robot.id}")
    for event in scenario.events:
        if event.kind in FREEZING:
            needs.setdefault("freeze", f"event {event.kind.value} at {event.time:g} s")
        elif event.kind is ScenarioEventKind.ROBOT_REMOVED:
            needs.setdefault("remove", f"event {event.kind.value} at {event.time:g} s")
    if scenario.bodies or scenario.dispensers:
        first = f"body {scenario.bodies[0].id}" if scenario.bodies else f"dispenser {scenario.dispensers[0].id}"
        needs.setdefault("bodies", first)
        for robot in scenario.robots:
            if {GRIPPER, "magnet"}.intersection(models[robot.model].actuators):
                needs.setdefault("attach", f"robot {robot.id}")
    for capability, who in needs.items():
        if capability not in capabilities:
            yield _lack(who, scenario.world, capability, capabilities)


def blind_sensors(scenario: ScenarioSpec, mounts: Iterable[Mount], capabilities: Collection[str]) -> Iterator[str]:
    """Find the sensors that want rays of a world that casts none.

    Yields:
        One line for each sensor and robot, with what the world can do.
    """
    if "ranges" not in capabilities:
        for mount in mounts:
            if mount.rays is not None:
                for carrier in mount.carriers:
                    yield _lack(where_it_is(carrier.context), scenario.world, "ranges", capabilities)


def _lack(who: str, name: str, capability: str, capabilities: Collection[str]) -> str:
    offered = ", ".join(sorted(capabilities)) or "nothing"
    return f"{who}: world {name} lacks {capability}; it can do: {offered}"
