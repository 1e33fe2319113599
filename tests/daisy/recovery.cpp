// L6: what a fault can cost. Every schedule, every joining phase, every single-byte fault.
//
// Asserted: after the last damaged byte every intact documented packet that starts 256 bytes later is delivered, to the
// end of the run, which goes on for several times the longest packet. The figures printed are measured, not judged.

#include "daisy/faulty_line.hpp"

namespace trama::test {
namespace {

constexpr std::size_t run_size = 1100;  ///< 256 to the bound, the rest to see whether the footing holds.

class daisy_schedule : public testing::TestWithParam<schedule> {
protected:
    const schedule& s = GetParam();
    tally changed, lost, inserted;

    void expect_bound(const outcome& o, std::string_view kind, std::size_t at, unsigned value) {
        EXPECT_EQ(o.late, 0U) << s.name << ": documented packets lost behind the bound, byte " << at << ' ' << kind << ", value " << value;
    }
    /// Every single-byte fault in the first cycle after `decoder`'s past; `step` leaves out values.
    void every_fault(const daisy::decoder& decoder, unsigned step) {
        const faulty_line clean(s, run_size);
        for (std::size_t at = 0; at != s.cycle.size() && !HasFailure(); ++at) {
            faulty_line broken = clean;
            broken.break_packet(at);
            faulty_line longer = clean;
            longer.insert(at, 0);
            for (unsigned difference = 1; difference < 256; difference += step) {
                const auto value = static_cast<std::uint8_t>(clean[at] ^ difference);
                broken.corrupt(at, value);
                const outcome o = broken.run(decoder, at);
                expect_bound(o, "changed", at, value);
                changed.add(o);
            }
            for (unsigned value = 0; value < 256; value += step) {  // among them the doubled byte
                longer.corrupt(at, static_cast<std::uint8_t>(clean[at] ^ value));
                const outcome o = longer.run(decoder, at);
                expect_bound(o, "inserted", at, value);
                inserted.add(o);
            }
            faulty_line shorter = clean;
            shorter.lose(at);
            const outcome o = shorter.run(decoder, at);
            expect_bound(o, "lost", at, 0);
            lost.add(o);
        }
    }
    void print() const {
        changed.print(s.name, "changed");
        inserted.print(s.name, "inserted");
        lost.print(s.name, "lost");
    }
};

TEST_P(daisy_schedule, finds_its_footing_wherever_it_joins) {
    tally joined;
    for (std::size_t phase = 0; phase != s.cycle.size(); ++phase) {
        faulty_line line(s, 4 * run_size);
        line.join(phase);
        const outcome o = line.run(daisy::decoder{}, 0);
        EXPECT_EQ(o.late, 0U) << "joined at " << phase;
        joined.add(o);
    }
    joined.print(s.name, "joined");
}

TEST_P(daisy_schedule, forgets_any_single_byte_fault_while_in_step) {
    every_fault(decoder_after(repeated(s, 20)), 1);
    print();
}

TEST_P(daisy_schedule, forgets_any_single_byte_fault_wherever_it_joined) {
    // Values in steps, so that the longer schedules stay quick; the decoder in step above sees all of them.
    const unsigned step = s.cycle.size() < 20 ? 1 : s.cycle.size() < 40 ? 7 : 31;
    for (std::size_t phase = 0; phase != s.cycle.size(); ++phase) every_fault(decoder_after(repeated(s, 1, phase)), step);
    print();
}

bool landmark(const octets& p) { return daisy::recovery::is_landmark(p, daisy::index_of(p[1], p[2], p[3])); }

TEST(daisy_recovery, a_text_is_a_landmark_when_it_is_plain) {
    EXPECT_TRUE(landmark(sealed(0, 0x11, 0x81, {})));
    EXPECT_TRUE(landmark(sealed(0, 0x11, 0x82, {'a', '\t', '\r', '\n', 0x20, 0x7E})));
    for (const unsigned c : {0x00U, 0x08U, 0x0BU, 0x0CU, 0x0EU, 0x1FU, 0x7FU, 0x80U, 0xFFU}) EXPECT_FALSE(landmark(sealed(0, 0x11, 0x81, {'a', static_cast<std::uint8_t>(c)}))) << c;
}

TEST(daisy_recovery, an_error_is_a_landmark_when_it_agrees_with_itself) {
    const octets ping{4, 0x11, 0x00, 0x03, 0x99};  // its CRC should be 0x16
    const auto report = [&](octets rejected, std::uint8_t expected) {
        octets data{0};
        append(data, rejected);
        data.push_back(expected);
        return sealed(0x00, 0x11, 0x04, data);
    };
    EXPECT_TRUE(landmark(report(ping, 0x16)));
    EXPECT_FALSE(landmark(report(ping, 0x17)));
    octets longer = ping;
    longer[0] = 5;
    EXPECT_FALSE(landmark(report(longer, 0x17)));
    EXPECT_TRUE(landmark(sealed(0x00, 0x11, 0x04, {1})));
    EXPECT_TRUE(landmark(sealed(0x00, 0x11, 0x04, {200})));
}

TEST(daisy_recovery, a_plain_text_that_holds_a_packet_is_no_landmark) {
    octets inside = sealed(0x21, 0x20, 0x41, octets(5, ' '));  // SET ALL POSITIONS, plain characters all of it
    ASSERT_EQ(inside, text_bytes("\t! A     i"));
    octets text = text_bytes("ab");
    append(text, inside);
    EXPECT_FALSE(landmark(sealed(0, 0x11, 0x81, text)));
    text.back() ^= 1;
    EXPECT_TRUE(landmark(sealed(0, 0x11, 0x81, text))) << "now its CRC is wrong";

    octets behind_a_tab = text_bytes("\t");  // which with the next three bytes looks like a header too
    append(behind_a_tab, sealed(0x21, 0x41, 0x41, octets(5, 'A')));
    ASSERT_EQ(behind_a_tab, text_bytes("\t\t!AAAAAAAi"));
    EXPECT_FALSE(landmark(sealed(0, 0x11, 0x81, behind_a_tab)));
}

TEST(daisy_recovery, a_packet_inside_begins_behind_the_first_byte_at_the_earliest) {
    const octets ping = sealed(0x10, 0x00, 0x03, {});
    octets whole{0};
    append(whole, ping);
    EXPECT_TRUE(daisy::recovery::holds_short_packet(whole));
    EXPECT_FALSE(daisy::recovery::holds_short_packet(ping)) << "not the packet itself";
}

TEST(daisy_recovery, holds_its_bound_on_random_schedules) {
    tally joined, changed;
    for (std::uint64_t seed = 1; seed != 61; ++seed) {
        const schedule s = random_schedule(seed);
        const daisy::decoder in_step = decoder_after(repeated(s, 20));
        const faulty_line clean(s, std::max(run_size, 4 * s.cycle.size()));
        for (std::size_t at = 0; at != s.cycle.size(); ++at) {
            SCOPED_TRACE(testing::Message() << s.name << ", byte " << at);
            faulty_line line = clean;
            line.join(at);
            const outcome o = line.run(daisy::decoder{}, 0);
            EXPECT_EQ(o.late, 0U) << "joined";
            joined.add(o);
            faulty_line broken = clean;
            broken.break_packet(at);
            for (unsigned difference = 1; difference < 256; difference += 12) {
                broken.corrupt(at, static_cast<std::uint8_t>(clean[at] ^ difference));
                const outcome c = broken.run(in_step, at);
                EXPECT_EQ(c.late, 0U) << "changed by " << difference;
                changed.add(c);
            }
        }
    }
    joined.print("random schedules", "joined");
    changed.print("random schedules", "changed");
}

INSTANTIATE_TEST_SUITE_P(recovery, daisy_schedule, testing::ValuesIn(all_schedules()), [](const auto& one) {
    std::string name = one.param.name;
    std::erase(name, ',');
    for (char& c : name) c = c == ' ' ? '_' : c;
    return name;
});

}  // namespace
}  // namespace trama::test
