"""What is written from an application's rqt_mrta.xml: parameter files and launch files.

* ``files``: all of them; the place to begin
* ``parameter_text``: one YAML file, as rosparam reads it
* ``launches``, ``launch_text``: which launch files there are; the text of one
* ``marks``: the line by which a generated file is known
"""
