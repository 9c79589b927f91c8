"""Why tasks went to whom they went: of each task that somebody asked about, a page of its own within the page."""

from __future__ import annotations

from typing import List, Optional, Sequence

from rqt_mrta_py.model import Explanation, Ground, Spell
from rqt_mrta_py.render.explaining import (
    candidate_groups,
    ends_of,
    named,
    others_in_lines,
    spell_in_words,
    task_in_words,
)
from rqt_mrta_py.render.report.html import Content, Html, element, joined
from rqt_mrta_py.render.report.report_input import ReportInput
from rqt_mrta_py.render.report.tables import moment, section, table
from rqt_mrta_py.render.signs import OUTCOME_SIGNS
from rqt_mrta_py.render.times import seconds

__all__ = ["explanations_section"]

_MOST_TASKS = 200
_MOST_ROWS = 2000
"""Of all tasks together, so that the page stays small."""
_FEWEST_ROWS = 10
_OPEN = 3
"""So many tasks are shown open; of more, each is opened by whoever wants to read it."""


def explanations_section(given: ReportInput) -> Optional[Html]:
    """Explain the tasks that somebody asked about; None if nobody did."""
    explanations = given.explanations
    if not explanations:
        return None
    start = given.view.record.start or 0.0
    shown = explanations[:_MOST_TASKS]
    rows = max(_MOST_ROWS // (2 * len(shown)), _FEWEST_ROWS)
    more = len(explanations) - len(shown)
    return section(
        "why",
        "Why",
        *(_task(each, start, rows, len(shown) <= _OPEN) for each in shown),
        element("p", f"{more} more are in why.json", class_="hint") if more else None,
        note="Who could have had a task, who took it when, and on what grounds, as far as the bag shows.",
    )


def _task(explanation: Explanation, start: float, most: int, is_open: bool) -> Html:
    return element(
        "details",
        element("summary", element("b", named([explanation.task])), f" {task_in_words(explanation)}"),
        element("h3", "Who could have had it"),
        _candidates(explanation),
        element("h3", "Who took it, and when"),
        _spells(explanation, start, most),
        element("h3", "On what grounds"),
        _grounds(explanation, start, most),
        class_="why",
        open=is_open,
    )


def _candidates(explanation: Explanation) -> Html:
    groups = candidate_groups(explanation.candidates)
    if not groups:
        return element("p", "No robot is known.", class_="calm")
    rows = [[group.answer, group.robots, group.why] for group in groups]
    return table(f"Who could have had {named([explanation.task])}", ("could", "robots", "because"), rows, 9)


def _spells(explanation: Explanation, start: float, most: int) -> Html:
    first, left_out, last = ends_of(explanation.spells, most)
    rows: List[Sequence[Content]] = [_spell(each, start) for each in first]
    if left_out:
        rows.append(["…", "", "", f"{left_out} more in why.json", ""])
    rows += [_spell(each, start) for each in last]
    if not rows:
        return element("p", "It was never there.", class_="calm")
    heads = ("from", "lasted", "held by", "how it went", "the others that could have had it")
    made = table(f"Who took {named([explanation.task])}", heads, rows, 9)
    return element("div", made, class_="spells")


def _spell(spell: Spell, start: float) -> Sequence[Content]:
    sign = "" if spell.outcome is None else OUTCOME_SIGNS[spell.outcome]
    went = f"{sign} {spell_in_words(spell)}".strip()
    return [
        moment(spell.start - start),
        seconds(spell.end - spell.start),
        named([spell.robot]) if spell.robot else element("em", "nobody"),
        went,
        joined([element("div", line) for line in others_in_lines(spell, start)]),
    ]


def _grounds(explanation: Explanation, start: float, most: int) -> Html:
    first, left_out, last = ends_of(explanation.grounds, most)
    rows: List[Sequence[Content]] = [_ground(each, start) for each in first]
    if left_out:
        rows.append(["…", "", f"{left_out} more in why.json"])
    rows += [_ground(each, start) for each in last]
    note = explanation.note
    if explanation.more:
        note = f"{explanation.more} more were told, and not kept. {note}"
    return element(
        "div",
        table(f"Grounds for {named([explanation.task])}", ("when", "robot", "ground"), rows, 9) if rows else None,
        element("p", note, class_="hint") if note else None,
    )


def _ground(ground: Ground, start: float) -> Sequence[Content]:
    return [moment(ground.time - start), named([ground.robot]) if ground.robot else "", ground.text]
