"""``report.html``: a finished mission in one page that needs no network and no other file.

* ``report_input``: what a report is made from; ``fine_curves`` asks panels for more points than a picture needs
* ``page``: the page as a whole; ``html`` escapes whatever stands in it; ``assets`` are its script and style
* ``summary``, ``incidents``, ``explorer``, ``tables``, ``explanations``, ``statistics``, ``network``, ``clocks``,
  ``provenance``: its sections
* ``payload``: what the script draws; ``packing`` makes it small, ``thinning`` leaves out what nobody can see
"""

from __future__ import annotations

from rqt_mrta_py.render.report.fine_curves import fine_panel
from rqt_mrta_py.render.report.page import report_html
from rqt_mrta_py.render.report.report_input import BagFile, Provenance, ReportInput

__all__ = ["BagFile", "Provenance", "ReportInput", "fine_panel", "report_html"]
