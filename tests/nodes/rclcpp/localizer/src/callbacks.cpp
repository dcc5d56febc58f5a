#include "localizer/localizer.hpp"

void Localizer::odom(Twist::ConstSharedPtr) { pose_->publish(Pose()); }
void Localizer::fix(NavSatFix::ConstSharedPtr) { pose_->publish(Pose()); }
