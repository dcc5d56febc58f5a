#include "stereo_node/stereo_node.hxx"

namespace stereo {

StereoNode::StereoNode(std::string const &name)
	: rclcpp::Node(name)
	, left_(this, "left/image")
{
	right_.subscribe(this, "right/image");
	sync_ = std::make_unique<Sync>(Policy(5), left_, right_);
	sync_->registerCallback(std::bind(&StereoNode::both, this, std::placeholders::_1, std::placeholders::_2));
	transport_pub_ = image_transport::create_publisher(this, "disparity");
}

void StereoNode::both(Image::ConstSharedPtr const &l, Image::ConstSharedPtr const &)
{
	transport_pub_.publish(l);
}

}

int main(int argc, char *argv[])
{
	rclcpp::init(argc, argv);
	auto node = std::make_shared<stereo::StereoNode>("stereo");
	rclcpp::spin(node);
}
