"""Part ``builds``: structures put up by one robot (tables 10, 12, 14 and 16)."""

from __future__ import annotations

from typing import Any, List, Mapping, NamedTuple, Optional, Tuple

from team_measures.statistics.tables import rounded

from block_construction.building.procedures import TRAVEL_SPEED
from block_construction.experiments.part import Options
from block_construction.experiments.published_builds import BUILDS, Build
from block_construction.pictures.bars import Handling, handling_bars
from rqt_mrta_py.hooks import BenchmarkReport, BenchmarkTable, Experiment, Laboratory, Trial

__all__ = ["APPLICATION", "build_of", "measure_builds"]

APPLICATION = "block_construction"
_STRUCTURES = ("wall", "tower", "dam", "pyramid", "station", "cistern")
_FEW_STRUCTURES = ("wall",)


class _Case(NamedTuple):
    """One build.

    Attributes:
        label: in the table.
        structure: a name of the library.
        settings: as ``--set`` takes them.
    """

    label: str
    structure: str
    settings: Tuple[str, ...]


def build_of(trial: Trial) -> Mapping[str, Any]:
    """Give what the measure ``build`` says of a mission in which something is built."""
    found: Mapping[str, Any] = trial.record.statistics["build"]
    return found


def measure_builds(options: Options, laboratory: Laboratory) -> BenchmarkReport:
    """Let one robot build the structures, and the wall also from the place that the source gives for it."""
    structures = _FEW_STRUCTURES if options.quick else _STRUCTURES
    cases = [_Case(name, name, (f"structure={name}",)) for name in structures]
    cases.insert(1, _Case("wall, table 19's place", "wall", ("structure=wall", "supply=wall_source")))
    experiments = [Experiment(APPLICATION, seed=1, robots=1, settings=case.settings) for case in cases]
    builds = [build_of(trial) for trial in laboratory.trials(experiments)]
    rows = [_row(case, build) for case, build in zip(cases, builds)]
    table = BenchmarkTable(
        "Tables 10, 12, 14 and 16: builds by one robot, 0.03 m/s and 0.08 rad/s, no noise",
        (
            *("structure", "placed", "of", "mean error [mm]", "max error [mm]"),
            *("fetching [min]", "placing [min]", "together [min]", "source's [min]"),
            *("fetching [m]", "placing [m]", "together [m]", "source's [m]"),
            *("beyond driving [s/block]", "source's [s/block]"),
        ),
        tuple(rows),
        (
            "Fetching is the source's manipulation, placing its assembly. Errors are distances from slots' middles.",
            "Beyond driving: time over the way at 0.03 m/s. The source's arena and its plans are not known.",
            "The station is a stand-in of 32 blocks and faults, as many as the source's.",
        ),
    )
    return BenchmarkReport((table,), (handling_bars([_handling(case, build) for case, build in zip(cases, builds)]),))


def _row(case: _Case, build: Mapping[str, Any]) -> Tuple[Any, ...]:
    fetching, placing = build["fetching"], build["placing"]
    minutes = [fetching["seconds"] / 60.0, placing["seconds"] / 60.0]
    metres = [fetching["metres"], placing["metres"]]
    source: Optional[Build] = BUILDS.get(case.label)
    published: List[Optional[float]] = [None] * 3
    if source is not None:
        time, way = source.fetching_minutes + source.placing_minutes, source.fetching + source.placing
        published = [time, way, (60.0 * time - way / TRAVEL_SPEED) / source.blocks]
    errors = [None if build[name] is None else 1000.0 * build[name] for name in ("mean_error", "max_error")]
    beyond = (60.0 * sum(minutes) - sum(metres) / TRAVEL_SPEED) / build["blocks"]
    return (
        *(case.label, build["placed"], build["blocks"], *(rounded(error) for error in errors)),
        *(rounded(value, 1) for value in (*minutes, sum(minutes), published[0])),
        *(rounded(value, 1) for value in (*metres, sum(metres), published[1])),
        *(rounded(value, 1) for value in (beyond, published[2])),
    )


def _handling(case: _Case, build: Mapping[str, Any]) -> Handling:
    fetching, placing = build["fetching"], build["placing"]
    source = BUILDS.get(case.label)
    return Handling(
        case.label,
        fetching["seconds"] / 60.0,
        placing["seconds"] / 60.0,
        fetching["metres"],
        placing["metres"],
        None if source is None else source[:4],
    )
