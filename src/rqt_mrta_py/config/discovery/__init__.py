"""From packages to what they register.

* ``search``: where packages are, with or without ROS
* ``manifest``: what one package.xml says
* ``registration``: what was found, and how to look it up
* ``source``: an architecture's or application's files, by what the user calls it
"""
