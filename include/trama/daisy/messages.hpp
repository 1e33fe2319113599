#pragma once

#include "trama/daisy/messages/battery_controller.hpp"
#include "trama/daisy/messages/common.hpp"
#include "trama/daisy/messages/dc_motor.hpp"
#include "trama/daisy/messages/distance_sensor.hpp"
#include "trama/daisy/messages/servo_motor.hpp"
#include "trama/daisy/messages/trash_bin.hpp"

namespace trama::daisy {

/// Every message of the document. [daisy §3, §6..§10]
using messages = join<common::messages, dc_motor::messages, servo_motor::messages, distance_sensor::messages, battery_controller::messages, trash_bin::messages>;

}  // namespace trama::daisy
