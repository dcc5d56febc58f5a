#include <message_filters/subscriber.h>
#include <message_filters/time_synchronizer.h>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <sensor_msgs/msg/point_cloud2.hpp>

class CloudSync : public rclcpp::Node
{
public:
  CloudSync(const rclcpp::NodeOptions & options)
    : Node("cloud_sync", options)
  {
    m_front.subscribe(this, "front/points");
    m_rear = std::make_unique<CloudSubscriber>(this, "rear/points", rclcpp::SensorDataQoS());
    m_sync = std::make_shared<Sync>(m_front, *m_rear, 10);
    m_sync->registerCallback(std::bind(&CloudSync::OnClouds, this, std::placeholders::_1, std::placeholders::_2));
    m_pub = create_publisher<Cloud>("points", 1);
  }

private:
  using Cloud = sensor_msgs::msg::PointCloud2;
  using CloudSubscriber = message_filters::Subscriber<Cloud>;
  using Sync = message_filters::TimeSynchronizer<Cloud, Cloud>;

  void OnClouds(const Cloud::ConstSharedPtr & front, const Cloud::ConstSharedPtr &)
  {
    m_pub->publish(*front);
  }

  CloudSubscriber m_front;
  std::unique_ptr<CloudSubscriber> m_rear;
  std::shared_ptr<Sync> m_sync;
  rclcpp::Publisher<Cloud>::SharedPtr m_pub;
};

RCLCPP_COMPONENTS_REGISTER_NODE(CloudSync)
