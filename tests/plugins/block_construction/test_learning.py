from __future__ import annotations

from typing import Any, Dict, List, Optional, Tuple

import numpy as np
import pytest
from block_construction.diagram.cost import diagram_cost
from block_construction.diagram.diagram import assembly_diagram
from block_construction.diagram.planning import plan_diagram
from block_construction.errors import ConstructionError
from block_construction.learning.compiled import has_compiler
from block_construction.learning.drawing import Reach, draw_action, draw_diagram
from block_construction.learning.learner import Training, learn
from block_construction.learning.network import Network, network_of, placements_of
from block_construction.learning.planner import LEARNERS
from block_construction.learning.reopening import Standing, fault_rows, least_blocks, reopen, settle
from block_construction.learning.settings import FALA_DEFAULTS, PLA_DEFAULTS, learning_settings
from block_construction.learning.state import BEGUN, LEAST, RUN, UNKNOWN, State, initial_state
from block_construction.structure.library import library_structure, structure_names
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.hooks import AssemblyPlanner, BlockPlacement, Structure

LENGTHS = (1, 2, 3)
FALA, PLA = LEARNERS["fala"], LEARNERS["pla"]
SQUARE = Structure("square", ((1, 1), (1, 1)))
"""Automata 0 to 3 at (1, 1), (2, 1), (1, 2), (2, 2); actions 1 2 -2, 1 -2, 1 2, 1."""

HEIGHTS = st.integers(1, 4).flatmap(
    lambda columns: st.lists(
        st.lists(st.integers(0, 3), min_size=columns, max_size=columns).map(tuple), min_size=1, max_size=4
    )
)


def trained(name: str, seed: int, *, compiled: bool = has_compiler(), **given: Any) -> Training:
    """Train by given settings, all others as of PLA where a noise is given, else as of FALA."""
    defaults = PLA_DEFAULTS if "noise" in given else FALA_DEFAULTS
    rules, course, _ = learning_settings({**defaults, **given})
    network = network_of(library_structure(name), LENGTHS)
    return learn(network, rules, course, np.random.default_rng(seed), compiled=compiled)


@pytest.mark.parametrize(
    ("name", "mean"), [("wall", 12.1), ("dam", 46.2), ("tower", 74.8), ("cistern", 88.8), ("pyramid", 101.0)]
)
def test_diagrams_of_automata_that_know_nothing_cost_what_the_reference_says(name: str, mean: float) -> None:
    found = trained(name, 0, rate=0.0, converged=0.0, iterations=2000)
    assert found.costs.mean() == pytest.approx(mean, abs=1.0)


class Scripted:
    """Draws what it is told."""

    def __init__(self, *draws: float) -> None:
        self.draws: List[float] = list(draws)

    def random(self) -> float:
        return self.draws.pop(0)


def diagram_of(network: Network, state: State, blocks: int) -> Tuple[BlockPlacement, ...]:
    """Give the diagram that a run has drawn."""
    actions = np.full(state.codes.size, -1)
    actions[state.selected[:blocks]] = state.chosen[:blocks]
    return placements_of(network, actions.tolist())


def test_an_action_on_covered_cells_is_left_out() -> None:
    """The second lays a block along y onto (2, 2); the third would lay one along x there, surely, but for that."""
    network = network_of(SQUARE, LENGTHS)
    state = initial_state(network, 1, 1)
    state.probabilities[:] = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0]
    state.tally[RUN] = 1
    random = Scripted(0.5, 0.5)
    blocks, _ = draw_diagram(network, state, random)
    laid = (BlockPlacement(1, 1, 1, 1), BlockPlacement(2, 1, 1, -2), BlockPlacement(1, 2, 1, 1))
    assert diagram_of(network, state, blocks) == laid
    assert random.draws == []


def first_drawn(probabilities: List[float], covered: List[int], draw: float) -> int:
    """Let the square's first automaton draw its action in run 1."""
    network = network_of(SQUARE, LENGTHS)
    reach = Reach(network.begin, network.cells, np.array(covered))
    return draw_action(reach, 1, 0, 3, np.array(probabilities), Scripted(draw))


def test_probabilities_of_open_actions_are_made_to_sum_to_one() -> None:
    # (2, 1) is covered: 0.2 and 0.3 are left, that is 0.4 and 0.6.
    assert first_drawn([0.2, 0.5, 0.3], [0, 1, 0, 0], 0.39) == 0
    assert first_drawn([0.2, 0.5, 0.3], [0, 1, 0, 0], 0.41) == 2
    assert first_drawn([0.2, 0.5, 0.3], [0, 0, 0, 0], 0.41) == 1


def test_open_actions_without_probability_are_drawn_evenly() -> None:
    assert first_drawn([0.0, 1.0, 0.0], [0, 1, 0, 0], 0.49) == 0
    assert first_drawn([0.0, 1.0, 0.0], [0, 1, 0, 0], 0.51) == 2


@given(HEIGHTS, st.integers(0, 2**32))
def test_the_loops_cost_is_that_of_the_diagram(heights: List[Tuple[int, ...]], seed: int) -> None:
    if not any(map(any, heights)):
        heights = [(1,)]
    structure = Structure("any", tuple(heights))
    network = network_of(structure, LENGTHS)
    state = initial_state(network, 1, 2)
    random = np.random.default_rng(seed)
    for run in (1, 2):
        state.tally[RUN] = run
        blocks, faults = draw_diagram(network, state, random)
        diagram = assembly_diagram(structure, LENGTHS, diagram_of(network, state, blocks))
        assert (len(diagram.blocks), len(diagram.faults)) == (blocks, faults)


@pytest.mark.parametrize("given", [{"noise": 0.1, "rate": 0.2}, {"rate": 0.05}, {"rate": 0.1, "credit": "local"}])
def test_the_best_seen_is_kept(given: Dict[str, Any]) -> None:
    found = trained("wall", 3, iterations=300, converged=0.0, **given)
    assert found.cost == found.costs.min() == diagram_cost(found.placements)
    assert len(found.costs) == len(found.convergence) == 300


@pytest.mark.parametrize("planner", [FALA, PLA], ids=["fala", "pla"])
def test_the_wall_is_learned(planner: AssemblyPlanner) -> None:
    planned = plan_diagram(planner, library_structure("wall"), LENGTHS, seed=1, settings={"rate": 0.05})
    assert planned.diagram.cost == 6
    assert planned.diagram.faults == ()
    assert min(planned.costs) == 6
    assert len(planned.convergence) == len(planned.costs)
    assert planned.convergence[-1] >= 0.95
    assert max(planned.convergence[:-1]) < 0.95


def test_the_same_seed_has_the_same_outcome() -> None:
    settings = {"iterations": 200, "reopen": "yes", "leg": 50}
    structure = library_structure("dam")
    first, second, other = (plan_diagram(PLA, structure, LENGTHS, seed=seed, settings=settings) for seed in (7, 7, 8))
    assert (first.diagram, first.costs, first.convergence) == (second.diagram, second.costs, second.convergence)
    assert first.costs != other.costs


@pytest.mark.skipif(not has_compiler(), reason="numba is not installed")
@pytest.mark.parametrize("given", [{"noise": 0.1, "rate": 0.2}, {"rate": 0.05, "penalty_rate": 0.01}])
@pytest.mark.parametrize("credit", ["global", "local"])
def test_compiled_or_not_is_the_same_to_the_last_bit(given: Dict[str, Any], credit: str) -> None:
    settings = {**given, "credit": credit, "iterations": 60, "memory": 20, "reopen": "yes", "leg": 40}
    one, two = (trained("station", 4, compiled=compiled, **settings) for compiled in (True, False))
    assert one.costs.tolist() == two.costs.tolist()
    assert one.convergence.tolist() == two.convergence.tolist()
    assert one.placements == two.placements


@pytest.mark.long
@pytest.mark.skipif(not has_compiler(), reason="numba is not installed")
@pytest.mark.parametrize("name", structure_names())
@pytest.mark.parametrize("planner", ["fala", "pla"])
def test_compiled_or_not_is_the_same_for_every_structure(name: str, planner: str) -> None:
    settings: Dict[str, Any] = {"rate": 0.1, "iterations": 1500, "converged": 0.0}
    settings.update({"noise": 0.1} if planner == "pla" else {})
    one, two = (trained(name, 5, compiled=compiled, **settings) for compiled in (True, False))
    assert one.costs.tolist() == two.costs.tolist()
    assert one.convergence.tolist() == two.convergence.tolist()


def test_training_stops_when_automata_have_decided() -> None:
    found = trained("wall", 0, rate=0.2, converged=0.9, iterations=5000)
    assert len(found.costs) < 5000
    assert found.convergence[-1] >= 0.9
    assert (found.convergence[:-1] < 0.9).all()


def test_training_stops_when_enough_recent_runs_cost_the_least() -> None:
    found = trained("wall", 0, rate=0.1, converged=0.0, enough_hits=30, iterations=5000)
    run = len(found.costs)
    assert run < 5000
    assert (found.costs[-100:] == found.cost).sum() == 30
    earlier = found.costs[: run - 1]
    assert (earlier[-100:] == earlier.min()).sum() < 30


def test_a_structure_without_a_choice_is_done_in_one_run() -> None:
    planned = plan_diagram(FALA, Structure("post", ((3,),)), LENGTHS)
    # Three singles, two faults between them.
    assert planned.diagram.cost == 5
    assert planned.costs == (5,)
    assert planned.convergence == (1.0,)


def test_progress_grows_to_the_end() -> None:
    told: List[float] = []
    settings = {"iterations": 250, "converged": 0.0}
    plan_diagram(FALA, library_structure("wall"), LENGTHS, settings=settings, on_progress=told.append)
    assert told == sorted(told)
    assert told[-1] == 1.0
    assert len(told) > 50


def test_costs_that_no_diagram_is_below() -> None:
    # A level of 24 cells in one layer needs 8 blocks of three; a pyramid's levels are 64, 36, 16 and 4 cells, in rings
    # of 28, 20, 12 and 4: (10 + 7 + 4 + 2) + (7 + 4 + 2) + (4 + 2) + 2.
    assert least_blocks(network_of(library_structure("cistern"), LENGTHS), 3) == 32
    assert least_blocks(network_of(library_structure("pyramid"), LENGTHS), 3) == 44
    assert plan_diagram(FALA, library_structure("wall"), (1,)).proved is False


def test_a_cost_equal_to_the_bound_is_proved() -> None:
    planned = plan_diagram(FALA, Structure("bar", ((1, 1, 1),)), LENGTHS, settings={"rate": 0.1})
    assert (planned.diagram.cost, planned.proved) == (1, True)


def test_rows_of_faults_are_told_by_layer_and_lower_level() -> None:
    network = network_of(Structure("stack", ((3, 3, 3),)), LENGTHS)
    best = np.full(9, -1)
    # Three units on all levels: their ends coincide twice.
    best[[0, 3, 6]] = [int(np.flatnonzero(network.lengths == 3)[level]) for level in range(3)]
    assert fault_rows(network, best) == [(1, 1), (1, 2)]


@given(st.integers(0, 2**32))
def test_only_levels_beside_a_row_of_faults_begin_anew(seed: int) -> None:
    network = network_of(Structure("stack", ((4, 4, 4),)), LENGTHS)
    threes = np.flatnonzero(network.lengths == 3)
    best = np.full(12, -1)
    # Blocks of three on levels 2 and 3 only: their ends coincide, all other ends are single on middle or middle on one.
    best[[3, 6]] = threes[1:3]
    assert fault_rows(network, best) == [(1, 2)]
    state = initial_state(network, 5, 10)
    state.probabilities[:] = 9.0
    standing = Standing(20, best, state.probabilities.copy(), state.parameters.copy())
    reopen(network, state, standing, np.random.default_rng(seed))
    fresh = {
        int(network.level[automaton]) for automaton in range(12) if state.probabilities[network.first[automaton]] < 9
    }
    assert fresh in ({3}, {3, 4}, {2}, {1, 2})
    assert state.tally[LEAST] == UNKNOWN
    assert state.tally[BEGUN] == state.tally[RUN]


def test_what_costs_more_is_not_taken() -> None:
    network = network_of(SQUARE, LENGTHS)
    state = initial_state(network, 5, 10)
    before = Standing(4, state.best.copy(), state.probabilities.copy(), state.parameters.copy())
    state.tally[LEAST] = 5
    state.probabilities[:] = 0.0
    assert settle(state, before) is before
    assert (state.probabilities == before.probabilities).all()
    state.tally[LEAST] = 4
    state.probabilities[:] = 0.25
    after = settle(state, before)
    assert after.cost == 4
    assert (after.probabilities == 0.25).all()


def test_noise_goes_by_the_rate_or_as_printed_by_its_root() -> None:
    for asked, deviation in (({}, 0.025), ({"noise_scale": "rate"}, 0.025), ({"noise_scale": "root"}, 0.05)):
        rules = learning_settings({**PLA_DEFAULTS, "rate": 0.25, **asked}).rules
        assert rules.noise == pytest.approx(deviation)
    assert learning_settings(FALA_DEFAULTS).rules.noise == 0.0


@pytest.mark.parametrize(
    ("credit", "reopen", "leg"),
    [
        ("global", "auto", None),
        ("global", "yes", 10_000),
        ("local", "auto", 10_000),
        ("local", "yes", 10_000),
        ("local", "no", None),
    ],
)
def test_automata_begin_anew_under_local_credit_unless_told_otherwise(
    credit: str, reopen: str, leg: Optional[int]
) -> None:
    for defaults in (FALA_DEFAULTS, PLA_DEFAULTS):
        assert learning_settings({**defaults, "credit": credit, "reopen": reopen}).course.leg == leg
    assert FALA_DEFAULTS["credit"] == PLA_DEFAULTS["credit"] == "global"


@pytest.mark.parametrize("method", ["fala", "pla", "fala-tuned", "pla-tuned"])
def test_local_credit_is_all_that_the_cistern_takes(method: str) -> None:
    cistern = library_structure("cistern")
    planned = plan_diagram(LEARNERS[method], cistern, LENGTHS, seed=5, settings={"credit": "local"})
    assert (planned.diagram.cost, planned.proved) == (32, True)


@pytest.mark.parametrize(
    ("setting", "value", "accepted"),
    [
        ("rate", 1.5, "0 to 1"),
        ("rate", float("nan"), "0 to 1"),
        ("memory", 0, "1 to 100000"),
        ("iterations", 0, "1 to 10000000"),
        ("credit", "shared", "global or local"),
        ("enough_hits", 101, "0 to 100"),
        ("compiled", "maybe", "auto, no or yes"),
    ],
)
def test_settings_out_of_range_are_told(setting: str, value: object, accepted: str) -> None:
    with pytest.raises(ConstructionError) as caught:
        plan_diagram(FALA, library_structure("wall"), LENGTHS, settings={setting: value})
    assert str(caught.value) == f"setting {setting}: {value}; accepted is {accepted}"


def test_parameters_that_grow_beyond_all_bounds_are_told() -> None:
    settings = {
        "rate": 1.0,
        "stiffness": 10.0,
        "bound": 0.1,
        "power": 5,
        "noise": 5.0,
        "converged": 0.0,
        "iterations": 300,
    }
    with pytest.raises(ConstructionError, match="grew beyond all bounds; lower rate, stiffness, power or noise"):
        plan_diagram(PLA, library_structure("wall"), LENGTHS, settings=settings)


def test_too_much_to_remember_is_told() -> None:
    settings = {"memory": 100_000, "iterations": 1}
    with pytest.raises(ConstructionError, match=r"^cistern: 1200 automata that remember 100000 costs each; .* smaller"):
        plan_diagram(FALA, Structure("cistern", ((600,) * 2,)), LENGTHS, settings=settings)
