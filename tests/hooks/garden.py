"""The mission of the stranger's plugin: two moles, of which one digs, in a burrow with a bad radio."""

from __future__ import annotations

from rqt_mrta_py.hooks import RobotModel, Subscription
from rqt_mrta_py.model import (
    ApplicationRobot,
    ApplicationSpec,
    ArchitectureSpec,
    Arena,
    Mission,
    MonitoredTopic,
    Pose,
    RadioSetup,
    RobotSetup,
    ScenarioSpec,
    SensorSetup,
    Task,
    Taxonomy,
)

MILEAGE = Subscription("mileage", "std_msgs/Float64", ("data",))
MOLE = RobotModel("mole", "differential", 0.4, 0.3, 0.2, 0.25, 5.0, 0.05, 0.25, 0.7, 1.0, 0.1)
CLAIM = MonitoredTopic("/@robot_id@/claim/@task_id@", "std_msgs/String", timeout=5.0)
_NOSE = SensorSetup("nose", "smell", 10.0)
SCENARIO = ScenarioSpec(
    arena=Arena(-3.0, -3.0, 3.0, 3.0),
    obstacles=(),
    robots=(
        RobotSetup("mole1", "mole", Pose(1.5, 0.0), (SensorSetup("odometer", "mileage", 10.0), _NOSE)),
        RobotSetup("mole2", "mole", Pose(-1.5, 0.0), (_NOSE,)),
    ),
    world="burrow",
    planner="tunnels",
    control_rate=10,
    radio=RadioSetup("earth", {"delay": 0.65}),
)
MISSION = Mission(
    application=ApplicationSpec(
        "garden", "Garden", robots=(ApplicationRobot("mole1", ("dig",)), ApplicationRobot("mole2"))
    ),
    architecture=ArchitectureSpec(
        "stranger", "Stranger", Taxonomy.parse("ST-SR-IA"), busy_robots=(CLAIM,), widgets=("stranger/mileage",)
    ),
    tasks=(Task("dig", "digging"),),
    scenario=SCENARIO,
    seed=4,
)
