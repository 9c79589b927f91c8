"""Explanations on the terminal, held against what a person would lay out."""

from __future__ import annotations

from dataclasses import replace

from rqt_mrta_py.app.cli.why_text import why_text
from rqt_mrta_py.model import (
    Candidate,
    Explanation,
    Ground,
    Outcome,
    RobotState,
    Spell,
    Task,
    TaskState,
    Whereabouts,
)

DIG = Explanation(
    "dig",
    Task("dig", "digging", capabilities=("claws",)),
    TaskState.DONE,
    (Candidate("mole", True, "has claws"), Candidate("worm", False, "lacks claws")),
    (
        Spell(10.0, 13.5, states=(TaskState.WAITING,), others=(Whereabouts("mole", RobotState.IDLE, (), 10.0, 13.5),)),
        Spell(13.5, 110.0, "mole", Outcome.DONE, (TaskState.EXECUTING,), "all dug"),
    ),
    (Ground(12.0, "dig", "was ordered"), Ground(13.4, "dig", "bids 2 m", "mole"), Ground(120.0, "dig", "late", "mole")),
    7,
    "no more is known",
)


def test_explanation_is_laid_out_in_columns() -> None:
    assert why_text([DIG], 10.0).splitlines() == [
        "",
        "why dig: digging, needs claws; done at the end",
        "  who could have had it",
        "    yes      mole: has claws",
        "    no       worm: lacks claws",
        "  who took it, and when",
        "       0.0 s to     3.5 s  nobody: waiting",
        "                             mole: idle",
        "       3.5 s to   100.0 s  mole: done: all dug",
        "  on what grounds",
        "       2.0 s        was ordered",
        "       3.4 s  mole  bids 2 m",
        "    1 more, of when it had ended, in why.json",
        "    7 more were told, and not kept",
        "    no more is known",
    ]


def test_long_lines_go_on_below_their_text_and_no_number_loses_its_unit() -> None:
    text = " ".join(f"at {n}.0 s" for n in range(10, 50))
    explanation = replace(DIG, grounds=(Ground(12.0, "dig", text, "mole"),), more=0, note="")
    lines = why_text([explanation], 10.0).splitlines()
    grounds = lines[lines.index("  on what grounds") + 1 :]
    assert len(grounds) == 5
    assert [line[:20].strip() for line in grounds] == ["2.0 s  mole", *[""] * (len(grounds) - 1)]
    assert all(len(line) <= 110 and line.endswith(" s") for line in grounds)
    assert " ".join(line[20:] for line in grounds) == text


def test_of_very_many_grounds_the_first_and_the_last_are_printed() -> None:
    grounds = tuple(Ground(10.0 + n / 10.0, "dig", f"ground {n}.", "mole") for n in range(500))
    lines = why_text([replace(DIG, grounds=grounds)], 10.0).splitlines()
    assert sum("ground" in line and "." in line for line in lines) == 60
    assert "    440 more in why.json" in lines
