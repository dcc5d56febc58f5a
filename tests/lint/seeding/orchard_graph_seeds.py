"""Defects of the graph and the parameters of the orchard robot."""

from __future__ import annotations

from seed_table import seeds_of

BASE = "orchard_driver/orchard_driver/base.py"
NAMES = "orchard_driver/orchard_driver/names.py"
MOTOR = "orchard_driver/orchard_driver/motor_driver.py"
BATTERY = "orchard_driver/orchard_driver/battery.py"
CAMERA = "orchard_driver/orchard_driver/fruit_camera.py"
LIGHT = "orchard_driver/orchard_driver/status_light.py"
ROW = "orchard_control/orchard_control/row_driver.py"
SUPER = "orchard_control/orchard_control/supervisor.py"
PICKER = "orchard_control/orchard_control/picker.py"
ROBOT = "orchard_bringup/launch/robot.launch.py"
PICKING = "orchard_bringup/launch/picking.launch.xml"
LIGHTS = "orchard_bringup/launch/light.launch.yaml"
CONFIG = "orchard_bringup/config/robot.yaml"

CMD_PUB = (ROW, "create_publisher(Twist, CMD_VEL")
CMD_SUB = (MOTOR, "create_subscription(Twist, CMD_VEL")
MODE_PUB = (SUPER, "create_publisher(String, 'mode'")
MODE_SUB = (LIGHT, "create_subscription(String, 'mode'")
LOW_PUB = (BATTERY, "self.create_publisher(Bool, 'battery_low'")
LOW_SUB = (LIGHT, "create_subscription(BoolMsg")
STATE_PUB = (MOTOR, "create_publisher(MotorState")
STATE_SUB = (ROW, "create_subscription(MotorState")
BATTERY_PUB = (BATTERY, "create_publisher(BatteryState")
BATTERY_SUB = (SUPER, "create_subscription(BatteryState")
FRUIT_PUB = (CAMERA, "self.create_publisher(om.FruitCount")
FRUIT_SUB = (SUPER, "create_subscription(FruitCount")
GOAL_PUB = (ROW, "create_publisher(PoseStamped")
GOAL_SUB = (SUPER, "create_subscription(PoseStamped")
TOOL_PUB = (SUPER, "create_publisher(ToolCommand")
TOOL_SUB = (PICKER, "self.create_subscription(")
TOOL_NAME = (PICKER, "topic='tool/command'")

# A seed a line or two is read as a table.
# fmt: off
seed = seeds_of("orchard")

GRAPH = (
    seed("RG101", (MOTOR, "self.create_subscription(Twist,", "§self.create_subscription(TwistStamped,"),
         (MOTOR, "import Twist\n", "import Twist, TwistStamped\n"), at=(CMD_PUB,), also="RM201 RM202"),
    seed("RG101", (LIGHT, "(String, 'mode', lambda", "(§BoolMsg, 'mode', lambda"), at=(MODE_PUB,)),
    seed("RG101", (MOTOR, "import Trigger", "import SetBool"), (MOTOR, "(Trigger,", "(§SetBool,"),
         at=((SUPER, "(Trigger, 'motor_driver/stop')"),)),
    seed("RG101", (PICKER, "Int32, 'picked'", "§Int32, 'mode'"), at=(MODE_PUB, MODE_SUB)),
    seed("RG101", (NAMES, "'fruits'", "'mode'"), at=(MODE_PUB, MODE_SUB, FRUIT_PUB, FRUIT_SUB, (NAMES, "FRUITS ="))),
    seed("RG101", (SUPER, "import String", "import Float64MultiArray, String"),
         (SUPER, "        self.drive = ActionClient", "        §self.create_subscription(Float64MultiArray, 'tool/forces', print, 10)\n        self.drive = ActionClient"),
         at=((PICKER, "create_publisher(Float32MultiArray"),)),
    seed("RG101", ("orchard_interfaces/action/DriveRowSlowly.action", None, "string row\nfloat64 speed\n---\nbool reached\nfloat64 distance\n---\nfloat32 progress\n"),
         ("orchard_interfaces/CMakeLists.txt", '  "action/DriveRow.action"', '  "action/DriveRow.action"\n  "action/DriveRowSlowly.action"'),
         (SUPER, "action import DriveRow", "action import DriveRowSlowly as DriveRow"),
         at=((SUPER, "ActionClient(self"), (ROW, "self.server = ActionServer("), (ROW, "            DriveRow,"), (ROW, "            'drive_row'"))),
    seed("RG101", (SUPER, "self.create_client(CountFruits, 'count_fruits')", "§self.create_client(SetGear, 'count_fruits')"),
         (SUPER, "import CountFruits", "import CountFruits, SetGear"), at=((CAMERA, "create_service(CountFruits"),), also="RM201 RM202"),
    seed("RG101", (BATTERY, "(Bool, 'battery_low'", "(§String, 'battery_low'"), (BATTERY, "import Bool", "import Bool, String"), at=(LOW_SUB,), also="RM202 RM201"),
    seed("RG102", (SUPER, "self.on_battery, qos_profile_sensor_data)", "§self.on_battery, 10)"), at=(BATTERY_PUB,)),
    seed("RG102", (CAMERA, "names.FRUITS, 10", "§names.FRUITS, names.BEST_EFFORT"), at=(FRUIT_SUB,)),
    seed("RG102", (BATTERY, "'battery_low', LATCHED", "'battery_low', 1"), at=(LOW_PUB, LOW_SUB)),
    seed("RG102", (MOTOR, "MOTOR_STATE, 10", "MOTOR_STATE, BEST_EFFORT"), (MOTOR, "import CMD_VEL,", "import BEST_EFFORT, CMD_VEL,"), at=(STATE_PUB, STATE_SUB)),
    seed("RG102", (SUPER, "self.on_goal_pose, 10)", "self.on_goal_pose, QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL))"),
         (SUPER, "from rclpy.qos import ", "from rclpy.qos import DurabilityPolicy, QoSProfile, "), at=(GOAL_PUB, GOAL_SUB)),
    seed("RG102", (SUPER, "        self.mode_pub =", "        qos = QoSProfile(depth=10)\n        qos.reliability = ReliabilityPolicy.BEST_EFFORT\n        self.mode_pub ="),
         (SUPER, "'mode', 10)", "'mode', qos)"), (SUPER, "from rclpy.qos import ", "from rclpy.qos import QoSProfile, ReliabilityPolicy, "), at=(MODE_PUB, MODE_SUB)),
    seed("RG102", (SUPER, "'tool/command', 10)", "'tool/command', QoSPresetProfiles.SENSOR_DATA.value)"),
         (SUPER, "from rclpy.qos import ", "from rclpy.qos import QoSPresetProfiles, "), at=(TOOL_PUB, TOOL_SUB, TOOL_NAME, (PICKER, "qos_profile=10"))),
    seed("RG102", (ROW, "self.on_odom, 10)", "self.on_odom, QoSProfile(depth=10, deadline=Duration(seconds=1)))"),
         (ROW, "from rclpy.node import Node\n", "from rclpy.node import Node\nfrom rclpy.duration import Duration\nfrom rclpy.qos import QoSProfile\n"),
         at=((ROW, "create_subscription(Odometry"), (MOTOR, "create_publisher(Odometry"))),
    seed("RG102", (NAMES, "    durability=QoSDurabilityPolicy.TRANSIENT_LOCAL,\n", ""),
         (LIGHT, "self.on_low, LATCHED)", "self.on_low, ALWAYS)"),
         (LIGHT, "class StatusLight", "from rclpy.qos import DurabilityPolicy, QoSProfile\n\nALWAYS = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)\n\n\nclass StatusLight"), at=(LOW_PUB, LOW_SUB)),
    seed("RG102", (ROW, "Twist, CMD_VEL, 10)", "Twist, CMD_VEL, rclpy.qos.qos_profile_sensor_data)"), at=(CMD_PUB, CMD_SUB)),
    seed("RG102", (SUPER, "FRUITS, self.on_fruits, 10)", "FRUITS, self.on_fruits, qos_profile=LATCHED)"), (SUPER, "import BATTERY_TOPIC, FRUITS", "import BATTERY_TOPIC, FRUITS, LATCHED"), at=(FRUIT_PUB, FRUIT_SUB)),
    seed("RG103", (ROBOT, "executable='status_light')", "executable='status_light', §name='battery')"), at=((ROBOT, "battery = Node("), (ROBOT, "        name='battery'"))),
    seed("RG103", (ROBOT, "        Node(package='orchard_driver', executable='status_light'),\n", "        §Node(package='orchard_driver', executable='status_light'),\n        §Node(package='orchard_driver', executable='status_light'),\n")),
    seed("RG103", (PICKING, 'exec="row_driver" name="row_driver"', '§exec="row_driver" name="motor_driver"'), at=((PICKING, 'exec="motor_driver"'),)),
    seed("RG103", (LIGHTS, 'name: "battery"\n', '§name: "status_light"\n'), at=((LIGHTS, '      name: "status_light"\n      remap'), (LIGHTS, '- node:\n      pkg: "orchard_driver"\n      exec: "status_light"'), (LIGHTS, '- node:\n      pkg: "orchard_driver"\n      exec: "battery"'))),
    seed("RG103", (PICKING, "</launch>", '  §<node pkg="orchard_control" exec="supervisor"/>\n</launch>'), at=((PICKING, 'exec="supervisor" name='),)),
    seed("RG103", (ROBOT, "name='row_driver'", "§name='supervisor'"), at=((ROBOT, "supervisor = Node("), (ROBOT, "row_driver = Node("), (ROBOT, "executable='supervisor'")), also="RP302 RP301"),
    seed("RG103", (PICKING, "  </group>", '    §<node pkg="orchard_control" exec="picker" name="picker"/>\n  </group>'), at=((PICKING, 'exec="picker" name="picker">'),)),
    seed("RG103", (PICKING, "</launch>", '  §<include file="$(find-pkg-share orchard_bringup)/launch/light.launch.yaml"/>\n</launch>'),
         at=((PICKING, 'exec="supervisor"'), (PICKING, 'exec="battery"'), (LIGHTS, 'name: "battery"'), (LIGHTS, 'name: "supervisor"'), (LIGHTS, '- node:\n      pkg: "orchard_driver"\n      exec: "battery"'), (LIGHTS, '- node:\n      pkg: "orchard_control"'))),
    seed("RG103", (ROBOT, "name='fruit_camera'", "§name='battery'"), at=((ROBOT, "battery = Node("), (ROBOT, "        name='battery',\n        parameters=[config],\n    )\n    row"), (ROBOT, "        Node(\n            package='orchard_driver'")), also="RP301 RP302"),
    seed("RG103", (ROBOT, "            name='picker',\n            parameters=[config],\n        ),\n", "            name='picker',\n            parameters=[config],\n        ),\n        *[\n            §Node(package='orchard_driver', executable='status_light', name='side_light')\n            for side in ('left', 'right')\n        ],\n")),
    seed("RG104", (LIGHT, "String, 'mode'", "String, 'modes'"), at=(MODE_PUB, (LIGHT, "(String, 'modes'"))),
    seed("RG104", (LIGHT, "'battery_low'", "'batery_low'"), at=(LOW_PUB, LOW_SUB, (LIGHT, "low_topic ="))),
    seed("RG104", (ROW, "'motor_state'", "'motor_sate'"), at=(STATE_PUB, STATE_SUB, (NAMES, "MOTOR_STATE"))),
    seed("RG104", (SUPER, "'row_goal'", "'row_gaol'"), at=(GOAL_PUB, GOAL_SUB)),
    seed("RG104", (SUPER, "CountFruits, 'count_fruits'", "§CountFruits, 'count_fruit'"), at=((CAMERA, "create_service(CountFruits"),)),
    seed("RG104", (ROW, "SetGear, 'set_gear'", "§SetGear, 'set_geer'"), at=((MOTOR, "create_service(SetGear"),)),
    seed("RG104", (SUPER, "DriveRow, 'drive_row'", "§DriveRow, 'drive_rows'"), at=((ROW, "self.server ="), (ROW, "            'drive_row'"))),
    seed("RG104", (PICKER, "topic='tool/command'", "topic='tool/comand'"), at=(TOOL_PUB, TOOL_SUB, (*TOOL_NAME[:1], "topic='tool")), also="RG105 RG107"),
    seed("RG104", (PICKER, "topic='tool/command'", "topic='toolcommand'"), at=(TOOL_PUB, TOOL_SUB, (*TOOL_NAME[:1], "topic='tool")), also="RG105 RG107"),
    seed("RG104", (SUPER, "'motor_driver/stop'", "'motor_drive/stop'"), at=((SUPER, "create_client(Trigger"), (MOTOR, "create_service(Trigger"))),
    seed("RG104", (PICKING, 'to="/tool/command"', 'to="/tool/commands"'), at=((PICKING, 'from="tool/command"'), TOOL_PUB, TOOL_SUB, TOOL_NAME)),
    seed("RG105", (ROBOT, "('camera/left/image_raw'", "('camera/left/image'")),
    seed("RG105", (PICKING, 'from="joint_states"', 'from="joint_state"')),
    seed("RG105", (LIGHTS, 'from: "light/color"', 'from: "light/colour"'), at=((LIGHTS, "from:"), (LIGHTS, "        - from"), (LIGHTS, "to:"))),
    seed("RG105", (PICKING, 'from="joint_states"', 'from="/joint_states"')),
    seed("RG105", (ROBOT, "        name='battery',\n", "        name='battery',\n        §remappings=[('cmd_vel', '/cmd_vel_raw')],\n")),
    seed("RG105", (ROBOT, "('camera/left/image_raw', '/left_camera/image_raw')", "('/left_camera/image_raw', 'camera/left/image_raw')")),
    seed("RG105", (ROBOT, "        arguments=['--ros-args'", "        §remappings=[('~/errors', '/row_error')],\n        arguments=['--ros-args'")),
    seed("RG105", (PICKING, '<node pkg="orchard_driver" exec="motor_driver" name="motor_driver"/>', '<node pkg="orchard_driver" exec="motor_driver" name="motor_driver">\n    §<remap from="set_gears" to="/gearbox/set_gear"/>\n  </node>')),
    seed("RG105", (ROBOT, "    return LaunchDescription([", "    §light_remaps = [('colour', 'light/color')]\n    return LaunchDescription(["),
         (ROBOT, "executable='status_light')", "executable='status_light', §remappings=light_remaps)")),
    seed("RG105", (PICKING, '  <node pkg="orchard_driver" exec="battery" name="battery"/>', '  <node pkg="orchard_driver" exec="battery" name="battery">\n    §<remap from="battery_state" to="/power/battery"/>\n  </node>')),
    seed("RG106", (PICKING, '      <remap from="tool/command" to="/tool/command"/>\n', ""), at=((PICKING, "<push-ros-namespace"), (PICKING, 'exec="picker"'), (PICKING, "<group>"), TOOL_PUB, TOOL_SUB, TOOL_NAME)),
    seed("RG106", (ROBOT, "        name='motor_driver',\n", "        name='motor_driver',\n        §namespace='base',\n"), at=((ROBOT, "motor_driver = Node("), CMD_SUB, CMD_PUB, STATE_PUB, STATE_SUB), also="RP302 RP301 RG109"),
    seed("RG106", (ROBOT, "executable='status_light')", "executable='status_light', §namespace='lights')"), at=(MODE_SUB, MODE_PUB, LOW_SUB, LOW_PUB)),
    seed("RG106", (LIGHTS, '      exec: "supervisor"\n', '      exec: "supervisor"\n      §namespace: "ctrl"\n'), at=((LIGHTS, '      name: "supervisor"'), (LIGHTS, '- node:\n      pkg: "orchard_control"'), MODE_PUB, MODE_SUB)),
    seed("RG106", (PICKING, '  <node pkg="orchard_driver" exec="fruit_camera" name="fruit_camera"/>', '  <group>\n    §<push-ros-namespace namespace="cameras"/>\n    §<node pkg="orchard_driver" exec="fruit_camera" name="fruit_camera"/>\n  </group>'), at=(FRUIT_PUB, FRUIT_SUB, (CAMERA, "create_service("), (SUPER, "create_client(CountFruits"))),
    seed("RG106", (SUPER, "String, 'mode'", "String, '/state/mode'"), (LIGHT, "String, 'mode'", "String, 'state/mode'"), (LIGHTS, '      exec: "status_light"\n', '      exec: "status_light"\n      §namespace: "gpio"\n'),
         at=((*MODE_PUB[:1], "create_publisher(String"), (*MODE_SUB[:1], "create_subscription(String"), (LIGHTS, '- node:\n      pkg: "orchard_driver"\n      exec: "status_light"'), LOW_PUB, LOW_SUB)),
    seed("RG106", (PICKING, '<node pkg="orchard_control" exec="row_driver" name="row_driver"/>', '§<node pkg="orchard_control" exec="row_driver" name="row_driver" namespace="drive"/>'), at=(CMD_PUB, CMD_SUB, STATE_PUB, STATE_SUB, GOAL_PUB, GOAL_SUB, (ROW, "self.gear_client ="), (ROW, "self.server ="), (ROW, "create_subscription(Odometry"), (MOTOR, "create_publisher(Odometry"))),
    seed("RG107", (LIGHT, "String, 'mode'", "String, 'operation'")),
    seed("RG107", (CAMERA, "names.FRUITS, 10", "'detections', 10"), at=(FRUIT_SUB,)),
    seed("RG107", (ROW, "'motor_state'", "'wheels'")),
    seed("RG107", (LIGHT, "low_topic = 'battery_low'", "low_topic = 'power/empty'"), at=(LOW_SUB, (LIGHT, "low_topic = "))),
    seed("RG107", (SUPER, "'tool/command', 10", "'gripper', 10"), at=(TOOL_SUB, TOOL_NAME)),
    seed("RG107", (SUPER, "        self.drive = ActionClient", "        §self.create_subscription(String, 'voice', print, 10)\n        self.drive = ActionClient")),
    seed("RG107", (BATTERY, "BATTERY_TOPIC, qos", "f'{BATTERY_TOPIC}_state', qos"), at=(BATTERY_SUB,)),
    seed("RG107", (ROW, "        self.goal_pub = self.create_publisher(PoseStamped, 'row_goal', 10)\n", ""), (ROW, "        self.goal_pub.publish(pose)\n", ""), at=(GOAL_SUB,)),
    seed("RG108", (SUPER, "        self.create_subscription(FruitCount, FRUITS, self.on_fruits, 10)\n", ""), at=(FRUIT_PUB,)),
    seed("RG108", (SUPER, "'mode', 10)", "'operation', 10)"), at=((*MODE_PUB[:1], "create_publisher(String"),)),
    seed("RG108", (LIGHT, "low_topic = 'battery_low'", "low_topic = 'power/empty'"), at=(LOW_PUB,)),
    seed("RG108", (SUPER, "        self.drive = ActionClient", "        §self.log_pub = self.create_publisher(String, 'events', 10)\n        self.drive = ActionClient")),
    seed("RG108", (MOTOR, "MOTOR_STATE, 10", "MOTOR_STATE + 's', 10")),
    seed("RG108", (NAMES, "MOTOR_STATE = 'motor_state'", "MOTOR_STATE = 'motors/state'"), at=(STATE_PUB, (NAMES, "MOTOR_STATE = "))),
    seed("RG108", (SUPER, "PoseStamped, 'row_goal'", "PoseStamped, 'goal_pose'"), at=(GOAL_PUB,)),
    seed("RG108", (PICKER, "topic='tool/command'", "topic='gripper/command'"), at=(TOOL_PUB,)),
    seed("RG109", (SUPER, "CountFruits, 'count_fruits'", "CountFruits, 'how_many'")),
    seed("RG109", (ROW, "SetGear, 'set_gear'", "SetGear, 'gearbox/shift'")),
    seed("RG109", (SUPER, "DriveRow, 'drive_row'", "DriveRow, 'follow_row'")),
    seed("RG109", (MOTOR, "self.create_service(SetGear, 'set_gear'", "self.create_service(SetGear, '~/set_gear'"), at=((ROW, "self.create_client(SetGear"),)),
    seed("RG109", (ROW, "            'drive_row',", "            '/tasks/drive',"), at=((SUPER, "ActionClient(self"),)),
    seed("RG109", (CAMERA, "        self.srv = self.create_service(CountFruits, 'count_fruits', self.on_count)\n", ""), at=((SUPER, "create_client(CountFruits"),)),
    seed("RG109", (SUPER, "        self.tick =", "        §self.light_client = self.create_client(Trigger, 'light/test')\n        self.tick =")),
    seed("RG110", (SUPER, "CountFruits, 'count_fruits'", "CountFruits, 'how_many'"), at=((CAMERA, "create_service("),)),
    seed("RG110", (CAMERA, "CountFruits, 'count_fruits'", "CountFruits, 'fruits/count'")),
    seed("RG110", (LIGHT, "        self.create_timer(0.2", "        §self.create_service(Trigger, 'light/test', lambda request, response: response)\n        self.create_timer(0.2"), (LIGHT, "from std_msgs.msg import ColorRGBA", "from std_srvs.srv import Trigger\nfrom std_msgs.msg import ColorRGBA")),
    seed("RG110", (SUPER, "DriveRow, 'drive_row'", "DriveRow, 'follow_row'"), at=((ROW, "self.server ="), (ROW, "            'drive_row'"))),
    seed("RG110", (ROW, "            'drive_row',", "            §'tasks/drive',"), at=((ROW, "self.server ="),)),
    seed("RG110", (MOTOR, "SetGear, 'set_gear'", "SetGear, 'gears'")),
    seed("RG110", (MOTOR, "Trigger, '~/stop'", "Trigger, '~/halt'")),
)

PARAMETERS = (
    seed("RP301", (CONFIG, "wheel_radius:", "whel_radius:")),
    seed("RP301", (CONFIG, "max_speed:", "max_sped:")),
    seed("RP301", (CONFIG, "      reach:", "      length:")),
    seed("RP301", (ROBOT, "{'port':", "{'serial_port':")),
    seed("RP301", (PICKING, 'name="grip_force"', 'name="grip_forces"')),
    seed("RP301", (LIGHTS, 'name: "cells"', 'name: "cell_count"'), at=((LIGHTS, 'name: "cell'),)),
    seed("RP301", (CONFIG, "    cells: 6\n", "    cells: 6\n    §gain: 2.0\n")),
    seed("RP301", (CONFIG, "waypoints:", "way_points:")),
    seed("RP301", (CONFIG, "    speed: 0.6", "    Speed: 0.6")),
    seed("RP301", (ROBOT, "{'start_delay': 5.0}", "{'delay': 5.0}")),
    seed("RP301", (CONFIG, "    grip_force: 2.0\n", "    §grip:\n      §force: 2.0\n")),
    seed("RP301", (ROBOT, "'min_confidence': 0.7", "'confidence': 0.7")),
    seed("RP301", (PICKER, "'dry_run', False)", "'simulate', False)"), (PICKER, "get_parameter('dry_run')", "get_parameter('simulate')"), at=((CONFIG, "dry_run"), (PICKING, 'param name="dry_run"'))),
    seed("RP302", (CONFIG, "motor_driver:\n", "motordriver:\n")),
    seed("RP302", (CONFIG, "battery:\n", "batery:\n")),
    seed("RP302", (CONFIG, "supervisor:\n", "/robot/supervisor:\n")),
    seed("RP302", (ROBOT, "name='motor_driver'", "§name='wheels'"), at=((CONFIG, "motor_driver:"), (ROBOT, "motor_driver = Node("), (ROBOT, "parameters=[config, {'port'")), also="RG109"),
    seed("RP302", (CONFIG, "picker:\n", "arm_picker:\n")),
    seed("RP302", (ROBOT, "        name='battery',\n", "        name='battery',\n        §namespace='power',\n"), at=((CONFIG, "battery:"), (ROBOT, "battery = Node("), (ROBOT, "executable='battery'")), also="RG106"),
    seed("RP302", (CONFIG, "row_driver:\n", "row_diver:\n")),
    seed("RP302", (CONFIG, "row_driver:\n", "RowDriver:\n")),
    seed("RP302", (BATTERY, "__init__('battery'", "__init__('battery_monitor'"), (ROBOT, "        name='battery',\n", ""), at=((CONFIG, "battery:"), (ROBOT, "battery = Node("), (ROBOT, "executable='battery'"))),
    seed("RP302", ("orchard_bringup/config/camera.yaml", None, "§camera:\n  ros__parameters:\n    min_confidence: 0.5\n"), (ROBOT, "    return Launch", "    camera_config = os.path.join(get_package_share_directory('orchard_bringup'), 'config', 'camera.yaml')\n    return Launch"),
         (ROBOT, "parameters=[{'row': 'B1', 'min_confidence': 0.7}]", "§parameters=[camera_config]")),
    seed("RP302", ("orchard_bringup/config/camera.yaml", None, "§cameras:\n  ros__parameters:\n    min_confidence: 0.5\n"),
         (PICKING, '<node pkg="orchard_driver" exec="fruit_camera" name="fruit_camera"/>', '<node pkg="orchard_driver" exec="fruit_camera" name="fruit_camera">\n    §<param from="$(find-pkg-share orchard_bringup)/config/camera.yaml"/>\n  </node>')),
    seed("RP303", (CONFIG, "wheel_radius: 0.17", "wheel_radius: 1")),
    seed("RP303", (CONFIG, "baud: 230400", 'baud: "230400"')),
    seed("RP303", (CONFIG, "max_speed: 1.0", "max_speed: 1")),
    seed("RP303", (CONFIG, 'rows: ["A1", "A2"]', 'rows: "A1"')),
    seed("RP303", (CONFIG, "use_gears: true", 'use_gears: "true"')),
    seed("RP303", (CONFIG, "cells: 6", "cells: 6.0")),
    seed("RP303", (CONFIG, "[0.0, 12.5, 25.0]", "[0, 12, 25]")),
    seed("RP303", (CONFIG, "reach: 0.85", "reach: far")),
    seed("RP303", (ROBOT, "'start_delay': 5.0", "'start_delay': 5")),
    seed("RP303", (PICKING, 'value="3.5"', 'value="3"')),
    seed("RP303", (CONFIG, "rate: 50.0", "rate: 50")),
    seed("RP303", (LIGHTS, "value: 24.0", "value: 24"), at=((LIGHTS, 'name: "full_voltage"'), (LIGHTS, "value: 24"))),
    seed("RP303", (CONFIG, "reverse: false", "reverse: 0")),
    seed("RP303", (ROBOT, "'row': 'B1'", "'row': 1")),
    seed("RP303", (CONFIG, "speed: 0.6", "speed: '0.6'")),
    seed("RP303", (CONFIG, "grip_force: 2.0", "grip_force: 2")),
    seed("RP304", (CAMERA, "get_parameter('min_confidence')", "get_parameter('min_confidnce')")),
    seed("RP304", (ROW, "get_parameter('gain')", "get_parameter('kp')")),
    seed("RP304", (ROW, "        self.declare_parameter('use_gears', True)\n", ""), at=((ROW, "get_parameter('use_gears')"),), also="RP301"),
    seed("RP304", (MOTOR, "get_parameter('wheel_radius')", "get_parameter('radius')")),
    seed("RP304", (SUPER, "get_parameter('rows')", "get_parameter('row')")),
    seed("RP304", (PICKER, "get_parameter('arm.reach')", "get_parameter('reach')")),
    seed("RP304", (BASE, "        self.declare_parameter('frame_id', 'base_link')\n", ""), at=((BASE, "get_parameter('frame_id')"),)),
    seed("RP304", (BATTERY, "        self.voltage = self.full", "        self.name = §self.get_parameter('cell_name').value\n        self.voltage = self.full")),
    seed("RP304", (MOTOR, "                ('port', '/dev/ttyUSB0'),\n", ""), at=((MOTOR, "get_parameter('port')"),), also="RP301"),
    seed("RP304", (ROW, "get_parameter('max_speed').value", "get_parameter('max_speeds').get_parameter_value().double_value")),
    seed("RP304", (LIGHT, "        self.create_timer(0.2, self.blink)", "        §period = self.get_parameter('blink_period').value\n        self.create_timer(period, self.blink)")),
    seed("RP304", (SUPER, "self.get_parameter('start_delay')", "§self.get_parameter('startDelay')")),
)

SEEDS = GRAPH + PARAMETERS
