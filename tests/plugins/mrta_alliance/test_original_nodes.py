"""Our agent against a recording of the original C++ nodes (section 7.7 of the reference describes it).

Fed is what each recorded robot heard: the other's announcements and the SensoryFeedback of its own low_level node. A
cycle of the agent has one time, while each behaviour set of the original reads the clock anew, 8 to 86 microseconds
after the one before. So each robot is stepped at the stamps of the set that it acts upon (robot1: patrol, robot2:
inspect): that set's time is compared with lambda = 40 s, and it falls due within 20 microseconds of a cycle.

The recording begins in the middle: robot1's first motivation of patrol is 4.5, three cycles of 1.5. So the agent goes
through two such cycles before, which are not compared.
"""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Sequence, Tuple

import pytest

from rqt_mrta_py.hooks import Heard
from tests.plugins.mrta_alliance.team import (
    COMMUNICATION,
    CYCLE,
    agent,
    announced,
    announcements,
    behaviour_set,
    motivations,
    nested,
    step,
)

TASKS = ("patrol", "inspect")
FAST_RATES = {"robot1": (1.5, 1.0), "robot2": (1.0, 1.25)}
ACTS_UPON = {"robot1": "patrol", "robot2": "inspect"}
FIELDS = ("impatience", "acquiescent", "suppressed", "resetted", "applicable", "motivation", "threshold", "active")


class Recorded(NamedTuple):
    """One robot in the recording.

    Attributes:
        motivations: stamp and fields of Motivation messages, by task, in order.
        heard: what it heard, in order of receipt.
        announced: stamps of its own announcements.
        begin: receipt of the recording's first message, of whomever.
    """

    motivations: Mapping[str, List[Tuple[float, Mapping[str, Any]]]]
    heard: List[Heard]
    announced: List[float]
    begin: float


@pytest.fixture(scope="module")
def recording() -> Callable[[Path], Mapping[str, Recorded]]:
    """Read the recording once."""
    known: Dict[Path, Mapping[str, Recorded]] = {}

    def read(path: Path) -> Mapping[str, Recorded]:
        if path not in known:
            known[path] = read_recording(path)
        return known[path]

    return read


def read_recording(path: Path) -> Mapping[str, Recorded]:
    highlevel = pytest.importorskip("rosbags.highlevel")
    typesys = pytest.importorskip("rosbags.typesys")
    store = typesys.get_typestore(typesys.Stores.ROS1_NOETIC)
    with highlevel.AnyReader([path], default_typestore=store) as bag:
        begin = bag.start_time / 1e9
        found = {robot: Recorded({task: [] for task in TASKS}, [], [], begin) for robot in FAST_RATES}
        for connection, receipt_ns, raw in bag.messages():
            message, receipt = bag.deserialize(raw, connection.msgtype), receipt_ns / 1e9
            stamp = message.header.stamp.sec + message.header.stamp.nanosec / 1e9
            sender = message.header.frame_id.lstrip("/")
            if connection.topic == COMMUNICATION:
                duration = message.expected_duration.sec + message.expected_duration.nanosec / 1e9
                found[sender].announced.append(stamp)
                for listener in found.values():
                    listener.heard.append(announced(sender, message.task_id, receipt, duration, stamp))
            elif connection.topic.endswith("/sensory_feedback"):
                found[sender].heard.append(felt(sender, message.task_id, receipt, message.applicable))
            else:
                fields = {name: getattr(message, name) for name in FIELDS}
                found[sender].motivations[message.task_id].append((stamp, fields))
    return found


def felt(robot: str, task: str, receipt: float, applicable: bool = True) -> Heard:
    fields = {"task_id": task, "applicable": applicable}
    return Heard(f"/{robot}/alliance/sensory_feedback", "alliance_msgs/SensoryFeedback", receipt, fields)


class Replay(NamedTuple):
    """How the agent did.

    Attributes:
        compared: how many Motivation messages.
        mismatches: seconds since the recording's begin, task and names of the fields that differ.
        announced: how many of the recorded announcements the agent made in the same cycle.
    """

    compared: int
    mismatches: List[Tuple[float, str, List[str]]]
    announced: int


def replay(robot: str, recorded: Recorded, stamps_of: str, strict_original: bool) -> Replay:
    sets = (behaviour_set(task, rate) for task, rate in zip(TASKS, FAST_RATES[robot]))
    told = nested(*sets, strict_original=strict_original, low_level_feedback=True)
    one = agent(robot, told, TASKS, tuple(FAST_RATES))
    times = [stamp for stamp, _ in recorded.motivations[stamps_of]]
    early = times[0] - 2.5 * CYCLE
    step(one, early, [felt(robot, task, early) for task in TASKS])
    growing = 2 if strict_original else 1  # feedback that is taken in first counts a cycle earlier
    for cycle in range(growing, 0, -1):
        step(one, times[0] - cycle * CYCLE)
    heard, mismatches, met = list(recorded.heard), [], 0
    for index, now in enumerate(times):
        came = list(itertools.takewhile(lambda each, now=now: each.receipt <= now, heard))  # type: ignore[misc]
        del heard[: len(came)]
        decision = step(one, now, came)
        said = motivations(decision)
        for task in TASKS:
            names = differing(recorded.motivations[task][index][1], said[task])
            if names:
                mismatches.append((now - recorded.begin, task, names))
        met += bool(announcements(decision)) and any(now < each < now + CYCLE / 2 for each in recorded.announced)
    return Replay(len(times) * len(TASKS), mismatches, met)


def differing(recorded: Mapping[str, Any], said: Mapping[str, Any]) -> List[str]:
    """Name what differs: flags at all, numbers by more than 1e-9."""
    return [name for name in FIELDS if abs(recorded[name] - said[name]) > 1e-9]


Read = Callable[[Path], Mapping[str, Recorded]]


@pytest.mark.parametrize(("robot", "messages"), [("robot1", 738), ("robot2", 1240)])
def test_strict_agent_says_every_recorded_motivation(
    shared_data: Callable[[str], Path], recording: Read, robot: str, messages: int
) -> None:
    """Asked for are 99.5 %; all 1978 match, in all flags, impatience and motivation."""
    recorded = recording(shared_data("alliance_two_robots.bag"))[robot]
    done = replay(robot, recorded, ACTS_UPON[robot], strict_original=True)
    assert (done.compared, done.mismatches) == (messages, [])


@pytest.mark.parametrize(("robot", "all_of_them", "same_cycle"), [("robot1", 131, 131), ("robot2", 219, 205)])
def test_strict_agent_announces_when_the_original_did(
    shared_data: Callable[[str], Path], recording: Read, robot: str, all_of_them: int, same_cycle: int
) -> None:
    """336 of 350 in the very cycle, the rest one cycle off: the timer fell due within a millisecond of a cycle's end.

    Whether its thread was in time then, no message tells.
    """
    recorded = recording(shared_data("alliance_two_robots.bag"))[robot]
    assert len(recorded.announced) == all_of_them
    assert replay(robot, recorded, ACTS_UPON[robot], strict_original=True).announced == same_cycle


@pytest.mark.parametrize(
    ("robot", "stamps_of", "begin", "end", "count"),
    [("robot1", "inspect", 43.5, 47.8, 42), ("robot2", "patrol", 44.3, 49.6, 50)],
)
def test_times_of_the_other_set_move_one_giving_up_by_one_cycle(
    shared_data: Callable[[str], Path],
    recording: Read,
    *,
    robot: str,
    stamps_of: str,
    begin: float,
    end: float,
    count: int,
) -> None:
    """robot1 was 40.000019 s active when it gave up, robot2 39.999993 s a cycle before it did.

    By the other set's stamps these are 39.999999 and 40.000010: the giving up moves, and with it all up to the next
    activation; after that everything matches again.
    """
    recorded = recording(shared_data("alliance_two_robots.bag"))[robot]
    mismatches = replay(robot, recorded, stamps_of, strict_original=True).mismatches
    assert len(mismatches) == count
    assert all(begin < time < end for time, _, _ in mismatches)


@pytest.mark.parametrize(
    ("robot", "count", "windows"),
    [
        ("robot1", 14, [(5.1, 5.4), (46.6, 48.6), (50.0, 50.2), (65.0, 65.2)]),
        ("robot2", 25, [(4.1, 4.4), (45.1, 49.4), (64.1, 64.3)]),
    ],
)
def test_agent_by_the_equations_differs_where_the_original_departs_from_them(
    shared_data: Callable[[str], Path], recording: Read, robot: str, count: int, windows: Sequence[Tuple[float, float]]
) -> None:
    """39 of 1978 differ.

    Each reset comes a cycle earlier, for the message is taken in before evaluating; impatience is fast again 2 s
    earlier, tau after the last announcement and not 2 tau, so that motivation is ahead until the next activation; it is
    slow again a cycle earlier, as the reset; and the end of phi comes a cycle earlier.
    """
    recorded = recording(shared_data("alliance_two_robots.bag"))[robot]
    mismatches = replay(robot, recorded, ACTS_UPON[robot], strict_original=False).mismatches
    assert len(mismatches) == count
    times = [time for time, _, _ in mismatches]
    assert all(any(begin < time < end for begin, end in windows) for time in times)
    assert all(any(begin < time < end for time in times) for begin, end in windows)
    assert {name for _, _, names in mismatches for name in names} == {"impatience", "resetted", "motivation"}
