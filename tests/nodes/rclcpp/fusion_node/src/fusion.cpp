#include <fusion_node/fusion.h>

#define BIND1(f) std::bind(&Fusion::f, this, std::placeholders::_1)

Fusion::Fusion()
    : Node("fusion"),
      imu_sub_(create_subscription<sensor_msgs::msg::Imu>("imu", rclcpp::QoS(100), std::bind(&Fusion::imu, this, std::placeholders::_1))),
      pose_pub_(create_publisher<geometry_msgs::msg::PoseStamped>("pose", 10))
{
    std::string ns = "gps";
    gps_sub_ = create_subscription<sensor_msgs::msg::NavSatFix>(ns + "/fix", 10, BIND1(gps));
}

void Fusion::imu(const sensor_msgs::msg::Imu::SharedPtr) {}
void Fusion::gps(const sensor_msgs::msg::NavSatFix::SharedPtr) {}

int main(int argc, char **argv)
{
    rclcpp::init(argc, argv);
    rclcpp::spin(std::make_shared<Fusion>());
}
