// order_slots against the document's rules, over every sequence of operations.
#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>
#include <utility>

#include "reference/order_slots.hpp"
#include "trama/gateway/order_slots.hpp"

namespace gateway = trama::gateway;
using gateway::order_slots;
using gateway::order_use;
using gateway::transit_order;
using gateway::transit_phase;
using trama_reference::plain_cart;

namespace {

enum operation { new_order, phase_none, phase_go, phase_transiting, phase_done, cancel, operations };
constexpr std::array phases{transit_phase::none, transit_phase::go_transit, transit_phase::transiting, transit_phase::transit_done};
const std::array<std::string, 4> phase_words{"none", "go_transit", "transiting", "transit_done"};

transit_order numbered(int number) {
    transit_order o{};
    o.station_id = static_cast<std::uint32_t>(number);
    o.transit_id = trama::text<10>(std::to_string(number));
    return o;
}

void expect_invariants(const order_slots& slots) {
    for (const order_use use : {order_use::previous, order_use::current, order_use::next}) {
        int n = 0;
        for (const transit_order& o : slots.orders()) n += o.use == use ? 1 : 0;
        ASSERT_LE(n, 1) << trama::name_of(use);
    }
    const transit_order* next = slots.find(order_use::next);
    const transit_order* current = slots.find(order_use::current);
    if (next != nullptr) {
        ASSERT_NE(current, nullptr) << "a next waits behind nothing";
        ASSERT_NE(current->phase, transit_phase::transit_done) << "a next waits behind a finished transit";
        ASSERT_EQ(next->phase, transit_phase::none);
    }
    if (const transit_order* previous = slots.find(order_use::previous)) { ASSERT_EQ(previous->phase, transit_phase::transit_done); }
    for (const transit_order& o : slots.orders()) {
        if (o.use == order_use::unused) { ASSERT_EQ(o, transit_order{}); }
    }
}

void expect_same(const order_slots& slots, const plain_cart& cart) {
    for (std::size_t i = 0; i != 2; ++i) {
        const transit_order& o = slots.orders()[i];
        ASSERT_EQ(trama::name_of(o.use), cart.slot[i].use);
        ASSERT_EQ(trama::name_of(o.phase), cart.slot[i].phase);
        ASSERT_EQ(o.station_id, static_cast<std::uint32_t>(cart.slot[i].order));
    }
}

void apply(int op, int number, order_slots& slots, plain_cart& cart) {
    if (op == new_order) {
        const bool place = slots.has_place();
        const transit_order* placed = slots.accept(numbered(number));
        ASSERT_EQ(placed != nullptr, cart.order(number));
        ASSERT_EQ(placed != nullptr, place);
        if (placed != nullptr) { ASSERT_EQ(placed->station_id, static_cast<std::uint32_t>(number)); }
    } else if (op == cancel) {
        ASSERT_EQ(slots.cancel(), static_cast<std::size_t>(cart.cancel()));
    } else {
        const auto i = static_cast<std::size_t>(op - phase_none);
        ASSERT_EQ(slots.advance(phases[i]), cart.phase(phase_words[i]));
    }
}

// Every sequence of `depth` more operations.
void explore(const order_slots& slots, const plain_cart& cart, int depth, int number, std::uint64_t& seen) {
    ++seen;
    if (depth == 0) return;
    for (int op = 0; op != operations; ++op) {
        order_slots s = slots;
        plain_cart c = cart;
        ASSERT_NO_FATAL_FAILURE(apply(op, number, s, c));
        ASSERT_NO_FATAL_FAILURE(expect_invariants(s));
        ASSERT_NO_FATAL_FAILURE(expect_same(s, c));
        ASSERT_NO_FATAL_FAILURE(explore(s, c, depth - 1, number + 1, seen));
    }
}

using state = std::array<std::pair<order_use, transit_phase>, 2>;
state state_of(const order_slots& s) {
    return {{{s.orders()[0].use, s.orders()[0].phase}, {s.orders()[1].use, s.orders()[1].phase}}};
}

}  // namespace

TEST(order_slots, follows_the_document_over_every_sequence_of_seven_operations) {
    std::uint64_t seen = 0;
    explore({}, {}, 7, 1, seen);
    EXPECT_EQ(seen, 335923U);  // 1 + 6 + 6^2 + … + 6^7
}

TEST(order_slots, keeps_its_invariants_in_every_state_that_any_sequence_can_reach) {
    // What a slot holds besides use and phase never decides, so the reachable states close after a few steps.
    std::set<state> known{state_of({})};
    std::vector<std::pair<order_slots, plain_cart>> open{{order_slots{}, plain_cart{}}};
    int number = 0;
    while (!open.empty()) {
        const auto [slots, cart] = open.back();
        open.pop_back();
        for (int op = 0; op != operations; ++op) {
            order_slots s = slots;
            plain_cart c = cart;
            ASSERT_NO_FATAL_FAILURE(apply(op, ++number, s, c));
            ASSERT_NO_FATAL_FAILURE(expect_invariants(s));
            ASSERT_NO_FATAL_FAILURE(expect_same(s, c));
            if (known.insert(state_of(s)).second) open.emplace_back(s, c);
        }
    }
    // By hand, c a current and C a finished one: both unused 1; c/C with unused behind it 4; c with next, both ways
    // round 6; previous with c/C, both ways round 8; previous with unused, both ways round 2.
    EXPECT_EQ(known.size(), 21U);
}

TEST(order_slots, begins_unused) {
    constexpr order_slots slots;
    static_assert(slots.orders()[0].use == order_use::unused && slots.orders()[1].use == order_use::unused);
    static_assert(slots.has_place() && slots.find(order_use::current) == nullptr);
    EXPECT_NE(slots.find(order_use::unused), nullptr);
}

TEST(order_slots, takes_load_and_unload_one_after_the_other) {
    constexpr auto run = [] {
        order_slots s;
        transit_order load{}, unload{};
        load.type = gateway::order_type::load;
        unload.type = gateway::order_type::unload;
        bool good = s.accept(load)->use == order_use::current && s.accept(unload)->use == order_use::next;
        good = good && s.accept(load) == nullptr;
        good = good && s.advance(transit_phase::transiting) && s.advance(transit_phase::transit_done);
        good = good && s.orders()[0].use == order_use::previous && s.orders()[1].use == order_use::current;
        return good && s.orders()[1].phase == transit_phase::go_transit;
    };
    static_assert(run());
    EXPECT_TRUE(run());
}

TEST(order_slots, a_finished_current_without_a_next_stays_until_the_next_order) {
    order_slots s;
    s.accept(numbered(1));
    EXPECT_TRUE(s.advance(transit_phase::transit_done));
    EXPECT_EQ(s.find(order_use::current)->phase, transit_phase::transit_done);
    EXPECT_FALSE(s.advance(transit_phase::go_transit)) << "a finished transit begins again";
    EXPECT_EQ(s.cancel(), 0U) << "a finished transit is cancelled";
    s.accept(numbered(2));
    EXPECT_EQ(s.find(order_use::previous)->station_id, 1U);
    EXPECT_EQ(s.find(order_use::current)->station_id, 2U);
    EXPECT_EQ(s.find(order_use::current)->phase, transit_phase::go_transit);
}

TEST(order_slots, assigns_only_to_transits_that_are_current_or_next) {
    order_slots s;
    s.accept(numbered(1));
    s.accept(numbered(2));
    EXPECT_TRUE(s.assign<&transit_order::last_command>("1", "lift"));
    EXPECT_TRUE(s.assign<&transit_order::inputs>("2", "0101"));
    EXPECT_EQ(s.find("1")->last_command.view(), "lift");
    EXPECT_EQ(s.find("2")->inputs.view(), "0101");
    EXPECT_FALSE(s.assign<&transit_order::cargo_id>("3", "box"));
    s.advance(transit_phase::transit_done);
    EXPECT_FALSE(s.assign<&transit_order::cargo_id>("1", "box")) << "transit 1 is over";
    EXPECT_TRUE(s.assign<&transit_order::cargo_id>("2", "box"));
    EXPECT_EQ(order_slots{}.find(trama::text<10>{}), nullptr) << "an unused slot bears no name";
}

TEST(order_slots, assigns_nothing_to_a_finished_transit_whether_another_came_or_not) {
    order_slots s;
    s.accept(numbered(1));
    s.advance(transit_phase::transit_done);
    ASSERT_EQ(s.find("1")->use, order_use::current);
    EXPECT_FALSE(s.assign<&transit_order::last_command>("1", "lift")) << "it is the current one still";
    s.accept(numbered(2));
    ASSERT_EQ(s.find("1")->use, order_use::previous);
    EXPECT_FALSE(s.assign<&transit_order::last_command>("1", "lift"));
    EXPECT_EQ(s.find("1")->last_command.view(), "");
}

TEST(order_slots, assigns_nothing_that_a_cart_state_cannot_carry) {
    order_slots s;
    s.accept(numbered(1));
    EXPECT_TRUE(s.assign<&transit_order::outputs>("1", "ten~chars!"));
    for (const std::string_view bad : {"twelve chars", "v\xc3\xa1lvula", "a\x03", "\x7f", "tab\t"}) {
        EXPECT_FALSE(s.assign<&transit_order::outputs>("1", bad)) << bad;
    }
    EXPECT_EQ(s.find("1")->outputs.view(), "ten~chars!");
}
