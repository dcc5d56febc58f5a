#include <chrono>
#include <rclcpp/rclcpp.hpp>

using namespace std::chrono_literals;
using std::chrono::milliseconds;

class Durations : public rclcpp::Node
{
public:
  Durations() : Node("durations")
  {
    t_[0] = create_wall_timer(0.5s, [] {});
    t_[1] = create_wall_timer(std::chrono::duration<double, std::milli>(50.0), [] {});
    t_[2] = create_wall_timer(milliseconds(1000 / 40), [] {});
    t_[3] = create_wall_timer(std::chrono::nanoseconds(static_cast<int64_t>(1e9 / 50)), [] {});
    t_[4] = create_wall_timer(std::chrono::duration<float>(period_), [] {});
    t_[5] = create_wall_timer(std::chrono::minutes(1) + 30s, [] {});
    t_[6] = rclcpp::create_timer(get_node_base_interface(), get_node_timers_interface(), get_clock(), rclcpp::Duration(2s), [] {});
    t_[7] = rclcpp::create_timer(this, get_clock(), rclcpp::Duration(0, 5000000), std::bind(&Durations::tick, this));
    const auto period = rclcpp::Rate(25.0).period();
    t_[8] = create_wall_timer(period, std::bind(&Durations::tick, this));
    const auto ms = 2 * 15ms;
    t_[9] = create_wall_timer(ms, std::bind(&Durations::tick, this));
  }

private:
  void tick() {}
  const float period_ = 0.2f;
  rclcpp::TimerBase::SharedPtr t_[10];
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Durations>());
  rclcpp::shutdown();
}
