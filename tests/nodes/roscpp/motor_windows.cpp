#include <ros/ros.h>
#include <std_msgs/Float64.h>
#include <std_srvs/Trigger.h>

class CMotorNode
{
public:
	CMotorNode()
		: m_nh()
		, m_private("~")
	{
		m_pubCurrent = m_nh.advertise<std_msgs::Float64>("motor/current", 1, true);
		m_subSpeed   = m_nh.subscribe("motor/speed", 1, &CMotorNode::OnSpeed, this);
		m_srvStop    = m_private.advertiseService("stop", &CMotorNode::OnStop, this);
		m_timer      = m_nh.createTimer(ros::Duration(0.05), &CMotorNode::OnTimer, this);
	}

private:
	void OnSpeed(const std_msgs::Float64::ConstPtr & speed)
	{
		m_speed = speed->data;
	}

	bool OnStop(std_srvs::Trigger::Request &, std_srvs::Trigger::Response & response)
	{
		m_speed = 0.0;
		response.success = true;
		return true;
	}

	void OnTimer(const ros::TimerEvent &)
	{
		std_msgs::Float64 current;
		current.data = m_speed / 12.0;
		m_pubCurrent.publish(current);
	}

	ros::NodeHandle    m_nh;
	ros::NodeHandle    m_private;
	ros::Publisher     m_pubCurrent;
	ros::Subscriber    m_subSpeed;
	ros::ServiceServer m_srvStop;
	ros::Timer         m_timer;
	double             m_speed = 0.0;
};

int main(int argc, char ** argv)
{
	ros::init(argc, argv, "motor");
	CMotorNode node;
	ros::spin();
	return 0;
}
