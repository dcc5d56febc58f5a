import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    config = os.path.join(get_package_share_directory('orchard_bringup'), 'config', 'robot.yaml')
    log_level = LaunchConfiguration('log_level')

    motor_driver = Node(
        package='orchard_driver',
        executable='motor_driver',
        name='motor_driver',
        parameters=[config, {'port': '/dev/ttyACM0'}],
        output='screen',
    )
    battery = Node(
        package='orchard_driver',
        executable='battery',
        name='battery',
        parameters=[config],
    )
    row_driver = Node(
        package='orchard_control',
        executable='row_driver',
        name='row_driver',
        parameters=[config],
        arguments=['--ros-args', '--log-level', log_level],
    )
    supervisor = Node(
        package='orchard_control',
        executable='supervisor',
        parameters=[config, {'start_delay': 5.0}],
    )
    return LaunchDescription([
        DeclareLaunchArgument('log_level', default_value='info'),
        motor_driver,
        battery,
        row_driver,
        supervisor,
        Node(
            package='orchard_driver',
            executable='fruit_camera',
            name='fruit_camera',
            parameters=[{'row': 'B1', 'min_confidence': 0.7}],
            remappings=[
                ('camera/left/image_raw', '/left_camera/image_raw'),
                ('camera/right/image_raw', '/right_camera/image_raw'),
            ],
        ),
        Node(package='orchard_driver', executable='status_light'),
        Node(
            package='orchard_control',
            executable='picker',
            name='picker',
            parameters=[config],
        ),
    ])
