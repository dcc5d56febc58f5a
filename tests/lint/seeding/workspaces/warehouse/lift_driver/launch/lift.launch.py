from launch import LaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    params = PathJoinSubstitution([FindPackageShare('lift_driver'), 'config', 'lift.yaml'])
    container = ComposableNodeContainer(
        name='lift_container',
        namespace='',
        package='rclcpp_components',
        executable='component_container',
        composable_node_descriptions=[
            ComposableNode(
                package='lift_driver',
                plugin='lift_driver::LiftComponent',
                name='lift',
                parameters=[params],
                remappings=[('joint_states', '/arm/joint_states')],
            ),
        ],
    )
    return LaunchDescription([
        container,
        Node(package='lift_driver', executable='planner', name='planner', parameters=[params]),
        Node(package='lift_driver', executable='scale', parameters=[params]),
        Node(package='lift_driver', executable='pallet_logger.py', name='pallet_logger'),
    ])
