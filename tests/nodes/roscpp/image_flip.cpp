#include <image_transport/image_transport.h>
#include <ros/ros.h>

static image_transport::Publisher pub;

void imageCallback(const sensor_msgs::ImageConstPtr& msg)
{
  sensor_msgs::Image out = *msg;
  pub.publish(out);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "image_flip");
  ros::NodeHandle nh;
  image_transport::ImageTransport it(nh);
  image_transport::TransportHints hints("raw");
  image_transport::Subscriber sub = it.subscribe("in/image", 1, imageCallback, ros::VoidPtr(), hints);
  pub = it.advertise("out/image", 1);
  ros::spin();
}
