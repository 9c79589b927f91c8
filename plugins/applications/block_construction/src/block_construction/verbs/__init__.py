"""Verbs of the command ``mrta``.

* ``plan_structure``: from a structure to its assembly diagram; ``plan_build``: from there to an execution plan
"""
