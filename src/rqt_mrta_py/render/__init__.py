"""Pictures of a mission.

* ``scene``, ``path``, ``pose_log``, ``frames``, ``body_keeper``, ``happenings``: follow the stream to know where
  everything is and was, and what a scenario made happen
* ``monitor``: one moment; its parts are ``header``, ``floor``, ``arena``, ``bodies``, ``crowd`` and ``trails``,
  ``team``, ``tasks``, ``events``, ``timeline`` and ``marks``, ``curves`` and ``curve_axes``; ``page`` is what they are
  drawn from, ``layers`` draw again only what looks different
* ``dashboard``: the whole; its parts are in ``charts``
* ``report``: the whole as a page to walk through
* ``figures``: charts that missions and benchmarks leave
* ``network``: nodes and topics; ``drawings``: plans and views that verbs leave
* ``layout``, ``canvas``, ``text``, ``labels``, ``signs``, ``stamps``, ``palette``, ``times``, ``spells``,
  ``foremost``: what parts are drawn with
* ``markers``: the scene for RViz and its like; ``explaining``: why tasks went to whom they went, in words
* ``encode``, ``jpeg_series``, ``film``: PNG and JPEG, as bytes and as files; pictures one after another; films
* ``libraries``: the doors to the drawing libraries
* ``plugin``: registers the pictures
"""

from __future__ import annotations

from rqt_mrta_py.render.dashboard import draw_dashboard
from rqt_mrta_py.render.encode import jpeg, png, write_picture
from rqt_mrta_py.render.film import FilmWriter
from rqt_mrta_py.render.jpeg_series import JpegSeries
from rqt_mrta_py.render.markers import MARKERS_TOPIC, team_markers
from rqt_mrta_py.render.monitor import MonitorRenderer, draw_monitor
from rqt_mrta_py.render.network.picture import draw_communication
from rqt_mrta_py.render.scene import SceneTracker

__all__ = [
    "MARKERS_TOPIC",
    "FilmWriter",
    "JpegSeries",
    "MonitorRenderer",
    "SceneTracker",
    "draw_communication",
    "draw_dashboard",
    "draw_monitor",
    "jpeg",
    "png",
    "team_markers",
    "write_picture",
]
