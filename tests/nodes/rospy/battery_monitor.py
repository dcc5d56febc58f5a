#!/usr/bin/env python
import rospy as r
from sensor_msgs.msg import BatteryState
from std_msgs.msg import Bool, Float32 as Level
from std_srvs.srv import Trigger, TriggerResponse


class BatteryMonitor:
    LOW = 0.2

    def __init__(self):
        self._level = None
        self._low = r.Publisher('battery/low', Bool, latch=True, queue_size=1)
        self._out = r.Publisher('battery/level', Level, queue_size=5)
        r.Subscriber('battery', BatteryState, self._seen)
        r.Service('~report', Trigger, self._report)
        r.Timer(r.Duration(1.0), self._tick)

    def _seen(self, state):
        self._level = state.percentage

    def _report(self, _request):
        return TriggerResponse(self._level is not None, str(self._level))

    def _tick(self, _event):
        if self._level is None:
            return
        self._low.publish(self._level < self.LOW)
        self._out.publish(self._level)


r.init_node('battery')
monitor = BatteryMonitor()
r.spin()
