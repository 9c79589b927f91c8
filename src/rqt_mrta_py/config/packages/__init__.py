"""New packages: architectures and applications, from answers to folders that catkin builds and ``mrta`` runs.

* ``answers_form``: which questions there are, as data; ``answers``: a file with answers; ``entries``: robots, tasks,
  topics and parameters among them; ``origin``: where each was said
* ``checks``: what is wrong with an answer, in the words of rqt_mrta's wizards
* ``description``: what every package says of itself
* ``manifest``, ``cmake``: package.xml and CMakeLists.txt
* ``architecture``: an architecture with, from ``skeleton``, a plugin to start from
* ``application``: an application; ``layout``: where its robots and tasks are; ``scenario_text``: what is simulated
* ``mandatory``: parameters that must be given and are not
* ``building``: a folder that is there whole or not at all
* ``workspace``: catkin workspaces
"""
