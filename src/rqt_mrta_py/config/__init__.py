"""Reads what users and packages write, and knows the line of every value.

* ``mission``: all of it joined; the place to begin
* ``discovery``: package.xml to what is registered, and where; what the user calls it to its files
* ``xml``: both flavours of rqt_mrta.xml, read and written
* ``schema``: what all files may hold, as data; grammars and docs/config.md are written from it
* ``yaml``: YAML text to values with lines, checked by tables that are also the documentation
* ``tasks``, ``scenario``, ``tolerances``: the files with these tables
* ``parameters``: templates and what is given to each robot's parameters
* ``fitting``: whether an architecture can share out the tasks
* ``substitution``: tokens such as ``@robot_id@``, in parameters and launch files
* ``loading``: application, architecture, tasks and scenario, checked against one another
* ``generated``: parameter files and launch files written from an rqt_mrta.xml
* ``editing``: changes of an application that keep what they do not change
* ``packages``: new packages, from answers to files
* ``gaps``: what of an application's file could not be read, from whose absence nothing may be concluded
* ``problems``: all problems of a file at once, each with where, what is wrong, what is accepted
* ``files``: read whole; written whole or not at all

Names are imported from the modules themselves: ``mrta list`` then reads what finds packages, and no more.
"""

from __future__ import annotations
