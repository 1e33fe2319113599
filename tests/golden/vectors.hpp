#pragma once
/// All golden vectors, for whoever needs packets that a person worked out.

#include "golden/vectors/can.hpp"
#include "golden/vectors/daisy_battery.hpp"
#include "golden/vectors/daisy_common.hpp"
#include "golden/vectors/daisy_dc_motor.hpp"
#include "golden/vectors/daisy_distance_sensor.hpp"
#include "golden/vectors/daisy_servo_motor.hpp"
#include "golden/vectors/daisy_trash_bin.hpp"
#include "golden/vectors/gateway_orders.hpp"
#include "golden/vectors/gateway_replies.hpp"
#include "golden/vectors/gateway_states.hpp"

namespace trama::golden {

/// Calls `f(row)` for every golden vector of every format.
constexpr void each_vector(auto&& f) {
    each_row(daisy_common::rows, f);
    each_row(daisy_dc_motor::rows, f);
    each_row(daisy_servo_motor::rows, f);
    each_row(daisy_distance_sensor::rows, f);
    each_row(daisy_battery::rows, f);
    each_row(daisy_trash_bin::rows, f);
    each_row(can_messages::rows, f);
    each_row(gateway_orders::rows, f);
    each_row(gateway_replies::rows, f);
    each_row(gateway_states::rows, f);
}

}  // namespace trama::golden
