"""In which order, from where: the execution plan (Dantas 2017, section 5.4).

* ``arena``: the square and the site; ``supply``, ``supply_file``: where blocks wait
* ``approach``: from where they are placed
* ``order``: groups of blocks built one after another; ``ways``: how long ways are among placed blocks
* ``problem``: all of these together; ``cost``: how far a plan drives
* ``greedy``, ``subset_programme``, ``local_search``, ``network``: methods; ``planners``: by name
* ``plan``: what they come to; ``plan_file``: the same as files
* ``corridor``, ``blocking``: what lies in the way of what; ``feasibility``: whether a plan can be carried out
"""
