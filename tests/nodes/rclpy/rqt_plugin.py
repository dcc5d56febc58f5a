"""A panel of rqt; the node is the panel's context's."""
from python_qt_binding.QtCore import QTimer, Signal
from python_qt_binding.QtWidgets import QSlider, QWidget
from rclpy.qos import QoSProfile
from rqt_gui_py.plugin import Plugin
from std_msgs.msg import Float64


class Panel(Plugin):
    changed = Signal(float)

    def __init__(self, context):
        super(Panel, self).__init__(context)
        self.setObjectName('Panel')
        self._node = context.node
        self._widget = QWidget()
        self._slider = QSlider(self._widget)
        self._publisher = self._node.create_publisher(Float64, 'slider', qos_profile=QoSProfile(depth=10))
        self._subscription = self._node.create_subscription(Float64, 'measured', lambda m: self.changed.emit(m.data), 10)
        self._timer = QTimer(self)
        self._timer.timeout.connect(self.tick)
        self._timer.start(100)

    def tick(self):
        self._publisher.publish(Float64(data=float(self._slider.value())))

    def shutdown_plugin(self):
        self._node.destroy_publisher(self._publisher)
