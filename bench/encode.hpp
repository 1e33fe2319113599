#pragma once
// Encoding races: messages in memory, packets out. The limit is a memcpy of what comes out.
#include <memory>
#include <variant>

#include "limits.hpp"
#include "random_message.hpp"
#include "tasks.hpp"

namespace trama::bench {

/// Encodes all of `inputs` to `out`, which has room, and returns the units written.
template <class Input, class Unit>
using encoder = std::size_t (*)(std::span<const Input> inputs, std::span<Unit> out);
template <class Input>
using shared_inputs = std::shared_ptr<const std::vector<Input>>;

/// Of a byte that is read back; formats add theirs for other units.
void each_unit_word(std::uint8_t byte, auto&& f) { f(byte); }

template <class Unit>
class encoding {
public:
    encoding(race& r, std::uint64_t messages, std::size_t most_units) : race_(r), messages_(messages), room_(most_units + 64) {}

    /// The first one added must be the library: what it writes is what the limit copies. The timed code tells how much it
    /// wrote, the proof every unit of it.
    template <class Input>
    void add(const char* name, role part, const shared_inputs<Input>& inputs, encoder<Input, Unit> encode) {
        const auto out = std::make_shared<std::vector<Unit>>(room_);
        const std::size_t size = encode(*inputs, *out) * sizeof(Unit);
        if (race_.contenders.empty()) {
            const auto copy = std::make_shared<std::vector<std::uint8_t>>(size);
            race_.contenders.push_back({"memcpy of the output", "whole", role::limit, size, messages_,
                                        [out, copy, size] { return copy_all({reinterpret_cast<const std::uint8_t*>(out->data()), size}, *copy); }});
        }
        const auto run = [inputs, out, encode] { return std::span<const Unit>(*out).first(encode(*inputs, *out)); };
        race_.contenders.push_back({name, "whole", part, size, messages_, [run, n = messages_] { return tally{n, run().size(), 0}; }});
        race_.answers.push_back({whole_stream, name, "whole", [run, n = messages_] { return tally{n, sum_of(run()), 0}; }});
        library_ = library_ ? library_ : run;
    }
    /// What the hand-written decoder must read out of what the library wrote.
    void prove_by_reading(tally (*read)(std::span<const Unit>), const tally& expected) {
        race_.answers.push_back({"read back", "trama", "whole", [read, run = library_] { return read(run()); }});
        race_.answers.push_back({"read back", "generator", {}, [expected] { return expected; }});
    }

private:
    static std::uint64_t sum_of(std::span<const Unit> out) {
        ordered_sum sum;
        for (const Unit& one : out) each_unit_word(one, [&](std::uint64_t word) { sum.add(word); });
        return sum.value;
    }
    race& race_;
    std::uint64_t messages_;
    std::size_t room_;
    std::function<std::span<const Unit>()> library_{};
};

inline void add_encoding(std::vector<entry>& all, const scale& sizes, const char* format, const char* workload, void (*fill)(race&, std::size_t bytes)) {
    for (const std::size_t bytes : {sizes.large, sizes.small}) {
        const race empty{format, workload, size_name(bytes), "encode"};
        all.push_back({empty.id(), [empty, fill, bytes] {
            race r = empty;
            fill(r, bytes);
            return r;
        }});
    }
}

template <class List>
struct variant_of;
template <class... M>
struct variant_of<message_list<M...>> {
    using type = std::variant<M...>;
};
/// Any message of a format and where it goes.
template <class F>
struct any_message {
    typename F::envelope addresses;
    typename variant_of<typename F::messages>::type message;
};

template <class F>
std::size_t encode_any(std::span<const any_message<F>> in, std::span<typename F::unit> out) {
    std::size_t at = 0;
    for (const any_message<F>& one : in)
        std::visit([&](const auto& m) { if (const auto size = F::encode(one.addresses, m, out.subspan(at))) at += *size; }, one.message);
    return at;
}

/// So many messages of all kinds whose size is fixed, at random.
template <class F>
shared_inputs<any_message<F>> any_messages(std::size_t count) {
    auto all = std::make_shared<std::vector<any_message<F>>>();
    dice d(8);
    arena memory;
    while (all->size() < count)
        F::messages::at(d.below(F::messages::count), [&]<class M>() {
            if constexpr (M::layout.fixed) all->push_back({traits<F>::template addresses<M>(d), random_message<M>(d, memory)});
        });
    return all;
}
/// What a decoder must find in what they are encoded to.
template <class F>
tally fields_of(const std::vector<any_message<F>>& all) {
    ordered_sum sum;
    for (const auto& one : all)
        std::visit([&](const auto& m) { each_message_word<F>(one.addresses, m, [&](std::uint64_t word) { sum.add(word); }); }, one.message);
    return {all.size(), sum.value, 0};
}

}  // namespace trama::bench
