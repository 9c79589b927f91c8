"""Two finished missions side by side.

* ``side``: what ``summary.json`` says of one of them, checked
* ``figures``: its numbers by name, and what those are judged by where a user says nothing
* ``allocations``, ``incidents``: what is in one, in the other, in both
* ``comparison``: all of it, judged
* ``document``, ``text``, ``page``: for programs, for a terminal, for a browser; ``drawing``: allocations on two lanes;
  ``wording``: numbers as people read them
"""

from __future__ import annotations
