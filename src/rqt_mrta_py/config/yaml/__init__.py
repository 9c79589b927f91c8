"""YAML files by tables.

* ``text``: YAML text to values that know their line
* ``schema``: tables; ``rows``: what a mapping says by its table
* ``places``: a table that several files share
* ``lines``: where values stand, by the names that problems give them
* ``plain_values``: the same tables for values that no file holds
* ``dump``: plain values to text
"""
