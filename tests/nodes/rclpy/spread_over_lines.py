import rclpy
from rclpy \
    .node import (
        Node,
    )
from trajectory_msgs.msg import JointTrajectory
from control_msgs.srv import (QueryTrajectoryState,
                              QueryCalibrationState)


class Spread(
        Node):
    def __init__(
            self):
        super(
        ).__init__(
            'spread',
        )
        self.trajectories = \
            self \
            .create_publisher(
                # what it takes
                JointTrajectory,

                'arm_controller/joint_trajectory',  # where the controller listens
                (
                    1
                ),
            )
        self.state = (
            self.create_client(
                QueryTrajectoryState,
                'arm_controller/'
                'query_state',
            )
        )
        self.calibration = [
            self
            .create_client(
                (QueryCalibrationState), ('calibration')
            ),
        ][0]


rclpy.init()
rclpy.spin(Spread())
