#pragma once
// Which messages the inputs of a replay have reached: `fuzz_daisy_stream --census corpus/` prints it.
#include <bitset>
#include <string>

#include "transcript.hpp"

namespace trama::fuzz {

/// What the driver prints after a replay; a target that keeps a census sets it.
struct census_table {
    std::size_t count = 0;
    bool (*reached)(std::size_t) = nullptr;
    const char* (*name)(std::size_t) = nullptr;
};
inline census_table& current_census() {
    static census_table table;
    return table;
}

template <wire_format F>
class census {
public:
    /// A message of that place in `F::messages` was decoded with its type.
    static void note(std::size_t index) {
        reached_[index] = true;
        current_census() = {F::messages::count, [](std::size_t i) -> bool { return reached_[i]; }, name_of};
    }
    static void note(const record<F>& r) {
        if (r.code != errc::ok || reached_[r.index]) return;
        F::messages::at(r.index, [&]<class M>() {
            M m{};
            if (!load_body(std::span<const std::uint8_t>(r.body), m)) note(r.index);
        });
    }

private:
    static const char* name_of(std::size_t index) {
        static std::string name;
        F::messages::at(index, [&]<class M>() { name = std::string(M::name) + " " + std::to_string(static_cast<unsigned>(M::key)); });
        return name.c_str();
    }
    static inline std::bitset<F::messages::count> reached_{};
};

}  // namespace trama::fuzz

/// Prints `reached <count> of <count>` and the names of those that were not.
extern "C" [[gnu::used]] inline void trama_fuzz_census() {
    const auto& c = trama::fuzz::current_census();
    std::size_t reached = 0;
    for (std::size_t i = 0; i != c.count; ++i) reached += c.reached(i);
    std::printf("reached %zu of %zu message types\n", reached, c.count);
    for (std::size_t i = 0; i != c.count; ++i)
        if (!c.reached(i)) std::printf("missing %s\n", c.name(i));
}
