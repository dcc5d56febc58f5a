// Reads a serial device in a thread of its own.
#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

#include <ros/ros.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/Temperature.h>
#include <std_srvs/Trigger.h>

class Driver
{
public:
	Driver(int argc, char *argv[]) try : m_running(true)
	{
		ros::init(argc, argv, "driver", ros::init_options::NoSigintHandler);
		m_nh = std::make_unique<ros::NodeHandle>();
		m_pnh = std::make_unique<ros::NodeHandle>("~");
		m_imu = m_nh->advertise<sensor_msgs::Imu>("imu/data_raw", 100);
		if (m_pnh->param("temperature", false))
			m_temperature = m_nh->advertise<sensor_msgs::Temperature>("imu/temperature", 1);
		m_calibrate = m_nh->advertiseService("imu/calibrate", &Driver::calibrate, this);
		m_thread = std::thread([this]() { read(); });
	}
	catch (const std::exception &e)
	{
		ROS_FATAL_STREAM("no driver: " << e.what());
	}

	~Driver() noexcept
	{
		m_running = false;
		if (m_thread.joinable())
			m_thread.join();
	}

private:
	void read()
	{
		while (m_running) {
			sensor_msgs::Imu imu;
			std::lock_guard<std::mutex> guard(m_mutex);
			m_imu.publish(imu);
		}
	}

	[[nodiscard]] bool calibrate([[maybe_unused]] std_srvs::Trigger::Request &req, std_srvs::Trigger::Response &res)
	{
		return res.success = true;
	}

	std::unique_ptr<ros::NodeHandle> m_nh, m_pnh;
	ros::Publisher m_imu, m_temperature;
	ros::ServiceServer m_calibrate;
	std::atomic<bool> m_running;
	std::mutex m_mutex;
	std::thread m_thread;
};

int main(int argc, char *argv[])
{
	Driver driver(argc, argv);
	ros::spin();
}
