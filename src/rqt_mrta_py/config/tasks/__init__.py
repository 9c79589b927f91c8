"""The tasks of an application.

* ``tasks_file``: a whole tasks.yaml
* ``task_text``: one entry of it, alone; so tasks travel in messages
"""
