"""What a bag is about that says nothing of itself: held against every registered architecture and application."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, Iterable, List, Mapping, Optional, Sequence, Set, Tuple

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.config.discovery.registration import RegistrationKind
from rqt_mrta_py.config.mission import load_mission, load_observed
from rqt_mrta_py.errors import MrtaError
from rqt_mrta_py.hooks import Codec, Connection
from rqt_mrta_py.model import ArchitectureSpec, Mission, MonitoredTopic
from rqt_mrta_py.transport.patterns import TopicPattern

__all__ = ["Fit", "Guess", "fit_of", "guess"]


@dataclass(frozen=True)
class Fit:
    """How the topics of a bag fit an architecture.

    Attributes:
        architecture: that the topics are held against.
        found: its monitored topics of which the bag has messages, with the fields that are to be read.
        missing: the others.
        telling: whether any of those found tells who is busy or idle, or who has which task.
        messages: how many the bag has of those found.
        robots: ids that the names of topics tell.
        tasks: likewise.
    """

    architecture: ArchitectureSpec
    found: Tuple[MonitoredTopic, ...]
    missing: Tuple[MonitoredTopic, ...]
    telling: bool
    messages: int
    robots: Tuple[str, ...]
    tasks: Tuple[str, ...]

    @property
    def score(self) -> Tuple[int, int]:
        """Rank it: by how many topics were found, then by how few are missing; the highest fits best."""
        return len(self.found), -len(self.missing)


@dataclass(frozen=True)
class Guess:
    """What a bag is likely to be about.

    Attributes:
        architecture: package of the architecture that fits best; the first by name where several do.
        application: package of the application whose robots and tasks these are; None if of none, or of several.
        others: packages of the architectures that fit as well.
        why: in a few words.
    """

    architecture: str
    application: Optional[str]
    others: Tuple[str, ...]
    why: str


def guess(host: Host, connections: Mapping[Connection, int], codec: Codec) -> Optional[Guess]:
    """Find the architecture that fits best, and the application if its robots and tasks are these.

    Args:
        host: knows what is registered; what cannot be read there is passed over.
        connections: of the bag, with their numbers of messages.
        codec: reads definitions.

    Returns:
        The guess; None if no architecture fits at all.
    """
    fits: Dict[str, Fit] = {}
    for package in _registered(host, RegistrationKind.ARCHITECTURE):
        try:
            fit = fit_of(load_observed(host.registry, package).architecture, connections, codec)
        except MrtaError:
            continue
        if fit.telling:
            fits[package] = fit
    if not fits:
        return None
    best = max(fit.score for fit in fits.values())
    tied = [package for package in sorted(fits) if fits[package].score == best]
    missions = [mission for mission in _applications(host) if _is_of(mission, fits, tied)]
    known = {mission.architecture.package for mission in missions}
    architecture = next((package for package in tied if package in known), tied[0])
    fit = fits[architecture]
    of_it = [mission.application for mission in missions if mission.architecture.package == architecture]
    application = of_it[0].package if len(of_it) == 1 else None
    total = len(fit.found) + len(fit.missing)
    why = f"{len(fit.found)} of its {total} monitored topics are there with {fit.messages} messages"
    if application is not None:
        why += f", and robots {', '.join(fit.robots)} with tasks {', '.join(fit.tasks)} are those of {application}"
    return Guess(architecture, application, tuple(package for package in tied if package != architecture), why)


def fit_of(architecture: ArchitectureSpec, connections: Mapping[Connection, int], codec: Codec) -> Fit:
    """Hold the topics of a bag against those of an architecture.

    Args:
        architecture: declares topics.
        connections: of the bag, with their numbers of messages.
        codec: reads definitions.
    """
    telling = {*architecture.busy_robots, *architecture.idle_robots, *architecture.allocated_tasks}
    others = (*architecture.incoming_tasks, *architecture.completed_tasks, *architecture.failed_tasks)
    declared: Dict[Tuple[str, str], List[MonitoredTopic]] = {}
    for topic in (*architecture.busy_robots, *architecture.idle_robots, *architecture.allocated_tasks, *others):
        if topic.name:
            declared.setdefault((topic.name, topic.type), []).append(topic)
    found: List[MonitoredTopic] = []
    missing: List[MonitoredTopic] = []
    tells = False
    counted: Set[Connection] = set()
    robots: Dict[str, None] = {}
    tasks: Dict[str, None] = {}
    for (name, type_name), topics in declared.items():
        pattern = TopicPattern(name)
        matching = [each for each in connections if each.type == type_name and pattern.match(each.topic) is not None]
        readable = [each for each in matching if connections[each] and _reads(codec, each, topics)]
        (found if readable else missing).append(topics[0])
        if not readable:
            continue
        tells = tells or any(topic in telling for topic in topics)
        counted.update(readable)
        for connection in readable:
            robot, task = pattern.match(connection.topic) or ("", "")
            robots.update({robot: None} if robot else {})
            tasks.update({task: None} if task else {})
    messages = sum(connections[each] for each in counted)
    return Fit(architecture, tuple(found), tuple(missing), tells, messages, tuple(sorted(robots)), tuple(sorted(tasks)))


def _reads(codec: Codec, connection: Connection, topics: Iterable[MonitoredTopic]) -> bool:
    """Tell whether a connection carries the fields that are to be read."""
    paths = {path for topic in topics for path in (topic.field, topic.robot_field, topic.task_field) if path}
    try:
        codec.compile(connection, tuple(sorted(paths)))
    except MrtaError:
        return False
    return True


def _registered(host: Host, kind: RegistrationKind) -> Sequence[str]:
    return sorted({each.package for each in host.registry.of_kind(kind)})


def _applications(host: Host) -> List[Mission]:
    missions: List[Mission] = []
    for package in _registered(host, RegistrationKind.APPLICATION):
        try:
            missions.append(load_mission(host.registry, package, seed=None, checks=host.manager, must_fit=False))
        except MrtaError:
            continue
    return missions


def _is_of(mission: Mission, fits: Mapping[str, Fit], tied: Sequence[str]) -> bool:
    """Tell whether a bag shows all robots of a mission and no others, with tasks of it and no others."""
    package = mission.architecture.package
    if package not in tied or not fits[package].tasks:
        return False
    robots = {robot.id for robot in mission.application.robots}
    tasks = {task.id for task in mission.every_task}
    return set(fits[package].robots) == robots and set(fits[package].tasks) <= tasks
