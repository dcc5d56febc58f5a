import rclpy
from rcl_interfaces.msg import (FloatingPointRange, ParameterDescriptor, ParameterType,
                                SetParametersResult)
from rclpy.node import Node
from rclpy.parameter import Parameter

COLORS = [('red', 255), ('green', 0)]
PREFIX = 'limits'


class Parameters(Node):
    def __init__(self):
        super().__init__('parameters', allow_undeclared_parameters=True)
        self.declare_parameter('speed', 1.0, ParameterDescriptor(
            description='how fast',
            floating_point_range=[FloatingPointRange(from_value=0.0, to_value=2.0, step=0.0)]))
        self.declare_parameter('frame', descriptor=ParameterDescriptor(type=ParameterType.PARAMETER_STRING))
        self.declare_parameter('wheels', Parameter.Type.STRING_ARRAY)
        self.declare_parameters(
            namespace='motor',
            parameters=[
                ('kp', 1.0),
                ('ki', 0.1, ParameterDescriptor(description='integral')),
            ],
        )
        self.declare_parameters(PREFIX, [('low', 0.0), ("high", 1.0)])
        self.declare_parameters('', COLORS)
        self.declare_parameters(parameters=[(n, 0) for n in 'abc'], namespace='')
        self.speed = self.get_parameter('speed').value
        self.kp = self.get_parameter('motor.kp').get_parameter_value().double_value
        self.high = self.get_parameter(PREFIX + '.high').value
        for name in ('frame', 'wheels'):
            if self.has_parameter(name):
                setattr(self, name, self.get_parameter(name).value)
        self.add_on_set_parameters_callback(self.changed)

    def changed(self, parameters):
        for parameter in parameters:
            if parameter.name == 'speed':
                self.speed = parameter.value
        return SetParametersResult(successful=True)


def main():
    rclpy.init()
    node = Parameters()
    node.set_parameters([Parameter('speed', Parameter.Type.DOUBLE, 2.0)])
    print(node.get_parameter('speed').value)
    rclpy.spin(node)
