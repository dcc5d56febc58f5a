"""Defects of the survey boat, in rospy, roscpp and a nodelet."""

from __future__ import annotations

from seed_table import seeds_of

TOPICS = "boat_nodes/src/boat_nodes/topics.py"
PILOT = "boat_nodes/scripts/autopilot.py"
SURVEY = "boat_nodes/scripts/survey.py"
BEACON = "boat_nodes/scripts/beacon.py"
LAUNCH = "boat_nodes/launch/survey.launch"
NODES_CMAKE = "boat_nodes/CMakeLists.txt"
NODES_XML = "boat_nodes/package.xml"
SONAR = "boat_drivers/src/sonar.cpp"
SONAR_MAIN = "boat_drivers/src/sonar_main.cpp"
THRUSTERS = "boat_drivers/src/thrusters.cpp"
LEAK = "boat_drivers/src/leak_nodelet.cpp"
LEAK_LAUNCH = "boat_drivers/launch/leak.launch"
DRIVERS_CMAKE = "boat_drivers/CMakeLists.txt"
DRIVERS_XML = "boat_drivers/package.xml"
TYPES_CMAKE = "boat_msgs/CMakeLists.txt"
TYPES_XML = "boat_msgs/package.xml"
DEPTH = "boat_msgs/msg/Depth.msg"
THRUST = "boat_msgs/msg/Thrust.msg"
HEADING = "boat_msgs/srv/SetHeading.srv"

THRUST_PUB = (PILOT, "rospy.Publisher(THRUST")
THRUST_SUB = (THRUSTERS, 'n.subscribe("thrust"')
DEPTH_SUB = (SURVEY, "rospy.Subscriber(topics.DEPTH")
DEPTH_PUB = (SONAR, "depth_pub_ = nh_.advertise")
LAMP_PUB = (SURVEY, "lamp = rospy.Publisher")
LAMP_SUB = (BEACON, "self.sub = rospy.Subscriber")
STATE_PUB = (SURVEY, "state = rospy.Publisher")
STATE_SUB = (BEACON, "rospy.Subscriber('survey/")
WAY_PUB = (SURVEY, "waypoints = rospy.Publisher")
WAY_SUB = (PILOT, "rospy.Subscriber(WAYPOINT")
HEADING_SRV = (PILOT, "rospy.Service(")
HEADING_CALL = (SURVEY, "set_heading = rospy.ServiceProxy")
HEADING_WAIT = (SURVEY, "rospy.wait_for_service(")

# A seed a line or two is read as a table.
# fmt: off
seed = seeds_of("boat")

GRAPH = (
    seed("RG101", (SURVEY, "Publisher('lamp', Bool", "Publisher('lamp', String"), (SURVEY, "lamp.publish(len(depths) > 100)", "lamp.publish('on')"), at=(LAMP_PUB, LAMP_SUB)),
    seed("RG101", (TOPICS, "WAYPOINT = 'waypoint'", "WAYPOINT = 'thrust'"), at=(THRUST_PUB, THRUST_SUB, WAY_PUB, WAY_SUB, (TOPICS, "WAYPOINT"))),
    seed("RG101", (SURVEY, "rospy.ServiceProxy('sonar/ping', Trigger)", "rospy.ServiceProxy('sonar/ping', Empty)"), (SURVEY, "import Trigger", "import Empty"), (SURVEY, "if not ping().success", "if not ping()"), at=((SURVEY, "ping = rospy"), (SONAR, "ping_srv_ ="))),
    seed("RG101", (THRUSTERS, "using boat_msgs::Thrust;", "#include <boat_msgs/Depth.h>\nusing Thrust = boat_msgs::Depth;"), at=(THRUST_SUB, THRUST_PUB), also="RM201"),
    seed("RG101", (BEACON, "import String as Text", "import Float64 as Text"), at=(STATE_SUB, STATE_PUB)),
    seed("RG103", (LAUNCH, 'type="survey.py" name="survey"', '§type="survey.py" name="autopilot"'), at=((LAUNCH, 'type="autopilot.py"'),)),
    seed("RG103", (LAUNCH, "</launch>", '  §<node pkg="boat_drivers" type="sonar" name="thrusters"/>\n</launch>'), at=((LAUNCH, 'type="thrusters"'),), also="RG106"),
    seed("RG103", (LEAK_LAUNCH, 'name="leak" args', 'name="manager" args'), at=((LEAK_LAUNCH, 'name="manager" args="manager"'), (LEAK_LAUNCH, 'args="load'))),
    seed("RG104", (SURVEY, "'lamp', Bool", "'lmap', Bool"), at=((SURVEY, "lamp = rospy"), LAMP_SUB, (LAUNCH, 'from="lamp"'))),
    seed("RG104", (SURVEY, "rospy.ServiceProxy('set_heading'", "rospy.ServiceProxy('set_heding'"), at=(HEADING_CALL, HEADING_SRV)),
    seed("RG104", (TOPICS, "DEPTH = 'sonar/depth'", "DEPTH = 'sonar/dept'"), at=(DEPTH_SUB, DEPTH_PUB, (TOPICS, "DEPTH"), (LAUNCH, 'from="range"')), also="RG107"),
    seed("RG104", (THRUSTERS, 'n.subscribe("thrust"', 'n.subscribe("thurst"'), at=((THRUSTERS, "n.subscribe("), THRUST_PUB)),
    seed("RG105", (LAUNCH, 'from="range"', 'from="ranges"'), also="RG107"),
    seed("RG105", (LAUNCH, 'from="imu/data"', 'from="/data"')),
    seed("RG105", (LEAK_LAUNCH, 'from="thrusters/left"', 'from="left"')),
    seed("RG105", (LAUNCH, 'from="lamp"', 'from="/lamp"'), also="RG106"),
    seed("RG105", (LAUNCH, 'type="survey.py" name="survey">', 'type="survey.py" name="survey">\n    §<remap from="way_point" to="goal"/>')),
    seed("RG106", (LAUNCH, '      <remap from="lamp" to="/lamp"/>\n', ""), at=((LAUNCH, '<group ns'), (LAUNCH, 'type="beacon.py"'), LAMP_PUB, LAMP_SUB)),
    seed("RG106", (LAUNCH, 'type="thrusters" name="thrusters"', '§type="thrusters" name="thrusters" ns="hull"'), at=(THRUST_PUB, THRUST_SUB)),
    seed("RG106", (LAUNCH, 'name="autopilot" respawn', '§name="autopilot" ns="ap" respawn'), at=(THRUST_PUB, THRUST_SUB, WAY_PUB, WAY_SUB, HEADING_SRV, HEADING_CALL, HEADING_WAIT)),
    seed("RG107", (SURVEY, "rospy.Publisher('lamp'", "rospy.Publisher('mast_light'"), at=(LAMP_SUB,)),
    seed("RG107", (PILOT, "rospy.Publisher(THRUST", "rospy.Publisher('motors'"), at=(THRUST_SUB,)),
    seed("RG107", (SONAR, 'advertise<boat_msgs::Depth>("range"', 'advertise<boat_msgs::Depth>("echo_depth"'), at=(DEPTH_SUB,), also="RG105"),
    seed("RG108", (THRUSTERS, '  ros::Subscriber thrust_sub = n.subscribe("thrust", 1, thrustCallback);\n', ""), at=(THRUST_PUB,)),
    seed("RG108", (BEACON, "        rospy.Subscriber('survey/state', Text, self.on_state)\n", ""), at=(STATE_PUB,)),
    seed("RG108", (SONAR, "  echo_sub_ =", '  §extra_pub_ = nh_.advertise<boat_msgs::Depth>("raw", 1);\n  echo_sub_ ='), ("boat_drivers/include/boat_drivers/sonar.h", "ros::Publisher depth_pub_;", "ros::Publisher depth_pub_, extra_pub_;")),
    seed("RG109", (SURVEY, "rospy.ServiceProxy('set_heading'", "rospy.ServiceProxy('steer_to'"), (SURVEY, "wait_for_service('set_heading')", "wait_for_service('steer_to')"), at=((SURVEY, "rospy.ServiceProxy('steer_to'"), (SURVEY, "wait_for_service("))),
    seed("RG109", (SONAR, 'advertiseService("ping"', 'advertiseService("test"'), at=((SURVEY, "ping = rospy"),)),
    seed("RG109", (LAUNCH, 'name="sonar" ns="sonar"', 'name="sonar" ns="front"'), (TOPICS, "'sonar/depth'", "'front/depth'"), at=((SURVEY, "ping = rospy"),)),
    seed("RG110", (SURVEY, "'sonar/ping', Trigger", "'sonar/reset', Trigger"), at=((SONAR, "ping_srv_ ="),)),
    seed("RG110", (PILOT, "rospy.Service('set_heading'", "rospy.Service('steer'")),
    seed("RG110", (BEACON, "        self.sub =", "        §rospy.Service('beacon/test', Trigger, lambda request: None)\n        self.sub ="), (BEACON, "import std_msgs.msg\n", "import std_msgs.msg\nfrom std_srvs.srv import Trigger\n")),
)

MESSAGES = (
    seed("RM201", (PILOT, "q = msg.orientation", "q = msg.quaternion")),
    seed("RM201", (PILOT, "waypoint.pose.position.y, ", "waypoint.position.y, ")),
    seed("RM201", (PILOT, "thrust.armed =", "thrust.enabled =")),
    seed("RM201", (SURVEY, "depth.beams[0]", "depth.beam[0]")),
    seed("RM201", (SURVEY, "answer.message", "answer.text")),
    seed("RM201", (SURVEY, "heading=0.5, source", "angle=0.5, source")),
    seed("RM201", (PILOT, "if req.source ==", "if req.sender ==")),
    seed("RM201", (BEACON, "rospy.logdebug(text.data)", "rospy.logdebug(text.text)")),
    seed("RM201", (SONAR, "last_ = echo->range;", "last_ = echo->distance;")),
    seed("RM201", (SONAR, "depth.beams[0] =", "depth.beam[0] =")),
    seed("RM201", (THRUSTERS, "if (!msg->armed)", "if (!msg->arm)")),
    seed("RM201", (LEAK, "voltage->data > ", "voltage->value > ")),
    seed("RM201", (SONAR, "res.success =", "res.ok =")),
    seed("RM201", (PILOT, "SetHeadingResponse(success=False, message", "SetHeadingResponse(ok=False, message")),
    seed("RM202", (PILOT, "thrust.armed = not self.leak", "thrust.offset = 'none'\n        thrust.armed = not self.leak"), (PILOT, "        thrust.offset = Vector3(0, 0.1, 0)\n", "")),
    seed("RM202", (PILOT, "thrust.left = self.gain * error", "thrust.left = 'full'")),
    seed("RM202", (SURVEY, "String(data='%d depths' % len(depths))", "String(data=5)")),
    seed("RM202", (PILOT, "pose.header.frame_id = 'map'", "pose.header.frame_id = 1")),
    seed("RM202", (SURVEY, "pose.pose.position.x = x", "pose.pose.position = None"), missed="rospy takes None until it is sent, and something else may be given before"),
    seed("RM202", (SURVEY, "state.publish(String(data='%d depths' % len(depths)))", "state.publish(42)")),
    seed("RM204", (PILOT, "SetHeadingResponse(True, 'steering')", "SetHeadingResponse(True)")),
    seed("RM204", (PILOT, "Vector3(0, 0.1, 0)", "Vector3(0, 0.1)")),
    seed("RM204", (BEACON, "ColorRGBA(1, 0, 0, 1 if on else 0)", "ColorRGBA(1, 0, 0)")),
    seed("RM204", (SURVEY, "String(data='%d depths' % len(depths))", "String('%d depths', len(depths))")),
    seed("RM204", (SURVEY, "SetHeadingRequest(heading=0.5, source='survey')", "SetHeadingRequest(0.5, source='survey')")),
    seed("RM204", (PILOT, "thrust = Thrust()", "thrust = Thrust(0.0, 0.0)")),
    seed("RM205", (PILOT, "        pose.header.stamp = rospy.Time.now()\n", ""), at=((PILOT, "pose = PoseStamped()"), (PILOT, "self.pose_pub.publish(pose)"))),
    seed("RM205", (SURVEY, "    pose.header.stamp = rospy.get_rostime()\n", ""), at=((SURVEY, "pose = PoseStamped()"), (SURVEY, "waypoints.publish("))),
    seed("RM205", (SONAR, "  depth.header.stamp = ros::Time::now();\n", ""), at=((SONAR, "Depth depth;"), (SONAR, "depth_pub_.publish"))),
    seed("RM205", (THRUSTERS, "    imu.header.stamp = ros::Time::now();\n", ""), at=((THRUSTERS, "Imu imu;"), (THRUSTERS, "imu_pub.publish"))),
    seed("RM206", (PILOT, "        pose.header.frame_id = 'map'\n", ""), at=((PILOT, "pose = PoseStamped()"), (PILOT, "self.pose_pub.publish(pose)"))),
    seed("RM206", (SURVEY, "    pose.header.frame_id = 'map'\n", ""), at=((SURVEY, "pose = PoseStamped()"), (SURVEY, "waypoints.publish("))),
    seed("RM206", (THRUSTERS, '    imu.header.frame_id = "imu_link";\n', ""), at=((THRUSTERS, "Imu imu;"), (THRUSTERS, "imu_pub.publish"))),
)

CODE = (
    seed("RC402", (PILOT, "        self.heading = math.atan2(way", "        §rospy.sleep(1.0)\n        self.heading = math.atan2(way")),
    seed("RC402", (SURVEY, "        depths.append(depth.beams[0])\n", "        depths.append(depth.beams[0])\n        §time.sleep(2)\n"), (SURVEY, "import rospy\n", "import time\n\nimport rospy\n")),
    seed("RC402", (SONAR, "  res.message = \"pong\";\n", "  res.message = \"pong\";\n  §ros::Duration(0.5).sleep();\n")),
    seed("RC402", (SONAR, "  last_ = echo->range;\n", "  last_ = echo->range;\n  §sleep(1);\n")),
    seed("RC402", (SONAR, "  boat_msgs::Depth depth;\n", "  §usleep(200000);\n  boat_msgs::Depth depth;\n")),
    seed("RC402", (BEACON, "        rospy.logdebug(text.data)\n", "        §rospy.sleep(rospy.Duration(3))\n        rospy.logdebug(text.data)\n")),
    seed("RC403", (PILOT, "def on_imu(self, msg):\n", "def on_imu(self):\n        msg = Imu()\n"), at=((PILOT, "def on_imu"), (PILOT, "self.on_imu)"))),
    seed("RC403", (PILOT, ", callback_args='hull'", ""), at=((PILOT, "def on_leak"), (PILOT, "rospy.Subscriber('leak'"))),
    seed("RC403", (PILOT, "def step(self, event):", "def step(self):"), at=((PILOT, "def step"), (PILOT, "rospy.Timer"))),
    seed("RC403", (PILOT, "def on_set_heading(self, req):", "def on_set_heading(self, req, res):"), at=((PILOT, "def on_set_heading"), HEADING_SRV)),
    seed("RC403", (SURVEY, "def on_depth(depth):", "def on_depth(depth, topic):"), at=((SURVEY, "def on_depth"), DEPTH_SUB)),
    seed("RC403", (BEACON, "lambda msg: self.switch(msg.data)", "lambda: self.switch(True)")),
    seed("RC404", (PILOT, "        self.leak = msg.data\n", "        self.leak = msg.data\n        §pub = rospy.Publisher('leak_seen', Bool, queue_size=1)\n        pub.publish(msg)\n")),
    seed("RC404", (SURVEY, "        if not ping().success:", "        §log = rospy.Publisher('survey/log', String, queue_size=1)\n        log.publish('x')\n        if not ping().success:")),
    seed("RC404", (PILOT, "        error = self.heading", "        §rospy.Subscriber('imu/data', Imu, self.on_imu)\n        error = self.heading")),
    seed("RC404", (THRUSTERS, "    return;\n  std", "    return;\n  ros::NodeHandle n;\n  §left_pub = n.advertise<std_msgs::Float64>(\"thrusters/left\", 1);\n  std")),
    seed("RC404", (SONAR, "  boat_msgs::Depth depth;\n", '  §depth_pub_ = nh_.advertise<boat_msgs::Depth>("range", 10);\n  boat_msgs::Depth depth;\n')),
    seed("RC405", (PILOT, "    Autopilot()\n    rospy.spin()\n", "    §Autopilot()\n"), at=((PILOT, "rospy.init_node("), (PILOT, "class Autopilot"), (PILOT, "if __name__"))),
    seed("RC405", (BEACON, "        rospy.spin()\n", "        rospy.loginfo('ready')\n"), at=((BEACON, "rospy.init_node("), (BEACON, "class Beacon"), (BEACON, "Beacon().run()"), (BEACON, "if __name__"))),
    seed("RC405", (SONAR_MAIN, "  ros::spin();\n", ""), at=((SONAR_MAIN, "int main"), (SONAR_MAIN, "Sonar sonar"), (SONAR_MAIN, "ros::init"))),
    seed("RC405", (THRUSTERS, "    ros::spinOnce();\n", ""), at=((THRUSTERS, "int main"), (THRUSTERS, "while ("), THRUST_SUB, (THRUSTERS, "ros::init"))),
    seed("RC405", (PILOT, "    rospy.spin()\n", "    rospy.spin\n"), at=((PILOT, "    rospy.spin\n"), (PILOT, "rospy.init_node("), (PILOT, "class Autopilot"), (PILOT, "    Autopilot()"), (PILOT, "if __name__"))),
    seed("RC406", (SONAR, "  echo_sub_ = nh_.sub", "  nh_.sub")),
    seed("RC406", (SONAR, "  ping_srv_ = nh_", "  ros::ServiceServer ping = nh_")),
    seed("RC406", (SONAR, "  timer_ = nh_", "  ros::Timer timer = nh_")),
    seed("RC406", (THRUSTERS, "  ros::Subscriber thrust_sub = n.sub", "  n.sub")),
    seed("RC406", (LEAK, "    sub_ = nh.sub", "    ros::Subscriber sub = nh.sub")),
    seed("RC407", (PILOT, "THRUST, Thrust, queue_size=1)", "THRUST, Thrust)")),
    seed("RC407", (PILOT, "Float64, queue_size=10)", "Float64)")),
    seed("RC407", (PILOT, "PoseStamped, queue_size=10, latch=True)", "PoseStamped, latch=True)")),
    seed("RC407", (SURVEY, "topics.WAYPOINT, PoseStamped, queue_size=1)", "topics.WAYPOINT, PoseStamped)")),
    seed("RC407", (SURVEY, "'lamp', Bool, queue_size=1)", "'lamp', data_class=Bool)")),
    seed("RC407", (BEACON, "std_msgs.msg.ColorRGBA, queue_size=1)", "std_msgs.msg.ColorRGBA)")),
    seed("RC407", (SURVEY, "String, queue_size=1)", "String, queue_size=None)")),
    seed("RC407", (SURVEY, "String, queue_size=1)", "String, tcp_nodelay=True)")),
    seed("RC407", (SURVEY, "    lamp = rospy", "    §rospy.Publisher(name='done', data_class=Bool)\n    lamp = rospy")),
    seed("RC407", (SURVEY, "import rospy\n", "import rospy\nfrom rospy import Publisher\n"), (SURVEY, "    lamp = rospy.Publisher('lamp', Bool, queue_size=1)", "    §lamp = Publisher('lamp', Bool)")),
    seed("RC407", (PILOT, "        self.pose_pub = rospy", "        §self.stop_pub = rospy.Publisher('/stop', Bool, None, False, True)\n        self.pose_pub = rospy")),
    seed("RC408", (SURVEY, "    lamp = rospy", "    hello = rospy.Publisher('survey/hello', String, queue_size=1)\n    §hello.publish('hello')\n    lamp = rospy")),
    seed("RC408", (BEACON, "        self.sub =", "        §rospy.Publisher('beacon/found', std_msgs.msg.Bool, queue_size=1).publish(True)\n        self.sub =")),
    seed("RC408", (THRUSTERS, "  ros::Publisher imu_pub", '  ros::Publisher arm_pub = n.advertise<std_msgs::Bool>("arm", 1);\n  std_msgs::Bool arm;\n  arm.data = true;\n  §arm_pub.publish(arm);\n  ros::Publisher imu_pub')),
    seed("RC408", (LEAK, "    pub_ = nh.adv", "    ros::Publisher found = nh.advertise<std_msgs::Bool>(\"leak/found\", 1);\n    §found.publish(std_msgs::Bool());\n    pub_ = nh.adv")),
)

PACKAGES = (
    seed("RK501", (NODES_XML, "  <depend>sensor_msgs</depend>\n", ""), at=((NODES_XML, "<name>"), (PILOT, "from sensor_msgs"), (NODES_CMAKE, "find_package(catkin"))),
    seed("RK501", (DRIVERS_XML, "  <depend>boat_msgs</depend>\n", ""), at=((DRIVERS_XML, "<name>"), (THRUSTERS, "#include <boat_msgs"), ("boat_drivers/include/boat_drivers/sonar.h", "#include <boat_msgs"), (DRIVERS_CMAKE, "find_package(catkin"))),
    seed("RK501", (NODES_XML, "  <depend>std_srvs</depend>\n", ""), at=((NODES_XML, "<name>"), (SURVEY, "from std_srvs"), (NODES_CMAKE, "find_package(catkin"))),
    seed("RK501", (TYPES_XML, "  <depend>geometry_msgs</depend>\n", ""), at=((TYPES_XML, "<name>"), (THRUST, "geometry_msgs/"), (TYPES_CMAKE, "find_package("), (TYPES_CMAKE, "generate_messages("))),
    seed("RK502", (NODES_XML, "  <depend>std_srvs</depend>\n", "  <depend>std_srvs</depend>\n  §<depend>nav_msgs</depend>\n")),
    seed("RK502", (DRIVERS_XML, "  <depend>std_srvs</depend>\n", "  <depend>std_srvs</depend>\n  §<exec_depend>visualization_msgs</exec_depend>\n")),
    seed("RK502", (NODES_XML, "  <depend>std_srvs</depend>\n", "  <depend>std_srvs</depend>\n  §<build_depend>geographic_msgs</build_depend>\n")),
    seed("RK503", (NODES_CMAKE, "  scripts/beacon.py\n", ""), at=((BEACON, "class Beacon"), (BEACON, "#!/usr"), (BEACON, "import rospy\n"), (BEACON, "if __name__"), (NODES_CMAKE, "catkin_install_python("))),
    seed("RK503", (DRIVERS_CMAKE, "install(TARGETS sonar thrusters ", "install(TARGETS sonar "), at=((DRIVERS_CMAKE, "add_executable(thrusters"), (THRUSTERS, "int main"), (DRIVERS_CMAKE, "install(TARGETS sonar"))),
    seed("RK504", (SURVEY, "#!/usr/bin/env python3\n", ""), (NODES_CMAKE, "catkin_install_python(PROGRAMS", "install(PROGRAMS"), at=((SURVEY, "import rospy\n"), (NODES_CMAKE, "scripts/survey.py"), (NODES_CMAKE, "install(PROGRAMS"))),
    seed("RK504", (BEACON, "#!/usr/bin/env python3\n", "#!/usr/bin/env python3\r\n"), (NODES_CMAKE, "catkin_install_python(PROGRAMS", "install(PROGRAMS"), at=((BEACON, "#!/usr"), (NODES_CMAKE, "scripts/beacon.py"), (NODES_CMAKE, "install(PROGRAMS"))),
    seed("RK504", (NODES_CMAKE, "catkin_install_python(PROGRAMS", "install(PROGRAMS"), mode=SURVEY, at=((SURVEY, "#!/usr"), (NODES_CMAKE, "scripts/survey.py"), (LAUNCH, 'type="survey.py"'))),
    seed("RK506", (LAUNCH, 'type="survey.py"', 'type="survey"')),
    seed("RK506", (LAUNCH, 'type="thrusters"', 'type="thruster"')),
    seed("RK506", (LAUNCH, 'pkg="boat_drivers" type="sonar"', 'pkg="boat_nodes" type="sonar"'), also="RG107"),
    seed("RK506", (LEAK_LAUNCH, 'type="thrusters"', 'type="thrusters_node"')),
    seed("RK506", (LAUNCH, 'type="beacon.py"', 'type="Beacon.py"')),
    seed("RK507", (TYPES_CMAKE, "  Thrust.msg\n", ""), at=((THRUST, "float64 left"), (TYPES_CMAKE, "add_message_files("))),
    seed("RK507", (TYPES_CMAKE, "  SetHeading.srv\n", "  SetHeadings.srv\n"), at=((TYPES_CMAKE, "  SetHeadings.srv"), (TYPES_CMAKE, "add_service_files("), (HEADING, "float64 heading"))),
    seed("RK507", (TYPES_CMAKE, "generate_messages(DEPENDENCIES std_msgs geometry_msgs)\n", ""), at=((TYPES_CMAKE, "add_message_files("), (TYPES_CMAKE, "add_service_files("), (TYPES_CMAKE, "project("))),
    seed("RK507", (TYPES_CMAKE, "generate_messages(DEPENDENCIES std_msgs geometry_msgs)", "generate_messages(DEPENDENCIES std_msgs)"), at=((TYPES_CMAKE, "generate_messages("), (THRUST, "geometry_msgs/"))),
    seed("RK508", (DEPTH, "float32 depth", "float32 meters"), at=((DEPTH, "meters"), (SONAR, "depth.depth ="), (SURVEY, "if depth.depth")), also="RM201"),
    seed("RK508", (THRUST, "bool armed", "string armed"), at=((THRUST, "armed"), (PILOT, "thrust.armed"), (THRUSTERS, "msg->armed")), also="RM202"),
    seed("RK508", (HEADING, "string source\n", ""), at=((HEADING, "float64 heading"), (PILOT, "req.source"), (SURVEY, "source='survey'")), also="RM201"),
)

SEEDS = GRAPH + MESSAGES + CODE + PACKAGES
