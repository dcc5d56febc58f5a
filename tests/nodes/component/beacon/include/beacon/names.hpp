#pragma once
#include <chrono>
#include <string>

namespace acme::names
{
inline constexpr char kNode[] = "beacon";
inline constexpr char kBlink[] = "beacon/blink";
inline constexpr int kDepth = 3;
inline constexpr std::chrono::milliseconds kPeriod{200};
static const std::string mode = std::string(kNode) + "/mode";
}
