"""The whole page: one file, no network, nothing in it that its input could have made live."""

from __future__ import annotations

import base64
import hashlib
import pkgutil
from typing import Iterable, List, Mapping, Optional, Tuple

from rqt_mrta_py.render.palette import (
    BODY_COLOURS,
    SEVERITY_COLOURS,
    STATE_COLOURS,
    TASK_COLOURS,
    TASK_STATE_COLOURS,
    Colour,
    TaskColours,
    readable_on,
)
from rqt_mrta_py.render.report.clocks import clocks_section
from rqt_mrta_py.render.report.explanations import explanations_section
from rqt_mrta_py.render.report.explorer import explorer_section
from rqt_mrta_py.render.report.html import Html, element, joined, json_block
from rqt_mrta_py.render.report.incidents import incidents_section
from rqt_mrta_py.render.report.network import network_section
from rqt_mrta_py.render.report.payload import payload
from rqt_mrta_py.render.report.provenance import provenance_section
from rqt_mrta_py.render.report.report_input import ReportInput
from rqt_mrta_py.render.report.statistics import sorted_figures, statistics_section
from rqt_mrta_py.render.report.summary import summary_section
from rqt_mrta_py.render.report.tables import allocations_section, robots_section, tasks_section

__all__ = ["report_html"]

_SCRIPTS = ("data", "scale", "overview", "rows", "curves", "arena", "moment", "main")


def report_html(given: ReportInput) -> str:
    """Make the page.

    Args:
        given: a finished mission.

    Returns:
        HTML; equal for equal input.
    """
    style = Html(_palette() + _asset("report.css"))
    script = Html("(function(){'use strict';\n" + "".join(_asset(f"{name}.js") for name in _SCRIPTS) + "})();")
    view = given.view
    head = element(
        "head",
        element("meta", charset="utf-8"),
        element("meta", http_equiv="Content-Security-Policy", content=_policy(style, script)),
        element("meta", name="viewport", content="width=device-width, initial-scale=1"),
        element("meta", name="color-scheme", content="light dark"),
        element("title", f"{view.title or 'Mission'}: report"),
        element("style", style),
    )
    figures = sorted_figures(given)
    sections = [
        ("summary", "", summary_section(given)),
        ("incidents", "Incidents", incidents_section(given)),
        ("mission", "Mission", explorer_section(given)),
        ("robots", "Robots", robots_section(given, figures.of_robots)),
        ("tasks", "Tasks", tasks_section(given, figures.of_tasks)),
        ("allocations", "Allocations", allocations_section(given)),
        ("why", "Why", explanations_section(given)),
        ("statistics", "Statistics", statistics_section(figures)),
        ("communication", "Communication", network_section(given)),
        ("clocks", "Clocks", clocks_section(given)),
        ("provenance", "Provenance", provenance_section(given)),
    ]
    body = element(
        "body",
        element("a", "Skip to the timeline", href="#mission", class_="skip"),
        _band(given),
        _contents(sections),
        element("main", *(made for _, _, made in sections if made is not None)),
        json_block("mission-data", payload(given, TaskColours.of(view))),
        element("script", script),
    )
    return f"<!DOCTYPE html>\n{element('html', head, body, lang='en')}\n"


def _band(given: ReportInput) -> Html:
    view = given.view
    return element(
        "header",
        element("h1", view.title or "Mission"),
        element("p", " · ".join(view.subtitle.split("  ")), class_="subtitle"),
        element(
            "button", "Theme", id="theme", type="button", title="Light, dark, or as the system has it", class_="screen"
        ),
        class_="band",
    )


def _contents(sections: Iterable[Tuple[str, str, Optional[Html]]]) -> Html:
    links = [element("a", title, href=f"#{name}") for name, title, made in sections if title and made is not None]
    return element("nav", *links, aria_label="Sections", class_="screen")


def _policy(style: Html, script: Html) -> str:
    """Allow the page's own script and style, and nothing else: no network, no handler, no frame, no form."""
    return (
        f"default-src 'none'; script-src {_hash(script)}; style-src {_hash(style)}; base-uri 'none'; form-action 'none'"
    )


def _hash(text: str) -> str:
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode('utf-8')).digest()).decode('ascii')}'"


def _asset(name: str) -> str:
    content = pkgutil.get_data("rqt_mrta_py.render.report", f"assets/{name}")
    return joined([Html((content or b"").decode("utf-8"))])


def _palette() -> str:
    """Give the colours of the pictures to the page."""
    colours: List[Tuple[str, Colour]] = []
    colours += [(f"task-{number}", colour) for number, colour in enumerate(TASK_COLOURS)]
    colours += [(f"on-task-{number}", readable_on(colour)) for number, colour in enumerate(TASK_COLOURS)]
    colours += [(f"body-{number}", colour) for number, colour in enumerate(BODY_COLOURS)]
    named: Iterable[Tuple[str, Mapping[object, Colour]]] = (
        ("state", {state.value: colour for state, colour in STATE_COLOURS.items()}),
        ("stage", {state.value: colour for state, colour in TASK_STATE_COLOURS.items()}),
        ("severity", {severity.value: colour for severity, colour in SEVERITY_COLOURS.items()}),
    )
    colours += [(f"{kind}-{name}", colour) for kind, mapping in named for name, colour in mapping.items()]
    told = "".join(f"--{name}:rgb({red} {green} {blue});" for name, (red, green, blue) in colours)
    numbers = range(len(TASK_COLOURS))
    fills = "".join(f".t{n}{{--c:var(--task-{n});--on:var(--on-task-{n})}}" for n in numbers)
    bodies = "".join(f".b{n}{{fill:var(--body-{n})}}" for n in range(len(BODY_COLOURS)))
    return f":root{{{told}}}{fills}{bodies}\n"
