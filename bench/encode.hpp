#pragma once
// Encoding races: messages in memory, packets out. The limit is a memcpy of what comes out.
#include <memory>

#include "limits.hpp"
#include "tasks.hpp"

namespace trama::bench {

/// Encodes all of `inputs` to `out`, which has room, and returns the units written.
template <class Input, class Unit>
using encoder = std::size_t (*)(std::span<const Input> inputs, std::span<Unit> out);

/// Of a byte that is read back; formats add theirs for other units.
inline std::uint64_t content_of(std::uint8_t byte) { return byte; }

/// What is read back: the number of units, or with `all` a sum that depends on each one's place.
template <class Unit>
tally tally_of(std::span<const Unit> out, std::uint64_t messages, bool all) {
    tally t{messages, out.size(), 0};
    if (all)
        for (const Unit& one : out) t.sum = t.sum * 31 + content_of(one);
    return t;
}

template <class Input, class Unit>
class encoding {
public:
    encoding(race& r, std::shared_ptr<const std::vector<Input>> inputs, std::uint64_t messages_each, std::size_t most_units)
        : race_(r), inputs_(std::move(inputs)), messages_(inputs_->size() * messages_each), room_(most_units * inputs_->size() + 64) {}

    /// The first one added must be the library: what it writes is what the limit copies.
    void add(const char* name, role part, encoder<Input, Unit> encode) {
        const auto out = std::make_shared<std::vector<Unit>>(room_);
        const std::size_t written = encode(*inputs_, *out), size = written * sizeof(Unit);
        if (race_.contenders.empty()) {
            const auto copy = std::make_shared<std::vector<std::uint8_t>>(size);
            race_.contenders.push_back({"memcpy of the output", "whole", role::limit, size, not_compared,
                                        [out, copy, size] { return copy_all({reinterpret_cast<const std::uint8_t*>(out->data()), size}, *copy); }, {}});
        }
        const auto once = [inputs = inputs_, out, encode, messages = messages_](bool all) {
            const std::size_t n = encode(*inputs, *out);
            return tally_of<Unit>(std::span(*out).first(n), messages, all);
        };
        race_.contenders.push_back({name, "whole", part, size, 1, [once] { return once(false); }, [once] { return once(true); }});
    }

private:
    race& race_;
    std::shared_ptr<const std::vector<Input>> inputs_;
    std::uint64_t messages_;
    std::size_t room_;
};

}  // namespace trama::bench
