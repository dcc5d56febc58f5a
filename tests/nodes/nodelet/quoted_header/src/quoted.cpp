#include "quoted.h"
#include <pluginlib/class_list_macros.hpp>

void Quoted::onInit() {
    pub = getNodeHandle().advertise<Msg>(TOPIC, 1);
    sub = getNodeHandle().subscribe("answer", 1, &Quoted::answer, this);
}

PLUGINLIB_EXPORT_CLASS(Quoted, nodelet::Nodelet)
