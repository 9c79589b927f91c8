"""From templates and what is given to the parameters of each robot.

* ``team``: which files count for which robot; the place to begin
* ``layers``: what XML, YAML and the command line give, one on top of the other
* ``resolving``: a template filled in; ``array_sizes`` says how long its arrays are, ``values`` what a text means
* ``task_layers``: layers of tasks, as the package alliance lists them
* ``lookup``: parameters by their paths
* ``context``: for whom, and where in the parameters
* ``parameter_file``: parameters as YAML text
"""
