#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Float64MultiArray.h>

static ros::CallbackQueue queue;

void onBool(const std_msgs::BoolConstPtr& m) { ROS_INFO("%d", m->data); }
void connected(const ros::SingleSubscriberPublisher& pub) { ROS_INFO("%s", pub.getSubscriberName().c_str()); }
void arrayEvent(const ros::MessageEvent<std_msgs::Float64MultiArray const>& event) { (void)event; }

int main(int argc, char** argv)
{
  ros::init(argc, argv, "options");
  ros::NodeHandle nh;
  ros::SubscribeOptions so = ros::SubscribeOptions::create<std_msgs::Bool>("enable", 1, onBool, ros::VoidPtr(), &queue);
  ros::Subscriber enable = nh.subscribe(so);
  ros::Publisher data = nh.advertise<std_msgs::Float64MultiArray>("data", 1, connected, connected);
  ros::Subscriber array = nh.subscribe("array", 1, arrayEvent);
  ros::AsyncSpinner spinner(1, &queue);
  spinner.start();
  ros::waitForShutdown();
}
