// No decoder reads past its input: the input ends where readable memory ends.

#include <sys/mman.h>
#include <unistd.h>

#include "laws/can_subject.hpp"
#include "laws/daisy_subject.hpp"
#include "laws/gateway_subject.hpp"
#include "laws/listener.hpp"

namespace trama::test {
namespace {

/// Some pages, the last of which may not be touched.
class guarded {
public:
    guarded() : page_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))) {
        void* at = mmap(nullptr, pages * page_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (at == MAP_FAILED) return;
        memory_ = static_cast<std::uint8_t*>(at);
        if (mprotect(memory_ + (pages - 1) * page_, page_, PROT_NONE) != 0) memory_ = nullptr;
    }
    ~guarded() { if (memory_ != nullptr) munmap(memory_, pages * page_); }
    guarded(const guarded&) = delete;
    guarded& operator=(const guarded&) = delete;

    bool usable() const { return memory_ != nullptr; }
    /// A copy of `units` whose end is the end of the readable pages.
    template <class Unit>
    std::span<const Unit> end_with(std::span<const Unit> units) {
        auto* at = memory_ + (pages - 1) * page_ - units.size_bytes();
        if (!units.empty()) std::memcpy(at, units.data(), units.size_bytes());
        return {reinterpret_cast<const Unit*>(at), units.size()};
    }

private:
    static constexpr std::size_t pages = 64;
    std::size_t page_;
    std::uint8_t* memory_ = nullptr;
};

/// EXPECT_TRUE where it would be compiled once for each message.
[[gnu::noinline]] void holds(bool is_so, std::string_view message) { EXPECT_TRUE(is_so) << message; }

template <class F>
class guard_page : public testing::Test {};
using formats = testing::Types<daisy::format, can::format, gateway::format>;
TYPED_TEST_SUITE(guard_page, formats);

TYPED_TEST(guard_page, is_never_touched_wherever_a_chunk_ends) {
    guarded memory_end;
    ASSERT_TRUE(memory_end.usable());
    std::uint64_t covered = 0;
    for (const traffic kind : all_traffic)
        for (std::uint64_t seed = 1; seed != 6; ++seed) {
            rng random(seed);
            const auto stream = subject<TypeParam>::random_stream(random, kind, 500);
            const std::span<const typename TypeParam::unit> all(stream);
            for (std::size_t end = 0; end <= all.size(); ++end) {
                typename TypeParam::decoder decoder;
                // The first chunk ends at `end`, the second 40 units later.
                for (const auto chunk : {all.first(end), all.subspan(end, std::min<std::size_t>(40, all.size() - end))})
                    read<TypeParam>(decoder, memory_end.end_with(chunk), [&](const auto& e) { covered += e.length; });
            }
        }
    EXPECT_GT(covered, 0U);
}

TYPED_TEST(guard_page, is_never_touched_by_reading_the_fields_of_a_body) {
    guarded memory_end;
    ASSERT_TRUE(memory_end.usable());
    rng random(7);
    memory views;
    for (int round = 0; round != 20; ++round)
        TypeParam::messages::each([&]<class M>() {
            const M m = random_message<M>(random, manners::valid, views);
            octets body(body_size(m));
            store_body(body.data(), m);
            M back{};
            const error why = load_body(memory_end.end_with(std::span<const std::uint8_t>(body)), back);
            holds(!why && back == m, M::name);
            if (body.empty()) return;
            body[random.below(body.size())] = static_cast<std::uint8_t>(random.below(256));
            (void)load_body(memory_end.end_with(std::span<const std::uint8_t>(body)), back);
        });
}

TYPED_TEST(guard_page, is_never_written_by_an_encoder_that_fills_its_buffer) {
    guarded memory_end;
    ASSERT_TRUE(memory_end.usable());
    rng random(11);
    memory views;
    TypeParam::messages::each([&]<class M>() {
        const M m = random_message<M>(random, manners::valid, views);
        const auto envelope = subject<TypeParam>::template random_envelope<M>(random, manners::valid);
        const std::vector<typename TypeParam::unit> blank(TypeParam::encoded_size(m));
        const auto out = memory_end.end_with(std::span<const typename TypeParam::unit>(blank));
        holds(bool(TypeParam::encode(envelope, m, std::span(const_cast<typename TypeParam::unit*>(out.data()), out.size()))), M::name);
    });
}

TEST(guard_page, is_never_touched_by_the_helpers_on_bytes) {
    guarded memory_end;
    ASSERT_TRUE(memory_end.usable());
    for (std::size_t n = 0; n != 300; ++n) {
        const octets printable(n, 'x');
        const auto bytes = memory_end.end_with(std::span<const std::uint8_t>(printable));
        EXPECT_TRUE(all_printable(bytes.data(), n));
        EXPECT_EQ(printable_run(bytes.data(), n), n);
        EXPECT_EQ(xor_of(bytes), n % 2 == 0 ? 0 : 'x');
    }
}

}  // namespace
}  // namespace trama::test
