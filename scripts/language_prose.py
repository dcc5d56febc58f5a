"""What docs/language.md says besides the statements, which are written from their declarations."""

from __future__ import annotations

from plastron_tui.diagnostics import escapes

LANGUAGE_HEAD = f"""\
# The language on one page

A program is text, one statement a line, in a file that ends in `.plastron`. It describes ROS nodes,
the topics and services that join them, the messages that they send, and robots. Statements run from top to
bottom.

```plastron
// A node that says hello on the topic `chatter`, twice a second.
create_node 'talker' as talker
create_message greeting of message_type String and input "hello"
talker publish greeting to 'chatter' of message_type String at 2 hz
generate_node talker
```

`plastron check FILE` says what is wrong with a program, `plastron generate FILE` writes its nodes.

Four words come up again and again. A **node** is a program of its own that does one thing. A
**topic** is a name under which nodes send **messages**: every node that subscribes to it gets
them. A **service** is a name under which a node answers: another calls it with a request, and
gets one response.

## Words

| what | how it is written | notes |
|---|---|---|
| statement | one line | ends where the line ends; a statement \
cannot go on in the next line |
| comment | `// to the end of the line` or `/* from here to there */` | anywhere between words |
| variable | `talker`, `joint_1` | a letter, then letters, digits and `_`; no keyword; all \
variables share one namespace |
| ROS name | `'chatter'`, `'/arm/joint_1'`, `'~/private'` | in single quotes, and a name that ROS \
takes; a node's name has no `/` |
| text | `"hello"` | in double quotes; {escapes.listed("`")} within |
| number | `5`, `-5`, `0.25`, `1e-3` | |
| place, axis | `0, 0.2, 0` | three numbers: forward, to the left, up; metres |
| angles | `0, 0, 90 deg`, `0, 0, 1.57 rad` | roll, pitch and yaw, and what they are in |
| colour | `blue`, `"#3060ff"` | a name, or a code in double quotes |
| boolean | `True`, `False` | |
| type | `Point`, `geometry_msgs/Point`, `geometry_msgs/msg/Point` | the package is needed only \
where several have a type of the name |

"""

STATEMENTS_HEAD = """\
## Statements

What is in capitals is for you to fill in; what is in brackets may be left out; a bar stands between
two ways to do it.

"""

LANGUAGE_TAIL = """\
## Values

The fields of a message, and of a request, get their values after the word `input`:

| how | example | meaning |
|---|---|---|
| in order | `input 5, 6, 7` | one value for each field, in the order of the type |
| flattened | `input 1, 0, 0, 0, 0, 0.5` | for a message of messages: one for each number or text \
within, if there are no lists |
| by name | `input x=5, y=6` | the rest keeps its default |
| deeper | `input linear.x=1.0` | a field of a field |
| nested | `input linear=(1, 0, 0), angular=(z=0.5)` | the values of a message within the message |
| list | `input ranges=[1.0, 2.0]` | an array |
| first in order, then by name | `input 1, 2, z=3` | |
| `none` | `input none` | every field keeps its default |

A value has to fit its field: a text, a boolean, a number or a list where one belongs, a whole
number within the range of its type, a list of the array's length. A whole number is fine where a
fraction belongs. A field that is a time or a duration (`time` and `duration` in ROS 1,
`builtin_interfaces/Time` and `Duration` in ROS 2) takes seconds, `stamp=1.5`, or whole seconds and
nanoseconds, `stamp=(1, 500000000)`.

A message with a `header` that a node publishes is stamped when it is sent: its `header.stamp` is the
node's time then, where the values give none. A time that they give is sent as it is, each time.

`plastron types Twist` shows the fields of a type, `plastron types '*Scan*'` finds types.

### Values that are known when they are sent

| value | what it is | where it can stand |
|---|---|---|
| `parameter 'speed'` | what the parameter of the node is then | in messages, requests, goals, \
answers; as a rate |
| `received.axes` | a field of the message that was received, or of the request | in messages that \
are sent `for_each` message of a topic; in answers |
| `received.axes[1]` | an element of a list in it, counted from 0 | there |
| `received.axes[1] * 0.5 + 1` | calculated with numbers: `+`, `-`, `*`, `/`, as in arithmetic | of \
a parameter too |
| `received.a + received.b` | calculated with others, all of one message or request; with \
parameters too | where something is received |

```plastron
// A joystick that drives. A stop is sent for each scan in which something is near.
create_node 'driver' as driver
subscribe driver to 'joy' of message_type sensor_msgs/Joy
create_message drive of message_type Twist and input linear.x=received.axes[1] * 0.5
driver publish drive to 'cmd_vel' of message_type Twist for_each 'joy'
subscribe driver to 'scan' of message_type sensor_msgs/LaserScan with qos sensor_data
create_message stop of message_type Twist and input none
driver publish stop to 'cmd_vel' of message_type Twist for_each 'scan' when any received.ranges < 0.3
generate_node driver
```

```plastron
// A service that adds two numbers.
create_node 'adder' as adder
adder provides_service 'add' of service_type AddTwoInts answering received.a + received.b
generate_node adder
```

A calculation begins with `received` or `parameter`, and has no brackets: what takes more is code.
Whole numbers stay whole but for `/`, which makes a fraction, and so fits no field of integers. A message
can be sent to a topic for several reasons, a statement each: at a rate, once, and `for_each`
message of one topic and of another.

A condition compares one field with a number (`<`, `>`, `=`), or with a text or a truth value
(`=`); of a list, `any` or `all` of its elements, and `all` holds of an empty one. One that every
integer of the field's type meets, or none, is an error. An element that is not there, a number
that the field cannot hold, and a division by 0 are a warning in the node's log that names them, and
nothing is sent; a request that cannot be answered fails in ROS 1, and gets an empty answer in ROS 2,
which knows no failure. What needs more is code: the node's file is yours.

## Parameters

A parameter is a `bool`, an `int`, a `float` or a `string`, or a list of them: `int_list`. In ROS 2
the node declares it, with its range and what it is for, refuses what does not fit, and follows a
change at once. In ROS 1 it is a private parameter that the node looks up when it needs it; a value
that does not fit is a warning, and the last good one stays. What goes into a field of integers
has the field's range too.

```plastron
create_node 'driver' as driver
driver has_parameter 'speed' of parameter_type float with default 0.5 between 0 and 2
create_message go of message_type Twist and input linear.x=parameter 'speed'
driver publish go to 'cmd_vel' of message_type Twist
generate_node driver
```

`plastron run FILE --set driver.speed=0.8` sets it at the start; `ros2 param set /driver speed 0.8`,
in ROS 1 `rosparam set /driver/speed 0.8`, while it runs. The defaults are written to
`config/NAME.yaml` too, which `run` reads and which is yours to change ([more](commands.md#plastron-run)).

## Requests and goals

A node whose only work is to call services calls each once, in the order of the program, and ends; a
service that is not there within ten seconds is an error, and its exit status is then 1. A node that
does something else too, or calls `at` a rate, lives on: it waits for the service, warns every ten
seconds while nobody provides it, and goes on with its other work meanwhile. So it is with goals: the
feedback and the result are logged. Ctrl-C ends the node; a goal that it sent stays with the server.

The function of an action is yours to fill in, as that of a service: it is written with a feedback, a
result, and the place where it looks whether it is to end. A client may cancel; a new goal ends the
one before it. Messages, timers and other calls of the node go on while it works.

## Quality of service

How messages are to arrive stands behind `with qos`: words in any order, with commas between them.
Without it all messages arrive, and the last ten are kept for who is slow.

@QOS@
A publisher and a subscription of a program that ROS 2 would never match are an error
(`qos-incompatible`).

## Managed nodes

A `managed` node is a [lifecycle node](https://design.ros2.org/articles/node_lifecycle.html) of ROS 2. What
it has is there from configuration to cleanup. While it is active it publishes, calls functions
again and again, and asks others: what is asked once is asked once each time that it is activated.
Its actions reject goals while it is inactive. Deactivation ends what is under way: it aborts the
goals that the node works on, cancels those that it has sent, and no longer waits for answers.
A node that is shut down while it is active may leave what it has sent to the server, as at Ctrl-C.
Services are answered, and messages heard, while it is inactive too.

## Types

A type is looked up among those of the ROS distribution that the node is for, those of the ROS
packages that are sourced, and the `.msg`, `.srv` and `.action` files in the program's folder, in any
of these places:

```text
rover/                      the program's folder
├── drive.plastron
├── Wheel.msg               rover/Wheel: the package is called as the folder is,
│                           or as a package.xml in it says
├── srv/
│   └── Park.srv            rover/Park
└── arm_msgs/               a package of its own, at any depth
    ├── package.xml
    └── msg/
        └── Joint.msg       arm_msgs/Joint
```

`types` in `plastron.yaml` names other folders to look in instead. To run a node, ROS needs the package
built and sourced; what the program itself makes `plastron run` builds. These bare names always mean the same, whatever
else is installed, until a program makes a type of such a name, which a warning says; and all of them run
([how](commands.md#plastron-run)):

| name | ROS 1 | ROS 2 |
|---|---|---|
| `String`, `Char`, `Int32`, `Float32` | `std_msgs` | `std_msgs` |
| `Point`, `Vector3`, `Quaternion`, `Pose2D`, `Pose`, `Twist` | `geometry_msgs` | `geometry_msgs` |
| `Empty`, `SetBool`, `Trigger` (services) | `std_srvs` | `std_srvs` |
| `AddTwoInts` | `beginner_tutorials` | `example_interfaces` |
| `Fibonacci` (action) | `actionlib_tutorials` | `example_interfaces` |
| `WaypointClear`, `WaypointPull` | `mavros_msgs` | `mavros_msgs` |
| `WordCount` | `basics` | `basics` |

## Types of your own

Where no type has the fields that a message needs, a program makes one, and uses it from the next line
on. Fields are written as in a definition file, with commas between them; behind `default` stands the
value that a field has where none is given, behind `=` that of a constant. The type of a field comes
before its name, and says how large it is: `int32` and `float64`, where a parameter is an `int` or a
`float`:

```plastron
create_message_type WheelSpeed with float64 left, float64 right, string<=10 label default "none"
create_service_type Reset with bool hard returning bool done, string reason
create_action_type Dock with int32 bay returning bool docked reporting float32 distance
create_node 'odometer' as odometer
create_message still of message_type WheelSpeed and input left=0, right=0
odometer publish still to 'wheels' of message_type WheelSpeed at 10 hz
generate_node odometer
```

A bare name of a message, `Point[] path`, means what it means elsewhere in the program. Names, bounds and
values are checked by the rules of both generations of ROS; what one of them cannot have, as bounds and
defaults in ROS 1, is an error where a node of it uses the type.

A type without a package belongs to the program's: in ROS 2 to `ROVER_interfaces` beside the package
`rover`, in ROS 1 to `rover` itself, and in a program without a package to `PROGRAM_interfaces`, after
the program's file. `create_message_type rover_msgs/WheelSpeed with …` names another one.
Where it names a package that the program creates, as in `create_message_type rover/WheelSpeed with …`,
that package builds the type beside its nodes, in ROS 2 too: with `ament_cmake` and
`ament_cmake_python`, and with its modules in the folder `rover_nodes`, since the types have `rover`.
Where it names one that the program loads, or is of a loaded package of catkin, `generate_package` puts
the definition there, and what builds it into `CMakeLists.txt` and `package.xml`. The interface package
of a loaded package of ROS 2 is made in the output folder, with `--in-place` beside that package; where
one is there already, load it too and write it with `generate_package`.

`load_type 'msg/WheelSpeed.msg' as WheelSpeed` reads a definition that exists. `has_field` gives a type a
field more, or one of its fields another type, and `no_longer_has_field` takes one away: every other byte
of the file stays. A change that something of the program does not bear is an error that names it. The
file is written to `PACKAGE/msg/WheelSpeed.msg` in the output folder, with `--in-place` where it is.

## Packages and launch files

A package is a folder that a robot's workspace takes: `generate_package` writes it with its nodes,
`package.xml`, what builds it, a license, and tests.

```plastron
create_node 'talker' as talker
create_message greeting of message_type String and input "hello"
talker publish greeting to 'chatter' of message_type String at 2 hz
create_package 'rover' as rover described_as "It says hello" maintained_by "Ada <ada@example.com>" licensed_under "MIT"
rover contains talker
create_launch 'bringup' as bringup
bringup starts talker in 'front' remapping 'chatter' to 'words'
rover contains bringup
generate_package rover
```

The package is for the ROS of its nodes: one for catkin in ROS 1, for `ament_python` or `ament_cmake` in
ROS 2. What the nodes import is in its `package.xml`. A node is started by its name, or by the one behind
`as`. What people write into these files stays, as with nodes.

Its tests start each node and ask the graph for what it has. In ROS 2 they check the style too. In ROS 1
they check its launch files with `roslaunch_add_file_check`; of style they check nothing, since `roslint`
is no part of Debian's ROS, and a package that needs it could not be built there.

`load_package 'src/rover' as rover` reads a package that exists. What `contains` asks for is then written
into its `package.xml`, and into `setup.py`, `setup.cfg` or `CMakeLists.txt`, where each has its like. What
a file computes, and Plastron is not sure of, is refused with the line: scripts that a `pyproject.toml` has
below `[project]`, a list that a function or another name may change. So is taking out what CMake installs
by a pattern or in a branch. The output folder gets the whole package, changed, so that it is built from
there ([more](commands.md#packages-that-exist)); with `--in-place` it is changed where it is.
`no_longer_contains` takes out what `contains` put in, to the byte; the file of the node stays, and a
warning says so, as one does where a launch file of the package starts the node still. To take out again
what is gone already does nothing. A `CMakeLists.txt` is read with the extra `cmake`
(`pip install 'plastron-tui[cmake]'`), which `./dev` brings.

A launch file starts nodes, each with its name, namespace, other names for its topics, and parameters, and
includes other launch files. It is XML in both generations of ROS; with `launch: python` in
`plastron.yaml` Python in ROS 2. `load_launch` reads one in XML, to change it.

```plastron
create_launch 'rover' as rover
rover has_argument 'side' with default "left"
rover has_argument 'speed' with default 0.5
rover starts 'rover_base/wheels' in '$(var side)' remapping 'cmd_vel' to '/$(var side)/speed' setting 'max' = "$(var speed)"
rover starts 'image_proc/image_proc::RectifyNode' as 'eye' inside 'eyes'
```

What an argument brings is `$(var NAME)` in a name, a namespace, the new name of a topic and a text, for
ROS 1 as well; `"$(var speed)"` alone is a number where it comes to one. Nodes of one name in two
namespaces are two: `no_longer_starts 'left/wheels'` says which. A container holds components, which are
classes of C++ and are named as such; a node in Python runs in a process of its own.

The file behind `with parameters` is looked for from the program's folder. The package that contains the
launch file gets a copy of it in `config`, and installs it; into a package that is loaded you copy it
yourself, and name it there.

@ROBOTS@
## Client libraries

A node is written for a client library:

| | ROS 1 | ROS 2 |
|---|---|---|
| Python, a program of its own | `rospy` | `rclpy` |
| C++, a program of its own | `roscpp` | `rclcpp` |
| C++, loaded into a process of others | `nodelet` | `component` |

All statements mean the same for each of them. Nodes in C++ have to be built: their output folder is a
package (`docs/commands.md`, "run"). A node is not brought from one language to another, nor from `roscpp`
to `rclcpp`: `unsupported-target`.

Another distribution adds a client library with an entry point in the group `plastron.targets`: its
name, and a subclass of `plastron_tui.targets.base.Target` of that `name`, with the `ros_version`
that it is for, its `language` (a `plastron_tui.sources.base.Language`), and the `api_version` that it
was written for, which is 4: a target for another version is refused by name (`unsupported-target`).
What it has no means for it leaves out of `writes`: such a statement is an error then.
The word `using` names it. Without it counts, in this order: the option `--target`, the `target` in
`plastron.yaml`, the ROS that is sourced, the one that is installed, `rclpy`
([which ROS](commands.md#which-ros)).

## Files

`generate_node` writes a node as it is at that point of the program: a statement further down changes
nothing in the file (`changed-after-generating` warns of it), so it comes last. A created node goes
into the output folder, by default `output` beside the program. The file is called as the node is,
with an ending that says what it does:

| ending | the node |
|---|---|
| `_pub.py` | only publishes |
| `_sub1.py` | subscribes to one topic |
| `_sub2.py` | subscribes to several |
| `_client.py` | only calls services |
| `_server.py` | only provides services |
| `_node.py` | does several of these |

The ending is chosen when the node is first written, and stays: with a second subscription
`ears_sub1.py` is still `ears_sub1.py`. With `file_names: plain` in `plastron.yaml` new files have no
ending: `ears.py`.

`load NAME` looks for `NAME.py`, then `NAME.cpp`, in the output folder, its folder `src`, the program's
folder and the working folder; `load 'path/to/file.py'` starts at the program's folder. A file outside of the
project (the repository, else the folder of `plastron.yaml`, else the program's) is read once you
[trust the project](commands.md#plastron-trust). A loaded node keeps its file's name, and goes into
the output folder, with `--in-place` over the file it came from: what no statement asked to change
stays as it is, byte for byte.

A file may hold several nodes: `load 'arms.py' node 'left_arm' as left` names one, by the name that it
has there, or by its class where the file does not say its name. The other nodes stay as they are; the
changes of all that a program loads from one file are written to one file.

No node gets the name of a file that Python, pytest, a shell or git runs by itself (`conftest.py`,
`usercustomize.py`, `test_….py`, `.bashrc`), or of a module that nodes import (`rospy.py`), unless it
is written over the file it came from. Only a node that the program creates may be called a test:
pytest can import its file, for nothing of it runs then.

A program may be generated as often as you like: what it loads and wrote itself stands for what it
started from at first, with what was changed by hand since ([more](commands.md#plastron-generate)).

## Mistakes

A statement with a mistake has no effect, and the rest of the program still runs; but a program with
an error generates nothing. Every mistake is explained in [the list of diagnostics](diagnostics.md).
"""
