#include <ros/ros.h>

constexpr double kRate = 20.0;

class Clocks
{
public:
  Clocks(ros::NodeHandle & nh)
  {
    double rate;
    nh.param("rate", rate, 4.0);
    a_ = nh.createTimer(ros::Duration(0.5), &Clocks::a, this);
    b_ = nh.createTimer(ros::Rate(5), &Clocks::a, this);
    c_ = nh.createWallTimer(ros::WallDuration(3.0), &Clocks::c, this);
    d_ = nh.createSteadyTimer(ros::WallDuration(0.25), &Clocks::d, this);
    e_ = nh.createTimer(ros::Duration(1.5), &Clocks::once, this, true);
    f_ = nh.createTimer(ros::Duration(1.0 / kRate), &Clocks::a, this, false, false);
    g_ = nh.createTimer(ros::Rate(50).expectedCycleTime(), &Clocks::a, this);
    h_ = nh.createTimer(ros::Duration(1, 500000000), &Clocks::a, this);
    const ros::Duration period(2.5);
    j_ = nh.createTimer(period, &Clocks::a, this);
    k_ = nh.createTimer(ros::Duration(interval()), &Clocks::a, this);
  }

private:
  double interval();
  void a(const ros::TimerEvent &) {}
  void c(const ros::WallTimerEvent &) {}
  void d(const ros::SteadyTimerEvent &) {}
  void once(const ros::TimerEvent &) {}

  ros::Timer a_, b_, e_, f_, g_, h_, j_, k_;
  ros::WallTimer c_;
  ros::SteadyTimer d_;
};

double Clocks::interval() { return ros::Time::now().toSec() > 100 ? 1.0 : 2.0; }

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "timers");
  ros::NodeHandle nh;
  Clocks clocks(nh);
  ros::spin();
}
