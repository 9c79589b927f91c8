"""Plugins' parts where their answer is needed: what they raise, or answer amiss, is told with whose part it is.

* ``asking``: asks one part, makes one, hears what it wants to hear
* ``navigator``, ``allocator``, ``senses``: between agents or behaviours and what they work with
* ``panel``, ``renderer``, ``exporter``, ``message_exporter``, ``figure``, ``measure``: on the watching side
* ``grounds``: there too, but never in the way of a review
* ``drawing``: what verbs leave
"""

from __future__ import annotations

from rqt_mrta_py.app.guard.allocator import guarded_allocators
from rqt_mrta_py.app.guard.asking import guarded, made, makers, wishes_of
from rqt_mrta_py.app.guard.drawing import checked_drawing
from rqt_mrta_py.app.guard.exporter import GuardedExporter
from rqt_mrta_py.app.guard.figure import GuardedFigureMaker, checked_figures
from rqt_mrta_py.app.guard.grounds import GuardedGrounds
from rqt_mrta_py.app.guard.measure import GuardedMeasure
from rqt_mrta_py.app.guard.message_exporter import GuardedMessageExporter
from rqt_mrta_py.app.guard.navigator import GuardedNavigator
from rqt_mrta_py.app.guard.panel import GuardedPanel
from rqt_mrta_py.app.guard.renderer import guarded_renderer
from rqt_mrta_py.app.guard.senses import guarded_evaluators, guarded_robot_sensors

__all__ = [
    "GuardedExporter",
    "GuardedFigureMaker",
    "GuardedGrounds",
    "GuardedMeasure",
    "GuardedMessageExporter",
    "GuardedNavigator",
    "GuardedPanel",
    "checked_drawing",
    "checked_figures",
    "guarded",
    "guarded_allocators",
    "guarded_evaluators",
    "guarded_renderer",
    "guarded_robot_sensors",
    "made",
    "makers",
    "wishes_of",
]
