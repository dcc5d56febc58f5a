#ifndef OBSTACLE_STOP__VISIBILITY_CONTROL_H_
#define OBSTACLE_STOP__VISIBILITY_CONTROL_H_
#if defined _WIN32 || defined __CYGWIN__
  #define OBSTACLE_STOP_PUBLIC __declspec(dllexport)
  #define OBSTACLE_STOP_LOCAL
#else
  #define OBSTACLE_STOP_PUBLIC __attribute__ ((visibility("default")))
  #define OBSTACLE_STOP_LOCAL  __attribute__ ((visibility("hidden")))
#endif
#endif
