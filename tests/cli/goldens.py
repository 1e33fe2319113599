"""Every message of the three formats, worked out by hand from the tables of the documents: bytes and JSON.

daisy: destination, source and command; DATA; message; kind; fields. LEN and CRC follow from their definitions.
gateway: payload; message; fields. can: frames; id; message; fields.
"""

from tool import can_log, octets, packet, record

REQUEST, RESPONSE = "request", "response"
NOTHING = "{}"

# Little-endian: 1000 = 0x03E8 is e8 03; i16 -1200 = 0x10000 - 0x4B0 = 0xFB50 is 50 fb; i16 1200 = 0x04B0 is b0 04;
# i32 100000 = 0x000186A0 is a0 86 01 00; i32 -2 = 0xFFFFFFFE is fe ff ff ff; u16 900 = 0x0384 is 84 03.
DAISY = [
    ("ff 00 01", "", "common.init", REQUEST, NOTHING),
    ("00 10 81", "44 43 20 6d 6f 74 6f 72", "common.init", RESPONSE, '{"description":"DC motor"}'),
    ("20 00 02", "", "common.reset", REQUEST, NOTHING),
    ("00 20 82", "", "common.reset", RESPONSE, '{"description":""}'),
    ("31 00 03", "", "common.ping", REQUEST, NOTHING),
    ("00 31 83", "", "common.ping", RESPONSE, NOTHING),
    ("10 00 04", "01", "common.error", REQUEST, '{"code":1}'),
    ("00 11 04", "7b", "common.error", REQUEST, '{"code":123}'),
    # code 0: the packet 05 10 00 40 01 54 as it was rejected, whose CRC 55 was expected to be 05^10^00^40^01 = 54
    ("00 10 04", "00 05 10 00 40 01 55 54", "common.error", REQUEST,
     '{"code":0,"rejected":"051000400155","expected_crc":84}'),

    ("11 00 40", "01", "dc_motor.set_direction", REQUEST, '{"direction":"counter_clockwise"}'),
    ("00 11 c0", "", "dc_motor.set_direction", RESPONSE, NOTHING),
    ("11 00 41", "00 50 fb", "dc_motor.set_dc_speed", REQUEST, '{"direction":"clockwise","speed":-1200}'),
    ("00 11 c1", "", "dc_motor.set_dc_speed", RESPONSE, NOTHING),
    ("11 00 42", "a0 86 01 00", "dc_motor.set_encoder", REQUEST, '{"count":100000}'),
    ("00 11 c2", "", "dc_motor.set_encoder", RESPONSE, NOTHING),
    ("11 00 43", "", "dc_motor.get_encoder", REQUEST, NOTHING),
    ("00 11 c3", "fe ff ff ff", "dc_motor.get_encoder", RESPONSE, '{"count":-2}'),
    ("11 00 44", "", "dc_motor.reset_encoder", REQUEST, NOTHING),
    ("00 11 c4", "", "dc_motor.reset_encoder", RESPONSE, NOTHING),
    ("11 00 45", "00 80", "dc_motor.set_encoder_to_stop", REQUEST, '{"count":-32768}'),
    ("00 11 c5", "", "dc_motor.set_encoder_to_stop", RESPONSE, NOTHING),
    ("11 00 46", "", "dc_motor.get_encoder_to_stop", REQUEST, NOTHING),
    ("00 11 c6", "ff 7f", "dc_motor.get_encoder_to_stop", RESPONSE, '{"count":32767}'),
    ("11 00 47", "", "dc_motor.dont_stop", REQUEST, NOTHING),
    ("00 11 c7", "", "dc_motor.dont_stop", RESPONSE, NOTHING),
    ("11 00 48", "", "dc_motor.motor_consumption", REQUEST, NOTHING),
    ("00 11 c8", "e8 03", "dc_motor.motor_consumption", RESPONSE, '{"consumption":1000}'),
    ("00 11 49", "ff 03", "dc_motor.motor_stress_alarm", REQUEST, '{"consumption":1023}'),
    ("11 00 c9", "", "dc_motor.motor_stress_alarm", RESPONSE, NOTHING),
    ("00 11 4a", "00 01", "dc_motor.motor_shut_down_alarm", REQUEST, '{"consumption":256}'),
    ("11 00 ca", "", "dc_motor.motor_shut_down_alarm", RESPONSE, NOTHING),
    ("11 00 4b", "", "dc_motor.get_dc_speed", REQUEST, NOTHING),
    ("00 11 cb", "01 b0 04", "dc_motor.get_dc_speed", RESPONSE, '{"direction":"counter_clockwise","speed":1200}'),

    ("20 00 40", "04 b4", "servo_motor.set_position", REQUEST, '{"servo_id":4,"position":180}'),
    ("00 20 c0", "", "servo_motor.set_position", RESPONSE, NOTHING),
    ("20 00 41", "00 01 5a b3 b4", "servo_motor.set_all_positions", REQUEST, '{"positions":[0,1,90,179,180]}'),
    ("00 20 c1", "", "servo_motor.set_all_positions", RESPONSE, NOTHING),
    ("20 00 42", "02", "servo_motor.get_position", REQUEST, '{"servo_id":2}'),
    ("00 20 c2", "02 5a", "servo_motor.get_position", RESPONSE, '{"servo_id":2,"position":90}'),
    ("20 00 43", "", "servo_motor.get_all_positions", REQUEST, NOTHING),
    ("00 20 c3", "05 04 03 02 01", "servo_motor.get_all_positions", RESPONSE, '{"positions":[5,4,3,2,1]}'),
    ("20 00 44", "01 3c", "servo_motor.set_servo_speed", REQUEST, '{"servo_id":1,"speed":60}'),
    ("00 20 c4", "", "servo_motor.set_servo_speed", RESPONSE, NOTHING),
    ("20 00 45", "0a 14 1e 28 32", "servo_motor.set_all_speeds", REQUEST, '{"speeds":[10,20,30,40,50]}'),
    ("00 20 c5", "", "servo_motor.set_all_speeds", RESPONSE, NOTHING),
    ("20 00 46", "03", "servo_motor.get_servo_speed", REQUEST, '{"servo_id":3}'),
    ("00 20 c6", "03 00", "servo_motor.get_servo_speed", RESPONSE, '{"servo_id":3,"speed":0}'),
    ("20 00 47", "", "servo_motor.get_all_speeds", REQUEST, NOTHING),
    ("00 20 c7", "b4 b4 b4 b4 b4", "servo_motor.get_all_speeds", RESPONSE, '{"speeds":[180,180,180,180,180]}'),
    ("20 00 48", "00", "servo_motor.free_servo", REQUEST, '{"servo_id":0}'),
    ("00 20 c8", "", "servo_motor.free_servo", RESPONSE, NOTHING),
    ("20 00 49", "", "servo_motor.free_all_servos", REQUEST, NOTHING),
    ("00 20 c9", "", "servo_motor.free_all_servos", RESPONSE, NOTHING),
    ("20 00 4a", "", "servo_motor.get_status", REQUEST, NOTHING),
    ("00 20 ca", "7f", "servo_motor.get_status", RESPONSE, '{"switches":127}'),
    ("20 00 4b", "05 03", "servo_motor.alarm_on_state", REQUEST, '{"switch_id":5,"trigger":"any_change"}'),
    ("00 20 cb", "", "servo_motor.alarm_on_state", RESPONSE, NOTHING),
    ("00 20 4c", "05 01 01", "servo_motor.switch_alarm", REQUEST,
     '{"switch_id":5,"trigger":"rising_edge","state":"high"}'),
    ("20 00 cc", "", "servo_motor.switch_alarm", RESPONSE, NOTHING),

    ("3e 00 40", "05", "distance_sensor.on_distance_sensor", REQUEST, '{"sensor_id":5}'),
    ("00 3e c0", "", "distance_sensor.on_distance_sensor", RESPONSE, NOTHING),
    ("3e 00 41", "00", "distance_sensor.off_distance_sensor", REQUEST, '{"sensor_id":0}'),
    ("00 3e c1", "", "distance_sensor.off_distance_sensor", RESPONSE, NOTHING),
    ("3e 00 42", "3f", "distance_sensor.set_distance_sensors_mask", REQUEST, '{"sensors":63}'),
    ("00 3e c2", "", "distance_sensor.set_distance_sensors_mask", RESPONSE, NOTHING),
    ("3e 00 43", "", "distance_sensor.get_distance_sensors_mask", REQUEST, NOTHING),
    ("00 3e c3", "15", "distance_sensor.get_distance_sensors_mask", RESPONSE, '{"sensors":21}'),
    ("3e 00 44", "3f", "distance_sensor.get_value", REQUEST, '{"sensors":63}'),
    # bits 0, 2 and 5: three readings, 0x0102 = 258, 0x03FF = 1023 and 0x7594 = 30100
    ("00 3e c4", "25 02 01 ff 03 94 75", "distance_sensor.get_value", RESPONSE,
     '{"sensors":37,"readings":[258,1023,30100]}'),
    ("3e 00 45", "20", "distance_sensor.get_one_value", REQUEST, '{"sensors":32}'),
    ("00 3e c5", "20 ff ff", "distance_sensor.get_one_value", RESPONSE, '{"sensors":32,"readings":[65535]}'),
    ("00 3e c5", "00", "distance_sensor.get_one_value", RESPONSE, '{"sensors":0,"readings":[]}'),
    ("3e 00 46", "02", "distance_sensor.alarm_on_state", REQUEST, '{"trigger":"falling_edge"}'),
    ("00 3e c6", "", "distance_sensor.alarm_on_state", RESPONSE, NOTHING),
    ("00 3e 47", "00 00", "distance_sensor.switch_alarm", REQUEST, '{"trigger":"none","state":"low"}'),
    ("3e 00 c7", "", "distance_sensor.switch_alarm", RESPONSE, NOTHING),

    ("40 00 40", "", "battery_controller.enable", REQUEST, NOTHING),
    ("00 40 c0", "", "battery_controller.enable", RESPONSE, NOTHING),
    ("40 00 41", "", "battery_controller.disable", REQUEST, NOTHING),
    ("00 40 c1", "", "battery_controller.disable", RESPONSE, NOTHING),
    ("40 00 42", "", "battery_controller.get_battery_value", REQUEST, NOTHING),
    ("00 40 c2", "00 02", "battery_controller.get_battery_value", RESPONSE, '{"value":512}'),
    ("00 40 43", "", "battery_controller.battery_full_alarm", REQUEST, NOTHING),
    ("40 00 c3", "", "battery_controller.battery_full_alarm", RESPONSE, NOTHING),
    ("40 00 44", "64 02", "battery_controller.set_battery_empty_value", REQUEST, '{"value":612}'),
    ("00 40 c4", "", "battery_controller.set_battery_empty_value", RESPONSE, NOTHING),
    # [D2] group 6 is battery_controller too
    ("00 62 45", "0a 00", "battery_controller.battery_empty_alarm", REQUEST, '{"value":10}'),
    ("62 00 c5", "", "battery_controller.battery_empty_alarm", RESPONSE, NOTHING),
    ("40 00 46", "ff 03", "battery_controller.set_full_battery_value", REQUEST, '{"value":1023}'),
    ("00 40 c6", "", "battery_controller.set_full_battery_value", RESPONSE, NOTHING),

    ("50 00 40", "", "trash_bin.get_trash_bin_value", REQUEST, NOTHING),
    ("00 50 c0", "01 00", "trash_bin.get_trash_bin_value", RESPONSE, '{"value":1}'),
    ("00 50 41", "", "trash_bin.bin_full_alarm", REQUEST, NOTHING),
    ("50 00 c1", "", "trash_bin.bin_full_alarm", RESPONSE, NOTHING),
    ("50 00 42", "84 03", "trash_bin.set_full_bin_value", REQUEST, '{"value":900}'),
    ("00 50 c2", "", "trash_bin.set_full_bin_value", RESPONSE, NOTHING),
]


def daisy_packet(golden):
    return packet(golden[0], octets(golden[1]))


def daisy_line(golden, offset=0):
    head, data, message, kind, fields = golden
    destination, source = octets(head)[:2]
    return (f'{{"protocol":"daisy","offset":{offset},"length":{len(octets(data)) + 5},"destination":{destination},'
            f'"source":{source},"message":"{message}","kind":"{kind}","fields":{fields}}}')


# The document's own examples, and one more of each message with values of its own.
ZEROS = "#0000000000000000"
NO_DATE = '{"year":0,"month":0,"day":0,"hour":0,"minute":0,"second":0}'
CAN = [
    # 1|1|F|C|A|0|0|0: F = 46, C = 43, A = 41
    (["081#0101464341000000", "081" + ZEROS, "081" + ZEROS], 129, "define_function",
     '{"node":1,"message_id":1,"function":"continuous_all","start":' + NO_DATE + ',"end":' + NO_DATE +
     ',"sensor_count":0,"sensors":[0,0,0,0]}'),
    # 2|2|F|C|S|0|0|0, zeros, 0|0|0|4|0|1|2|3
    (["081#0202464353000000", "081" + ZEROS, "081#0000000400010203"], 129, "define_function",
     '{"node":2,"message_id":2,"function":"continuous_specific","start":' + NO_DATE + ',"end":' + NO_DATE +
     ',"sensor_count":4,"sensors":[0,1,2,3]}'),
    # 10|3|F|I|S|20|11|3, 13|20|11|3|15|9|15|10, 23|30|5|4|0|1|2|3
    (["082#0A03464953140B03", "082#0D140B030F090F0A", "082#171E050400010203"], 130, "define_function",
     '{"node":10,"message_id":3,"function":"interval_specific",'
     '"start":{"year":2011,"month":3,"day":13,"hour":9,"minute":15,"second":10},'
     '"end":{"year":2011,"month":3,"day":15,"hour":23,"minute":30,"second":5},'
     '"sensor_count":4,"sensors":[0,1,2,3]}'),
    # all sensors, from 1999-12-31 23:59:59 to 2000-01-01 00:00:00
    (["080#FFC846494113630C", "080#1F14000101173B3B", "080#0000000000000000"], 128, "define_function",
     '{"node":255,"message_id":200,"function":"interval_all",'
     '"start":{"year":1999,"month":12,"day":31,"hour":23,"minute":59,"second":59},'
     '"end":{"year":2000,"month":1,"day":1,"hour":0,"minute":0,"second":0},'
     '"sensor_count":0,"sensors":[0,0,0,0]}'),
    (["080#0B00465341000000", "080" + ZEROS, "080" + ZEROS], 128, "define_function",
     '{"node":11,"message_id":0,"function":"sleep","start":' + NO_DATE + ',"end":' + NO_DATE +
     ',"sensor_count":0,"sensors":[0,0,0,0]}'),
    # 2|4|R
    (["081#020452"], 129, "read_sensors", '{"node":2,"message_id":4}'),
    # 2|4|R|4|0|100|1|240, 2|20|3|55
    (["081#02045204006401F0", "081#02140337"], 129, "sensor_readings",
     '{"node":2,"message_id":4,"sensor_count":4,"readings":[{"sensor":0,"value":100},{"sensor":1,"value":240},'
     '{"sensor":2,"value":20},{"sensor":3,"value":55}]}'),
    # [D9] two frames whatever the count
    (["081#0205520107FF0000", "081#00000000"], 129, "sensor_readings",
     '{"node":2,"message_id":5,"sensor_count":1,"readings":[{"sensor":7,"value":255},{"sensor":0,"value":0},'
     '{"sensor":0,"value":0},{"sensor":0,"value":0}]}'),
    # 1|6|A|0, then 1|6|A|0|1
    (["081#01064100"], 129, "read_actuator", '{"node":1,"message_id":6,"actuator":0}'),
    (["081#0106410001"], 129, "actuator_state", '{"node":1,"message_id":6,"actuator":0,"state":1}'),
    # 1|7|M|0|0, and as the document prints it [D12]
    (["081#01074D0000"], 129, "set_actuator", '{"node":1,"message_id":7,"actuator":0,"state":0}'),
    (["081#0107410000"], 129, "actuator_state", '{"node":1,"message_id":7,"actuator":0,"state":0}'),
    # [D10] any state
    (["082#01084D09FE"], 130, "set_actuator", '{"node":1,"message_id":8,"actuator":9,"state":254}'),
    # 10|9|C|20|11|4|1|12, 20|30
    (["080#0A0943140B04010C", "080#141E"], 128, "set_clock",
     '{"node":10,"message_id":9,"year":2011,"month":4,"day":1,"hour":12,"minute":20,"second":30}'),
]


def can_line(golden, line=1):
    frames, number, message, fields = golden
    return (f'{{"protocol":"can","line":{line},"frames":{len(frames)},"id":{number},"message":"{message}",'
            f'"fields":{fields}}}')


def can_text(golden):
    """As encode writes it."""
    return can_log(*golden[0], step=0)


def columns(*parts):
    """The payload of (width, content) parts: numbers to the right of their columns, texts to the left."""
    return "".join(f"{content:>{width}}" if isinstance(content, int) else f"{content:<{width}}"
                   for width, content in parts)


ORDER_1 = columns((1, 2), (3, 1), (5, 0), (5, 17), (5, 2), (2, 15), (10, "FAST"), (10, "TR-1"), (10, "PALLET 7"),
                  (1, 2), (10, "0110"), (10, "1001"), (10, "UP"))
ORDER_1_JSON = ('{"use":"current","type":"load","node":0,"station_id":17,"station_type":2,"level":15,"options":"FAST",'
                '"transit_id":"TR-1","cargo_id":"PALLET 7","phase":"transiting","inputs":"0110","outputs":"1001",'
                '"last_command":"UP"}')
ORDER_0 = columns((1, 0), (3, 0), (5, 0), (5, 0), (5, 0), (2, 0), (10, ""), (10, ""), (10, ""),
                  (1, 0), (10, ""), (10, ""), (10, ""))
ORDER_0_JSON = ('{"use":"unused","type":"none","node":0,"station_id":0,"station_type":0,"level":0,"options":"",'
                '"transit_id":"","cargo_id":"","phase":"none","inputs":"","outputs":"","last_command":""}')
ORDER_FIELDS = '"msg_id":1,"cart_id":2,"station_id":17,"station_type":2,"level":15,"options":"FAST",' \
               '"initial_inputs":"in \\"x\\\\","cargo_id":"C 1"'
ORDER_COLUMNS = ((5, 1), (5, 2), (5, 17), (5, 2), (2, 15), (10, "FAST"), (10, 'in "x\\'), (10, "C 1"))

GATEWAY = [
    (columns((3, 1), *ORDER_COLUMNS), "load", "{" + ORDER_FIELDS + "}"),
    (columns((3, 2), *ORDER_COLUMNS), "transit", "{" + ORDER_FIELDS + "}"),
    (columns((3, 3), *ORDER_COLUMNS), "unload", "{" + ORDER_FIELDS + "}"),
    (columns((3, 10), (5, 99999), (5, 3), (5, 0)), "go_parking", '{"msg_id":99999,"cart_id":3,"parking_node":0}'),
    (columns((3, 15), (5, 0), (5, 3), (5, 99999)), "go_node", '{"msg_id":0,"cart_id":3,"node":99999}'),
    (columns((3, 20), (5, 7), (5, 3)), "cancel_transits", '{"msg_id":7,"cart_id":3}'),
    (columns((3, 21), (5, 8), (5, 3), (10, "TR-1"), (10, "OPEN")), "send_command",
     '{"msg_id":8,"cart_id":3,"transit_id":"TR-1","command":"OPEN"}'),
    (columns((3, 22), (5, 9), (5, 3), (10, "TR-1"), (10, "  01")), "send_inputs",
     '{"msg_id":9,"cart_id":3,"transit_id":"TR-1","inputs":"  01"}'),
    (columns((3, 23), (5, 10), (5, 3), (10, "TR-1"), (10, "0123456789")), "send_cargo_id",
     '{"msg_id":10,"cart_id":3,"transit_id":"TR-1","cargo_id":"0123456789"}'),
    (columns((3, 30), (5, 11), (5, 3), (5, 105)), "cross_granted", '{"msg_id":11,"cart_id":3,"node":105}'),
    (columns((3, 50), (5, 12)), "idle_processing", '{"msg_id":12}'),
    (columns((3, 100), (5, 13), (5, 3), (3, 10), (5, 11), (10, "TR-2")), "transit_ack",
     '{"msg_id":13,"cart_id":3,"src_type":"go_parking","src_msg_id":11,"transit_id":"TR-2"}'),
    (columns((3, 101), (5, 14), (5, 0), (3, 50), (5, 12)), "ack",
     '{"msg_id":14,"cart_id":0,"src_type":"idle_processing","src_msg_id":12}'),
    (columns((3, 102), (5, 15), (5, 3), (3, 1), (5, 16), (80, "no such station")), "nack",
     '{"msg_id":15,"cart_id":3,"src_type":"load","src_msg_id":16,"error_message":"no such station"}'),
    # cart_status 512 + 128 + 64 = 704: busy, ready, loaded
    (columns((3, 200), (5, 17), (5, 3), (4, 704), (1, 2), (5, 100), (3, 100), (5, 101), (5, 102), (5, -250), (1, 1))
     + ORDER_1 + ORDER_0, "cart_state",
     '{"msg_id":17,"cart_id":3,"cart_status":["busy","ready","loaded"],"cart_phase":"loading","ini_node":100,'
     '"rel_position":100,"end_node":101,"next_node":102,"speed_mms":-250,"cross_confirmation_needed":1,'
     '"orders":[' + ORDER_1_JSON + "," + ORDER_0_JSON + "]}"),
    # check 2048 + 16384 = 18432: bits 11 and 14
    (columns((3, 201), (5, 18)) + " 48.2" + "  7.0" + columns((5, 12), (7, 18432), (1, 5), (1, 2)), "circuit_state",
     '{"msg_id":18,"circuit_voltage":48.2,"circuit_current":7.0,"working_carts":12,'
     '"check":["door_open","undervoltage"],"target_mode":"automatic","mode":"init"}'),
]


def gateway_record(golden):
    return record(golden[0])


def gateway_line(golden, offset=0):
    payload, message, fields = golden
    return (f'{{"protocol":"gateway","offset":{offset},"length":{len(payload) + 2},"message":"{message}",'
            f'"fields":{fields}}}')
