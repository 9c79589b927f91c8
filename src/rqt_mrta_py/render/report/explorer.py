"""The mission to be walked through: what the page's script fills with timeline, arena and curves."""

from __future__ import annotations

from typing import Sequence, Tuple

from rqt_mrta_py.model import Outcome
from rqt_mrta_py.render.report.html import Html, element, joined
from rqt_mrta_py.render.report.report_input import ReportInput
from rqt_mrta_py.render.signs import OUTCOME_SIGNS

__all__ = ["explorer_section"]

_KEYS: Sequence[Tuple[str, str]] = (
    ("← →", "a second back or on; with Shift ten"),
    ("↑ ↓", "another row"),
    ("N P", "next, previous incident"),
    ("E B", "next event, event before"),
    ("+ −", "zoom in, out"),
    ("[ ]", "move the window"),
    ("0", "the whole mission"),
    ("Space", "play, stop"),
    ("Home End", "start, end"),
)


def explorer_section(given: ReportInput) -> Html:
    """Make the empty stage."""
    return element(
        "section",
        element(
            "div",
            element("h2", "The mission", id="mission-title"),
            element(
                "p", "click: choose a moment · drag: move · Ctrl + wheel or double click: zoom", class_="note screen"
            ),
            class_="head",
        ),
        element("noscript", element("p", "Timeline, arena and curves are drawn by the page's script.", class_="hint")),
        element("div", _stage(), _chart(), class_="explorer", id="explorer"),
        _legend(),
        _help(),
        id="mission",
        aria_labelledby="mission-title",
    )


def _stage() -> Html:
    return element(
        "div",
        element(
            "div",
            _button("back", "◀◀", "Event before (B)"),
            _button("play", "▶", "Play (Space)"),
            _button("on", "▶▶", "Next event (E)"),
            element("output", "", id="now", class_="clock"),
            element(
                "select",
                *(element("option", f"×{speed}", value=speed, selected=speed == 4) for speed in (1, 4, 16, 64)),
                id="speed",
                aria_label="Seconds of the mission a second",
            ),
            class_="transport screen",
        ),
        element("p", "", class_="printed-moment", id="printed-moment"),
        element("div", "", id="arena", class_="arena"),
        element("div", "", id="moment", class_="moment", role="region", aria_label="The team at the chosen moment"),
        class_="stage",
    )


def _chart() -> Html:
    return element(
        "div",
        element(
            "div",
            _button("zoom-in", "+", "Zoom in (+)"),
            _button("zoom-out", "−", "Zoom out (−)"),
            _button("fit", "Whole mission", "Show the whole mission (0)"),
            _button("previous", "▲ ‹", "Previous incident (P)"),
            _button("next", "▲ ›", "Next incident (N)"),
            element("span", "", id="parts", class_="parts"),
            class_="tools screen",
        ),
        element("div", "", id="overview", class_="overview screen"),
        element("div", "", id="axis", class_="axis"),
        element("div", "", id="rows", class_="rows"),
        element("p", "", id="said", class_="unseen", aria_live="polite"),
        class_="chart",
    )


def _legend() -> Html:
    states = [
        element("span", element("i", "", class_=f"swatch fill-{state}"), state) for state in ("idle", "busy", "offline")
    ]
    tasks = [
        element("span", element("i", "", class_=f"swatch task-{state}"), state)
        for state in ("waiting", "allocated", "executing", "done", "failed", "withdrawn")
    ]
    signs = [
        element("span", element("b", OUTCOME_SIGNS[outcome]), outcome.value.replace("_", " "))
        for outcome in Outcome
        if OUTCOME_SIGNS[outcome]
    ]
    marks = [
        element("span", element("b", "▲", class_="error"), "incident"),
        element("span", element("b", "◆", class_="scenario"), "made happen by the scenario"),
    ]
    groups = (("Robots", states), ("Tasks", tasks), ("Ends", signs), ("Marks", marks))
    return element(
        "p", *(element("span", element("em", name), *each, class_="group") for name, each in groups), class_="legend"
    )


def _help() -> Html:
    pairs = [
        element("div", element("dt", joined([element("kbd", key) for key in keys.split()])), element("dd", meaning))
        for keys, meaning in _KEYS
    ]
    return element(
        "details",
        element("summary", "Keys, once the timeline has the focus"),
        element("dl", *pairs, class_="keys"),
        class_="screen",
    )


def _button(name: str, sign: str, meaning: str) -> Html:
    return element("button", sign, id=name, type="button", title=meaning, aria_label=meaning)
