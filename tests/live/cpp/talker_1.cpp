// A node of ROS 1 that talks, and does what it is asked.

#include <ros/ros.h>
#include <std_msgs/String.h>
#include <std_srvs/SetBool.h>

class Talker
{
public:
  Talker()
  {
    publisher_ = nh_.advertise<std_msgs::String>("ticks", 10);
    service_ = nh_.advertiseService("switch", &Talker::answer, this);
    timer_ = nh_.createTimer(ros::Duration(0.05), &Talker::tick, this);
  }

private:
  void tick(const ros::TimerEvent &)
  {
    std_msgs::String message;
    message.data = "roscpp";
    publisher_.publish(message);
  }

  bool answer(std_srvs::SetBool::Request & request, std_srvs::SetBool::Response & response)
  {
    response.success = request.data;
    response.message = "roscpp";
    return true;
  }

  ros::NodeHandle nh_;
  ros::Publisher publisher_;
  ros::ServiceServer service_;
  ros::Timer timer_;
};

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "talker");
  Talker talker;
  ros::spin();
  return 0;
}
