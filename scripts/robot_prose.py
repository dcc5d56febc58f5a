"""The part of the page about the language that tells of robots."""

from __future__ import annotations

ROBOTS = """\
## Robots

The description of a robot says what it consists of. **Links** are its rigid parts; a **joint** holds one
link to another and says how it moves. Simulators, RViz and planners read descriptions as URDF, which is
what `generate_robot` writes.

```plastron
create_robot 'rover' as rover
rover has_link 'base_footprint'
rover has_link 'base' shaped box 0.4, 0.3, 0.1 weighing 5 painted blue
rover has_link 'left_wheel' shaped cylinder 0.1, 0.05 weighing 0.5 painted black turned 90, 0, 0 deg
rover has_link 'right_wheel' shaped cylinder 0.1, 0.05 weighing 0.5 painted black turned 90, 0, 0 deg
rover has_joint 'base_joint' of joint_type fixed from 'base_footprint' to 'base' at 0, 0, 0.1
rover has_joint 'left_joint' of joint_type continuous from 'base' to 'left_wheel' at 0, 0.2, 0 with axis 0, 1, 0
rover has_joint 'right_joint' of joint_type continuous from 'base' to 'right_wheel' at 0, -0.2, 0 with axis 0, 1, 0
generate_robot rover
```

Lengths are in metres and weights in kilograms, without a word for it; angles are in `deg` or `rad`, which
stands behind them. x points forward, y to the left, z up. `at` and `turned` say where the shape of a link
is, seen from the link, and where the child of a joint is, seen from its parent.

| `shaped` | values, in order or by name |
|---|---|
| `box` | `x`, `y`, `z` |
| `cylinder` | `radius`, `length`; it stands upright |
| `sphere` | `radius` |
| `mesh` | `uri`, such as `"package://rover/meshes/base.stl"`; `scale`, 1 without it |

A link with a shape is seen and collides; with a weight as well it has the inertia of that shape, as of one
solid body. A mesh counts as the box around it, and a warning says so; where its file is not there, the
inertia is left out. A link without a shape is a place. What moves should have a weight: Gazebo leaves out a
link that has none, unless it is held fast.

| `joint_type` | how the child moves | limits |
|---|---|---|
| `fixed` | not at all | none |
| `revolute` | turns about its axis, between two angles | has to have them |
| `continuous` | turns about its axis without end | effort and velocity |
| `prismatic` | slides along its axis, between two places in `m` | has to have them |
| `planar` | slides in a plane, of which the axis is the normal | none |
| `floating` | as it likes | none |

```plastron
create_robot 'arm' as arm
arm has_link 'stand'
arm has_link 'upper' shaped box 0.05, 0.05, 0.4 weighing 1 at 0, 0, 0.2
arm has_link 'lower' shaped box 0.05, 0.05, 0.3 weighing 0.8 painted "#ff8800" at 0, 0, 0.15
arm has_joint 'shoulder' of joint_type revolute from 'stand' to 'upper' with axis 0, 1, 0
arm has_joint 'elbow' of joint_type revolute from 'upper' to 'lower' at 0, 0, 0.4 with axis 0, 1, 0
arm limits_joint 'shoulder' between -90 and 90 deg with effort 20 and velocity 1.5
arm limits_joint 'elbow' between 0 and 135 deg with effort 10 and velocity 2 with damping 0.1 and friction 0.05
generate_robot arm
```

The links are one tree: one of them, the root, is held by none, and each other one by one joint.
`mimicking 'JOINT' times FACTOR` lets a joint follow another.

The names of colours: @COLORS@. A code is red, green and blue, and opacity behind
them if you like: `"#3060ff80"`.

`PACKAGE contains rover` puts the description into `urdf/` of a package, and beside it a launch file of the
robot's name. That starts robot_state_publisher, which tells everybody where the parts are. Where the joints
stand it hears on `joint_states`: from the nodes of the package that publish `sensor_msgs/JointState` there,
which the launch file starts too unless another one of the program does, or, where joints move and no node
of the program says it, from joint_state_publisher. Of several robots each has its own: the nodes whose
messages name joints of it, or that publish to `ROBOT/joint_states`. A node that has a parameter `joint_names` (`string_list`) or `base_frame`
(`string`) gets the names of the joints that move, or of the root. package.xml names what all of that needs.
Another launch file takes it in with `includes 'PACKAGE/rover.launch'`, in ROS 2 with
`'PACKAGE/rover.launch.xml'`, and `plastron run FILE rover` starts it. Where nodes in C++ make the output
folder a package, `generate_robot` puts the same there.

A package that the program creates gets what the description names, too: meshes by `package://PACKAGE/…` or
by relative paths, and what a xacro file includes, as far as they are within the project. They stand to the
description as they did. What belongs to other packages stays there, and is depended on; what is left is
told.

`load_robot 'urdf/rover.urdf' as rover` reads a description that exists. `has_link`, `has_joint` and
`limits_joint` of a name that it has change just what they say, and every other byte of the file stays. So a
joint that is there need not be told its type and its links again: `rover has_joint 'mast_joint' at 0, 0, 0.3`.
`painted none` takes a colour away, and `mimicking none` lets a joint follow no other; limits go where a joint
becomes one that has none: `rover has_joint 'elbow' of joint_type continuous`.
`shaped` and `at` are about what is seen and what collides; where only one of them has a shape of that kind,
only that one changes. What a part says that no sentence speaks of stays, or it is told that it goes. The
arguments of a xacro file (`$(arg NAME)`) get values by `setting`: `load_robot 'ur.urdf.xacro' as arm setting
'name' = "arm", 'ur_type' = "ur5e"`; what starts the robot gives it the same. `plastron inspect` and `plastron graph` take
them behind the file, as `name:=arm ur_type:=ur5e`.

"""
