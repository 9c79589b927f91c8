"""The seconds of planning are those of planning alone: importing and compiling are done before."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from typing import List, Tuple

import pytest
from block_construction.diagram.planning import plan_diagram
from block_construction.learning.compiled import has_compiler, training_loop
from block_construction.learning.planner import LEARNERS
from block_construction.structure.library import library_structure

from rqt_mrta_py.hooks import AssemblyOutcome, AssemblyPlanner, AssemblyRequest, BlockPlacement, Structure

LENGTHS = (1, 2, 3)


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> List[float]:
    """Stand in for the wall clock, which then passes only as a test lets it pass."""
    passed = [0.0]
    monkeypatch.setattr(time, "perf_counter", lambda: passed[0])
    return passed


def test_preparing_is_asked_first_and_not_counted(clock: List[float]) -> None:
    asked: List[Tuple[str, AssemblyRequest]] = []

    def prepare(request: AssemblyRequest) -> None:
        asked.append(("prepare", request))
        clock[0] += 100.0

    def plan(request: AssemblyRequest) -> AssemblyOutcome:
        asked.append(("plan", request))
        clock[0] += 2.5
        return AssemblyOutcome((BlockPlacement(1, 1, 1, 1),))

    structure = Structure("cell", ((1,),))
    planned = plan_diagram(AssemblyPlanner("any", plan, {"haste": 1}, prepare), structure, LENGTHS, seed=3)
    assert planned.seconds == 2.5
    assert [what for what, _ in asked] == ["prepare", "plan"]
    assert asked[0][1] is asked[1][1]
    assert asked[0][1].settings == {"haste": 1}


def test_the_exact_planner_imports_its_solver_when_it_prepares() -> None:
    pytest.importorskip("ortools", reason="OR-tools proves optima")
    said = """
import sys
from block_construction.exact.planner import EXACT
from rqt_mrta_py.hooks import AssemblyRequest, Structure
request = AssemblyRequest(Structure("cell", ((1,),)), (1,), 0, dict(EXACT.defaults))
name = "ortools.sat.python.cp_model"
before = name in sys.modules
EXACT.prepare(request)
after = set(sys.modules)
EXACT.plan(request)
print(before, name in after, sorted(each for each in set(sys.modules) - after if "ortools" in each))
"""
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    done = subprocess.run([sys.executable, "-c", said], capture_output=True, text=True, check=True, env=environment)
    assert done.stdout == "False True []\n"


@pytest.mark.long
@pytest.mark.skipif(not has_compiler(), reason="numba is not installed")
@pytest.mark.parametrize("method", sorted(LEARNERS))
def test_learners_compile_when_they_prepare_and_never_again(method: str) -> None:
    planner, structure = LEARNERS[method], library_structure("wall")
    settings = {**planner.defaults, "iterations": 20, "compiled": "yes"}
    request = AssemblyRequest(structure, LENGTHS, 0, settings)
    planner.prepare(request)
    loop = training_loop(True)
    made = len(loop.signatures)  # type: ignore[attr-defined]  # of numba's function
    planner.plan(request)
    assert made >= 1
    assert len(loop.signatures) == made  # type: ignore[attr-defined]  # of numba's function


def test_preparing_teaches_nothing() -> None:
    planner, structure = LEARNERS["pla"], library_structure("wall")
    settings = {**planner.defaults, "iterations": 30}
    request = AssemblyRequest(structure, LENGTHS, 1, settings)
    first = planner.plan(request)
    planner.prepare(request)
    assert planner.plan(request) == first
