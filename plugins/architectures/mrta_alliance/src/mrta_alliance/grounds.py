"""On what grounds ALLIANCE robots take tasks: what moves the motivation of each behaviour set, as they tell it.

Motivation messages say that the impatience has changed or that a set was reset, not because of whom; announcements of
the moment before tell that. So do other sets of the same robot who suppresses a set, though that may be said a moment
later: such a ground waits for it.
"""

from __future__ import annotations

import math
from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple

from mrta_alliance.messages import COMMUNICATION_TOPIC, COMMUNICATION_TYPE, MOTIVATION_TOPICS, MOTIVATION_TYPE
from mrta_alliance.parameters import BehaviourSetParameters
from mrta_alliance.reading import read_parameters
from rqt_mrta_py.hooks import GroundsSetup, Heard, ParameterRangeError, Subscription
from rqt_mrta_py.model import Ground, Mission, normalise_id

__all__ = ["AllianceGrounds"]

_ANNOUNCED_FOR = 2.0
"""As long as one announcement keeps a robot busy in rqt_mrta.xml [s]."""
_NOTABLE = 0.1
"""A share by which impatience must change to be worth a word; with fairness it changes a little in every cycle."""
_PATIENCE = 1.0
"""So long a suppressed set waits for the one that suppresses it to say that it is active [s]."""

_SUBSCRIPTIONS = (
    Subscription(
        MOTIVATION_TOPICS,
        MOTIVATION_TYPE,
        (
            *("header/frame_id", "task_id", "impatience", "acquiescent", "suppressed", "resetted", "applicable"),
            *("motivation", "threshold", "active"),
        ),
    ),
    Subscription(COMMUNICATION_TOPIC, COMMUNICATION_TYPE, ("header/frame_id", "task_id")),
)


class _Set(NamedTuple):
    """What a behaviour set said of itself last.

    Attributes:
        impatience: as last told in words; NaN before.
        grows_since: since when its motivation has grown from 0 [s].
        active_since: since when it is active; None if it is not [s].
        others: as in its message.
    """

    impatience: float
    grows_since: float
    active_since: Optional[float]
    motivation: float
    acquiescent: bool
    suppressed: bool
    resetted: bool
    applicable: bool


class AllianceGrounds:
    """Reads motivations and announcements.

    Args:
        setup: its mission's parameters, where they are known, say after what time a set should yield or give up.
    """

    def __init__(self, setup: GroundsSetup) -> None:
        self._parameters = _parameters_of(setup.mission)
        self._sets: Dict[Tuple[str, str], _Set] = {}
        self._active: Dict[str, Dict[str, None]] = {}
        self._announced: Dict[str, Dict[str, float]] = {}
        self._waiting: Dict[str, List[Ground]] = {}

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: all robots' motivations and announcements."""
        return _SUBSCRIPTIONS

    def hear(self, heard: Heard) -> Sequence[Ground]:
        """Answer what has changed in a behaviour set."""
        robot = normalise_id(heard.fields["header/frame_id"]) or heard.robot
        task = heard.fields["task_id"]
        if heard.topic == COMMUNICATION_TOPIC:
            self._announced.setdefault(task, {})[robot] = heard.receipt
            return ()
        grounds = self._changes(robot, task, heard)
        late = self._no_longer_waiting(robot, heard.receipt)
        return (*late, *grounds) if late or grounds else ()

    def _changes(self, robot: str, task: str, heard: Heard) -> List[Ground]:
        now, fields = heard.receipt, heard.fields
        before = self._sets.get((robot, task))
        active, motivation = bool(fields["active"]), float(fields["motivation"])
        known = before or _Set(math.nan, now, None, 0.0, False, False, False, True)
        texts: List[str] = []
        if active and known.active_since is None:
            texts.append(self._activation(known, before is None, now, fields["threshold"]))
        if fields["applicable"] != known.applicable:
            texts.append(f"the sensors {'' if fields['applicable'] else 'do not '}find it applicable")
        if fields["acquiescent"] and not known.acquiescent:
            texts.append(self._acquiescence(robot, task, known, now))
        if fields["resetted"] and not known.resetted:
            others = self._others(robot, task, now)
            texts.append(f"reset to 0: {others[-1]} has announced it" if others else "reset to 0")
        impatience = float(fields["impatience"])
        notable = not abs(impatience - known.impatience) <= _NOTABLE * abs(known.impatience)
        if notable:
            if before is None:
                texts.append(
                    f"motivation grows by {impatience:.4g} a cycle towards the threshold {fields['threshold']:g}"
                )
            else:
                texts.append(_change(known.impatience, impatience, self._others(robot, task, now)))
        suppressed = bool(fields["suppressed"])
        if known.suppressed and not suppressed and not active:
            texts.append("no longer suppressed")
        if known.active_since is not None and not active and not texts and not suppressed:
            texts.append("no longer active, and no reason is told")
        self._remember(robot, task, active)
        restarted = motivation < known.motivation or (known.motivation <= 0.0 < motivation)
        self._sets[robot, task] = _Set(
            impatience if notable else known.impatience,
            now if restarted else known.grows_since,
            (known.active_since if known.active_since is not None else now) if active else None,
            motivation,
            bool(fields["acquiescent"]),
            suppressed,
            bool(fields["resetted"]),
            bool(fields["applicable"]),
        )
        values = {"motivation": motivation, "threshold": float(fields["threshold"]), "impatience": impatience}
        told = {name: value for name, value in values.items() if math.isfinite(value)}
        if suppressed and not known.suppressed:
            self._waiting.setdefault(robot, []).append(Ground(now, task, "; ".join(texts), robot, told))
            return []
        return [Ground(now, task, "; ".join(texts), robot, told)] if texts else []

    def _remember(self, robot: str, task: str, active: bool) -> None:
        sets = self._active.setdefault(robot, {})
        if active:
            sets[task] = None
        else:
            sets.pop(task, None)

    def _no_longer_waiting(self, robot: str, now: float) -> Tuple[Ground, ...]:
        """Complete the grounds of suppressed sets whose suppressor has become known, or will not any more."""
        waiting = self._waiting.get(robot)
        if not waiting:
            return ()
        active = list(self._active.get(robot, {}))
        ready = [each for each in waiting if now - each.time > _PATIENCE or any(task != each.task for task in active)]
        self._waiting[robot] = [each for each in waiting if each not in ready]
        return tuple(_suppressed(each, [task for task in active if task != each.task]) for each in ready)

    def _activation(self, known: _Set, is_first: bool, now: float, threshold: float) -> str:
        if is_first:
            return "active when it was first heard of"
        return f"motivation reached the threshold {threshold:g} after {now - known.grows_since:.1f} s: becomes active"

    def _acquiescence(self, robot: str, task: str, known: _Set, now: float) -> str:
        others = self._others(robot, task, now)
        told = self._parameters.get((robot, task))
        held = "" if known.active_since is None else f" after {now - known.active_since:.1f} s"
        if others:
            due = "" if told is None else f" (psi {told.yielding_delay:g} s)"
            return f"acquiescent: yields to {others[-1]}{held}{due}"
        due = "" if told is None else f" (lambda {told.giving_up_delay:g} s)"
        return f"acquiescent: gives it up{held}{due}"

    def _others(self, robot: str, task: str, now: float) -> List[str]:
        """List who else has announced a task of late, the newest last."""
        announced = self._announced.get(task, {})
        recent = [(at, other) for other, at in announced.items() if other != robot and at > now - _ANNOUNCED_FOR]
        return [other for _, other in sorted(recent)]


def _change(before: float, after: float, others: Sequence[str]) -> str:
    """Say how impatience changes, and who has announced the task of late."""
    falls = after < before
    text = f"impatience {'falls' if falls else 'rises'} from {before:.4g} to {after:.4g} a cycle"
    if others:
        return f"{text}, {'while' if falls else 'though'} {others[-1]} announces it"
    return text if falls else f"{text}: nobody else announces it"


def _suppressed(ground: Ground, suppressors: Sequence[str]) -> Ground:
    text = f"suppressed by its {suppressors[0]}" if suppressors else "suppressed by another behaviour set"
    joined = f"{ground.text}; {text}" if ground.text else text
    return Ground(ground.time, ground.task, joined, ground.robot, ground.values)


def _parameters_of(mission: Mission) -> Dict[Tuple[str, str], BehaviourSetParameters]:
    """Read the parameters of each robot and task, as far as they are known and make sense."""
    found: Dict[Tuple[str, str], BehaviourSetParameters] = {}
    for robot, nested in mission.parameters.items():
        try:
            told = read_parameters(nested, mission.task_ids)
        except ParameterRangeError:
            continue
        found.update({(robot, each.task_id): each for each in told.behaviour_sets})
    return found
