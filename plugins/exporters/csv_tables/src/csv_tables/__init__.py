"""Missions as CSV tables.

* ``table``: how rows become CSV that every program reads alike
* ``exporter``: the tables of one mission; ``poses``: where its robots were
* ``digest``: one line for one finished mission, from its summary; ``tabulate``: the verb that lists many
* ``plugin``: the hooks
"""

from __future__ import annotations
