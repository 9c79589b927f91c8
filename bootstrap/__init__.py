"""Makes a checkout ready to run: Debian packages, the virtual environment, Python packages, message classes.

Needs the standard library of any Python from 3.8 on, before anything is installed. The shell files beside it decide
whether there is anything to do, and keep the stamp and the lock.

* ``sequence``: the steps in their order
* ``debian``: packages that come by apt
* ``environment``: the virtual environment ``.venv``
* ``packages``: what pip puts into it, and whether all of that imports (``probe``)
* ``messages``: Python classes of ROS messages (``generate``)
* ``shell``: what is said, what fails, what is started
"""

from __future__ import annotations
