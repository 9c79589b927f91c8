"""Pictures of a mission.

* ``scene``, ``path``: follow the stream to know where everything is and was
* ``monitor``: one moment; its parts are ``header``, ``floor`` and ``arena``, ``team``, ``tasks``, ``events``,
  ``timeline``, ``curves``
* ``dashboard``: the whole; its parts are in ``charts``
* ``layout``, ``canvas``, ``text``, ``labels``, ``signs``, ``palette``, ``times``, ``spells``: what parts are
  drawn with
* ``markers``: the scene for RViz and its like
* ``encode``: PNG and JPEG, as bytes and as files
* ``plugin``: registers the pictures
"""

from __future__ import annotations

from rqt_mrta_py.render.dashboard import draw_dashboard
from rqt_mrta_py.render.encode import jpeg, png, write_picture
from rqt_mrta_py.render.markers import MARKERS_TOPIC, team_markers
from rqt_mrta_py.render.monitor import draw_monitor
from rqt_mrta_py.render.scene import SceneTracker

__all__ = [
    "MARKERS_TOPIC",
    "SceneTracker",
    "draw_dashboard",
    "draw_monitor",
    "jpeg",
    "png",
    "team_markers",
    "write_picture",
]
