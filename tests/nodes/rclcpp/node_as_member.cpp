#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/imu.hpp>
#include <std_srvs/srv/trigger.hpp>

class CDriver
{
public:
	CDriver(rclcpp::Node::SharedPtr pNode)
		: m_pNode(pNode)
	{
		m_pImu   = m_pNode->create_publisher<sensor_msgs::msg::Imu>("imu", rclcpp::SensorDataQoS());
		m_pZero  = m_pNode->create_service<std_srvs::srv::Trigger>("zero", std::bind(&CDriver::OnZero, this, std::placeholders::_1, std::placeholders::_2));
		m_pTimer = m_pNode->create_wall_timer(std::chrono::milliseconds(10), std::bind(&CDriver::OnTimer, this));
	}

private:
	void OnZero(const std_srvs::srv::Trigger::Request::SharedPtr, std_srvs::srv::Trigger::Response::SharedPtr pResponse)
	{
		pResponse->success = true;
	}

	void OnTimer()
	{
		m_pImu->publish(sensor_msgs::msg::Imu());
	}

	rclcpp::Node::SharedPtr                                   m_pNode;
	rclcpp::Publisher<sensor_msgs::msg::Imu>::SharedPtr       m_pImu;
	rclcpp::Service<std_srvs::srv::Trigger>::SharedPtr        m_pZero;
	rclcpp::TimerBase::SharedPtr                              m_pTimer;
};

int main(int argc, char ** argv)
{
	rclcpp::init(argc, argv);
	auto node = rclcpp::Node::make_shared("driver");
	CDriver driver(node);
	rclcpp::spin(node);
	rclcpp::shutdown();
	return 0;
}
