"""One task as text: an entry of a tasks.yaml, alone; so tasks that appear on the way travel in messages."""

from __future__ import annotations

from typing import Any, Dict, Optional, Union

from rqt_mrta_py.config.problems import Problems
from rqt_mrta_py.config.yaml.dump import dump_yaml
from rqt_mrta_py.config.yaml.places import PLACE, pose_of
from rqt_mrta_py.config.yaml.rows import Row, read_document
from rqt_mrta_py.config.yaml.schema import Key, Table, ValueType
from rqt_mrta_py.config.yaml.text import parse_yaml
from rqt_mrta_py.model import Pose, Task, normalise_id
from rqt_mrta_py.wording import shown

__all__ = ["TASK", "check_id", "check_layers", "dump_task", "id_of", "read_task", "task_of"]

TASK = Table(
    "task",
    "One piece of work that robots share out among themselves.",
    (
        Key("id", ValueType.TEXT, "Name of the task, unique in the file."),
        Key("kind", ValueType.TEXT, "Name of the behaviour that carries it out."),
        Key(
            "layers",
            ValueType.TEXTS,
            "Kinds of behaviours above that one, from lower to higher. While one of them commands an actuator, what "
            "those below command it does not count. What is told to each stands in `data/layers/<kind>`.",
            default=(),
        ),
        Key("place", ValueType.TABLE, "Where it is done; anywhere if not given.", default=None, table=PLACE),
        Key("capabilities", ValueType.TEXTS, "What a robot must be able to do.", default=()),
        Key("predecessors", ValueType.TEXTS, "Ids of tasks that must be done before.", default=()),
        Key("resources", ValueType.TEXTS, "What the task occupies while it is carried out.", default=()),
        Key("robots", ValueType.WHOLE, "How many robots it needs.", default=1, minimum=1),
        Key("expected_duration", ValueType.NUMBER, "How long one robot is expected to take.", "s", None, above=0),
        Key("perpetual", ValueType.SWITCH, "Whether it never ends by itself.", default=False),
        Key("data", ValueType.FREE, "Whatever its behaviour wants to know besides.", default={}),
    ),
)


def read_task(text: Union[str, bytes], path: str) -> Task:
    """Read one task from the text of its entry.

    Args:
        text: one entry of a tasks.yaml, as a document of its own.
        path: by which problems name the text.

    Raises:
        ConfigError: with everything that is wrong, sorted by line. Whether its predecessors are tasks is not checked.
    """
    problems = Problems(path)
    row = read_document(parse_yaml(text, path), TASK, problems)
    check_id(row, problems)
    check_layers(row, problems)
    name = id_of(row)
    if name in [normalise_id(other) for other in row.values["predecessors"] or ()]:
        problems.add(*row.at("predecessors"), f"go round in a circle: {name} after {name}; take it out")
    problems.raise_if_any()
    return task_of(row)


def dump_task(task: Task) -> str:
    """Write one task as the text of its entry.

    Args:
        task: its data are plain values, numbers finite.

    Returns:
        YAML, ending in a line break; what takes its default is left out. ``read_task`` gives the same task again,
        sequences in its data as lists.
    """
    entry: Dict[str, Any] = {"id": _slashed(task.id), "kind": task.kind}
    if task.layers:
        entry["layers"] = list(task.layers)
    if task.place is not None:
        entry["place"] = _place(task.place)
    lists = {
        "capabilities": task.capabilities,
        "predecessors": [_slashed(other) for other in task.predecessors],
        "resources": task.resources,
    }
    entry.update((key, list(names)) for key, names in lists.items() if names)
    if task.robots != 1:
        entry["robots"] = task.robots
    if task.expected_duration is not None:
        entry["expected_duration"] = task.expected_duration
    if task.perpetual:
        entry["perpetual"] = True
    if task.data:
        entry["data"] = task.data
    return dump_yaml(entry)


def task_of(row: Row) -> Task:
    """Make the task of an entry that was read without problems."""
    values = row.values
    return Task(
        id=normalise_id(values["id"]),
        kind=values["kind"],
        place=pose_of(values["place"]),
        capabilities=values["capabilities"],
        predecessors=tuple(normalise_id(other) for other in values["predecessors"]),
        resources=values["resources"],
        robots=values["robots"],
        expected_duration=values["expected_duration"],
        perpetual=values["perpetual"],
        data=dict(values["data"]),
        layers=values["layers"],
    )


def id_of(row: Row) -> Optional[str]:
    """Give the normalised id of an entry; None where it has none."""
    value = row.values["id"]
    return normalise_id(value) if isinstance(value, str) else None


def check_id(row: Row, problems: Problems) -> None:
    """Note an id that cannot be one."""
    name = id_of(row)
    if name is not None and (not name or any(character.isspace() for character in name)):
        problems.add(*row.at("id"), f"must be a name without spaces (got {shown(row.values['id'])})")


def check_layers(row: Row, problems: Problems) -> None:
    """Note layers that stand twice, or that are the behaviour itself."""
    kind, layers = row.values["kind"], row.values["layers"] or ()
    for index, layer in enumerate(layers):
        if layer == kind:
            problems.add(
                *row.at("layers"), f"names {layer!r}, the task's own kind, which is the lowest layer; take it out"
            )
        elif layer in layers[:index]:
            problems.add(*row.at("layers"), f"names {layer!r} twice; take one of them out")


def _place(pose: Pose) -> Dict[str, float]:
    place = {"x": float(pose.x), "y": float(pose.y)}
    return {**place, "yaw": float(pose.yaw)} if pose.yaw else place


def _slashed(name: str) -> str:
    # Readers drop one leading slash.
    return f"/{name}" if name.startswith("/") else name
