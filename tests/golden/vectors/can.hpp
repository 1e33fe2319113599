#pragma once
// Golden vectors of the greenhouse masters and nodes. [can §1..§5]
// The document writes a frame as decimal bytes between bars; so do the comments, which quote its examples.
#include "golden/vectors/can_row.hpp"

namespace trama::golden::can_messages {

using namespace can;

inline constexpr moment from_13th{2011, 3, 13, 9, 15, 10}, to_15th{2011, 3, 15, 23, 30, 5};

inline constexpr table rows{
    // §1: 1|1|F|C|A|0|0|0, 0|0|0|0|0|0|0|0, 0|0|0|0|0|0|0|0
    can_row("define_function", define_function{1, 1, function::continuous_all, {}, {}, 0, {}},
            R"({"node":1,"message_id":1,"function":"continuous_all","start":{"year":0,"month":0,"day":0,"hour":0,"minute":0,"second":0},"end":{"year":0,"month":0,"day":0,"hour":0,"minute":0,"second":0},"sensor_count":0,"sensors":[0,0,0,0]})",
            data(0x81, 1, 1, 'F', 'C', 'A', 0, 0, 0), data(0x81, 0, 0, 0, 0, 0, 0, 0, 0), data(0x81, 0, 0, 0, 0, 0, 0, 0, 0)),
    // §1: 2|2|F|C|S|0|0|0, zeros, 0|0|0|4|0|1|2|3
    can_row("define_function", define_function{2, 2, function::continuous_specific, {}, {}, 4, {0, 1, 2, 3}},
            R"({"node":2,"message_id":2,"function":"continuous_specific","start":{"year":0,"month":0,"day":0,"hour":0,"minute":0,"second":0},"end":{"year":0,"month":0,"day":0,"hour":0,"minute":0,"second":0},"sensor_count":4,"sensors":[0,1,2,3]})",
            data(0x81, 2, 2, 'F', 'C', 'S', 0, 0, 0), data(0x81, 0, 0, 0, 0, 0, 0, 0, 0), data(0x81, 0, 0, 0, 4, 0, 1, 2, 3)),
    // §1: 2011/03/13 9h15m10s to 2011/03/15 23h30m5s, four sensors: 10|3|F|I|S|20|11|3, 13|20|11|3|15|9|15|10, 23|30|5|4|0|1|2|3
    // 1st: start year 20*100+11, month 3; 2nd: start day 13, end year 20*100+11, month 3, day 15, start 9:15:10; 3rd: end 23:30:05, 4 sensors
    can_row("define_function", define_function{10, 3, function::interval_specific, from_13th, to_15th, 4, {0, 1, 2, 3}},
            R"({"node":10,"message_id":3,"function":"interval_specific","start":{"year":2011,"month":3,"day":13,"hour":9,"minute":15,"second":10},"end":{"year":2011,"month":3,"day":15,"hour":23,"minute":30,"second":5},"sensor_count":4,"sensors":[0,1,2,3]})",
            data(0x80, 10, 3, 'F', 'I', 'S', 20, 11, 3), data(0x80, 13, 20, 11, 3, 15, 9, 15, 10), data(0x80, 23, 30, 5, 4, 0, 1, 2, 3)),
    // The two functions without an example; every byte of the interval differs, so that no two can be mixed up.
    can_row("define_function", define_function{5, 200, function::interval_all, {2112, 1, 2, 3, 4, 6}, {1934, 7, 8, 10, 11, 13}, 0, {}},
            R"({"node":5,"message_id":200,"function":"interval_all","start":{"year":2112,"month":1,"day":2,"hour":3,"minute":4,"second":6},"end":{"year":1934,"month":7,"day":8,"hour":10,"minute":11,"second":13},"sensor_count":0,"sensors":[0,0,0,0]})",
            data(0x82, 5, 200, 'F', 'I', 'A', 21, 12, 1), data(0x82, 2, 19, 34, 7, 8, 3, 4, 6), data(0x82, 10, 11, 13, 0, 0, 0, 0, 0)),
    can_row("define_function", define_function{6, 0, function::sleep, {}, {}, 0, {}},
            R"({"node":6,"message_id":0,"function":"sleep","start":{"year":0,"month":0,"day":0,"hour":0,"minute":0,"second":0},"end":{"year":0,"month":0,"day":0,"hour":0,"minute":0,"second":0},"sensor_count":0,"sensors":[0,0,0,0]})",
            data(0x82, 6, 0, 'F', 'S', 'A', 0, 0, 0), data(0x82, 0, 0, 0, 0, 0, 0, 0, 0), data(0x82, 0, 0, 0, 0, 0, 0, 0, 0)),
    // §2: 2|4|R, answered by 2|4|R|4|0|100|1|240, 2|20|3|55
    can_row("read_sensors", read_sensors{2, 4}, R"({"node":2,"message_id":4})", data(0x81, 2, 4, 'R')),
    can_row("sensor_readings", sensor_readings{2, 4, 4, {{{0, 100}, {1, 240}, {2, 20}, {3, 55}}}},
            R"({"node":2,"message_id":4,"sensor_count":4,"readings":[{"sensor":0,"value":100},{"sensor":1,"value":240},{"sensor":2,"value":20},{"sensor":3,"value":55}]})",
            data(0x81, 2, 4, 'R', 4, 0, 100, 1, 240), data(0x81, 2, 20, 3, 55)),
    // §3: 1|6|A|0, answered by 1|6|A|0|1
    can_row("read_actuator", read_actuator{1, 6, 0}, R"({"node":1,"message_id":6,"actuator":0})", data(0x81, 1, 6, 'A', 0)),
    can_row("actuator_state", actuator_state{1, 6, 0, 1}, R"({"node":1,"message_id":6,"actuator":0,"state":1})", data(0x81, 1, 6, 'A', 0, 1)),
    // §4 by its table: 1|7|M|0|0, echoed [D12]
    can_row("set_actuator", set_actuator{1, 7, 0, 0}, R"({"node":1,"message_id":7,"actuator":0,"state":0})", data(0x81, 1, 7, 'M', 0, 0)),
    // §5: 2011/04/01 12h20m30s: 10|9|C|20|11|4|1|12, 20|30
    can_row("set_clock", set_clock{10, 9, 2011, 4, 1, 12, 20, 30},
            R"({"node":10,"message_id":9,"year":2011,"month":4,"day":1,"hour":12,"minute":20,"second":30})",
            data(0x80, 10, 9, 'C', 20, 11, 4, 1, 12), data(0x80, 20, 30)),
};

}  // namespace trama::golden::can_messages
