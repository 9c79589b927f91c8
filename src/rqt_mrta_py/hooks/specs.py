"""The hook specifications: the whole contract with plugins on one page.

The verb tells the role. ``mrta_register_*`` returns named things: answers of all plugins are joined, and of two
plugins that register one name the one discovered first wins, as with packages. ``mrta_check_*`` returns problems:
all are joined. ``mrta_on_*`` observes and returns nothing: an observer that raises is logged by name and skipped.
A plugin that raises in any other hook, or returns what does not fit, stops the command with an error that names
plugin and hook. Plugins are asked in the order of their discovery.

Nobody waits for ever. Where a plugin's code has not returned within a minute (``RQT_MRTA_PY_PATIENCE`` [s]; 0: wait),
it is interrupted, with a message that names file, line and function: an observer is told no more, anything else stops
the command. Verbs and benchmarks may work as long as they like. Within a tick of a mission the same limit holds for
everything that plugins made: agents, behaviours, sensors, rules, panels.
"""

from __future__ import annotations

from typing import Any, Mapping, Sequence

import pluggy

from rqt_mrta_py.hooks.agent import AgentFactory
from rqt_mrta_py.hooks.allocation import AllocationInterpreterFactory
from rqt_mrta_py.hooks.allocator import Allocator
from rqt_mrta_py.hooks.behaviour import BehaviourFactory
from rqt_mrta_py.hooks.benchmark import Benchmark
from rqt_mrta_py.hooks.construction import AssemblyPlanner
from rqt_mrta_py.hooks.evaluator import SensoryEvaluatorFactory
from rqt_mrta_py.hooks.exporter import ExporterFactory
from rqt_mrta_py.hooks.figure import FigureMakerFactory
from rqt_mrta_py.hooks.grounds import GroundsReaderFactory
from rqt_mrta_py.hooks.incident import IncidentRuleFactory
from rqt_mrta_py.hooks.link import LinkFactory
from rqt_mrta_py.hooks.measure import MeasureFactory
from rqt_mrta_py.hooks.mission_maker import MissionMaker
from rqt_mrta_py.hooks.navigator import PlannerFactory
from rqt_mrta_py.hooks.observer import MessageObserverFactory
from rqt_mrta_py.hooks.pace import AllocationPaceFactory
from rqt_mrta_py.hooks.parameters import ParameterProblem
from rqt_mrta_py.hooks.picture import MonitorPanelFactory, Renderer
from rqt_mrta_py.hooks.robot_model import RobotModel
from rqt_mrta_py.hooks.robot_sensor import RobotSensorFactory
from rqt_mrta_py.hooks.sensor import SensorFactory, TeamSensorFactory
from rqt_mrta_py.hooks.statistic import Statistic
from rqt_mrta_py.hooks.verb import Verb
from rqt_mrta_py.hooks.world import WorldFactory
from rqt_mrta_py.model import Event, Mission, MissionRecord, Task

__all__ = ["PROJECT", "HookSpecs", "hookimpl"]

PROJECT = "rqt_mrta_py"

hookspec = pluggy.HookspecMarker(PROJECT)
hookimpl = pluggy.HookimplMarker(PROJECT)


class HookSpecs:
    """Every hook, one empty method each; its docstring is its contract."""

    @hookspec
    def mrta_register_agents(self) -> Mapping[str, AgentFactory]:  # type: ignore[empty-body]
        """Name the agents of architectures.

        Called: once, before a run or a live agent starts.
        Returns: factory by the package name of the architecture.
        Combined: joined; the first registration of a name wins.
        An exception: stops the command.
        """

    @hookspec
    def mrta_register_allocation_interpreters(self) -> Mapping[str, AllocationInterpreterFactory]:  # type: ignore[empty-body]
        """Name who reads an architecture's own signs of what became of an allocation.

        Called: once, before supervision starts.
        Returns: factory by the package name of the architecture; without one, topics alone decide.
        Combined: joined; the first registration of a name wins.
        An exception: stops the command.
        """

    @hookspec
    def mrta_register_allocation_paces(self) -> Mapping[str, AllocationPaceFactory]:  # type: ignore[empty-body]
        """Name who tells from an architecture's parameters how fast it shares out tasks when all is well.

        Called: once, before supervision starts; the factory of the mission's architecture once.
        Returns: factory by the package name of the architecture; without one, the timeouts of its monitored topics
        decide. It is given the mission, whose parameters may be missing, and what those timeouts tell.
        Combined: joined; the first registration of a name wins.
        An exception: stops the command; one raised by a factory stops it too.
        """

    @hookspec
    def mrta_register_grounds_readers(self) -> Mapping[str, GroundsReaderFactory]:  # type: ignore[empty-body]
        """Name who tells on what grounds an architecture's robots take tasks.

        Called: once, by ``mrta review --why``; the factory of the mission's architecture once.
        Returns: factory by the package name of the architecture; without one, only bids that the architecture's file
        names, and what operators say of tasks, are told.
        Combined: joined; the first registration of a name wins.
        An exception: stops the command; one raised by a factory or a reader later on is told, and the reader hears no
        more; the review goes on.
        """

    @hookspec
    def mrta_register_behaviours(self) -> Mapping[str, BehaviourFactory]:  # type: ignore[empty-body]
        """Name who carries out tasks.

        Called: once, before a run or a live agent starts.
        Returns: factory by the kind of task.
        Combined: joined; the first registration of a kind wins.
        An exception: stops the command.
        """

    @hookspec
    def mrta_register_sensory_evaluators(self) -> Mapping[str, SensoryEvaluatorFactory]:  # type: ignore[empty-body]
        """Name who judges from sensors whether a task is applicable.

        Called: once, before a run or a live agent starts.
        Returns: factory by name, spelt ``package/name`` as in parameters.
        Combined: joined; the first registration of a name wins.
        An exception: stops the command.
        """

    @hookspec
    def mrta_register_robot_sensors(self) -> Mapping[str, RobotSensorFactory]:  # type: ignore[empty-body]
        """Name who reads a robot's own sensors for sensory evaluators.

        Called: once, before a run or a live agent starts; an agent makes one reader for each sensor of its parameters.
        Returns: factory by name, spelt ``package/name`` as in parameters.
        Combined: joined; the first registration of a name wins.
        An exception: stops the command.
        """

    @hookspec
    def mrta_register_allocators(self) -> Mapping[str, Allocator]:  # type: ignore[empty-body]
        """Name who gives out tasks when all costs are known.

        Called: once, before a run or a live agent starts; each allocator whenever an agent asks it.
        Returns: allocator by name, spelt ``package/name`` as in parameters.
        Combined: joined; the first registration of a name wins.
        An exception: stops the command; one raised by an allocator later on stops the run.
        """

    @hookspec
    def mrta_register_planners(self) -> Mapping[str, PlannerFactory]:  # type: ignore[empty-body]
        """Name what robots find their ways with.

        Called: once, before a run or a live agent starts; each factory once for each robot that uses it, and again,
            with the planner before it, as the map of a robot changes that maps what it sees.
        Returns: factory by the name that scenarios use.
        Combined: joined; the first registration of a name wins.
        An exception: stops the command; one raised while planning stops the run.
        """

    @hookspec
    def mrta_register_worlds(self) -> Mapping[str, WorldFactory]:  # type: ignore[empty-body]
        """Name the worlds that robots can be simulated in.

        Called: once, before a run starts.
        Returns: factory by the name that ``--world`` and scenarios use.
        Combined: joined; the first registration of a name wins.
        An exception: stops the command.
        """

    @hookspec
    def mrta_register_robot_models(self) -> Mapping[str, RobotModel]:  # type: ignore[empty-body]
        """Name the kinds of robots.

        Called: once, before a run, a live agent or a review starts.
        Returns: model by the name that scenarios use.
        Combined: joined; the first registration of a name wins.
        An exception: stops the command.
        """

    @hookspec
    def mrta_register_sensors(self) -> Mapping[str, SensorFactory]:  # type: ignore[empty-body]
        """Name the sensors that robots can be given in simulation.

        Called: once, before a run starts; each factory once for each robot that carries such a sensor.
        Returns: factory by the kind that scenarios use.
        Combined: joined; the first registration of a kind wins.
        An exception: stops the command.
        """

    @hookspec
    def mrta_register_team_sensors(self) -> Mapping[str, TeamSensorFactory]:  # type: ignore[empty-body]
        """Name the sensors that measure on many simulated robots at once.

        Called: once, before a run starts; each factory once for all robots that carry such a sensor set up alike.
        Returns: factory by the kind that scenarios use.
        Combined: joined; the first registration of a kind wins, but a kind that ``mrta_register_sensors`` names too is
        taken from there: this is how ours are replaced by the simplest means.
        An exception: stops the command.
        """

    @hookspec
    def mrta_register_links(self) -> Mapping[str, LinkFactory]:  # type: ignore[empty-body]
        """Name the radios between simulated robots.

        Called: once, before a run starts; a factory at the start and at each ``radio_changes``.
        Returns: factory by the kind that scenarios use.
        Combined: joined; the first registration of a kind wins.
        An exception: stops the command.
        """

    @hookspec
    def mrta_register_incident_rules(self) -> Mapping[str, IncidentRuleFactory]:  # type: ignore[empty-body]
        """Name what counts as going wrong.

        Called: once, before supervision starts.
        Returns: factory by the rule's name, as written in incidents.
        Combined: joined; the first registration of a name wins; rules are asked in the order of their names.
        An exception: stops the command; one raised by a rule later on stops supervision.
        """

    @hookspec
    def mrta_register_statistics(self) -> Mapping[str, Statistic]:  # type: ignore[empty-body]
        """Name the numbers that sum up a mission.

        Called: once, before supervision starts; each statistic once, when the stream has ended.
        Returns: function by the key it has in ``summary.json``.
        Combined: joined; the first registration of a name wins; written in the order of names.
        An exception: stops the command.
        """

    @hookspec
    def mrta_register_measures(self) -> Mapping[str, MeasureFactory]:  # type: ignore[empty-body]
        """Name the numbers that sum up a mission and that can be told only by hearing it.

        Called: once, before supervision starts; each factory once, its measure asked when the stream has ended.
        Returns: factory by the key it has among the statistics of ``summary.json``.
        Combined: joined; the first registration of a name wins, before a statistic of that name.
        An exception: stops the command; one raised by a measure later on stops it too.
        """

    @hookspec
    def mrta_register_figures(self) -> Mapping[str, FigureMakerFactory]:  # type: ignore[empty-body]
        """Name the charts that runs and reviews can leave.

        Called: once, before a run or review starts; the factories only of those asked for (``--figures``).
        Returns: factory by the name that ``--figures`` uses; its pictures go to ``figures/<name>/``.
        Combined: joined; the first registration of a name wins.
        An exception: stops the command; one raised by a maker later on stops it too.
        """

    @hookspec
    def mrta_register_monitor_panels(self) -> Mapping[str, MonitorPanelFactory]:  # type: ignore[empty-body]
        """Name the panels that show an architecture's inner life.

        Called: once, before pictures are drawn.
        Returns: factory by the name that architectures list as widget.
        Combined: joined; the first registration of a name wins; a widget that nobody registers is left out.
        An exception: stops the command.
        """

    @hookspec
    def mrta_register_renderers(self) -> Mapping[str, Renderer]:  # type: ignore[empty-body]
        """Name the pictures that can be drawn.

        Called: once, before pictures are drawn.
        Returns: function by name; ``monitor`` is drawn every picture period, ``dashboard`` at the end.
        Combined: joined; the first registration of a name wins.
        An exception: stops the command; one raised while drawing stops it too.
        """

    @hookspec
    def mrta_register_exporters(self) -> Mapping[str, ExporterFactory]:  # type: ignore[empty-body]
        """Name further files that runs and reviews can leave.

        Called: once, before a run or review starts; the factories only of those asked for (``--export``).
        Returns: factory by the name that ``--export`` uses; it makes an Exporter, which hears fields, or a
        MessageExporter, which is handed the messages as they were recorded.
        Combined: joined; the first registration of a name wins.
        An exception: stops the command; one raised by an exporter later on stops it too.
        """

    @hookspec
    def mrta_register_message_observers(self) -> Mapping[str, MessageObserverFactory]:  # type: ignore[empty-body]
        """Name who hears messages as they come and answers nothing.

        Called: once, before the first message of a run or review.
        Returns: factory by the observer's name.
        Combined: joined; the first registration of a name wins; observers are told in the order of their names.
        An exception: stops the command; an observer that raises, or cannot be made, is logged and hears no more.
        """

    @hookspec
    def mrta_register_assembly_planners(self) -> Mapping[str, AssemblyPlanner]:  # type: ignore[empty-body]
        """Name who decides of which blocks a structure is put together.

        Called: once, when a verb or benchmark asks for planners.
        Returns: planner by the name that ``--method`` uses.
        Combined: joined; the first registration of a name wins.
        An exception: stops the command; one raised while planning stops it too.
        """

    @hookspec
    def mrta_register_mission_makers(self) -> Mapping[str, MissionMaker]:  # type: ignore[empty-body]
        """Name who makes an application's tasks and scenario from what the user sets.

        Called: once, before a run or a live node starts, and by ``mrta show`` of an application; a maker when the user
        sets something that is one of its settings (``--set name=value``), or another number of robots than its files
        are made for. Otherwise the application's files are used as they are.
        Returns: maker by the package name of the application. What it makes is read and checked as files are.
        Combined: joined; the first registration of a name wins.
        An exception: stops the command; one raised while making stops it too.
        """

    @hookspec
    def mrta_register_verbs(self) -> Mapping[str, Verb]:  # type: ignore[empty-body]
        """Name verbs that the command ``mrta`` shall have.

        Called: once, when a verb is asked for that is none of its own, and for its help page.
        Returns: verb by name; the command's own verbs cannot be replaced.
        Combined: joined; the first registration of a name wins.
        An exception: stops the command.
        """

    @hookspec
    def mrta_register_benchmarks(self) -> Mapping[str, Benchmark]:  # type: ignore[empty-body]
        """Name what ``mrta bench`` can measure.

        Called: once, by ``mrta bench``.
        Returns: benchmark by name.
        Combined: joined; the first registration of a name wins.
        An exception: stops the command.
        """

    @hookspec
    def mrta_check_parameters(  # type: ignore[empty-body]
        self, architecture: str, robot_id: str, parameters: Mapping[str, Any], tasks: Sequence[Task]
    ) -> Sequence[ParameterProblem]:
        """Find what is wrong with parameters that fit their templates.

        Called: for each robot, before a run or a live agent starts.
        Args: architecture: its package; a plugin answers for its own only. robot_id: whose parameters. parameters:
        nested as in the robot's YAML file, complete, types checked. tasks: that this robot may carry out.
        Returns: problems by the path of the parameter; empty if there are none.
        Combined: joined, in order; file and line are added.
        An exception: stops the command.
        """

    @hookspec
    def mrta_on_mission_start(self, mission: Mission) -> None:
        """Observe that a run or review begins.

        Called: once, before the first message.
        Args: mission: as far as it is known.
        Returns: nothing.
        Combined: all are called.
        An exception: is logged; the others go on.
        """

    @hookspec
    def mrta_on_event(self, event: Event) -> None:
        """Observe a change that the supervisor noticed.

        Called: once per event, in order, in a run as in a review.
        Args: event: what changed.
        Returns: nothing.
        Combined: all are called.
        An exception: is logged; the others go on.
        """

    @hookspec
    def mrta_on_mission_end(self, record: MissionRecord) -> None:
        """Observe that a run or review has ended.

        Called: once, after the last message, before outputs are written.
        Args: record: everything known of the mission.
        Returns: nothing.
        Combined: all are called.
        An exception: is logged; the others go on.
        """
