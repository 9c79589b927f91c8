"""The form of an application's rqt_mrta.xml."""

from __future__ import annotations

from rqt_mrta_py.config.schema.forms import Content, ElementForm, XmlForm
from rqt_mrta_py.config.schema.shared_elements import CONFIGS, GROUPS, LAUNCHES
from rqt_mrta_py.config.xml.flavour import ROOT

__all__ = ["APPLICATION_FILE"]

_ROBOT = ElementForm(
    "robot",
    "One robot.",
    numbered=True,
    plain=False,
    children=(
        ElementForm(
            "id",
            "Its id, as its messages carry it; one leading slash does not count.",
            Content.ID,
            "run, supervisor",
            required=True,
        ),
        ElementForm(
            "tasks",
            "The tasks that it may carry out.",
            default="all of them",
            children=(
                ElementForm(
                    "task",
                    "One of them.",
                    numbered=True,
                    plain=False,
                    children=(
                        ElementForm("id", "Its id, as in tasks.yaml.", Content.ID, "run, supervisor", required=True),
                    ),
                ),
            ),
        ),
    ),
)

APPLICATION_FILE = XmlForm(
    "application",
    "A team of robots, their tasks and parameters.",
    ElementForm(
        ROOT,
        "The whole file.",
        children=(
            ElementForm(
                "application",
                "The application itself.",
                required=True,
                children=(
                    ElementForm("name", "Its name for people.", Content.TEXT, "list, show, pictures", required=True),
                    ElementForm(
                        "architecture",
                        "Name of the package that registers its architecture.",
                        Content.TEXT,
                        "run, review, doctor",
                        default="whoever runs it names one",
                    ),
                    ElementForm("url", "Stands in the dissertation's files; says nothing.", Content.TEXT, "nobody"),
                    ElementForm("robots", "The team.", children=(_ROBOT,)),
                ),
            ),
            CONFIGS,
            LAUNCHES,
            ElementForm("architecture", "Stands in files of architectures.", Content.NOTHING),
        ),
    ),
    "application",
    GROUPS,
)
"""Every element of such a file."""
