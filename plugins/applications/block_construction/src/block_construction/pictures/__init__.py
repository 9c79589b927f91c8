"""Pictures of structures, diagrams and plans, as data.

* ``colours``: of blocks; ``levels``: a diagram level by level; ``isometric``: the same as it will stand
* ``ways``: a plan group by group; ``curves``: what was tried, and how sure learners were
* ``bars``: time and distance of builds; ``noise_curve``: how often they succeed
"""
