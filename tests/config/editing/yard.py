"""An application that somebody wrote by hand, each line laid out as it came."""

from __future__ import annotations

MANIFEST = """<package format="3">
  <name>{name}</name> <version>0.1.0</version> <description>d</description>
  <maintainer email="a@b.c">m</maintainer> <license>l</license>
  <exec_depend>rqt_mrta_py</exec_depend>
  <export> <rqt_mrta_py {export}/> </export>
</package>
"""
ARCHITECTURE = """<rqt_mrta format="architecture">
  <architecture> <name>A</name>
    <robots> <type>ST</type> <config_id>params</config_id> <launch_id>robot</launch_id> </robots>
    <tasks> <type>SR</type> </tasks> <allocations> <type>IA</type> </allocations>
  </architecture>
  <configs>
    <config_0> <id>params</id>
      <param_0> <name>name</name> <type>string</type> <default>@robot_id@</default> </param_0>
      <param_1> <name>rate</name> <type>double</type> <default>5.0</default> </param_1>
      <params_2> <name>sets</name>
        <param_0> <name>size</name> <type>int</type> <value>@array_size@</value> <default>0</default> </param_0>
        <array_1> <name>set@index@</name>
          <param_0> <name>task_id</name> <type>string</type> <value>@task_id@</value> </param_0>
          <params_1> <name>drive</name>
            <param_0> <name>gain</name> <type>double</type> <default>1.0</default> </param_0>
            <param_1> <name>limit</name> <type>int</type> <default>3</default> </param_1>
          </params_1>
        </array_1>
      </params_2>
    </config_0>
    <config_1> <id>tasks_params</id>
      <params_0> <name>tasks</name>
        <param_0> <name>size</name> <type>int</type> <default>0</default> </param_0>
        <array_1> <name>task@index@</name>
          <param_0> <name>id</name> <type>string</type> </param_0>
          <param_1> <name>layer</name> <type>string</type> <default>none</default> </param_1>
        </array_1>
      </params_0>
    </config_1>
  </configs>
  <launches> <launch_0> <id>robot</id> <includes> <include_0> <file>$(find {name})/robot.launch</file>
    <args> <arg_0> <name>params</name> <value>$(find @package@)/config/@robot_id@_params.yaml</value> </arg_0> </args>
  </include_0> </includes> </launch_0> </launches>
</rqt_mrta>
"""
APPLICATION = """<?xml version="1.0" encoding="UTF-8"?>
<!-- Written by hand. -->
<rqt_mrta format="application">
  <application>
    <name>Yard</name>
    <architecture>home</architecture>
    <robots>
      <robot_0>
        <id>robot1</id>
        <tasks> <task_0><id>dig</id></task_0> <task_1><id>carry</id></task_1> <task_2><id>rest</id></task_2> </tasks>
      </robot_0>
      <robot_1> <id>robot2</id> <tasks><task_0><id>carry</id></task_0> <task_1><id>rest</id></task_1></tasks> </robot_1>
      <!-- The old one. -->
      <robot_2> <id>robot3</id> <tasks> <task_0> <id>dig</id> </task_0> </tasks> </robot_2>
    </robots>
  </application>
  <configs>
    <config_0>
      <id>robot1_params</id>
      <param_0> <name>rate</name> <type>double</type> <value>2.5</value> </param_0> <!-- slow -->
      <params_1>
        <name>sets</name>
        <param_0> <name>size</name> <type>int</type> <value>3</value> </param_0>
        <params_1> <name>set0</name> <param_0> <name>task_id</name> <value>dig</value> </param_0>
          <param_1> <name>drive/gain</name> <type>double</type> <value>1.5</value> </param_1> </params_1>
        <params_2> <name>set1</name> <param_0> <name>task_id</name> <value>carry</value> </param_0> </params_2>
        <params_3> <name>set2</name>
          <param_0> <name>drive/gain</name> <type>double</type> <value>0.5</value> </param_0> </params_3>
      </params_1>
    </config_0>
    <config_1>
      <id>tasks_params</id>
      <params_0> <name>tasks</name>
        <param_0> <name>size</name> <type>int</type> <value>2</value> </param_0>
        <params_1> <name>task0</name> <param_0> <name>id</name> <value>dig</value> </param_0> </params_1>
        <params_2> <name>task1</name> <param_0> <name>id</name> <value>carry</value> </param_0>
          <param_1> <name>layer</name> <value>arm</value> </param_1> </params_2>
      </params_0>
    </config_1>
  </configs>
</rqt_mrta>
"""
TASKS = """# What there is to do.
tasks:
  - {id: dig, kind: go_to_place, place: {x: 1, y: 1}}   # first
  - id: carry
    kind: go_to_place
    place: {x: 3, y: 3}
    predecessors: [dig]
  - {id: rest, kind: wander, perpetual: true}
"""
SCENARIO = """# A small yard.
arena: {min_x: 0, min_y: 0, max_x: 4, max_y: 4}
robots:
  - {id: robot1, start: {x: 1, y: 3}, model: mecanum}
  - {id: robot2, start: {x: 3, y: 1}, model: mecanum}   # spare
  - {id: robot3, start: {x: 2, y: 2}, model: mecanum}
events:
  - {time: 5, kind: robot_stops, robot: robot2}
  - {time: 6, kind: radio_partitions, parameters: {groups: [[robot1, robot2]]}}
  - {time: 7, kind: task_withdrawn, task: rest}
"""
FILES = 'application="${prefix}/rqt_mrta.xml" tasks="${prefix}/tasks.yaml" scenario="${prefix}/scenario.yaml"'
