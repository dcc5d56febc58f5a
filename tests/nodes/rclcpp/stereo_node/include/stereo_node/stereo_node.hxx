#pragma once
#include <image_transport/image_transport.hpp>
#include <message_filters/subscriber.h>
#include <message_filters/sync_policies/approximate_time.h>
#include <message_filters/synchronizer.h>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/image.hpp>

namespace stereo {

class StereoNode : public rclcpp::Node
{
	typedef sensor_msgs::msg::Image Image;
	typedef message_filters::sync_policies::ApproximateTime<Image, Image> Policy;
	typedef message_filters::Synchronizer<Policy> Sync;

public:
	explicit StereoNode(std::string const &name);

private:
	void both(Image::ConstSharedPtr const &l, Image::ConstSharedPtr const &r);

	message_filters::Subscriber<Image> left_, right_;
	std::unique_ptr<Sync> sync_;
	image_transport::Publisher transport_pub_;
};

}
