"""The verb ``plan-build``: from an assembly diagram to an execution plan."""

from __future__ import annotations

import json
import sys
from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import Any, Dict

from block_construction.diagram.planning import read_settings
from block_construction.diagram.table import read_diagram
from block_construction.documents import bounded_text
from block_construction.execution.plan_file import plan_csv, plan_document
from block_construction.execution.planners import METHODS, PlannedBuild, plan_build
from block_construction.execution.problem import BuildProblem
from block_construction.execution.supply_file import supply_named
from block_construction.pictures.curves import tried_figure
from block_construction.pictures.ways import plan_drawing
from block_construction.structure.drawings import MOST_BYTES
from rqt_mrta_py.hooks import UsageError, Verb, VerbTools

__all__ = ["PLAN_BUILD", "SCHEMA"]

SCHEMA = "rqt_mrta_py/plan_build/1"


def _add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument("diagram", metavar="DIAGRAM", type=Path, help="diagram.json, as plan-structure leaves it")
    parser.add_argument(
        "--supply", metavar="FILE", required=True, help="arena and supply places (YAML or JSON), corners or corners_all"
    )
    methods = "; ".join(f"{name}: {method.help}" for name, method in sorted(METHODS.items()))
    parser.add_argument("--method", default="local", help=f"{methods} (default: local)")
    parser.add_argument("--seed", type=int, default=0, help="of all chance (default: 0)")
    parser.add_argument(
        "--set",
        metavar="KEY=VALUE",
        dest="settings",
        action="append",
        default=[],
        help="a setting of the method; may be given several times, and a wrong name lists what there is",
    )
    parser.add_argument("--level-first", action="store_true", help="finish each level before the next is begun")
    parser.add_argument("--out", metavar="DIR", type=Path, help="write plan and pictures to this folder")
    parser.add_argument("--force", action="store_true", help="write into DIR even if it is not empty")
    parser.add_argument("--json", action="store_true", help="print as JSON")


def _main(options: Namespace, tools: VerbTools) -> int:
    if options.method not in METHODS:
        raise UsageError(f"--method {options.method}: no such method; there are: {', '.join(sorted(METHODS))}")
    settings = read_settings(METHODS[options.method].defaults, options.settings)
    diagram = read_diagram(options.diagram.name, bounded_text(options.diagram, MOST_BYTES))
    supply = supply_named(options.supply)
    folder = None if options.out is None else tools.folder(options.out, force=options.force)
    problem = BuildProblem(diagram, supply.places, supply.arena, level_first=options.level_first)
    planned = plan_build(options.method, problem, seed=options.seed, settings=settings, on_progress=tools.progress)
    if folder is not None:
        folder.write("plan.json", json.dumps(plan_document(planned.plan), indent=1) + "\n")
        folder.write("plan.csv", plan_csv(planned.plan))
        folder.draw(plan_drawing(planned.plan))
        if planned.lengths:
            title = (
                f"{diagram.structure.name}: {planned.plan.cost.total:.2f} m by {options.method}, seed {options.seed}"
            )
            folder.draw(tried_figure("length", title, planned.lengths, "length [m]"))
    sys.stdout.write((json.dumps(_document(planned), indent=2) if options.json else _text(planned)) + "\n")
    return 0


def _document(planned: PlannedBuild) -> Dict[str, Any]:
    cost = planned.plan.cost
    return {
        "schema": SCHEMA,
        "method": planned.plan.method,
        "structure": planned.plan.diagram.structure.name,
        "length": round(cost.total, 6),
        "fetching": round(cost.fetching, 6),
        "placing": round(cost.placing, 6),
        "plan": list(planned.plan.alternating),
        "proved": planned.proved,
        "seconds": round(planned.seconds, 3),
    }


def _text(planned: PlannedBuild) -> str:
    plan, cost = planned.plan, planned.plan.cost
    end = ", the shortest for these groups and one side a block" if planned.proved else ""
    return (
        f"{plan.diagram.structure.name}: {cost.total:.2f} m by {plan.method}{end}\n"
        f"fetching {cost.fetching:.2f} m, placing {cost.placing:.2f} m, {len(plan.steps)} blocks, "
        f"{planned.seconds:.2f} s\n"
        f"place, block, place, block, ...: {' '.join(map(str, plan.alternating))}"
    )


PLAN_BUILD = Verb(
    "Plan in which order an assembly diagram is built, and from which supply places.", _add_arguments, _main
)
