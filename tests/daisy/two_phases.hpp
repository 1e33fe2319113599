#pragma once
// Streams that can be read in two phases: in the one all packets are documented, in the other all are intact, some of
// them documented and some not. Chance seldom makes such a stream; bytes that repeat, as on a line at rest, may.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "laws/rng.hpp"
#include "trama/daisy/format.hpp"

namespace trama::test {

using namespace daisy;


struct kind {
    std::uint8_t destination = 0, source = 0, command = 0;
    std::size_t data = 0;             ///< Its size.
    int first = -1;                   ///< The first byte of DATA where it is given.
    bool documented = true;

    std::size_t size() const { return data + min_packet; }
};
struct place {
    std::size_t at = 0;
    kind what;
};
/// Bytes that repeat. The packets of either phase fill them, those of the false one round the end.
struct two_phases {
    octets period;
    std::vector<place> truth, lie;
};

/// All documented messages, lists and texts in some lengths.
inline std::vector<kind> documented_kinds() {
    std::vector<kind> all;
    messages::each([&]<class M>() {
        const std::uint8_t command = command_of(M::key);
        const auto family = static_cast<unsigned>(family_of(M::key));
        const std::uint8_t one = board(family < 6 ? std::max(family, 1U) : 1, 1).octet;
        kind k{one, 0, command};
        if ((command & response_bit) != 0) std::swap(k.destination, k.source);
        if constexpr (M::layout.fixed) {
            k.data = M::layout.size;
            all.push_back(k);
        } else if constexpr (requires(M m) { m.readings; }) {
            for (const int sensors : {0x01, 0x03, 0x0F, 0x3F}) {
                k.first = sensors;
                k.data = 1 + 2 * static_cast<std::size_t>(std::popcount(static_cast<unsigned>(sensors)));
                all.push_back(k);
            }
        } else if constexpr (is_text<M>) {
            for (const std::size_t size : {5U, 20U, 40U, 60U, 120U, 200U}) {
                k.data = size;
                all.push_back(k);
            }
        }
    });
    return all;
}

/// Bytes that are given and sums that must be zero, one equation for each packet; what is left is drawn.
class puzzle {
public:
    explicit puzzle(std::size_t size) : given_(size, -1) {}

    /// False if the head of `p` does not go with the bytes given so far.
    bool lay(const place& p) {
        const int head[]{static_cast<int>(p.what.size() - 1), p.what.destination, p.what.source, p.what.command, p.what.first};
        auto given = given_;
        for (std::size_t i = 0; i != (p.what.first >= 0 ? 5U : 4U); ++i) {
            int& byte = given[(p.at + i) % given.size()];
            if (byte >= 0 && byte != head[i]) return false;
            byte = head[i];
        }
        given_ = std::move(given);
        equations_.push_back(p);
        return true;
    }
    std::optional<octets> solve(rng& d) const {
        const std::size_t n = given_.size();
        std::vector<std::vector<bool>> rows;
        octets sums;
        for (const place& p : equations_) {
            std::vector<bool> row(n);
            std::uint8_t sum = 0;
            for (std::size_t i = 0; i != p.what.size(); ++i) {
                const std::size_t q = (p.at + i) % n;
                if (given_[q] >= 0) sum = static_cast<std::uint8_t>(sum ^ given_[q]);
                else row[q] = !row[q];
            }
            rows.push_back(row);
            sums.push_back(sum);
        }
        std::vector<std::optional<std::size_t>> solved_for(rows.size());
        octets bytes(n);
        for (std::size_t q = 0; q != n; ++q) bytes[q] = static_cast<std::uint8_t>(given_[q] >= 0 ? static_cast<unsigned>(given_[q]) : d.below(256));
        for (std::size_t i = 0; i != rows.size(); ++i) {
            const auto free = static_cast<std::size_t>(std::count(rows[i].begin(), rows[i].end(), true));
            if (free == 0) {
                if (sums[i] != 0) return std::nullopt;
                continue;
            }
            std::size_t q = 0;
            for (std::size_t left = d.below(free); !rows[i][q] || left != 0; ++q) left -= rows[i][q] ? 1 : 0;
            solved_for[i] = q;
            bytes[q] = 0;
            for (std::size_t other = 0; other != rows.size(); ++other) {
                if (other == i || !rows[other][q]) continue;
                for (std::size_t z = 0; z != n; ++z) rows[other][z] = rows[other][z] != rows[i][z];
                sums[other] ^= sums[i];
            }
        }
        for (std::size_t i = 0; i != rows.size(); ++i) {
            if (!solved_for[i]) continue;
            std::uint8_t value = sums[i];
            for (std::size_t z = 0; z != n; ++z)
                if (rows[i][z] && z != *solved_for[i]) value = static_cast<std::uint8_t>(value ^ bytes[z]);
            bytes[*solved_for[i]] = value;
        }
        return bytes;
    }

private:
    std::vector<int> given_;
    std::vector<place> equations_;
};

/// True when from `at` on one documented packet follows the other up to `end`.
inline bool reads_as_documented(const octets& stream, std::size_t at, std::size_t end) {
    const window w({}, stream);
    while (at < end) {
        if (!recovery::is_intact(w, at, stream.size())) return false;
        at += stream[at] + 1U;
    }
    return true;
}

/// A stream that nobody could decide about: more than one phase is documented all through, or a true text holds a
/// documented message of fixed size.
inline bool is_undecidable(const two_phases& t) {
    const std::size_t period = t.period.size();
    const octets stream = repeated(t.period, 6 * max_packet / period + 3);
    for (std::size_t at = 0; at != period; ++at) {
        const bool true_place = std::any_of(t.truth.begin(), t.truth.end(), [&](const place& p) { return p.at == at; });
        if (!true_place && reads_as_documented(stream, at, stream.size() - 2 * max_packet)) return true;
    }
    for (const place& text : t.truth)
        for (std::size_t at = text.at + 1; at + min_packet <= text.at + text.what.size(); ++at) {
            const window w({}, std::span(stream).first(text.at + text.what.size()));
            if (recovery::is_intact(w, at, w.size()) && recovery::is_landmark_at(w, at)) return true;
        }
    return false;
}

/// Draws one; nothing if the dice do not come to one this time.
inline std::optional<two_phases> draw_two_phases(rng& d) {
    static const auto documented = documented_kinds();
    two_phases t;
    std::size_t size = 0;
    for (std::size_t left = 1 + d.below(3); left != 0; --left) {
        t.truth.push_back({size, documented[d.below(documented.size())]});
        size += t.truth.back().what.size();
    }
    puzzle bytes(size);
    for (const place& p : t.truth)
        if (!bytes.lay(p)) return std::nullopt;
    const std::size_t start = 1 + d.below(size - 1), seldom = 2 + d.below(3);
    bool odd = false;
    for (std::size_t left = size; left != 0;) {
        const std::size_t before = left;
        for (int tries = 0; tries != 200 && before == left; ++tries) {
            kind k = documented[d.below(documented.size())];
            if (d.below(seldom) == 0) k = {static_cast<std::uint8_t>(d.below(2) != 0 ? 0x77 : 0x11), static_cast<std::uint8_t>(d.below(2) != 0 ? 0x00 : 0x22), 0x7A, d.below(d.below(3) == 0 ? 200 : 20), -1, false};
            if (k.size() > left && !k.documented && left >= min_packet) k.data = left - min_packet;
            const place p{(start + size - left) % size, k};
            if (k.size() > left || !bytes.lay(p)) continue;
            t.lie.push_back(p);
            odd = odd || !k.documented;
            left -= k.size();
        }
        if (before == left) return std::nullopt;
    }
    const auto solved = bytes.solve(d);
    if (!odd || !solved) return std::nullopt;
    t.period = *solved;
    if (is_undecidable(t)) return std::nullopt;
    return t;
}

}  // namespace trama::test
