#pragma once
#include <cinttypes>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <std_msgs/Int64.h>

#if defined(_WIN32)
#define VIS_PUBLIC __declspec(dllexport)
#define VIS_LOCAL
#else
#define VIS_PUBLIC __attribute__((visibility("default")))
#define VIS_LOCAL __attribute__((visibility("hidden")))
#endif
#define VIS_TRACE(text) \
  do { \
    NODELET_DEBUG("%s", text); \
  } while (false)
#define VIS_BEGIN namespace vis {
#define VIS_END }

VIS_BEGIN
class VIS_PUBLIC Shown : public nodelet::Nodelet {
  VIS_PUBLIC void onInit() override;
  VIS_LOCAL void show(const std_msgs::Int64ConstPtr& n);

  ros::Publisher pub_;
  ros::Subscriber sub_;
};
VIS_END
