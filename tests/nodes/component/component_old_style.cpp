#include <memory>
#include <string>
#include "class_loader/register_macro.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/camera_info.hpp"
#include "sensor_msgs/srv/set_camera_info.hpp"

namespace camera_driver
{

class CameraDriver : public rclcpp::Node
{
public:
   CameraDriver (const rclcpp::NodeOptions & options) : Node ("cam_driver", options)
   {
      m_info_pub = this->create_publisher <sensor_msgs::msg::CameraInfo> ("camera_info", rclcpp::QoS (rclcpp::KeepLast (2)));
      m_set_srv  = this->create_service <sensor_msgs::srv::SetCameraInfo> ("set_camera_info", std::bind (&CameraDriver::set, this, std::placeholders::_1, std::placeholders::_2));
   }

private:
   using SetInfo = sensor_msgs::srv::SetCameraInfo;

   void set (const std::shared_ptr<SetInfo::Request> req, std::shared_ptr<SetInfo::Response> res)
   {
      m_info_pub->publish (req->camera_info);
      res->success = true;
   }

   rclcpp::Publisher<sensor_msgs::msg::CameraInfo>::SharedPtr m_info_pub;
   rclcpp::Service<SetInfo>::SharedPtr                        m_set_srv;
};

}

#include "rclcpp_components/register_node_macro.hpp"
RCLCPP_COMPONENTS_REGISTER_NODE (camera_driver::CameraDriver)
