#include <ros/ros.h>
#include <nav_msgs/Path.h>
#include <xmlrpcpp/XmlRpcValue.h>

class Converter
{
public:
  Converter() : nh_("~")
  {
    std::string in, out("path_out");
    nh_.param<std::string>("in", in, "path");
    nh_.param("out", out, out);
    nh_.param("absolute", absolute_, std::string("/path"));
    sub_ = nh_.subscribe(in, 1, &Converter::cb, this);
    pub_ = nh_.advertise<nav_msgs::Path>(absolute_, 1);

    XmlRpc::XmlRpcValue list;
    if (nh_.getParam("list", list))
    {
      for (int i = 0; i < list.size(); ++i)
      {
        const std::string name = list[i]["topic"];
        subs_.push_back(nh_.subscribe(name, 1, &Converter::cb, this));
      }
    }
    resolved_ = nh_.advertise<nav_msgs::Path>(nh_.resolveName("resolved"), 1);
  }

private:
  void cb(const nav_msgs::Path::ConstPtr& p) { pub_.publish(p); }

  ros::NodeHandle nh_;
  std::string absolute_;
  ros::Subscriber sub_;
  std::vector<ros::Subscriber> subs_;
  ros::Publisher pub_, resolved_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "private_topics");
  Converter converter;
  ros::spin();
}
