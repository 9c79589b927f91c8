"""Proved optima of assembly diagrams.

* ``programme``: the integer programme of one concentric layer; ``planner``: all layers, as a planner
"""
