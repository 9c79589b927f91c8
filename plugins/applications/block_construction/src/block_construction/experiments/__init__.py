"""The benchmark ``construction``: the source's tables beside what is measured here.

* ``published``: the source's tables as data; ``benchmark``: the parts, what it takes, the report; ``part``: what one is
* ``trainings``: many trainings, shared among all cores; ``ways``: how ours differ; ``readings``: of PLA's noise
* ``rates``, ``memory``, ``parameters``, ``extensions``, ``structures``, ``throughput``: parts of the assembly diagram;
  ``optima``: proved ones
* ``plans``: of the execution plan, ``published_plans`` the source's tables of it
* ``builds``, ``noise``, ``teams``: of simulated builds, ``published_builds`` the source's tables of them;
  ``undisturbed``: what teams are held against
"""
