#pragma once
// The races of a format: every workload in both sizes, every task that makes sense on it, every way to cut the stream.
#include "limits.hpp"
#include "reference.hpp"

namespace trama::bench {

enum class condition { clean, damaged, noise };

/// A kind of traffic.
template <class F>
struct workload {
    const char* name;
    condition is;
    std::function<stream<F>(std::size_t bytes)> make;
};

/// `session`, and the same with faults in one of 1000 and of 100 places of `spacing` units.
template <class F>
void add_session(std::vector<workload<F>>& all, stream<F> (*session)(std::size_t bytes), std::size_t spacing, std::uint64_t seed) {
    const auto with_one_in = [=](std::uint64_t one_in) { return [=](std::size_t bytes) { return damaged(session(bytes), one_in, spacing, seed); }; };
    all.push_back({"session, no damage", condition::clean, session});
    all.push_back({"session, 0.1 % damaged", condition::damaged, with_one_in(1000)});
    all.push_back({"session, 1 % damaged", condition::damaged, with_one_in(100)});
}

/// The stream of a workload. The last two are kept, since the races of a workload follow each other.
template <class F>
shared_stream<F> stream_of(const workload<F>& w, std::size_t bytes) {
    static std::vector<std::pair<std::string, shared_stream<F>>> shelf;
    const std::string name = w.name + size_name(bytes);
    for (std::size_t i = 0; i != shelf.size(); ++i)
        if (shelf[i].first == name) {
            std::swap(shelf[i], shelf.back());
            return shelf.back().second;
        }
    if (shelf.size() == 2) shelf.erase(shelf.begin());
    shelf.emplace_back(name, std::make_shared<const stream<F>>(w.make(bytes)));
    return shelf.back().second;
}

/// "whole" or the number of bytes.
inline std::string chunk_name(std::size_t bytes) {
    return bytes == 0 ? "whole" : bytes % 1024 == 0 ? std::to_string(bytes / 1024) + " Ki" : std::to_string(bytes);
}

/// The races on one stream, one task each.
template <class F, task T>
class race_builder {
public:
    race_builder(race& r, const workload<F>& w, std::size_t bytes) : race_(r), workload_(w), bytes_(bytes), stream_(stream_of(w, bytes)) {
        if (w.is != condition::noise) messages_ = stream_->made_of.messages;
    }

    void build(const workload<F>& clean) {
        traits<F>::add_limits(race_, stream_, T, workload_.is == condition::clean);
        add_memory_limits(race_, bytes_of<F>(stream_->data), messages_);
        ask_reference("the first 64 KiB", {std::span(stream_->data).first(std::min(stream_->data.size(), heard_by_reference / unit))}, stream_);
        if (workload_.is == condition::clean) ask_generator();
        if (T == task::validated) ask_about_ranges();
        if (workload_.is == condition::clean)
            for (const auto& code : traits<F>::by_hand()) add_by_hand(code);
        for (const std::size_t bytes : traits<F>::chunks)
            if (bytes == 0 || bytes >= 64 || T == task::framing || T == task::typed) add_library("trama", bytes, timed(T), by_library<F, T, true>);  // the rest costs the same however it is cut
        if constexpr (T == task::typed && requires { traits<F>::typed_ahead(); }) add_library("trama, read_ahead", 0, traits<F>::typed_ahead(), typed<F, true, false, true>);
        if (T == task::selected) add_comparison("trama, framing alone", stream_, task::framing);
        if (workload_.is != condition::clean) add_comparison(traits<F>::clean_name, stream_of(clean, bytes_), T);
    }

private:
    static constexpr std::size_t unit = sizeof(typename F::unit), heard_by_reference = std::size_t{64} << 10;
    static library_task<F> timed(task t) { return traits<F>::library()[static_cast<unsigned>(t)]; }

    std::size_t size() const { return stream_->data.size() * unit; }

    void witness(const std::string& question, const char* name, std::function<tally()> tell) { race_.answers.push_back({question, name, {}, std::move(tell)}); }
    void ask_generator() { witness(whole_stream, "generator", [s = stream_] { return s->made_of.answer(T); }); }
    /// What the library says about `in`, which `owner` keeps alive, as text; and how many messages and errors there are.
    void ask_reference(const std::string& part, unit_span<F> in, std::shared_ptr<const void> owner) {
        const auto said = std::make_shared<const lines>(reference_lines<F>(in));
        witness(part + ", as text", "trama", [in, owner] { return text_of(library_lines<F>(in)); });
        witness(part + ", as text", "tests/reference", [said] { return text_of(*said); });
        witness(part, "tests/reference", [said] { return tally_of(*said, T); });
        by_reference_.push_back({part, in, owner});
    }
    void ask_about_ranges() {
        const auto s = std::make_shared<const stream<F>>(out_of_range<F>(heard_by_reference / unit));
        ask_reference("values out of range, counts", s->data, s);
        out_of_range_ = s;
    }

    void add_by_hand(const by_hand_code<F>& code) {
        const auto& [run, proof] = code.tasks[static_cast<unsigned>(T)];
        race_.contenders.push_back({code.name, "whole", role::baseline, size(), messages_, [s = stream_, run = run] { return run(s->data); }});
        answer(whole_stream, code.name, "whole", [s = stream_, proof = proof] { return proof(s->data); });
        if (out_of_range_) answer("values out of range", code.name, "whole", [s = out_of_range_, proof = proof] { return proof(s->data); });
    }
    void add_library(const char* name, std::size_t bytes, library_task<F> run, library_task<F> proof) {
        const std::string chunk_is = chunk_name(bytes);
        const std::size_t chunk = bytes == 0 ? 0 : std::max<std::size_t>(1, bytes / unit);
        race_.contenders.push_back({name, chunk_is, role::library, size(), messages_, [s = stream_, chunk, run] { return run(s->data, chunk); }});
        answer(whole_stream, name, chunk_is, [s = stream_, chunk, proof] { return proof(s->data, chunk); });
        if (out_of_range_) answer("values out of range", name, chunk_is, [s = out_of_range_, chunk, proof] { return proof(s->data, chunk); });
        for (const auto& heard : by_reference_)
            answer(heard.question, name, chunk_is, [heard, chunk, proof] {
                const tally t = proof(heard.in, chunk);
                return tally{t.messages, T == task::framing ? t.sum : 0, t.errors};
            });
    }
    /// The library at something else, as a limit.
    void add_comparison(const char* name, const shared_stream<F>& s, task t) {
        race_.contenders.push_back({name, "whole", role::limit, s->data.size() * unit, s->made_of.messages, [s, run = timed(t)] { return run(s->data, 0); }});
    }
    void answer(const std::string& question, const char* name, const std::string& chunk, std::function<tally()> tell) {
        race_.answers.push_back({question, name, chunk, std::move(tell)});
    }

    struct part_of_stream {
        std::string question;
        unit_span<F> in;
        std::shared_ptr<const void> owner;
    };
    race& race_;
    const workload<F>& workload_;
    std::size_t bytes_;
    shared_stream<F> stream_;
    std::uint64_t messages_ = 0;
    shared_stream<F> out_of_range_{};
    std::vector<part_of_stream> by_reference_{};
};

template <class F, task T>
void add_race(std::vector<entry>& all, const workload<F>& w, const workload<F>& clean, std::size_t bytes) {
    race r{std::string(F::name), w.name, size_name(bytes), name_of(T)};
    all.push_back({r.id(), [r, w, clean, bytes] {
        race filled = r;
        race_builder<F, T>(filled, w, bytes).build(clean);
        return filled;
    }});
}

/// The first of `workloads` is the clean one that those with faults are compared with.
template <class F>
void add_races(std::vector<entry>& all, const scale& sizes, const std::vector<workload<F>>& workloads) {
    for (const std::size_t bytes : {sizes.large, sizes.small})
        for (const auto& w : workloads) {
            add_race<F, task::framing>(all, w, workloads[0], bytes);
            if (w.is != condition::noise) add_race<F, task::typed>(all, w, workloads[0], bytes);
            if (w.is != condition::clean) continue;
            add_race<F, task::validated>(all, w, workloads[0], bytes);
            add_race<F, task::selected>(all, w, workloads[0], bytes);
        }
}

}  // namespace trama::bench
