from __future__ import annotations

import math
from typing import Any, List, Optional, Tuple

import pytest

from rqt_mrta_py.errors import RobotError
from rqt_mrta_py.hooks import (
    BehaviourStep,
    Command,
    Decision,
    Outgoing,
    OutgoingRows,
    Perception,
    Subscription,
    TaskReport,
)
from rqt_mrta_py.model import Pose, Progress, Task, Twist
from tests.robot.hosting import DIG, MOW, Digger, Scripted, about, hear, hear_progress, make_host, progress_codes, run


def test_host_says_what_an_agent_says_together_in_its_place() -> None:
    agent = Scripted(lambda _: None)
    alone, rows = (
        Outgoing("a", "std_msgs/String", {}),
        OutgoingRows(("b", "b"), "std_msgs/String", {"data": ("x", "y")}),
    )
    agent.step = lambda situation: Decision(None, (alone, rows, alone))  # type: ignore[method-assign]
    assert make_host(agent).step(0, 1.0) == [alone, rows, alone]


def test_host_refuses_a_behaviour_that_says_many_together() -> None:
    step = BehaviourStep(messages=(OutgoingRows(("a",), "std_msgs/String", {}),))  # type: ignore[arg-type]
    with pytest.raises(RobotError, match=r"behaviour 'dig' on task 'dig1' failed .*; accepted is Outgoing"):
        make_host(Scripted(lambda _: "dig1"), dig=Digger((step,))).step(0, 1.0)


def test_host_steps_the_agent_at_its_own_rate_and_the_behaviour_every_tick() -> None:
    agent, digger = Scripted(lambda _: "dig1", rate=7.5), Digger()
    run(make_host(agent, dig=digger), 9)
    # ceil(k * 20 / 7.5) = 0, 3, 6, 8
    assert [situation.now for situation in agent.told] == pytest.approx([1.0, 1.15, 1.3, 1.4])
    assert digger.stepped == 9


def test_host_makes_up_for_the_agents_steps_in_skipped_ticks_with_one() -> None:
    agent = Scripted(lambda _: None, rate=10.0)
    host = make_host(agent)
    for tick in (0, 1, 101, 102, 103, 104):  # steps 1 to 50 fell into the gap
        host.step(tick, 1.0 + tick / 20)
    assert [situation.now for situation in agent.told] == pytest.approx([1.0, 6.05, 6.1, 6.2])


def test_host_publishes_commands_as_a_robot_takes_them() -> None:
    steps = (BehaviourStep((Command("base", Twist(0.5, 0.0, 0.1)), Command("gripper", 0.3))),)
    said = make_host(Scripted(lambda _: "dig1"), dig=Digger(steps)).step(0, 1.0)
    assert said[-2:] == [
        Outgoing("cmd_vel", "geometry_msgs/Twist", {"linear": {"x": 0.5, "y": 0.0}, "angular": {"z": 0.1}}),
        Outgoing("gripper/command", "std_msgs/Float64", {"data": 0.3}),
    ]


def test_host_stops_actuators_that_are_commanded_no_more_once() -> None:
    steps = (BehaviourStep((Command("base", Twist(0.5)), Command("gripper", 0.3))),)
    agent = Scripted(lambda cycle: "dig1" if cycle == 0 else "mow1" if cycle == 1 else None)
    host = make_host(agent, dig=Digger(steps), mow=Digger((BehaviourStep((Command("base", Twist(0.2)),)),)))
    host.step(0, 1.0)
    switched = host.step(1, 1.05)
    assert [fields["linear"]["x"] for fields in about(switched, "cmd_vel")] == [0.2]
    assert about(switched, "gripper/command") == [{"data": 0.0}]
    idle = host.step(2, 1.1)
    assert about(idle, "cmd_vel") == [{"linear": {"x": 0.0, "y": 0.0}, "angular": {"z": 0.0}}]
    assert about(idle, "gripper/command") == []
    assert about(host.step(3, 1.15), "cmd_vel") == []


def test_host_tells_of_a_task_once_when_it_starts_and_once_when_it_ends() -> None:
    steps = (BehaviourStep(), BehaviourStep(), BehaviourStep(progress=Progress.DONE, detail="dug"))
    agent = Scripted(lambda _: "dig1", rate=10.0)
    host = make_host(agent, dig=Digger(steps))
    said = run(host, 10)
    assert about(said, "/mrta/task_progress") == [
        {"header": {"stamp": 1.0}, "task_id": "dig1", "robot_id": "robot1", "progress": 0, "detail": ""},
        {"header": {"stamp": 1.1}, "task_id": "dig1", "robot_id": "robot1", "progress": 1, "detail": "dug"},
    ]
    lines = about(said, "/rosout")
    assert [(line["level"], line["name"], line["msg"]) for line in lines] == [
        (2, "/robot1/agent", "robot=robot1 task=dig1 running"),
        (2, "/robot1/agent", "robot=robot1 task=dig1 done: dug"),
        (4, "/robot1/agent", "robot=robot1 task=dig1 chosen, but it is finished"),
    ]
    # Done in tick 2, told at the agent's next cycle, which is tick 4.
    assert [list(situation.reports) for situation in agent.told] == [
        [],
        [],
        [TaskReport("dig1", Progress.DONE, "dug", "robot1")],
        [],
        [],
    ]


@pytest.mark.parametrize("progress", [Progress.DONE, Progress.FAILED])
def test_host_does_not_carry_out_a_finished_task_again(progress: Progress) -> None:
    agent, digger = Scripted(lambda _: "dig1"), Digger((BehaviourStep(progress=progress),))
    host = make_host(agent, dig=digger)
    run(host, 10)
    assert digger.started == 1
    assert host.task is None
    assert [situation.applicable["dig1"] for situation in agent.told] == [True] + [False] * 9


def test_host_tries_an_unreachable_task_again_when_the_agent_does() -> None:
    agent = Scripted(lambda cycle: "dig1" if cycle in (0, 4) else None)
    digger = Digger((BehaviourStep(progress=Progress.UNREACHABLE, detail="no way"),))
    said = run(make_host(agent, dig=digger), 6)
    assert progress_codes(said) == [("dig1", 0), ("dig1", 3), ("dig1", 0), ("dig1", 3)]
    assert agent.told[1].applicable["dig1"]


def test_host_starts_a_behaviour_anew_after_it_did_something_else() -> None:
    agent = Scripted(lambda cycle: ["dig1", "mow1", "dig1", None, "dig1"][cycle])
    digger = Digger()
    said = run(make_host(agent, dig=digger), 5)
    assert digger.started == 3
    assert progress_codes(said) == [("dig1", 0), ("mow1", 0), ("dig1", 0), ("dig1", 0)]


def test_host_gives_each_behaviour_what_it_subscribed_to_by_the_name_used() -> None:
    near, far = Digger(), Digger(wishes=(Subscription("scan", "sensor_msgs/LaserScan", ("range_max",)),))
    agent = Scripted(lambda cycle: "dig1" if cycle == 0 else "mow1")
    host = make_host(agent, dig=near, mow=far)
    host.step(0, 1.0)
    hear(host, "scan", {"ranges": [1.0, 2.0], "range_max": 4.0}, receipt=1.04)
    host.step(1, 1.05)
    assert near.seen == [None]
    assert far.seen[0] is not None
    assert far.seen[0].fields == {"range_max": 4.0}
    assert far.seen[0].receipt == 1.04


def test_host_shares_one_listener_among_behaviours_that_wish_the_same() -> None:
    one, other = Digger(), Digger()
    agent = Scripted(lambda cycle: "dig1" if cycle == 0 else "mow1")
    host = make_host(agent, dig=one, mow=other)
    assert [wish.topic for wish, _ in host.listeners()].count("scan") == 1
    hear(host, "scan", {"ranges": [1.0]})
    run(host, 2)
    assert one.seen[0] is other.seen[0] is not None


def test_host_knows_its_pose_from_the_localiser() -> None:
    digger, agent = Digger(), Scripted(lambda _: "dig1")
    host = make_host(agent, dig=digger)
    host.step(0, 1.0)
    # A quarter turn to the left: half the angle is 45 degrees.
    quarter = {"x": 0.0, "y": 0.0, "z": math.sqrt(0.5), "w": math.sqrt(0.5)}
    fields = {"pose/position/x": 2.0, "pose/position/y": -1.0}
    fields.update({f"pose/orientation/{axis}": value for axis, value in quarter.items()})
    hear(host, "pose", fields)
    host.step(1, 1.05)
    assert agent.told[0].pose is None
    assert agent.told[1].pose == digger.poses[1] == Pose(2.0, -1.0, pytest.approx(math.pi / 2))
    hear(host, "pose", {**fields, "pose/position/x": math.nan})
    host.step(2, 1.1)
    assert agent.told[2].pose == agent.told[1].pose


def test_host_hands_the_agent_what_came_since_its_last_step_in_order() -> None:
    agent = Scripted(lambda _: None, rate=10.0)
    host = make_host(agent)
    host.step(0, 1.0)
    hear(host, "/team", {"data": "a"})
    host.step(1, 1.05)
    hear(host, "/team", {"data": "b"})
    run(host, 3, first=2)
    assert [[heard.fields["data"] for heard in situation.heard] for situation in agent.told] == [[], ["a", "b"], []]


def test_host_tells_the_agent_what_its_tasks_cost() -> None:
    agent = Scripted(lambda _: None)
    host = make_host(agent)
    host.step(0, 1.0)
    assert agent.told[0].cost("dig1") == 3.5
    with pytest.raises(RobotError, match=r"robot1: agent Scripted asked for the cost of task 'sow1', which this robot"):
        agent.told[0].cost("sow1")


@pytest.mark.parametrize(
    ("robot", "code", "told", "goes_on"),
    [
        ("/robot2", 0, [], True),  # RUNNING there
        ("robot2", 1, [(Progress.DONE, "robot2")], False),
        ("", 1, [(Progress.DONE, None)], False),
        ("/robot2", 2, [(Progress.FAILED, "robot2")], False),
        ("robot2", 3, [], True),  # UNREACHABLE for robot2 only
        ("", 4, [(Progress.APPEARED, None)], True),
        ("", 5, [(Progress.WITHDRAWN, None)], False),
        ("robot1", 5, [(Progress.WITHDRAWN, None)], False),
        ("robot2", 6, [(Progress.REASSIGNED, "robot2")], True),
        ("/robot1", 6, [(Progress.REASSIGNED, "robot1")], True),
        ("", 6, [(Progress.REASSIGNED, None)], True),
        ("robot1", 1, [], True),  # its own echo
        ("/robot1", 0, [], True),  # its own echo
        ("robot2", 77, [], True),  # a number that nobody has defined
    ],
)
def test_host_hears_what_others_say_of_tasks(
    robot: str, code: int, told: List[Tuple[Progress, Optional[str]]], goes_on: bool
) -> None:
    agent = Scripted(lambda _: "dig1")
    host = make_host(agent)
    host.step(0, 1.0)
    hear_progress(host, "/dig1", robot, code, detail="because")
    said = host.step(1, 1.05)
    assert list(agent.told[1].reports) == [TaskReport("dig1", progress, "because", who) for progress, who in told]
    assert (host.task == "dig1") is goes_on
    assert agent.told[1].applicable["dig1"] is goes_on
    assert progress_codes(said) == []


def test_host_paused_hears_nothing_says_nothing_and_keeps_what_it_remembers() -> None:
    agent, digger = Scripted(lambda _: "dig1"), Digger()
    host = make_host(agent, dig=digger)
    hear(host, "/team", {"data": "before"})
    hear(host, "scan", {"ranges": [1.0]})
    host.step(0, 1.0)
    host.pause()
    hear(host, "/team", {"data": "meanwhile"})
    hear(host, "scan", {"ranges": [9.0]})
    hear_progress(host, "dig1", "robot2", 1)
    assert run(host, 5, first=1) == []
    host.resume()
    said = host.step(6, 1.3)
    assert [situation.now for situation in agent.told] == [1.0, 1.3]
    assert agent.told[1].heard == ()
    assert agent.told[1].reports == ()
    assert [heard.fields["ranges"] for heard in digger.seen if heard] == [[1.0], [1.0]]
    assert digger.started == 1
    assert len(about(said, "cmd_vel")) == 1


def test_host_refuses_a_task_without_a_behaviour_when_it_is_made() -> None:
    with pytest.raises(RobotError) as caught:
        make_host(Scripted(lambda _: None), tasks=(DIG, Task("sow1", "sow")))
    assert str(caught.value) == ("robot1: task 'sow1': no behaviour carries out the kind 'sow'; there are 'dig', 'mow'")


def test_host_refuses_two_tasks_of_one_id_when_it_is_made() -> None:
    with pytest.raises(RobotError, match="robot1: two tasks with the id 'dig1'; ids must be unique"):
        make_host(Scripted(lambda _: None), tasks=(DIG, DIG))


def test_host_refuses_an_agent_without_a_rate_when_it_is_made() -> None:
    with pytest.raises(RobotError, match=r"robot1: agent Scripted: a rate of 0\.0 Hz; it must be a finite number"):
        make_host(Scripted(lambda _: None, rate=0.0))


def test_host_refuses_a_behaviour_that_subscribes_twice_to_one_topic() -> None:
    twice = Digger(wishes=(Subscription("scan", "", ("a",)), Subscription("scan", "", ("b",))))
    with pytest.raises(RobotError, match="robot1: behaviour 'dig' subscribes to 'scan' twice; one subscription"):
        make_host(Scripted(lambda _: None), dig=twice)


def test_host_names_a_choice_that_the_robot_does_not_have() -> None:
    host = make_host(Scripted(lambda _: "sow1"))
    with pytest.raises(RobotError) as caught:
        host.step(0, 1.0)
    assert str(caught.value) == (
        "robot1: agent Scripted chose task 'sow1', which this robot does not have; it has 'dig1', 'mow1'"
    )


def test_host_names_an_agent_that_raises() -> None:
    def fail(_: int) -> Optional[str]:
        raise KeyError("motivation")

    with pytest.raises(
        RobotError, match=r"robot1: agent Scripted failed at 1\.000 s: KeyError: 'motivation'"
    ) as caught:
        make_host(Scripted(fail)).step(0, 1.0)
    assert isinstance(caught.value.__cause__, KeyError)


def test_host_asks_behaviours_about_all_tasks_when_it_is_made() -> None:
    """A speed of 99 m/s once came out at the first tick only, with a folder of outputs begun."""

    def refuse(task: Task, _: Perception) -> bool:
        raise ValueError(f"task {task.id!r}: data/speed: must be from 0.02 to 5 m/s (got 99.0)")

    digger = Digger()
    digger.applicable = refuse  # type: ignore[method-assign]
    with pytest.raises(RobotError) as caught:
        make_host(Scripted(lambda _: None), tasks=(DIG, MOW, Task("dig2", "dig")), dig=digger)
    assert str(caught.value).splitlines() == [
        f"robot1: behaviour 'dig' on task '{task}' cannot begin: "
        f"ValueError: task '{task}': data/speed: must be from 0.02 to 5 m/s (got 99.0)"
        for task in ("dig1", "dig2")
    ]
    assert isinstance(caught.value.__cause__, ValueError)


@pytest.mark.parametrize("method", ["applicable", "start", "step"])
def test_host_names_a_behaviour_that_raises(method: str) -> None:
    digger = Digger()
    host = make_host(Scripted(lambda _: "dig1"), dig=digger)

    def fail(*_: object) -> Any:
        raise ValueError("bent spade")

    setattr(digger, method, fail)
    expected = r"robot1: behaviour 'dig' on task 'dig1' failed at 1\.000 s: ValueError: bent spade"
    with pytest.raises(RobotError, match=expected) as caught:
        host.step(0, 1.0)
    assert isinstance(caught.value.__cause__, ValueError)


@pytest.mark.parametrize(
    ("step", "message"),
    [
        (BehaviourStep((Command("base", 0.5),)), "a command to 'base' of 0.5; it takes a Twist"),
        (BehaviourStep((Command("gripper", Twist()),)), "a command to 'gripper' of .*; it takes a number"),
        (BehaviourStep((Command("base", Twist(math.nan)),)), "only finite numbers are accepted"),
        (BehaviourStep((Command("arm", 1.0), Command("arm", 2.0))), "two commands to 'arm' in one tick"),
        (BehaviourStep(progress=Progress.WITHDRAWN), "RUNNING, DONE, FAILED, UNREACHABLE are accepted"),
    ],
)
def test_host_refuses_steps_that_do_not_fit(step: BehaviourStep, message: str) -> None:
    with pytest.raises(RobotError, match=f"robot1: behaviour 'dig' on task 'dig1' failed .*{message}"):
        make_host(Scripted(lambda _: "dig1"), dig=Digger((step,))).step(0, 1.0)


def test_host_refuses_ticks_that_do_not_increase() -> None:
    host = make_host(Scripted(lambda _: None))
    host.step(3, 1.15)
    with pytest.raises(ValueError, match="robot1: tick 3 after tick 3; ticks must increase"):
        host.step(3, 1.2)


@pytest.mark.parametrize(
    ("answer", "complaint"),
    [
        ("dig1", "answered 'dig1'; accepted is Decision"),
        (Decision(None, ("hello",)), "answered 'hello'; accepted is Outgoing"),  # type: ignore[arg-type]
        (
            Decision(None, (OutgoingRows("ab", "x/Y", {}),)),
            "answered an OutgoingRows on 'ab'; accepted is a tuple of te",
        ),  # type: ignore[arg-type]
        (Decision(None, (OutgoingRows((7,), "x/Y", {}),)), r"answered an OutgoingRows on \(7,\); accepted is a tuple"),  # type: ignore[arg-type]
        (Decision(None, (OutgoingRows(("a",), None, {}),)), "answered an OutgoingRows of type None; accepted is a tex"),  # type: ignore[arg-type]
        (
            Decision(None, (OutgoingRows(("a",), "x/Y", ()),)),  # type: ignore[arg-type]
            r"answered an OutgoingRows of 'x/Y' with columns \(\); accepted is a mapping",
        ),
        (
            Decision(None, (OutgoingRows(("a",), "x/Y", {"data": ("b", "c")}),)),
            "answered an OutgoingRows of 'x/Y' with 2 rows of 'data' for 1 topics; accepted are one row a topic",
        ),
        (Decision(None, None), "'NoneType' object is not iterable"),  # type: ignore[arg-type]
    ],
)
def test_host_names_an_agent_whose_answer_is_none(answer: Any, complaint: str) -> None:
    agent = Scripted(lambda _: None)
    agent.step = lambda situation: answer  # type: ignore[method-assign]
    with pytest.raises(RobotError, match=f"robot1: agent Scripted failed at 1.000 s: TypeError: {complaint}"):
        make_host(agent).step(0, 1.0)


@pytest.mark.parametrize("answer", [None, (), {"commands": ()}])
def test_host_names_a_behaviour_whose_answer_is_none(answer: Any) -> None:
    digger = Digger()
    digger.step = lambda task, perception: answer  # type: ignore[method-assign]
    with pytest.raises(RobotError, match=r"behaviour 'dig' on task 'dig1' failed at 1\.000 s: TypeError: answered"):
        make_host(Scripted(lambda _: "dig1"), dig=digger).step(0, 1.0)


@pytest.mark.parametrize("wishes", [None, ["scan"]])
def test_host_names_who_subscribes_to_nothing_that_is_a_subscription(wishes: Any) -> None:
    with pytest.raises(RobotError, match=r"robot1: behaviour 'dig' failed at 0\.000 s: TypeError: "):
        make_host(Scripted(lambda _: None), dig=Digger(wishes=wishes))
