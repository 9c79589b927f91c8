"""What went wrong, in words: each incident leads to its moment in the timeline."""

from __future__ import annotations

from typing import Optional

from rqt_mrta_py.model import Evidence, Incident, Severity
from rqt_mrta_py.render.report.html import Html, element, joined
from rqt_mrta_py.render.report.report_input import ReportInput
from rqt_mrta_py.render.report.tables import counted, moment, section
from rqt_mrta_py.render.times import seconds

__all__ = ["incidents_section", "severity_sign"]

_MOST = 1000
_MOST_EVIDENCE = 50


def severity_sign(severity: Severity) -> Html:
    """Give the sign of a severity; its shape says what its colour says."""
    sign = {Severity.ERROR: "▲", Severity.WARNING: "▲", Severity.INFO: "●"}[severity]
    return element("span", sign, class_=f"sign {severity.value}", aria_hidden="true")


def incidents_section(given: ReportInput) -> Html:
    """List the incidents by time."""
    record = given.view.record
    start = record.start or 0.0
    if not record.incidents:
        return section("incidents", "Incidents", element("p", "No rule found anything wrong.", class_="calm"))
    cards = [_card(given, number, start) for number in range(min(len(record.incidents), _MOST))]
    more = len(record.incidents) - len(cards)
    return section(
        "incidents",
        "Incidents",
        element("ol", *cards, class_="incidents"),
        element("p", f"{more} more are in incidents.jsonl", class_="hint") if more else None,
    )


def _card(given: ReportInput, number: int, start: float) -> Html:
    incident = given.view.record.incidents[number]
    length = incident.end - incident.start
    facts = [("rule", incident.rule.replace("_", " "))]
    facts += (
        [("robot" if len(incident.robots) == 1 else "robots", ", ".join(incident.robots))] if incident.robots else []
    )
    facts += [("task" if len(incident.tasks) == 1 else "tasks", ", ".join(incident.tasks))] if incident.tasks else []
    facts.append(("lasted", seconds(length)))
    causes = incident.causes
    return element(
        "li",
        severity_sign(incident.severity),
        element("div", moment(incident.start - start, number), class_="when-cell"),
        element(
            "div",
            element(
                "p",
                element("strong", f"{incident.severity.value}: ", class_=f"word {incident.severity.value}"),
                incident.text,
                class_="text",
            ),
            element("p", *(_fact(name, value) for name, value in facts), class_="facts"),
            element("p", element("b", "Usual cause: "), causes, class_="causes") if causes else None,
            _evidence(incident, start),
        ),
        class_=f"incident {incident.severity.value}",
    )


def _fact(name: str, value: str) -> Html:
    return element("span", element("i", f"{name} "), value)


def _evidence(incident: Incident, start: float) -> Optional[Html]:
    if not incident.evidence:
        return None
    shown = incident.evidence[:_MOST_EVIDENCE]
    more = len(incident.evidence) - len(shown)
    count = len(incident.evidence)
    return element(
        "details",
        element("summary", f"Evidence: {counted(count, 'message')}"),
        element(
            "ul",
            *(_message(each, start) for each in shown),
            element("li", f"{more} more in incidents.jsonl") if more else None,
        ),
    )


def _message(evidence: Evidence, start: float) -> Html:
    return element(
        "li",
        joined([moment(evidence.stamp - start), " "]),
        element("code", evidence.topic),
        f" message {evidence.index}",
    )
