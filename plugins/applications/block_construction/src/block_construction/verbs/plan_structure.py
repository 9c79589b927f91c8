"""The verb ``plan-structure``: from a structure to its assembly diagram."""

from __future__ import annotations

import json
import sys
from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import Any, Dict, Tuple

from block_construction.diagram.block_set import DEFAULT_LENGTHS, block_lengths
from block_construction.diagram.planning import PlannedDiagram, plan_diagram, read_settings
from block_construction.diagram.table import diagram_csv, diagram_document
from block_construction.errors import ConstructionError
from block_construction.pictures.curves import tried_figure
from block_construction.pictures.isometric import isometric_drawing
from block_construction.pictures.levels import level_drawing
from block_construction.structure.drawings import read_structure, structure_files
from block_construction.structure.library import structure_names
from rqt_mrta_py.hooks import UsageError, Verb, VerbTools

__all__ = ["PLAN_STRUCTURE", "SCHEMA"]

SCHEMA = "rqt_mrta_py/plan_structure/1"
_HOOK = "mrta_register_assembly_planners"


def _lengths(text: str) -> Tuple[int, ...]:
    try:
        return block_lengths(int(each) for each in text.split(","))
    except ValueError as error:
        raise UsageError(f"--blocks {text}: units of blocks are expected, for instance 1,2,3") from error
    except ConstructionError as error:
        raise UsageError(f"--blocks {text}: {error}") from error


def _add_arguments(parser: ArgumentParser) -> None:
    known = ", ".join(structure_names())
    parser.add_argument("structure", metavar="FILE", help=f"a .vox, .npy or .txt file, or one of the package: {known}")
    parser.add_argument(
        "--method",
        default="exact",
        help="exact, fala, pla, fala-tuned, pla-tuned or any other planner (default: exact)",
    )
    lengths = ",".join(map(str, DEFAULT_LENGTHS))
    parser.add_argument(
        "--blocks", metavar="UNITS", default=lengths, help=f"lengths of blocks, in cells of 8 cm (default: {lengths})"
    )
    parser.add_argument("--seed", type=int, default=0, help="of all chance (default: 0)")
    parser.add_argument(
        "--set",
        metavar="KEY=VALUE",
        dest="settings",
        action="append",
        default=[],
        help="a setting of the planner; may be given several times, and a wrong name lists what there is",
    )
    parser.add_argument("--out", metavar="DIR", type=Path, help="write diagram, structure and pictures to this folder")
    parser.add_argument("--force", action="store_true", help="write into DIR even if it is not empty")
    parser.add_argument("--json", action="store_true", help="print as JSON")


def _main(options: Namespace, tools: VerbTools) -> int:
    lengths = _lengths(options.blocks)
    planners = tools.registered(_HOOK)
    if options.method not in planners:
        raise UsageError(f"--method {options.method}: no such planner; there are: {', '.join(sorted(planners))}")
    planner = planners[options.method]
    settings = read_settings(planner.defaults, options.settings)
    structure = read_structure(options.structure)
    folder = None if options.out is None else tools.folder(options.out, force=options.force)
    planned = plan_diagram(
        planner, structure, lengths, seed=options.seed, settings=settings, on_progress=tools.progress
    )
    document = _document(planned)
    if folder is not None:
        for name, content in structure_files(structure).items():
            folder.write(name, content)
        folder.write("diagram.json", json.dumps(diagram_document(planned.diagram), indent=1) + "\n")
        folder.write("diagram.csv", diagram_csv(planned.diagram))
        folder.write("summary.json", json.dumps(document, indent=2) + "\n")
        folder.draw(level_drawing(planned.diagram))
        folder.draw(isometric_drawing(planned.diagram))
        if planned.costs:
            title = f"{structure.name}: least cost {planned.diagram.cost} by {options.method}, seed {options.seed}"
            folder.draw(tried_figure("cost", title, planned.costs, "cost: blocks and faults", planned.convergence))
    sys.stdout.write((json.dumps(document, indent=2) if options.json else _text(planned)) + "\n")
    return 0


def _document(planned: PlannedDiagram) -> Dict[str, Any]:
    diagram = planned.diagram
    return {
        "schema": SCHEMA,
        "cost": diagram.cost,
        "blocks": len(diagram.blocks),
        "faults": len(diagram.faults),
        "counts": {str(length): count for length, count in diagram.counts.items()},
        "proved": planned.proved,
        "seconds": round(planned.seconds, 3),
    }


def _text(planned: PlannedDiagram) -> str:
    diagram = planned.diagram
    counts = ", ".join(f"{count} of {units}" for units, count in diagram.counts.items())
    end = ", proved to be the least" if planned.proved else ""
    return (
        f"{diagram.structure.name}: cost {diagram.cost}{end}\n"
        f"blocks {len(diagram.blocks)} ({counts}), connection faults {len(diagram.faults)}, {planned.seconds:.2f} s"
    )


PLAN_STRUCTURE = Verb("Plan which blocks a structure is put together of.", _add_arguments, _main)
