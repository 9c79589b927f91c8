"""The command ``mrta``.

* ``main``: finds the verb and turns errors into one line and a status; ``parser``: what it reads arguments with
* ``list``, ``show``, ``new``, ``doctor``, ``configure``, ``run``, ``watch``, ``review``, ``compare``, ``salvage``,
  ``bench``: a verb each, with ``add_arguments`` and ``main``
* ``new_flags``, ``interview``: answers that ``new`` gets from flags and at a terminal; ``new_package``: what it makes
  of them; ``prompts``: one question
* ``plugin_verbs``: those of plugins; ``verb_tools``: what they can make use of
* ``common``: what verbs share; ``table``: columns of text; ``show_text``: what ``show`` puts into them; ``why_text``:
  explanations of ``review``
* ``watch_display``: what ``watch`` prints; ``watch_screen``: what it shows on a terminal
* ``stdout``: data for whoever reads it; ``logs``, ``log_format``: everything else; ``terminal``: text, and no commands
"""

from __future__ import annotations
