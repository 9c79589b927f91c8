"""The parts of the dashboard, drawn with matplotlib.

* ``sheet``: what they are drawn on
* ``paths``: the arena with the robots' whole paths
* ``schedule``: allocations, states and incidents over time
* ``happened``: marks of what a scenario made happen
* ``traces``: curves over time
* ``figures``: key figures and incidents in words
"""
