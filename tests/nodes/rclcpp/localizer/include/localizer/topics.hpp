#pragma once
#include <string>
#define LOCALIZER_POSE "pose"
namespace topics {
static const std::string ODOM = "wheel/odom";
constexpr char FIX[] = "gps/fix";
}
