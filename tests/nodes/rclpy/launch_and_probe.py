"""Launches a talker, and has a node of its own that watches it."""
import rclpy
from launch import LaunchDescription, LaunchService
from launch.actions import DeclareLaunchArgument, TimerAction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode, Parameter
from std_msgs.msg import String


def generate_launch_description():
    talker = Node(
        package='demo_nodes_py',
        executable='talker',
        name='talker',
        remappings=[('chatter', 'probe/in')],
        parameters=[{'use_sim_time': LaunchConfiguration('use_sim_time')}],
    )
    container = ComposableNodeContainer(
        name='container', namespace='', package='rclcpp_components', executable='component_container',
        composable_node_descriptions=[ComposableNode(package='image_proc', plugin='image_proc::RectifyNode')])
    return LaunchDescription([DeclareLaunchArgument('use_sim_time', default_value='false'),
                              TimerAction(period=2.0, actions=[talker]), container])


def probe():
    rclpy.init()
    node = rclpy.create_node('probe', cli_args=['--ros-args', '-r', 'in:=probe/in'])
    node.create_subscription(String, 'in', lambda m: print(m.data), 10)
    rclpy.spin(node)


if __name__ == '__main__':
    service = LaunchService()
    service.include_launch_description(generate_launch_description())
    probe()
