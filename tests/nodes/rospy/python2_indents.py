#!/usr/bin/env python
import rospy
from std_srvs.srv import Trigger


class Pit(object):
	"""Spaces before a tab count for nothing in Python 2."""
	def __init__(self):
		self.sub = None
 		self.is_near = False

	def look(self):
		if self.is_near:
			print "near"
		else:
			look = rospy.ServiceProxy("look", Trigger)
		 	try:
	  			self.found = look()
	  			if self.found.success:
	  				print "found"
					self.is_near = True
				print "looked"
			except rospy.ServiceException as error:
	  			print "no answer:", error

	def rest(self):
		pass


def main():
	rospy.init_node("pit")
	Pit().look()
	rospy.spin()


if __name__ == "__main__":
	main()
