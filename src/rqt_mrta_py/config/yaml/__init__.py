"""YAML files by tables.

* ``text``: YAML text to values that know their line
* ``schema``: tables; ``rows``: what a mapping says by its table
* ``places``: a table that several files share
* ``plain_values``: the same tables for values that no file holds
* ``dump``: plain values to text
"""
