#include <joy_mux/mux.h>

namespace joy_mux
{

void Mux::onInit()
{
  const auto nh = std::make_shared<ros::NodeHandle>(getNodeHandle(), "joy");
  std::string base;
  getPrivateNodeHandle().param<std::string>("base", base, DEFAULT_BASE);
  left_ = nh->subscribe<sensor_msgs::Joy>("left", 1, [this](const sensor_msgs::Joy::ConstPtr & joy) { pick(joy, 0); });
  right_ = nh->subscribe<sensor_msgs::Joy>("right", 1, boost::bind(&Mux::pick, this, boost::placeholders::_1, 1));
  out_ = getNodeHandle().advertise<sensor_msgs::Joy>(base + "/joy", 1);
  select_ = getNodeHandle().serviceClient<std_srvs::SetBool>("select");
}

void Mux::pick(const sensor_msgs::Joy::ConstPtr & joy, int side)
{
  std_srvs::SetBool call;
  call.request.data = side;
  if (select_.exists() && select_.call(call))
  {
    out_.publish(joy);
  }
}

}

#include <pluginlib/class_list_macros.hpp>
PLUGINLIB_EXPORT_CLASS(joy_mux::Mux, nodelet::Nodelet)
