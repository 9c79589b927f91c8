"""The form of a scenario.yaml.

A minimal one is short::

    arena: {min_x: -3, min_y: -3, max_x: 3, max_y: 3}
    robots:
      - {id: robot1, start: {x: 0, y: 0}}
"""

from __future__ import annotations

from rqt_mrta_py.config.scenario.event_form import EVENT, RADIO
from rqt_mrta_py.config.yaml.places import PLACE
from rqt_mrta_py.config.yaml.schema import Key, Table, ValueType
from rqt_mrta_py.model import MapKnowledge

__all__ = ["ARENA", "BODY", "DISPENSER", "OBSTACLE", "ROBOT", "ROBOT_DEFAULTS", "SCENARIO_FILE", "SENSOR"]

ARENA = Table(
    "arena",
    "A rectangle of floor with a wall around it, in the frame map.",
    (
        Key("min_x", ValueType.NUMBER, "Inner face of the wall towards smaller x.", "m"),
        Key("min_y", ValueType.NUMBER, "Inner face of the wall towards smaller y.", "m"),
        Key("max_x", ValueType.NUMBER, "Inner face of the wall towards larger x.", "m"),
        Key("max_y", ValueType.NUMBER, "Inner face of the wall towards larger y.", "m"),
        Key("wall_height", ValueType.NUMBER, "Height of the wall.", "m", 0.3, above=0),
    ),
)

OBSTACLE = Table(
    "obstacle",
    "A fixed body on the floor.",
    (
        Key("id", ValueType.TEXT, "Name of the obstacle, unique in the file."),
        Key("shape", ValueType.TEXT, "What it looks like.", default="box", choices=("box", "cylinder")),
        Key("x", ValueType.NUMBER, "Position of its centre along the x axis.", "m"),
        Key("y", ValueType.NUMBER, "Position of its centre along the y axis.", "m"),
        Key("yaw", ValueType.NUMBER, "Turn of its length, counter-clockwise from the x axis.", "rad", 0.0),
        Key("size", ValueType.NUMBERS, "Length, width, height; a cylinder's diameter stands twice.", "m", count=3),
    ),
)

_LOOSE = (
    Key("kind", ValueType.TEXT, "What it is, as those who look for it call it.", default="thing"),
    Key("x", ValueType.NUMBER, "Position of its centre along the x axis.", "m"),
    Key("y", ValueType.NUMBER, "Position of its centre along the y axis.", "m"),
    Key("yaw", ValueType.NUMBER, "Turn of its length, counter-clockwise from the x axis.", "rad", 0.0),
    Key("size", ValueType.NUMBERS, "Length, width, height.", "m", count=3),
    Key("mass", ValueType.NUMBER, "How heavy it is.", "kg", 0.2, above=0),
    Key("friction", ValueType.NUMBER, "Coefficient of its friction on the floor.", "N/N", 0.5, minimum=0),
)

BODY = Table(
    "body",
    "A loose body on the floor, which robots can push and, with a gripper or a magnet, carry.",
    (Key("id", ValueType.TEXT, "Name of the body; no obstacle or robot has it."), *_LOOSE),
)

DISPENSER = Table(
    "dispenser",
    "A place where bodies of one kind come from: a fresh one appears when the last one has been carried off.",
    (
        Key("id", ValueType.TEXT, "Name of the place; its bodies are called by it, with _1, _2 and so on."),
        *_LOOSE,
        Key(
            "stock",
            ValueType.WHOLE,
            "How many bodies there are in all; as many as are needed if not given.",
            "",
            None,
            1,
        ),
    ),
)

SENSOR = Table(
    "sensor",
    "One simulated sensor; further keys are the parameters of its model.",
    (
        Key("kind", ValueType.TEXT, "Name under which the sensor is registered."),
        Key("topic", ValueType.TEXT, "Where it publishes, relative to the robot's namespace."),
        Key("rate", ValueType.NUMBER, "How often it measures.", "Hz", above=0),
    ),
    further=True,
)

_EQUIPMENT = (
    Key("model", ValueType.TEXT, "Name under which the robot's model is registered.", default="diff_drive"),
    Key("sensors", ValueType.TABLES, "Its sensors.", default=(), table=SENSOR),
    Key("capabilities", ValueType.TEXTS, "What it can do, beyond its model's.", default=()),
    Key(
        "map",
        ValueType.TEXT,
        "Whether it knows the obstacles from the start, or maps what its range finder meets on the topic scan.",
        default=MapKnowledge.KNOWN.value,
        choices=tuple(each.value for each in MapKnowledge),
    ),
)

ROBOT_DEFAULTS = Table("robot_defaults", "What every robot has that does not say otherwise.", _EQUIPMENT)

ROBOT = Table(
    "robot",
    "One simulated robot; a key given here replaces the one in robot_defaults as a whole.",
    (
        Key("id", ValueType.TEXT, "As in the application."),
        Key("start", ValueType.TABLE, "Where it starts.", table=PLACE),
        *_EQUIPMENT,
    ),
)

SCENARIO_FILE = Table(
    "scenario.yaml",
    "Everything that is simulated in one application.",
    (
        Key("world", ValueType.TEXT, "Name under which the world is registered.", default="bullet"),
        Key("duration", ValueType.NUMBER, "Length of the mission, at most.", "s", 60.0, above=0),
        Key(
            "linger",
            ValueType.NUMBER,
            "So long after all tasks have ended that can the mission ends; left out: it goes on to its duration.",
            "s",
            None,
            0.0,
        ),
        Key("control_rate", ValueType.WHOLE, "Control ticks a second.", "Hz", 20, minimum=1, maximum=1000),
        Key(
            "picture_period", ValueType.NUMBER, "Mission time between two monitor pictures; 0 for none.", "s", 1.0, 0.0
        ),
        Key("arena", ValueType.TABLE, "Floor and walls.", table=ARENA),
        Key("obstacles", ValueType.TABLES, "Fixed bodies on the floor.", default=(), table=OBSTACLE),
        Key("bodies", ValueType.TABLES, "Loose bodies on the floor.", default=(), table=BODY),
        Key("dispensers", ValueType.TABLES, "Where further bodies come from.", default=(), table=DISPENSER),
        Key("robot_defaults", ValueType.TABLE, "What robots have in common.", default=None, table=ROBOT_DEFAULTS),
        Key("robots", ValueType.TABLES, "The robots of the application.", table=ROBOT),
        Key("radio", ValueType.TABLE, "The radio between robots; perfect if not given.", default=None, table=RADIO),
        Key(
            "planner",
            ValueType.TEXT,
            "Name under which is registered what robots find their ways with.",
            default="astar",
        ),
        Key("events", ValueType.TABLES, "What happens on the way.", default=(), table=EVENT),
    ),
)
