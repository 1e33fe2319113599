#pragma once

#include <compare>

#include "trama/can/frame.hpp"
#include "trama/can/values.hpp"
#include "trama/core/wire_format.hpp"

namespace trama::can {

/// Identity of a message: its letter, then the DLC of its first frame, which tells requests from replies.
enum class key : std::uint16_t {};
constexpr key key_of(char letter, unsigned length) noexcept { return static_cast<key>(unsigned{static_cast<unsigned char>(letter)} << 8 | length); }

/// DEFINE FUNCTION, master to node and echoed back: what a node samples and when. [can §1]
struct define_function {
    std::uint8_t node = 0;
    std::uint8_t message_id = 0;             ///< 0..200.
    can::function function{};              ///< Has no name until it is set.
    moment start, end;                       ///< Of interval functions; zero in all others.
    std::uint8_t sensor_count = 0;           ///< 1..4 [D8] of functions for specific sensors, 0 of others.
    std::array<std::uint8_t, 4> sensors{};   ///< The first `sensor_count`; the others are zero.

    constexpr const rule* rule_for(field_ref at) const noexcept;

    static constexpr can::key key = key_of('F', 8);
    static constexpr std::array<std::uint8_t, 3> frame_lengths{8, 8, 8};
    static constexpr std::string_view name = "define_function", section = "1";
    static constexpr fields layout{
        field<&define_function::node, wire::u8>{"node", {}, "node"},
        field<&define_function::message_id, wire::followed_by<wire::u8, 'F'>>{"message_id", message_ids, "repeated in the reply"},
        field<&define_function::function, wire::letter_pair>{"function", {}, "what to sample"},
        field<&define_function::start, wire::torn_record<moment, 4, 4, 4>>{"start", {}, "start of the interval"},
        field<&define_function::end, wire::torn_record<moment, 4, 3, 10>>{"end", {}, "end of the interval"},
        field<&define_function::sensor_count, wire::u8>{"sensor_count", between(0, 4), "sensors that follow"},
        field<&define_function::sensors, wire::repeated<wire::u8, 4>>{"sensors", {}, "sensors, zero at and past sensor_count"},
    };
    friend constexpr bool operator==(const define_function&, const define_function&) = default;
};

inline constexpr rule one_to_four = between(1, 4);

constexpr const rule* define_function::rule_for(field_ref at) const noexcept {
    const auto is = [&]<auto Member>() { return at.field == index_of<define_function, Member>(); };
    if (is.operator()<&define_function::start>() || is.operator()<&define_function::end>()) {
        if (!has_interval(function)) return &zero;
        return at.sub == index_of<moment, &moment::month>() ? &months : at.sub == index_of<moment, &moment::day>() ? &days : nullptr;
    }
    if (is.operator()<&define_function::sensor_count>()) return names_sensors(function) ? &one_to_four : is_listed(function) ? &zero : nullptr;
    return is.operator()<&define_function::sensors>() && at.index >= sensor_count ? &zero : nullptr;
}

/// READ, master to node, once a second. [can §2]
struct read_sensors {
    std::uint8_t node = 0;
    std::uint8_t message_id = 0;  ///< 0..200.

    static constexpr can::key key = key_of('R', 3);
    static constexpr std::array<std::uint8_t, 1> frame_lengths{3};
    static constexpr std::string_view name = "read_sensors", section = "2";
    static constexpr fields layout{
        field<&read_sensors::node, wire::u8>{"node", {}, "node"},
        field<&read_sensors::message_id, wire::followed_by<wire::u8, 'R'>>{"message_id", message_ids, "repeated in the reply"},
    };
    friend constexpr bool operator==(const read_sensors&, const read_sensors&) = default;
};

/// READ, reply: always two frames [D9]. [can §2.1]
struct sensor_readings {
    std::uint8_t node = 0;
    std::uint8_t message_id = 0;         ///< 0..200.
    std::uint8_t sensor_count = 0;       ///< 0..4.
    std::array<reading, 4> readings{};   ///< The first `sensor_count`; the others are zero.

    constexpr const rule* rule_for(field_ref at) const noexcept {
        return at.field == index_of<sensor_readings, &sensor_readings::readings>() && at.index >= sensor_count ? &zero : nullptr;
    }

    static constexpr can::key key = key_of('R', 8);
    static constexpr std::array<std::uint8_t, 2> frame_lengths{8, 4};
    static constexpr std::string_view name = "sensor_readings", section = "2.1";
    static constexpr fields layout{
        field<&sensor_readings::node, wire::u8>{"node", {}, "node"},
        field<&sensor_readings::message_id, wire::followed_by<wire::u8, 'R'>>{"message_id", message_ids, "that of the request"},
        field<&sensor_readings::sensor_count, wire::u8>{"sensor_count", between(0, 4), "readings that follow"},
        field<&sensor_readings::readings, wire::repeated<wire::record<reading>, 4>>{"readings", {}, "readings, zero at and past sensor_count"},
    };
    friend constexpr bool operator==(const sensor_readings&, const sensor_readings&) = default;
};

/// READ ACTUATOR, master to node. [can §3]
struct read_actuator {
    std::uint8_t node = 0;
    std::uint8_t message_id = 0;  ///< 0..200.
    std::uint8_t actuator = 0;

    static constexpr can::key key = key_of('A', 4);
    static constexpr std::array<std::uint8_t, 1> frame_lengths{4};
    static constexpr std::string_view name = "read_actuator", section = "3";
    static constexpr fields layout{
        field<&read_actuator::node, wire::u8>{"node", {}, "node"},
        field<&read_actuator::message_id, wire::followed_by<wire::u8, 'A'>>{"message_id", message_ids, "repeated in the reply"},
        field<&read_actuator::actuator, wire::u8>{"actuator", {}, "actuator"},
    };
    friend constexpr bool operator==(const read_actuator&, const read_actuator&) = default;
};

/// READ ACTUATOR, reply. [can §3]
struct actuator_state {
    std::uint8_t node = 0;
    std::uint8_t message_id = 0;  ///< 0..200.
    std::uint8_t actuator = 0;
    std::uint8_t state = 0;       ///< 0 off, 1 on, others belong to the application [D10].

    static constexpr can::key key = key_of('A', 5);
    static constexpr std::array<std::uint8_t, 1> frame_lengths{5};
    static constexpr std::string_view name = "actuator_state", section = "3";
    static constexpr fields layout{
        field<&actuator_state::node, wire::u8>{"node", {}, "node"},
        field<&actuator_state::message_id, wire::followed_by<wire::u8, 'A'>>{"message_id", message_ids, "that of the request"},
        field<&actuator_state::actuator, wire::u8>{"actuator", {}, "actuator"},
        field<&actuator_state::state, wire::u8>{"state", {}, "0 off, 1 on, others belong to the application"},
    };
    friend constexpr bool operator==(const actuator_state&, const actuator_state&) = default;
};

/// CHANGE ACTUATOR, master to node and echoed back [D12]. [can §4]
struct set_actuator {
    std::uint8_t node = 0;
    std::uint8_t message_id = 0;  ///< 0..200.
    std::uint8_t actuator = 0;
    std::uint8_t state = 0;       ///< 0 off, 1 on, others belong to the application [D10].

    static constexpr can::key key = key_of('M', 5);
    static constexpr std::array<std::uint8_t, 1> frame_lengths{5};
    static constexpr std::string_view name = "set_actuator", section = "4";
    static constexpr fields layout{
        field<&set_actuator::node, wire::u8>{"node", {}, "node"},
        field<&set_actuator::message_id, wire::followed_by<wire::u8, 'M'>>{"message_id", message_ids, "repeated in the reply"},
        field<&set_actuator::actuator, wire::u8>{"actuator", {}, "actuator"},
        field<&set_actuator::state, wire::u8>{"state", {}, "0 off, 1 on, others belong to the application"},
    };
    friend constexpr bool operator==(const set_actuator&, const set_actuator&) = default;
};

/// SET CLOCK, central master to everyone and echoed back. [can §5]
struct set_clock {
    std::uint8_t node = 0;            ///< `global_node` by the document's text [D11].
    std::uint8_t message_id = 0;      ///< 0..200.
    std::uint16_t year = 0;           ///< 0..9999.
    std::uint8_t month = 0;           ///< 1..12.
    std::uint8_t day = 0;             ///< 1..31.
    std::uint8_t hour = 0;            ///< 0..23.
    std::uint8_t minute = 0;          ///< 0..59.
    std::uint8_t second = 0;          ///< 0..59.

    static constexpr can::key key = key_of('C', 8);
    static constexpr std::array<std::uint8_t, 2> frame_lengths{8, 2};
    static constexpr std::string_view name = "set_clock", section = "5";
    static constexpr fields layout{
        field<&set_clock::node, wire::u8>{"node", {}, "99: the masters; nodes take the time too"},
        field<&set_clock::message_id, wire::followed_by<wire::u8, 'C'>>{"message_id", message_ids, "repeated in the reply"},
        field<&set_clock::year, wire::century_year>{"year", {}, "century, then year: 20, 11 is 2011"},
        field<&set_clock::month, wire::u8>{"month", months, "month"},
        field<&set_clock::day, wire::u8>{"day", days, "day"},
        field<&set_clock::hour, wire::u8>{"hour", hours, "hour"},
        field<&set_clock::minute, wire::u8>{"minute", sixtieths, "minute"},
        field<&set_clock::second, wire::u8>{"second", sixtieths, "second"},
    };
    friend constexpr bool operator==(const set_clock&, const set_clock&) = default;
};

/// Every message of the document.
using messages = message_list<define_function, read_sensors, sensor_readings, read_actuator, actuator_state, set_actuator, set_clock>;

/// True when `reply` is the confirmation of `request`: F, M and C are answered by the same frames, and no bit tells
/// which of the two a frame is. [can §1, §4, §5]
template <class M>
    requires(std::is_same_v<M, define_function> || std::is_same_v<M, set_actuator> || std::is_same_v<M, set_clock>)
constexpr bool is_echo_of(const M& request, const M& reply) noexcept { return request == reply; }

}  // namespace trama::can
