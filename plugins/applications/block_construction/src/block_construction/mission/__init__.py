"""Missions made of a drawing: what ``mrta run block_construction --set structure=...`` carries out.

* ``settings``: what can be set
* ``drawing``: from there to what is built, and in which order; ``published_wall``: the source's own plan
* ``limits``: what the robot cannot build; ``precedence``: what must lie before a block is placed
* ``fetching``: where blocks lie ready; ``lying``: whether anybody minds; ``starts``: where robots begin
* ``tasks_text``, ``scenario_text``: the files; ``numbers``: how numbers are written there
* ``maker``: all of that together
"""
