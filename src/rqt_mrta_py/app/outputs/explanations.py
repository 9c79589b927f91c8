"""``why.json``: who could have had the tasks that somebody asked about, who took them when, on what grounds."""

from __future__ import annotations

from typing import Any, Dict, Sequence

from rqt_mrta_py.app.outputs.folder import OutputFolder
from rqt_mrta_py.model import Explanation, Ground, Spell, Whereabouts

__all__ = ["explanations_document", "write_explanations"]


def write_explanations(folder: OutputFolder, explanations: Sequence[Explanation]) -> None:
    """Write ``why.json``.

    Args:
        folder: where to.
        explanations: of tasks.
    """
    folder.write_json("why.json", explanations_document(explanations))


def explanations_document(explanations: Sequence[Explanation]) -> Dict[str, Any]:
    """Make plain JSON of explanations, keys in their documented order.

    Args:
        explanations: of tasks.
    """
    return {"schema": "rqt_mrta_py/why/1", "tasks": [_task(each) for each in explanations]}


def _task(explanation: Explanation) -> Dict[str, Any]:
    definition = explanation.definition
    return {
        "id": explanation.task,
        "kind": None if definition is None else definition.kind,
        "capabilities": None if definition is None else list(definition.capabilities),
        "predecessors": None if definition is None else list(definition.predecessors),
        "state": explanation.state.value,
        "candidates": [{"robot": each.robot, "able": each.able, "why": each.why} for each in explanation.candidates],
        "spells": [_spell(each) for each in explanation.spells],
        "grounds": [_ground(each) for each in explanation.grounds],
        "grounds_left_out": explanation.more,
        "note": explanation.note or None,
    }


def _spell(spell: Spell) -> Dict[str, Any]:
    return {
        "robot": spell.robot or None,
        "from": spell.start,
        "to": spell.end,
        "outcome": None if spell.outcome is None else spell.outcome.value,
        "why": spell.text or None,
        "states": [state.value for state in spell.states],
        "others": [_whereabouts(each) for each in spell.others],
        "others_left_out": spell.more,
    }


def _whereabouts(each: Whereabouts) -> Dict[str, Any]:
    state = None if each.state is None else each.state.value
    return {"robot": each.robot, "state": state, "tasks": list(each.tasks), "from": each.start, "to": each.end}


def _ground(ground: Ground) -> Dict[str, Any]:
    values = dict(ground.values)
    return {"time": ground.time, "robot": ground.robot or None, "text": ground.text, "values": values}
