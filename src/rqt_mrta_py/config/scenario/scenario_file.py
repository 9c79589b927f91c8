"""From the text of a scenario.yaml to what is simulated."""

from __future__ import annotations

from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

from rqt_mrta_py.config.problems import Problems
from rqt_mrta_py.config.scenario.events import read_events
from rqt_mrta_py.config.scenario.form import SCENARIO_FILE
from rqt_mrta_py.config.yaml.places import PLACE, pose_of
from rqt_mrta_py.config.yaml.rows import Row, read_document
from rqt_mrta_py.config.yaml.text import parse_yaml
from rqt_mrta_py.model import (
    MAPPED_TOPICS,
    Arena,
    Dispenser,
    LooseBody,
    MapKnowledge,
    Obstacle,
    Pose,
    RadioSetup,
    RobotSetup,
    ScenarioSpec,
    SensorSetup,
    is_legal_name,
    normalise_id,
)
from rqt_mrta_py.wording import accepted, shown

__all__ = ["read_scenario"]


def read_scenario(
    text: Union[str, bytes],
    path: str,
    robots: Optional[Sequence[str]] = None,
    tasks: Optional[Sequence[str]] = None,
) -> ScenarioSpec:
    """Read what is simulated.

    Args:
        text: the whole file.
        path: by which problems name the file.
        robots: ids of the application's robots, which must be those of the scenario; None: not checked.
        tasks: ids of the application's tasks, to which alone something may happen; None: not checked.

    Raises:
        ConfigError: with everything that is wrong, sorted by line.
    """
    problems = Problems(path)
    root = read_document(parse_yaml(text, path), SCENARIO_FILE, problems)
    robot_rows: List[Row] = root.values["robots"] or []
    obstacle_rows: List[Row] = root.values["obstacles"] or []
    body_rows: List[Row] = root.values["bodies"] or []
    dispenser_rows: List[Row] = root.values["dispensers"] or []
    event_rows: List[Row] = root.values["events"] or []
    defaults: Optional[Row] = root.values["robot_defaults"]
    names = _check_ids(robot_rows, "robots", problems)
    _check_ids(obstacle_rows, "obstacles", problems)
    _check_ids(body_rows, "bodies", problems)
    _check_ids(dispenser_rows, "dispensers", problems)
    if robots is not None:
        _check_team(root, robot_rows, names, robots, problems)
    _check_arena(root.values["arena"], problems)
    for row in obstacle_rows:
        _check_obstacle(row, problems)
    for row in [*body_rows, *dispenser_rows]:
        _check_size(row, problems)
    for row in [*([defaults] if defaults is not None else []), *robot_rows]:
        _check_sensors(row, problems)
    for row in robot_rows:
        _check_map(row, defaults, problems)
    events = read_events(event_rows, list(names), tasks, problems)
    problems.raise_if_any()
    arena: Dict[str, float] = root.values["arena"].values
    return ScenarioSpec(
        arena=Arena(**arena),
        obstacles=tuple(_obstacle(row) for row in obstacle_rows),
        robots=tuple(_robot(row, defaults) for row in robot_rows),
        events=tuple(events),
        world=root.values["world"],
        duration=root.values["duration"],
        control_rate=root.values["control_rate"],
        picture_period=root.values["picture_period"],
        radio=_radio(root.values["radio"]),
        planner=root.values["planner"],
        bodies=tuple(_body(row) for row in body_rows),
        dispensers=tuple(_dispenser(row) for row in dispenser_rows),
        linger=root.values["linger"],
    )


def _check_ids(rows: List[Row], what: str, problems: Problems) -> Dict[str, int]:
    """Note ids that are unfit or stand twice; give the line of each id."""
    lines: Dict[str, int] = {}
    for row in rows:
        value = row.values["id"]
        if not isinstance(value, str):
            continue
        name = normalise_id(value)
        line, element = row.at("id")
        if any(character.isspace() for character in name) or not name:
            problems.add(line, element, f"must be a name without spaces (got {shown(value)})")
        elif name in lines:
            problems.add(line, element, f"{name!r} names two {what}; the first one is in line {lines[name]}")
        elif what == "robots" and not is_legal_name(f"/{name}"):
            problems.add(line, element, f"must be a name that ROS accepts: letters, digits and _ (got {shown(value)})")
        lines.setdefault(name, line)
    return lines


def _check_team(root: Row, rows: List[Row], names: Dict[str, int], team: Sequence[str], problems: Problems) -> None:
    for row in rows:
        name = normalise_id(row.values["id"] or "")
        if name and name not in team:
            problems.add(*row.at("id"), f"{name!r} is no robot of the application; {accepted(name, team)}")
    missing = [name for name in team if name not in names]
    if missing and root.values["robots"] is not None:
        problems.add(*root.at("robots"), f"the application also has {', '.join(missing)}; say where they start")


def _check_arena(row: Optional[Row], problems: Problems) -> None:
    if row is None:
        return
    for axis in ("x", "y"):
        low, high = row.values[f"min_{axis}"], row.values[f"max_{axis}"]
        if low is not None and high is not None and low >= high:
            problems.add(*row.at(f"max_{axis}"), f"must be above min_{axis}, which is {low:g} m (got {high:g})")


def _check_size(row: Row, problems: Problems) -> bool:
    """Note a size that is none; tell whether it is one."""
    size = row.values["size"]
    if size is None:
        return False
    if min(size) <= 0.0:
        problems.add(*row.at("size"), f"must be above 0 m in each direction (got {shown(list(size))})")
        return False
    return True


def _check_obstacle(row: Row, problems: Problems) -> None:
    size = row.values["size"]
    if _check_size(row, problems) and row.values["shape"] == "cylinder" and size[0] != size[1]:
        problems.add(*row.at("size"), f"of a cylinder begins with its diameter twice (got {shown(list(size))})")


def _check_sensors(row: Row, problems: Problems) -> None:
    sensors: Sequence[Row] = row.values["sensors"] or ()
    for sensor in sensors:
        topic = sensor.values["topic"]
        if topic is not None and not is_legal_name(topic):
            problems.add(*sensor.at("topic"), f"must be a name that ROS accepts (got {shown(topic)}), such as scan")


def _check_map(row: Row, defaults: Optional[Row], problems: Problems) -> None:
    """Note a robot that shall map and cannot: for want of a range finder, or because it does not know where it is."""
    if _equipment(row, defaults, "map") != MapKnowledge.UNKNOWN.value:
        return
    sensors: Sequence[Row] = _equipment(row, defaults, "sensors") or ()
    topics = [sensor.values["topic"] for sensor in sensors]
    missing = [topic for topic in MAPPED_TOPICS if topic not in topics]
    if missing and None not in topics:
        given = row if defaults is None or "map" in row.given else defaults
        needed = " and ".join(MAPPED_TOPICS)
        problems.add(
            *given.at("map"),
            f"{row.values['id'] or 'the robot'} has no sensor on the topic {' nor on '.join(missing)}, by which it "
            f"could map; give it sensors on {needed}, or let the map be {MapKnowledge.KNOWN.value}",
        )


def _equipment(row: Row, defaults: Optional[Row], key: str) -> Any:
    """Give what a robot has: what it says itself, else what all have."""
    return row.values[key] if defaults is None or key in row.given else defaults.values[key]


def _obstacle(row: Row) -> Obstacle:
    return Obstacle(normalise_id(row.values["id"]), _pose(row), _size(row), row.values["shape"])


def _body(row: Row) -> LooseBody:
    mass, kind, friction = (row.values[key] for key in ("mass", "kind", "friction"))
    return LooseBody(normalise_id(row.values["id"]), _pose(row), _size(row), mass, kind, friction)


def _dispenser(row: Row) -> Dispenser:
    mass, kind, friction, stock = (row.values[key] for key in ("mass", "kind", "friction", "stock"))
    return Dispenser(normalise_id(row.values["id"]), _pose(row), _size(row), mass, kind, friction, stock)


def _pose(row: Row) -> Pose:
    return Pose(row.values["x"], row.values["y"], row.values["yaw"])


def _size(row: Row) -> Tuple[float, float, float]:
    length, width, height = row.values["size"]
    return length, width, height


def _robot(row: Row, defaults: Optional[Row]) -> RobotSetup:
    start = pose_of(row.values["start"])
    if start is None:
        raise ValueError(f"{row.element} was read without a start; {PLACE.summary}")
    return RobotSetup(
        id=normalise_id(row.values["id"]),
        model=_equipment(row, defaults, "model"),
        start=start,
        sensors=tuple(_sensor(sensor) for sensor in _equipment(row, defaults, "sensors")),
        capabilities=tuple(_equipment(row, defaults, "capabilities")),
        map=MapKnowledge(_equipment(row, defaults, "map")),
    )


def _sensor(row: Row) -> SensorSetup:
    return SensorSetup(row.values["kind"], row.values["topic"], row.values["rate"], row.further)


def _radio(row: Optional[Row]) -> RadioSetup:
    return RadioSetup() if row is None else RadioSetup(row.values["kind"], row.further)
