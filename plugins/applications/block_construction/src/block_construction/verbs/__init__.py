"""Verbs of the command ``mrta``.

* ``plan_structure``: from a structure to its assembly diagram
"""
