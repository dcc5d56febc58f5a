#pragma once
namespace detector {
namespace topics {
constexpr const char* IMAGE = "camera/image";
constexpr const char* DETECTIONS = "detections";
}  // namespace topics
}  // namespace detector
