#include <ros/ros.h>
#include <std_msgs/Int16.h>
#include <std_msgs/String.h>

template <class Msg>
class Relay {
public:
	Relay(ros::NodeHandle& nh, const std::string& from, const std::string& to)
	{
		pub_ = nh.advertise<Msg>(to, 1);
		sub_ = nh.subscribe(from, 1, &Relay<Msg>::callback, this);
	}
	void callback(const boost::shared_ptr<const Msg>& msg) { pub_.publish(msg); }

private:
	ros::Publisher pub_;
	ros::Subscriber sub_;
};

int main(int argc, char** argv)
{
	ros::init(argc, argv, "relay");
	ros::NodeHandle nh;
	Relay<std_msgs::Int16> one(nh, "one_in", "one_out");
	Relay<std_msgs::String> two(nh, "two_in", "two_out");
	ros::Publisher alive = nh.advertise<std_msgs::String>("alive", 1, true);
	ros::spin();
}
