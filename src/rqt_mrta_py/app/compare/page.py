"""A comparison for a browser: one page that needs nothing else, in light, dark and on paper."""

from __future__ import annotations

from html import escape
from typing import Iterable, Iterator, List, Sequence

from rqt_mrta_py.app.compare.comparison import Comparison, FigureComparison, Verdict
from rqt_mrta_py.app.compare.drawing import lanes
from rqt_mrta_py.app.compare.wording import (
    NOTHING,
    allowed,
    change,
    headline,
    holding,
    number,
    side_name,
    task_line,
    verdict_line,
)

__all__ = ["page"]

_STYLE = """
:root {color-scheme: light dark; --ground: #fff; --ink: #1f242c; --soft: #5c6570; --line: #cdd3da; --bad: #be1a26;
  --good: #006e50; --badly: #fdecec}
@media (prefers-color-scheme: dark) {:root {--ground: #15181d; --ink: #e6e9ee; --soft: #a3acb8; --line: #3a424d;
  --bad: #ff8a90; --good: #5fd3ae; --badly: #3a1c20}}
* {box-sizing: border-box}
body {margin: 0 auto; padding: 1.5rem; max-width: 70rem; background: var(--ground); color: var(--ink);
  font: 16px/1.45 system-ui, sans-serif; overflow-wrap: anywhere}
h1 {font-size: 1.5rem; margin: 0 0 .3rem}
h2 {font-size: 1.15rem; margin: 2rem 0 .5rem}
h3 {font-size: 1rem; margin: 1.2rem 0 .2rem}
p {margin: .3rem 0}
.soft {color: var(--soft)}
.verdict {font-weight: 600; border-left: .35rem solid var(--good); padding: .4rem .8rem}
.verdict.worse {border-color: var(--bad); background: var(--badly)}
table {border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums}
th, td {text-align: left; padding: .25rem .6rem; border-bottom: 1px solid var(--line); vertical-align: top;
  overflow-wrap: break-word}
th.n, td.n {text-align: right; white-space: nowrap}
tr.worse td {background: var(--badly)}
tr.worse td:last-child {color: var(--bad); font-weight: 600}
.wide {overflow-x: auto}
svg {width: 100%; min-width: 40rem; height: auto; display: block}
svg text {font: 12px system-ui, sans-serif}
svg .lane, svg .tick {fill: var(--soft)}
svg .axis {stroke: var(--soft)}
svg .grid {stroke: var(--line)}
details {margin: .6rem 0}
summary {cursor: pointer}
:focus-visible {outline: 2px solid var(--ink); outline-offset: 2px}
@media print {
  :root {--ground: #fff; --ink: #000; --soft: #444; --line: #bbb; --bad: #a00; --good: #060; --badly: #fff}
  body {padding: 0; max-width: none}
  h2, h3 {break-after: avoid}
  tr, svg {break-inside: avoid}
  svg {min-width: 0}
  th, td {overflow-wrap: anywhere}
  * {print-color-adjust: exact}
}
"""


def page(comparison: Comparison, shift: float) -> str:
    """Write a comparison as HTML.

    Args:
        comparison: of two missions.
        shift: by how much an allocation's times may differ without being told of [s].

    Returns:
        The page: no scripts, nothing from elsewhere; every text from outside is escaped. The same for the same
        comparison.
    """
    names = dict.fromkeys(side_name(side) for side in (comparison.first, comparison.second))
    title = f"{' and '.join(names)}: two missions compared"
    return "".join(
        [
            '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n',
            '<meta name="viewport" content="width=device-width, initial-scale=1">\n',
            "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n",
            f"<title>{escape(title)}</title>\n<style>{_STYLE}</style>\n</head>\n<body>\n<main>\n",
            f"<h1>{escape(title)}</h1>\n",
            *_verdict(comparison),
            *_sides(comparison),
            *_figures(comparison),
            *_tasks(comparison, shift),
            *_incidents(comparison),
            "</main>\n</body>\n</html>\n",
        ]
    )


def _verdict(comparison: Comparison) -> Iterator[str]:
    kind = "verdict worse" if comparison.worse else "verdict"
    yield f'<p class="{kind}" role="status">{escape(verdict_line(comparison))}</p>\n'


def _sides(comparison: Comparison) -> Iterator[str]:
    sides = (comparison.first, comparison.second)
    rows = [
        ["Folder", *(str(side.path.parent) for side in sides)],
        ["Application", *(side.application or NOTHING for side in sides)],
        ["Architecture", *(side.architecture or NOTHING for side in sides)],
        ["Taxonomy", *(side.taxonomy or NOTHING for side in sides)],
        ["Seed", *(number(side.seed) for side in sides)],
        ["Duration [s]", *(number(side.duration) for side in sides)],
    ]
    yield "<h2>Missions</h2>\n"
    yield from _table(("", "A", "B"), rows)


def _figures(comparison: Comparison) -> Iterator[str]:
    differing = [figure for figure in comparison.figures if figure.verdict is not Verdict.EQUAL]
    worse = [figure for figure in differing if figure.verdict is Verdict.WORSE]
    others = [figure for figure in differing if figure.verdict is not Verdict.WORSE]
    equal = len(comparison.figures) - len(differing)
    counts = f"{len(worse)} worse, {len(others)} otherwise different, {equal} equal"
    yield f'<h2>Figures</h2>\n<p class="soft">{counts}</p>\n'
    if differing:
        yield from _figure_table([*worse, *others])
    if equal:
        yield "<details><summary>Equal figures</summary>\n"
        yield from _figure_table([figure for figure in comparison.figures if figure.verdict is Verdict.EQUAL])
        yield "</details>\n"


def _figure_table(figures: Sequence[FigureComparison]) -> Iterator[str]:
    rows = [
        [
            figure.name,
            number(figure.first) if figure.known[0] else "none",
            number(figure.second) if figure.known[1] else "none",
            change(figure),
            allowed(figure),
            figure.verdict.value,
        ]
        for figure in figures
    ]
    marks = ["worse" if figure.verdict is Verdict.WORSE else "" for figure in figures]
    yield from _table(("Figure", "A", "B", "Change", "Allowed", "Verdict"), rows, numbers=(1, 2, 3, 4), marks=marks)


def _tasks(comparison: Comparison, shift: float) -> Iterator[str]:
    yield f"<h2>Allocations</h2>\n<p>{escape(headline(comparison, shift))}</p>\n"
    robots = sorted({*comparison.first.robots, *comparison.second.robots})
    until = max([comparison.first.duration or 0.0, comparison.second.duration or 0.0])
    for task in comparison.tasks:
        yield f'<h3>{escape(task.task)}</h3>\n<p class="soft">{escape(task_line(task))}</p>\n'
        if not task.pairs:
            continue
        yield f'<div class="wide">{lanes(task, robots, until)}</div>\n'
        rows = [
            [
                pair.robot,
                str(pair.number),
                holding(pair.first),
                holding(pair.second),
                "differs" if pair.differs(shift) else "same",
            ]
            for pair in task.pairs
        ]
        yield f"<details><summary>{len(rows)} allocation{'' if len(rows) == 1 else 's'}</summary>\n"
        yield from _table(("Robot", "No.", "A", "B", ""), rows, numbers=(1,))
        yield "</details>\n"


def _incidents(comparison: Comparison) -> Iterator[str]:
    rows: List[List[str]] = []
    for pair in comparison.incidents:
        both = pair.first is not None and pair.second is not None
        where = "both" if both else "A only" if pair.second is None else "B only"
        shown = pair.shown
        rows.append([where, f"{shown.start:.1f}", shown.severity, shown.rule, shown.text])
    rows.sort(key=lambda row: row[0] == "both")
    new = sum(row[0] == "B only" for row in rows)
    gone = sum(row[0] == "A only" for row in rows)
    counts = f"{new} new in B, {gone} in A only, {len(rows) - new - gone} in both"
    yield f'<h2>Incidents</h2>\n<p class="soft">{counts}</p>\n'
    if rows:
        yield from _table(("In", "From [s]", "Severity", "Rule", "What happened"), rows, numbers=(1,))


def _table(
    head: Sequence[str], rows: Sequence[Sequence[str]], numbers: Iterable[int] = (), marks: Sequence[str] = ()
) -> Iterator[str]:
    right = frozenset(numbers)
    kinds = [' class="n"' if column in right else "" for column in range(len(head))]
    yield '<div class="wide"><table>\n<thead><tr>'
    yield "".join(f'<th scope="col"{kind}>{escape(title)}</th>' for kind, title in zip(kinds, head))
    yield "</tr></thead>\n<tbody>\n"
    for index, row in enumerate(rows):
        mark = f' class="{marks[index]}"' if marks and marks[index] else ""
        yield f"<tr{mark}>" + "".join(f"<td{kind}>{escape(cell)}</td>" for kind, cell in zip(kinds, row)) + "</tr>\n"
    yield "</tbody></table></div>\n"
