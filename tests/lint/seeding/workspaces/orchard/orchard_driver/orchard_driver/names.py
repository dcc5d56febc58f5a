"""Names and profiles that several nodes share."""

from rclpy.qos import QoSDurabilityPolicy, QoSHistoryPolicy, QoSProfile, QoSReliabilityPolicy

CMD_VEL = 'cmd_vel'
MOTOR_STATE = 'motor_state'
BATTERY_TOPIC = 'battery'
FRUITS = 'fruits'

BEST_EFFORT = QoSProfile(
    depth=5,
    history=QoSHistoryPolicy.KEEP_LAST,
    reliability=QoSReliabilityPolicy.BEST_EFFORT,
)
LATCHED = QoSProfile(
    depth=1,
    reliability=QoSReliabilityPolicy.RELIABLE,
    durability=QoSDurabilityPolicy.TRANSIENT_LOCAL,
)
