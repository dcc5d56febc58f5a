#ifndef LIFT_TOPICS_H
#define LIFT_TOPICS_H

#include <string>

#define LIFT_PREFIX "lift/"
#define LIFT_LOAD_TOPIC LIFT_PREFIX "load"

namespace lift {
const std::string NODE = "lift";
constexpr int QUEUE = 20;
namespace topics {
const std::string BASE = "lift";
const std::string FLOOR = BASE + "/floor";
static const char* const HEIGHT = "lift/height";
}
}

#endif
