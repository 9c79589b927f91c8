"""Changing an application that somebody wrote: whole or not at all, and nothing but what is asked for.

* ``configuring``: from edits to the files that would be written; the place to begin
* ``values``, ``robots``, ``tasks``: the edits
* ``draft``: the files while they are edited; ``xml_document`` and ``yaml_document`` keep their layout and comments
* ``parameter_nodes``, ``task_arrays``: configs within rqt_mrta.xml, and arrays in them whose elements stand for tasks
* ``mentions``: where YAML files name robots and tasks
* ``free_place``: where a new robot may start
* ``elsewhere``: parameters under another architecture than the application's own; ``following``: they follow
  changes of robots and tasks
* ``telling``: problems of texts that were never written
"""
