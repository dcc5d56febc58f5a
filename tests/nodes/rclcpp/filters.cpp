#include <message_filters/subscriber.h>
#include <message_filters/sync_policies/approximate_time.h>
#include <message_filters/synchronizer.h>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/camera_info.hpp>
#include <sensor_msgs/msg/image.hpp>

class Filters : public rclcpp::Node
{
    using Image = sensor_msgs::msg::Image;
    using CameraInfo = sensor_msgs::msg::CameraInfo;
    using Policy = message_filters::sync_policies::ApproximateTime<Image, CameraInfo>;
    using Synchronizer = message_filters::Synchronizer<Policy>;

public:
    Filters() : Node("filters"), depth_(this, "depth")
    {
        image_.subscribe(this, "image", rmw_qos_profile_sensor_data);
        info_ = std::make_shared<message_filters::Subscriber<CameraInfo>>(this, "camera_info");
        sync_ = std::make_shared<Synchronizer>(Policy(10), image_, *info_);
        sync_->registerCallback(std::bind(&Filters::both, this, std::placeholders::_1, std::placeholders::_2));
    }

private:
    void both(const Image::ConstSharedPtr &, const CameraInfo::ConstSharedPtr &) {}

    message_filters::Subscriber<Image> depth_, image_;
    std::shared_ptr<message_filters::Subscriber<CameraInfo>> info_;
    std::shared_ptr<Synchronizer> sync_;
};

int main(int argc, char **argv)
{
    rclcpp::init(argc, argv);
    rclcpp::spin(std::make_shared<Filters>());
    rclcpp::shutdown();
}
