import rospy
from std_msgs.msg import Int32
class Odd:
  def __init__(self):
      self.pub = rospy.Publisher('odd', Int32, queue_size=1)
      if True :
         self.n = 1
       else:
         self.n = 2
  def loop(self) :
        while not rospy.is_shutdown() :
            self.pub.publish( self.n )
             self.n += 2
rospy.init_node( 'odd' )
sub = rospy.Subscriber( 'even' , Int32 , lambda m : None )
Odd( ).loop( )
