#include <ros/ros.h>
#include <std_msgs/String.h>
#include <std_srvs/Empty.h>

static void heard(const std_msgs::String::ConstPtr& /* msg */) {}

int main(int argc, char** argv)
{
  ros::init(argc, argv, /* the node's name */ "comments");
  ros::NodeHandle nh; // global
  ros::Publisher pub = nh.advertise<std_msgs::String /* text */>(
      /* topic */ "spoken",  // what is said
      // not nh.advertise<std_msgs::String>("unspoken", 1)
      10 /* queue */);
  ros::Subscriber sub = nh // the handle
                          .subscribe(
                              "heard",
                              1'000,  // a lot
                              heard /* callback */);
  auto client = nh.serviceClient<std_srvs::Empty>(/*service=*/"clear", /*persistent=*/false);
  ros::spin();
}
