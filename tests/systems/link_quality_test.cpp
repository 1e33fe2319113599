#include <gtest/gtest.h>

#include <deque>
#include <random>

#include "trama/core/link_quality.hpp"

using trama::link_quality;
using trama::rate_meter;

TEST(rate_meter, sums_up_the_last_window) {
    constexpr auto run = [](std::uint64_t at) {
        rate_meter m(800);  // steps of 100
        m.add(5, 0);
        m.add(7, 150);
        return m.sum(at);
    };
    static_assert(run(150) == 12 && run(799) == 12 && run(800) == 7 && run(899) == 7 && run(900) == 0 && run(1'000'000) == 0);
    EXPECT_EQ(run(799), 12U);
}

TEST(rate_meter, agrees_with_a_list_of_everything_over_random_times) {
    std::mt19937 random(7);
    rate_meter m(800);
    std::deque<std::pair<std::uint64_t, std::uint64_t>> all;
    std::uint64_t now = 0;
    for (int i = 0; i != 20000; ++i) {
        now += random() % 8 == 0 ? random() % 2000 : random() % 60;
        if (random() % 2 == 0) {
            const std::uint64_t amount = random() % 100;
            m.add(amount, now);
            all.emplace_back(now, amount);
        }
        std::uint64_t expected = 0;
        for (const auto& [when, amount] : all) expected += when / 100 + 8 > now / 100 ? amount : 0;
        ASSERT_EQ(m.sum(now), expected) << "at " << now << ", step " << i;
        while (!all.empty() && all.front().first + 2000 < now) all.pop_front();
    }
}

TEST(rate_meter, takes_a_clock_that_goes_backwards_as_the_latest_step) {
    rate_meter m(800);
    m.add(1, 5000);
    m.add(2, 100);
    EXPECT_EQ(m.sum(5000), 3U);
    EXPECT_EQ(m.sum(100), 3U);
}

TEST(link_quality, counts_both_ways_and_keeps_round_trips) {
    constexpr link_quality q = [] {
        link_quality all(1000);
        all.sent(6);
        all.sent(6);
        all.received(9, 40);
        all.lost_step(13);
        all.round_trip.add(30);
        all.round_trip.add(10);
        all.round_trip.add(21);
        return all;
    }();
    static_assert(q.packets_sent == 2 && q.bytes_sent == 12 && q.packets_received == 1 && q.bytes_received == 9);
    static_assert(q.resynchronisations == 1 && q.bytes_skipped == 13);
    static_assert(q.round_trip.count == 3 && q.round_trip.least == 10 && q.round_trip.most == 30 && q.round_trip.last == 21);
    static_assert(q.round_trip.mean() == 20 && trama::round_trips{}.mean() == 0);
    static_assert(q.goodput(40) == 9 && q.goodput(5000) == 0);
    EXPECT_EQ(q.goodput(500), 9U);
}

TEST(round_trips, know_the_least_the_most_and_the_mean) {
    trama::round_trips t;
    EXPECT_EQ(t.mean(), 0U) << "nothing was measured yet";
    for (const std::uint64_t time : {30U, 10U, 20U, 41U}) t.add(time);
    EXPECT_EQ(t.count, 4U);
    EXPECT_EQ(t.least, 10U);
    EXPECT_EQ(t.most, 41U);
    EXPECT_EQ(t.last, 41U);
    EXPECT_EQ(t.mean(), 25U);
}
