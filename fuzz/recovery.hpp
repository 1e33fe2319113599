#pragma once
// After garbage, or after a mutation of good traffic, intact messages must come through again.
#include "samples.hpp"
#include "transcript.hpp"

namespace trama::fuzz {

/// Clean traffic and where in it each packet begins; only messages that speak for themselves.
template <wire_format F>
struct traffic {
    std::vector<typename F::unit> units;
    std::vector<std::size_t> begins;
    std::vector<octets> bodies;
};

template <wire_format F>
void add_packet(traffic<F>& t, dice& d) {
    auto one = random_sample<F>(d);
    t.begins.push_back(t.units.size());
    t.bodies.push_back(std::move(one.body));
    t.units.insert(t.units.end(), one.units.begin(), one.units.end());
}

template <wire_format F>
traffic<F> clean_traffic(dice& d, std::size_t count) {
    traffic<F> t;
    while (t.begins.size() != count) add_packet(t, d);
    return t;
}

/// Where the bound begins to count in `units`, of which the first `damaged` are what was heard before `clean`: behind the last window
/// that is no packet and could be taken for one.
template <wire_format F>
std::size_t settled_place(std::span<const typename F::unit> units, std::size_t damaged, const traffic<F>& clean) {
    std::size_t settled = damaged;
    for (std::size_t at = 0, next = 0; at != units.size(); ++at) {
        if (next != clean.begins.size() && at == damaged + clean.begins[next]) {
            ++next;
        } else if (at + traits<F>::recovery_bound >= damaged && traits<F>::could_be_packet(units.subspan(at))) {
            settled = std::max(settled, at + units[at] + 1);
        }
    }
    return settled;
}

/// The input is what was heard on the line before: whatever it is, the traffic behind it arrives from the published bound on.
template <wire_format F>
int recovery(std::span<const std::uint8_t> input) {
    using unit = typename F::unit;
    constexpr std::size_t bound = traits<F>::recovery_bound;
    dice d(hash_of(input));
    auto units = traits<F>::units_from(input);
    const std::size_t damaged = units.size();
    // As much traffic as it takes for something to lie past the bound.
    traffic<F> clean;
    std::size_t settled = damaged;
    for (int turns = 64; units.size() < settled + bound + 256; --turns) {
        require(turns != 0, "random traffic is not for ever ambiguous");
        const std::size_t enough = clean.units.size() + bound + 256;
        while (clean.units.size() < enough) add_packet(clean, d);
        units.resize(damaged);
        units.insert(units.end(), clean.units.begin(), clean.units.end());
        settled = settled_place(std::span<const unit>(units), damaged, clean);
    }
    const auto events = transcript<F>(std::span<const unit>(units), [&] { return units.size(); });
    std::size_t e = 0, checked = 0;
    for (std::size_t i = 0; i != clean.begins.size(); ++i) {
        const std::size_t begin = damaged + clean.begins[i];
        if (begin < settled + bound) continue;
        while (e != events.size() && events[e].offset < begin) ++e;
        require(e != events.size() && events[e].offset == begin && events[e].code == errc::ok, "an intact packet past the bound is delivered");
        require(events[e].body == clean.bodies[i], "an intact packet is delivered unchanged");
        ++checked;
    }
    require(checked != 0, "something lies past the bound");
    return 0;
}

}  // namespace trama::fuzz
