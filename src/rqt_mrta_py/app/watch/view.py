"""What is shown of a watched team, and what shows it."""

from __future__ import annotations

from pathlib import Path
from typing import Dict, Iterable, List, Mapping, NamedTuple, Optional, Protocol, Sequence, Tuple

from rqt_mrta_py.app.live.interest import TopicChoice
from rqt_mrta_py.model import CommunicationGraph, Event, Mission, MissionRecord, Outcome
from rqt_mrta_py.supervisor import Standing

__all__ = ["Display", "WatchRequest", "WatchView"]


class WatchRequest(NamedTuple):
    """What the user asks for.

    Attributes:
        bag: to follow; None for a ROS master.
        application: a registered name or path that says what is watched; None to let the stream say it.
        architecture: a registered name or path; None for the application's own.
        follow: go on when everything that is there has been read; None: while the bag is not complete.
        timeout: end when nothing has been heard for so long [s]; None: never.
        graph: watch nodes and topics too.
        topics: which of them are shown.
        arguments: ROS remappings for the node that listens.
    """

    bag: Optional[Path] = None
    application: Optional[str] = None
    architecture: Optional[str] = None
    follow: Optional[bool] = None
    timeout: Optional[float] = None
    graph: bool = False
    topics: TopicChoice = TopicChoice()
    arguments: Sequence[str] = ()


class WatchView(NamedTuple):
    """A watched team at one moment.

    Attributes:
        mission: what it is about.
        record: everything known of it so far.
        messages: number of those heard.
        graph: nodes and topics; None if nobody asked for them.
    """

    mission: Mission
    record: MissionRecord
    messages: int
    graph: Optional[CommunicationGraph]

    def holders(self) -> Mapping[str, Tuple[str, ...]]:
        """List the robots that hold each task now, sorted; tasks that nobody holds are left out."""
        return _grouped((each.task, each.robot) for each in self.record.allocations if each.outcome is Outcome.OPEN)

    def holdings(self) -> Mapping[str, Tuple[str, ...]]:
        """List the tasks that each robot holds now, sorted; robots that hold none are left out."""
        return _grouped((each.robot, each.task) for each in self.record.allocations if each.outcome is Outcome.OPEN)


def _grouped(pairs: Iterable[Tuple[str, str]]) -> Mapping[str, Tuple[str, ...]]:
    found: Dict[str, List[str]] = {}
    for key, value in pairs:
        found.setdefault(key, []).append(value)
    return {key: tuple(sorted(values)) for key, values in found.items()}


class Display(Protocol):
    """Whoever shows a watched team; called from one thread."""

    period: Optional[float]
    """How often it wants to show everything anew [s]; None: changes are enough."""

    def begin(self, mission: Mission, where: str) -> None:
        """Begin with a mission, or with another one.

        Args:
            mission: what it is about.
            where: names the stream.
        """
        ...

    def stand(self, standing: Standing, teller: str, now: float) -> None:
        """Tell how the team stands when its watching begins, as far as it was not heard from itself.

        Args:
            standing: what is told.
            teller: the node that tells it.
            now: when it is heard [s].
        """
        ...

    def tell(self, events: Sequence[Event], start: float) -> None:
        """Tell what changed.

        Args:
            events: in the order in which they were noticed.
            start: of the stream [s].
        """
        ...

    def show(self, view: WatchView) -> None:
        """Show everything as it is now."""
        ...

    def end(self, view: WatchView) -> None:
        """Show everything as it is at the end of a mission."""
        ...
