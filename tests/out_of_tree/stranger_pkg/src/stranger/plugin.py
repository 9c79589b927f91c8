"""The stranger's implementations of hooks: all there are."""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path
from typing import Any, Mapping, Sequence

from rqt_mrta_py.hooks import (
    AssemblyPlanner,
    Benchmark,
    BenchmarkTable,
    Chart,
    Figure,
    Line,
    MadeMission,
    MissionMaker,
    MissionRequest,
    MissionSetting,
    ParameterProblem,
    Verb,
    hookimpl,
)
from rqt_mrta_py.model import Event, Mission, MissionRecord, Outcome, Task
from stranger import ground, mole, watching


@hookimpl
def mrta_register_agents() -> Mapping[str, Any]:
    return {"stranger": mole.Agent}


@hookimpl
def mrta_register_allocation_interpreters() -> Mapping[str, Any]:
    return {"stranger": watching.Interpreter}


@hookimpl
def mrta_register_allocation_paces() -> Mapping[str, Any]:
    return {"stranger": lambda mission, usual: replace(usual, uptake=40.0 + len(mission.application.robots))}


@hookimpl
def mrta_register_behaviours() -> Mapping[str, Any]:
    return {"digging": mole.Digging}


@hookimpl
def mrta_register_sensory_evaluators() -> Mapping[str, Any]:
    return {"stranger/after_a_while": mole.AfterAWhile}


@hookimpl
def mrta_register_robot_sensors() -> Mapping[str, Any]:
    return {"stranger/whiskers": mole.Whiskers}


@hookimpl
def mrta_register_allocators() -> Mapping[str, Any]:
    return {"stranger/last_first": mole.last_first}


@hookimpl
def mrta_register_planners() -> Mapping[str, Any]:
    return {"detour": ground.Detour}


@hookimpl
def mrta_register_worlds() -> Mapping[str, Any]:
    return {"burrow": ground.Burrow}


@hookimpl
def mrta_register_robot_models() -> Mapping[str, Any]:
    return {"mole": ground.MOLE}


@hookimpl
def mrta_register_sensors() -> Mapping[str, Any]:
    return {"odometer": ground.Odometer}


@hookimpl
def mrta_register_team_sensors() -> Mapping[str, Any]:
    return {"rank": ground.Ranks}


@hookimpl
def mrta_register_links() -> Mapping[str, Any]:
    return {"tin_can": ground.TinCan}


@hookimpl
def mrta_register_incident_rules() -> Mapping[str, Any]:
    return {"somebody_works": watching.SomebodyWorks}


@hookimpl
def mrta_register_measures() -> Mapping[str, Any]:
    return {"mileage": watching.Mileage}


@hookimpl
def mrta_register_statistics() -> Mapping[str, Any]:
    return {"gave_up": lambda record: sum(each.outcome is Outcome.GAVE_UP for each in record.allocations)}


@hookimpl
def mrta_register_monitor_panels() -> Mapping[str, Any]:
    return {"stranger/mileage": watching.MileagePanel}


@hookimpl
def mrta_register_renderers() -> Mapping[str, Any]:
    return {"monitor": watching.draw}


@hookimpl
def mrta_register_exporters() -> Mapping[str, Any]:
    return {"trace": watching.Trace}


@hookimpl
def mrta_register_figures() -> Mapping[str, Any]:
    return {"tunnels": watching.Tunnels}


@hookimpl
def mrta_register_grounds_readers() -> Mapping[str, Any]:
    return {"stranger": watching.Reasons}


@hookimpl
def mrta_register_message_observers() -> Mapping[str, Any]:
    return {"ear": watching.Ear}


@hookimpl
def mrta_register_assembly_planners() -> Mapping[str, Any]:
    return {"crumbs": AssemblyPlanner("one crumb for each cell", ground.crumbs, {"worms": 0})}


@hookimpl
def mrta_register_mission_makers() -> Mapping[str, Any]:
    def more(request: MissionRequest) -> MadeMission:
        tasks = [f"  - {{id: heap{each}, kind: digging}}\n" for each in range(int(request.settings["heaps"]))]
        return MadeMission(request.tasks_yaml + "".join(tasks), request.scenario_yaml)

    return {"stranger": MissionMaker((MissionSetting("heaps", "how many more", "0"),), more)}


@hookimpl
def mrta_register_verbs() -> Mapping[str, Any]:
    def heap(options: Any, tools: Any) -> int:
        sys.stdout.write("o" * options.height + "\n")
        if options.out:
            folder = tools.folder(options.out)
            folder.write("heap.txt", f"{options.height}\n")
            line = Line("heap", (0.0, 1.0), (0.0, float(options.height)))
            folder.draw(Figure("heap", "A molehill", "time [s]", (Chart((line,), "height [m]"),)))
        return 1 if options.height > 9 else 0

    def arguments(parser: Any) -> None:
        parser.add_argument("height", type=int)
        parser.add_argument("--out", type=Path)

    return {"molehill": Verb("Heap up a molehill.", arguments, heap)}


@hookimpl
def mrta_register_benchmarks() -> Mapping[str, Any]:
    def measure(options: Any, laboratory: Any) -> BenchmarkTable:
        return BenchmarkTable("Digging", ("depth [m]", "worms"), ((options.depth, 3),), ("Worms may vary.",))

    return {"burrowing": Benchmark("dig", lambda parser: parser.add_argument("--depth", type=float), measure)}


@hookimpl
def mrta_check_parameters(
    architecture: str, robot_id: str, parameters: Mapping[str, Any], tasks: Sequence[Task]
) -> Sequence[ParameterProblem]:
    if architecture != "stranger" or parameters["patience"] > 0.0:
        return ()
    return [ParameterProblem("patience", f"{robot_id} has none left for {len(tasks)} tasks")]


@hookimpl
def mrta_on_mission_start(mission: Mission) -> None:
    watching.LOG.info("begins: %s", mission.application.name)


@hookimpl
def mrta_on_event(event: Event) -> None:
    watching.LOG.info("event: %s", event.text)


@hookimpl
def mrta_on_mission_end(record: MissionRecord) -> None:
    watching.LOG.info("ends after %g s", (record.end or 0.0) - (record.start or 0.0))
