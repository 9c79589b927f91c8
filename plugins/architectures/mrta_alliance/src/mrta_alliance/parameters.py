"""What one robot is told about itself, in words; the file's names and the paper's letters stand beside them.

Every value checks its own ranges when it is made and then refuses with all that is wrong at once. Defaults are those
of the template in ``rqt_mrta.xml``, save for ``head_start``: files of the original nodes lack it and mean none.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import List, Tuple

from mrta_alliance.equations import TIME_TOLERANCE
from rqt_mrta_py.hooks import ParameterProblem, ParameterRangeError

__all__ = ["AllianceParameters", "BehaviourSetParameters", "SensorParameters"]


@dataclass(frozen=True)
class SensorParameters:
    """One of the robot's sensors (``sensors/sensor<i>``).

    Attributes:
        topic_name: where it publishes, in the robot's namespace unless it begins with a slash.
        timeout_duration: for how long a message is up to date [s].
        buffer_horizon: for how long messages are kept [s].
        plugin_name: of its reader.
    """

    topic_name: str
    timeout_duration: float = 5.0
    buffer_horizon: float = 5.0
    plugin_name: str = "mrta_alliance/any_message"

    def __post_init__(self) -> None:
        problems: List[ParameterProblem] = []
        if not self.plugin_name:
            problems.append(ParameterProblem("plugin_name", "must name a sensor (got nothing)"))
        if not self.topic_name:
            problems.append(ParameterProblem("topic_name", "must name a topic (got nothing)"))
        _above_zero(problems, "timeout_duration", self.timeout_duration, "s")
        _above_zero(problems, "buffer_horizon", self.buffer_horizon, "s")
        _refuse(problems)


@dataclass(frozen=True)
class BehaviourSetParameters:
    """One behaviour set c_ij (``behaviour_sets/behaviour_set<i>``).

    Attributes:
        task_id: the task h_i(c_ij) that it carries out.
        task_expected_duration: how long this robot takes for it; announced to the others, whose phi it becomes [s].
        threshold: theta, the motivation at which it becomes active [1].
        yielding_delay: psi, after what time of activity it yields to another robot [s].
        giving_up_delay: lambda, after what time of activity it gives up [s].
        fast_rate: delta_fast, growth of motivation in a cycle while nobody carries out the task [1].
        head_start: by what share motivation grows faster in the team's first robot than in its last, and evenly less
            in those between [1]. Differs from the paper: equation 3.7 times 1 + head_start x seniority, so that fast
            and slow rates grow alike. Equal robots that cycle at the same moments would decide alike for ever;
            hardware differs by itself.
        fairness: how much faster the motivation for a perpetual task grows the longer other perpetual tasks have been
            carried out than it [1]. Differs from the paper: see ``fairness``; 0 follows the equations.
        evaluator: name of the sensory evaluator, asked only if there are sensors.
        sensors: topics of the robot's sensors that it is judged by, in file order.
    """

    task_id: str
    task_expected_duration: float = 1800.0
    threshold: float = 30.0
    yielding_delay: float = 20.0
    giving_up_delay: float = 300.0
    fast_rate: float = 1.0
    head_start: float = 0.0
    fairness: float = 0.0
    evaluator: str = "basic_behaviours/all_sensors_fresh"
    sensors: Tuple[str, ...] = ()

    def __post_init__(self) -> None:
        problems: List[ParameterProblem] = []
        if not self.task_id:
            problems.append(ParameterProblem("task_id", "must name a task (got nothing)"))
        inner = "motivational_behaviour"
        _above_zero(problems, "task_expected_duration", self.task_expected_duration, "s")
        _above_zero(problems, f"{inner}/threshold", self.threshold)
        _at_least_zero(problems, f"{inner}/acquiescence/yielding_delay", self.yielding_delay, "s")
        _above_zero(problems, f"{inner}/acquiescence/giving_up_delay", self.giving_up_delay, "s")
        _above_zero(problems, f"{inner}/impatience/fast_rate", self.fast_rate)
        _at_least_zero(problems, f"{inner}/impatience/head_start", self.head_start)
        _at_least_zero(problems, f"{inner}/impatience/fairness", self.fairness)
        if self.sensors and not self.evaluator:
            problems.append(
                ParameterProblem(f"{inner}/sensory_feedback/plugin_name", "must name a sensory evaluator (got nothing)")
            )
        if not problems and self.task_expected_duration <= self.threshold / self.fast_rate:
            # H1 of the original nodes: an expected duration this short makes every listening node abort.
            least = self.threshold / self.fast_rate
            problems.append(
                ParameterProblem(
                    "task_expected_duration",
                    f"must be above threshold / fast_rate = {least:g} s (got {self.task_expected_duration:g}), "
                    "or announcing the task would slow nobody down",
                )
            )
        _refuse(problems)


@dataclass(frozen=True)
class AllianceParameters:
    """Everything one robot r_i is told.

    Attributes:
        behaviour_sets: in file order, which decides ties; each its own task.
        spin_rate: rho, how often motivations are updated [Hz].
        broadcast_rate: how often the robot announces the task that it carries out [Hz].
        timeout_duration: tau, after what silence another robot counts as stopped [s].
        buffer_horizon: how long announcements of others are kept; the first of each robot is kept for ever [s].
        strict_original: whether the robot times what it does as the original nodes do (see ``original``).
        low_level_feedback: whether a low_level node, such as the original's, judges if tasks are applicable, and is
            heard on ``alliance/sensory_feedback``; the robot's own evaluators are not asked then.
        sensors: of the robot, in file order.
    """

    behaviour_sets: Tuple[BehaviourSetParameters, ...]
    spin_rate: float = 5.0
    broadcast_rate: float = 2.0
    timeout_duration: float = 3.0
    buffer_horizon: float = 10.0
    strict_original: bool = False
    low_level_feedback: bool = False
    sensors: Tuple[SensorParameters, ...] = ()

    def __post_init__(self) -> None:
        problems: List[ParameterProblem] = []
        _above_zero(problems, "spin_rate", self.spin_rate, "Hz")
        _above_zero(problems, "broadcast_rate", self.broadcast_rate, "Hz")
        _above_zero(problems, "timeout_duration", self.timeout_duration, "s")
        _above_zero(problems, "buffer_horizon", self.buffer_horizon, "s")
        if not problems:
            # A robot announces itself at its own cycles, so no more often than either rate.
            period = max(1.0 / self.broadcast_rate, 1.0 / self.spin_rate)
            if self.timeout_duration <= period + TIME_TOLERANCE:
                problems.append(
                    ParameterProblem(
                        "timeout_duration",
                        f"must be above the period of announcements, {period:g} s (got {self.timeout_duration:g}), "
                        "or robots at work would count as stopped",
                    )
                )
            if self.buffer_horizon < self.timeout_duration:
                found = f"(got {self.buffer_horizon:g})"
                problems.append(
                    ParameterProblem(
                        "buffer_horizon", f"must be at least timeout_duration = {self.timeout_duration:g} s {found}"
                    )
                )
        _refuse(problems)


def _above_zero(problems: List[ParameterProblem], path: str, value: float, unit: str = "") -> None:
    if not (math.isfinite(value) and value > 0.0):
        problems.append(ParameterProblem(path, f"must be above 0{' ' * bool(unit)}{unit} (got {value:g})"))


def _at_least_zero(problems: List[ParameterProblem], path: str, value: float, unit: str = "") -> None:
    if not (math.isfinite(value) and value >= 0.0):
        problems.append(ParameterProblem(path, f"must be at least 0{' ' * bool(unit)}{unit} (got {value:g})"))


def _refuse(problems: List[ParameterProblem]) -> None:
    if problems:
        raise ParameterRangeError(tuple(problems))
