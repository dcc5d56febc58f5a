#include <chrono>
#include <rclcpp/rclcpp.hpp>

using namespace std::chrono_literals;
namespace ch = std::chrono;

static constexpr double RATE = 20;
static constexpr auto kPeriod = 40ms;

class Timers : public rclcpp::Node
{
	rclcpp::TimerBase::SharedPtr a, b, c, d, e, f, g, h, i, j;

	void tick() {}
	void tock() {}

public:
	Timers() : Node("timers")
	{
		a = create_wall_timer(100ms, std::bind(&Timers::tick, this));
		b = create_wall_timer(std::chrono::milliseconds(20), std::bind(&Timers::tock, this));
		c = create_wall_timer(ch::seconds{2}, [this]() { tick(); });
		d = create_wall_timer(std::chrono::duration<double>(1.0 / RATE), std::bind(&Timers::tick, this));
		e = create_wall_timer(kPeriod, std::bind(&Timers::tick, this));
		f = rclcpp::create_timer(this, get_clock(), 1s, std::bind(&Timers::tock, this));
		g = rclcpp::create_timer(this, this->get_clock(), rclcpp::Duration::from_seconds(0.25), std::bind(&Timers::tock, this));
		h = create_timer(1.5s, std::bind(&Timers::tick, this));
		const double hz = declare_parameter("hz", 10.0);
		i = create_wall_timer(ch::duration<double>(1.0 / hz), std::bind(&Timers::tick, this));
		j = create_wall_timer(ch::duration_cast<ch::nanoseconds>(ch::milliseconds(5)), std::bind(&Timers::tick, this));
	}
};

int main(int argc, char *argv[])
{
	rclcpp::init(argc, argv);
	rclcpp::spin(std::make_shared<Timers>());
	rclcpp::shutdown();
}
