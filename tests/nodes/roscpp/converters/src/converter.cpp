#include "converters/converter.h"
#include "converters/util.h"

Converter::Converter() : topic_out_("points_out")
{
  ros::NodeHandle pn("~");
  pn.param("topic", topic_in_, topic_in_);
  pub_ = n_.advertise<sensor_msgs::PointCloud>(topic_out_, 1);
  sub_ = n_.subscribe(frame_ + "/points", 1, &Converter::callback, this);
}

void Converter::callback(sensor_msgs::PointCloud2ConstPtr cloud)
{
  (void)cloud;
  pub_.publish(sensor_msgs::PointCloud());
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "converters");
  Converter c;
  util::spinAt(30);
  return 0;
}
