"""What a robot's behaviours wish to hear: behaviours that wish the same share one listener."""

from __future__ import annotations

from typing import Callable, Dict, List, Mapping, Sequence, Set, Tuple

from rqt_mrta_py.errors import RobotError
from rqt_mrta_py.hooks import Behaviour, Heard, Subscription
from rqt_mrta_py.robot.asking import Asking, checked
from rqt_mrta_py.robot.perception import Audience, BehaviourPerception, Senses

__all__ = ["HeardBy", "behaviours_listeners", "wishes"]

HeardBy = Callable[[Heard], None]


def wishes(asking: Asking, who: str, ask: Callable[[], Sequence[Subscription]]) -> Tuple[Subscription, ...]:
    """Ask agent or behaviour what to hear.

    Args:
        asking: on behalf of whom.
        who: names it.
        ask: its method.

    Raises:
        RobotError: it raised, or answers anything but subscriptions.
    """
    return asking.ask(who, lambda: tuple(checked(each, Subscription) for each in ask()))


def behaviours_listeners(
    asking: Asking,
    robot_id: str,
    behaviours: Mapping[str, Behaviour],
    views: Mapping[str, BehaviourPerception],
    senses: Senses,
) -> List[Tuple[Subscription, HeardBy]]:
    """List what behaviours wish to hear, with whom to tell.

    Args:
        asking: on behalf of whom.
        robot_id: normalised.
        behaviours: by the kind of task.
        views: what each of them perceives, by the same kinds.
        senses: that all of them share.

    Raises:
        RobotError: a behaviour raised, answers anything but subscriptions, or subscribes to a topic twice.
    """
    audiences: Dict[Subscription, Audience] = {}
    for kind, behaviour in behaviours.items():
        topics: Set[str] = set()
        for subscription in wishes(asking, f"behaviour {kind!r}", behaviour.subscriptions):
            if subscription.topic in topics:
                raise RobotError(
                    f"{robot_id}: behaviour {kind!r} subscribes to {subscription.topic!r} twice; "
                    "one subscription with all fields is accepted"
                )
            topics.add(subscription.topic)
            views[kind].join(audiences.setdefault(subscription, Audience(senses, subscription.topic)))
    return [(subscription, audience.hear) for subscription, audience in audiences.items()]
