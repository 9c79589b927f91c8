"""How fast a simulated mission runs, everything on: mission seconds for a second of wall and of processor time."""

from __future__ import annotations

import argparse
import resource
import tempfile
import time
from contextlib import ExitStack
from pathlib import Path
from typing import Any, Dict, List, NamedTuple, Tuple

from rqt_mrta_py.app.bench.apart import apart
from rqt_mrta_py.app.bench.load import CONTROL_RATE, LoadPlugin, load_mission_of
from rqt_mrta_py.app.bench.parts import PartTimer
from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.app.observation import Observation
from rqt_mrta_py.app.outputs.folder import OutputFolder
from rqt_mrta_py.app.outputs.pictures import PictureSchedule
from rqt_mrta_py.app.run.collector import rare_collections
from rqt_mrta_py.app.run.embedded import EmbeddedRun
from rqt_mrta_py.app.run.watch import WatchPlan, open_watch
from rqt_mrta_py.app.run.watch_process import open_watcher
from rqt_mrta_py.hooks import BenchmarkTable, Codec

__all__ = ["add_arguments", "measure"]

_CASES = "bullet:3,bullet:10,bullet:50,bullet:100,planar:100,planar:1000"
_PICTURE_RATE = 10
_WARM_UP = 1.0
"""What passes before the clock is started [s]."""

PARTS = ("physics", "rays", "sensing", "bus", "robots", "recording", "supervision", "views", "drawing")


class _Case(NamedTuple):
    """One team in one world, for so many seconds of mission."""

    world: str
    robots: int
    duration: float


class _Speed(NamedTuple):
    """What one run took, without its warm-up [s]."""

    mission: float
    wall: float
    processor: float


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the benchmark takes."""
    parser.add_argument(
        "--cases", metavar="WORLD:N,...", type=_cases, default=_cases(_CASES), help=f"teams (default: {_CASES})"
    )
    parser.add_argument("--processes", type=int, choices=(1, 2), default=2, help="that share the work (default: 2)")
    parser.add_argument("--repeats", metavar="N", type=int, default=3, help="runs of each case; the best counts")
    parser.add_argument("--no-parts", action="store_true", help="do not tell where the time goes (one run less)")


def measure(options: argparse.Namespace) -> BenchmarkTable:
    """Run every case."""
    rows: List[Tuple[Any, ...]] = []
    for case in options.cases:
        speeds = [apart(_speed, case, options.processes) for _ in range(max(1, options.repeats))]
        best = min(speeds, key=lambda speed: speed.wall)
        shares = {} if options.no_parts else apart(_parts, case)
        total = sum(shares.values()) or 1.0
        rows.append(
            (
                case.world,
                case.robots,
                round(best.mission / best.wall, 2),
                round(best.mission / best.processor, 2),
                *(round(100 * shares[part] / total) if part in shares else None for part in PARTS),
            )
        )
    return BenchmarkTable(
        title="A mission with everything on: 20 Hz control, 36 rays and odometry at 10 Hz, tf, agents, supervisor, "
        "10 JPEG pictures a mission second in the bag, no PNG",
        columns=("world", "robots", "mission s / wall s", "mission s / CPU s", *(f"{part} %" for part in PARTS)),
        rows=tuple(rows),
        notes=(
            f"Best of {max(1, options.repeats)} runs in {options.processes} process(es), after a warm-up of "
            f"{_WARM_UP:g} s, until the bag is complete; processor time is that of all processes.",
            "Shares are of a run in one process, encoding of pictures left out (it has a thread of its own).",
        ),
    )


def _cases(text: str) -> List[_Case]:
    cases = []
    for part in text.split(","):
        world, _, number = part.partition(":")
        if not world or not number.isdigit() or not int(number):
            raise argparse.ArgumentTypeError(f"{part!r}: a world and a number of robots are expected, as in bullet:10")
        robots = int(number)
        cases.append(_Case(world, robots, 30.0 if robots <= 10 else 11.0))
    return cases


def _speed(case: _Case, processes: int) -> _Speed:
    with ExitStack() as stack:
        run, plan, codec = _wired(case, stack)
        watcher = stack.enter_context(open_watcher(plan, run.bus, codec, processes))
        warm = round(_WARM_UP * CONTROL_RATE)
        for tick in range(warm):
            run.step(tick)
            watcher.end_tick(tick)
        processor, wall = _processor(), time.perf_counter()
        for tick in range(warm, run.last_tick + 1):
            run.step(tick)
            watcher.end_tick(tick)
        watcher.finish()
        wall = time.perf_counter() - wall
        processor = _processor() - processor
    return _Speed((run.last_tick + 1 - warm) / CONTROL_RATE, wall, processor)


def _parts(case: _Case) -> Dict[str, float]:
    with ExitStack() as stack:
        run, plan, _ = _wired(case, stack)
        watch = stack.enter_context(open_watch(plan, run.bus))
        timer = PartTimer()
        for target, method, part in (*run.timed_parts(), *watch.timed_parts()):
            timer.watch(target, method, part)
        for tick in range(run.last_tick + 1):
            run.step(tick)
            watch.end_tick(tick)
    return timer.seconds


def _wired(case: _Case, stack: ExitStack) -> Tuple[EmbeddedRun, WatchPlan, Codec]:
    host = compose()
    host.manager.register(LoadPlugin(), "bench_load")
    mission = load_mission_of(case.robots, case.world, case.duration)
    codec = host.codec()
    observation = Observation(mission, codec, host.manager, case.duration)
    run = EmbeddedRun(mission, case.duration, codec, host.manager)
    stack.callback(run.close)
    folder = OutputFolder(Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="mrta-bench-"))))
    pictures = PictureSchedule(host.renderer("monitor"), CONTROL_RATE // _PICTURE_RATE, CONTROL_RATE)
    plan = WatchPlan(observation, folder, run.clock, run.last_tick, False, pictures, None, {}, host.manager.patience)
    stack.enter_context(rare_collections())
    return run, plan, codec


def _processor() -> float:
    """Give the processor time of this process and of those it has waited for [s]."""
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(usage.ru_utime + usage.ru_stime for usage in used)
