#include "fusion/fusion_node.hh"

using namespace sensor_msgs;

Fusion::Fusion()
{
	image_.reset(new message_filters::Subscriber<Image>(nh_, "image", 2));
	cloud_ = boost::make_shared<CloudSubscriber>(nh_, "cloud", 2);
	odom_.subscribe(nh_, "odom", 10);
	sync_ = boost::make_shared<Sync>(*image_, *cloud_, 10);
	sync_->registerCallback(&Fusion::both, this);
	fused_ = nh_.advertise<PointCloud2>("fused", 2);
}

void Fusion::both(const ImageConstPtr& image, const PointCloud2ConstPtr& cloud)
{
	if (image->header.stamp <= cloud->header.stamp)
		fused_.publish(cloud);
}

int main(int argc, char** argv)
{
	ros::init(argc, argv, "fusion");
	Fusion fusion;
	ros::spin();
}
