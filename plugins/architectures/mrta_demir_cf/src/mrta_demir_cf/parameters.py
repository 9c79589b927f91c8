"""What one robot is told; the names are those of its YAML file."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum
from typing import Any, Callable, Dict, List, Mapping, Tuple

from mrta_demir_cf.planning.costs import ALPHA, CostFunction, eyh_cost, uem_cost
from rqt_mrta_py.hooks import ParameterProblem, ParameterRangeError, read_fields, wrong_parameters

__all__ = [
    "BALANCED",
    "GREEDY",
    "ROLLOUT",
    "DemirCfParameters",
    "Objective",
    "find_problems",
    "read_parameters",
]

ROLLOUT = "rollout"
"""The value of ``cost`` by which a robot imagines what its neighbours will do."""

BALANCED = "balanced"
"""The value of ``cost`` by which robots keep to a plan for the whole team whose longest route is short."""

GREEDY = "greedy"
"""The value of ``cost`` by which a robot selects what costs itself least, wherever the others are."""

# Longer, and the executions that rqt_mrta.xml monitors would not stay fresh from one to the next.
_LONGEST_HEARTBEAT = 2.5


class Objective(Enum):
    """What the team keeps short: the sum of all paths, or the time until all is done."""

    PATH = "path"
    TIME = "time"


@dataclass(frozen=True)
class DemirCfParameters:
    """Parameters of one robot; all but ``speed`` should be the same for the whole team.

    Attributes:
        rate: how often the robot thinks, from 2 to 100 [Hz].
        objective: see ``Objective``; decides when it gives way to what another requests.
        cost: what it selects by: ``eyh`` (Eq. 2), ``uem`` (Eq. 3), ``rollout`` (see ``planning.rollout``), ``greedy``
            (what costs itself least, whoever is nearer: where ways are short beside what tasks take) or, under the
            time objective only, ``balanced`` (see ``planning.balanced_plan``).
        alpha: weight of the distance in ``uem``, 0 to 1 [1].
        reply_timeout: T_reply, for how long it waits for bids; at least two cycles [s].
        heartbeat: T_hb, how often it says that it is at work, or is there [s].
        execution_timeout: T_exec and T_fail, after what silence a task is uncertain and a robot has failed; at least
            three heartbeats [s].
        request_timeout: T_req, after what silence a task that another requested is uncertain; from reply_timeout +
            heartbeat to execution_timeout [s].
        overdue: after how many times its estimate a task is looked at anew, above 1 [1].
        exchange: whether it asks others for tasks that they carry out.
        margin: by what share a cost must be lower, or higher, to change what is going on, 0 to below 1 [1].
        handling: whether robots warn, answer and yield where their beliefs differ.
        gives_way: whether, under the time objective, a request near by at less than its own task makes it wait
            (Algorithm 3''); under the path objective it always does (3').
        looks_ahead: whether, under the time objective, it takes from another's cell what it reaches first, when it has
            nothing else to do.
        literal_award: whether it takes awards only while it has nothing else to do, as Algorithm 3 is printed; counts
            for the time objective.
        retry: after what time it thinks again of a task that could not be reached, twice as long each time; 0: only
            when its map shows a way [s].
        unknown_cost: what a task counts as whose behaviour cannot tell its cost [m].
        speed: how fast it expects to move, for estimates of duration [m/s].
    """

    rate: float = 10.0
    objective: str = Objective.TIME.value
    cost: str = "uem"
    alpha: float = ALPHA
    reply_timeout: float = 1.0
    heartbeat: float = 2.0
    execution_timeout: float = 7.0
    request_timeout: float = 7.0
    overdue: float = 2.0
    exchange: bool = False
    margin: float = 0.1
    handling: bool = True
    gives_way: bool = False
    looks_ahead: bool = False
    literal_award: bool = False
    retry: float = 30.0
    unknown_cost: float = 1000.0
    speed: float = 0.3

    def __post_init__(self) -> None:
        problems: List[ParameterProblem] = []

        def check(name: str, sound: bool, accepted: str) -> None:
            if not sound:
                value = getattr(self, name)
                found = f"{value:g}" if isinstance(value, float) else repr(value)
                problems.append(ParameterProblem(name, f"must be {accepted} (got {found})"))

        objectives = [objective.value for objective in Objective]
        check("rate", 2.0 <= self.rate <= 100.0, "from 2 to 100 Hz")
        check("objective", self.objective in objectives, " or ".join(objectives))
        *known, last = (*_COSTS, ROLLOUT, GREEDY) if self.keeps_paths_short else (*_COSTS, ROLLOUT, GREEDY, BALANCED)
        accepted = f"{', '.join(known)} or {last} under the objective {self.objective}"
        check("cost", self.cost in (*known, last), accepted)
        check("alpha", 0.0 <= self.alpha <= 1.0, "from 0 to 1")
        check("overdue", 1.0 < self.overdue < math.inf, "above 1")
        check("margin", 0.0 <= self.margin < 1.0, "at least 0 and below 1")
        check("retry", 0.0 <= self.retry < math.inf, "a finite number, at least 0 s")
        check("unknown_cost", 0.0 <= self.unknown_cost < math.inf, "a finite number, at least 0 m")
        check("speed", 0.0 < self.speed < math.inf, "a finite number, above 0 m/s")
        check("heartbeat", 0.0 < self.heartbeat <= _LONGEST_HEARTBEAT, f"above 0 and at most {_LONGEST_HEARTBEAT:g} s")
        if not problems:
            least = 2.0 / self.rate
            check("reply_timeout", least <= self.reply_timeout < math.inf, f"at least two cycles, {least:g} s")
            least = 3.0 * self.heartbeat
            accepted = f"at least three heartbeats, {least:g} s"
            check("execution_timeout", least <= self.execution_timeout < math.inf, accepted)
            least, most = self.reply_timeout + self.heartbeat, self.execution_timeout
            accepted = f"from reply_timeout + heartbeat = {least:g} s to execution_timeout = {most:g} s"
            check("request_timeout", least <= self.request_timeout <= most, accepted)
        if problems:
            raise ParameterRangeError(tuple(problems))

    @property
    def keeps_paths_short(self) -> bool:
        """Whether the objective is the path."""
        return self.objective == Objective.PATH.value

    def cost_function(self) -> CostFunction:
        """Give what the robot selects by; of what is beyond an imagined or planned route, the nearest."""
        return _COSTS.get(self.cost, _COSTS["eyh"])(self)


_COSTS: Dict[str, Callable[[DemirCfParameters], CostFunction]] = {
    "eyh": lambda parameters: eyh_cost,
    "uem": lambda parameters: uem_cost(parameters.alpha),
}


def read_parameters(given: Mapping[str, Any]) -> DemirCfParameters:
    """Make a robot's parameters; what is missing takes its default.

    Args:
        given: as in the robot's YAML file.

    Raises:
        ParameterRangeError: carries everything that is wrong.
    """
    return read_fields(DemirCfParameters, given)


def find_problems(given: Mapping[str, Any]) -> Tuple[ParameterProblem, ...]:
    """List everything that is wrong with a robot's parameters; empty if nothing is."""
    return wrong_parameters(lambda: read_parameters(given))
