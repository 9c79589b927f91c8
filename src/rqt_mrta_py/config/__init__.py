"""Reads what users and packages write, and knows the line of every value.

* ``problems``, ``wording``: all problems of a file at once, each with where, what is wrong, what is accepted
* ``xml_text``, ``element``: XML text to a cursor with typed getters
* ``architecture``, ``application``: both flavours of rqt_mrta.xml; ``topics``, ``templates``, ``launches``,
  ``flavour`` and ``ids`` are their parts
* ``manifest``, ``registration``, ``discovery``: package.xml to what is registered, and where
* ``values``: what a parameter's text is worth
"""

from __future__ import annotations

from rqt_mrta_py.config.application import read_application
from rqt_mrta_py.config.architecture import read_architecture
from rqt_mrta_py.config.discovery import discover, own_packages
from rqt_mrta_py.config.manifest import Manifest, read_manifest
from rqt_mrta_py.config.registration import Registration, RegistrationKind, Registry

__all__ = [
    "Manifest",
    "Registration",
    "RegistrationKind",
    "Registry",
    "discover",
    "own_packages",
    "read_application",
    "read_architecture",
    "read_manifest",
]
