#!/usr/bin/env python3
import rospy as r
import std_msgs.msg as m
from std_srvs.srv import SetBool, SetBoolResponse


class Lamp(object):
	"""A lamp, with tabs."""
	TOPIC = "lamp"

	def __init__(self):
		self.is_on = False
		self._pub = r.Publisher(
			name=self.TOPIC + "/state",
			data_class=m.Bool,
			queue_size=1,
		)
		self._srv = r.Service("lamp/switch", SetBool, self._switch)
		self._timer = r.Timer(r.Duration(0.1), self._tick)

	def _switch(self, req):
		self.is_on = req.data
		return SetBoolResponse(True, "switched")

	def _tick(self, event):
		self._pub.publish(self.is_on)


if __name__ == "__main__":
	r.init_node("lamp")
	lamp = Lamp()
	r.spin()
