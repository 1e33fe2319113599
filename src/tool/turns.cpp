#include "tool/turns.hpp"

#include <algorithm>

namespace trama::tool {

namespace {

constexpr std::size_t written = std::size_t{1} << 16;  ///< Of lines at a time, bytes.
constexpr std::size_t budget = std::size_t{64} << 20;  ///< Of all parts' lines together.
constexpr std::size_t enough = std::size_t{4} << 20;   ///< Of one part's lines: the pings of a block take less.

}  // namespace

turns::turns(std::uint64_t size, std::uint64_t block, std::size_t most, search find)
    : size_(size), block_(block), most_(most), kept_(std::clamp(budget / most, written, enough)), find_(std::move(find)), shown_(size) {}

/// Appends a part. The search for its end may be long, so the others are not kept waiting meanwhile.
void turns::cut(std::unique_lock<std::mutex>& lock) {
    cutting_ = true;
    const seam begin = next_;
    lock.unlock();
    // From the last seam on, so that a stretch without any is searched once.
    const seam end = find_(begin, std::max(begin.join + block_, begin.place + 1));
    auto p = std::make_shared<part>();
    p->begin = begin;
    p->end = end;
    p->reached = begin.place;
    lock.lock();
    next_ = end;
    parts_.push_back(std::move(p));
    cutting_ = false;
    changed_.notify_all();
}

std::shared_ptr<part> turns::take() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return stopped_ || (!cutting_ && (next_.place >= size_ || parts_.size() < most_)); });
    if (stopped_ || next_.place >= size_) return nullptr;
    cut(lock);
    return parts_.back();
}

void turns::add(part& p, std::string_view line) {
    const std::size_t before = p.text.size() / written;
    p.text += line;
    if (p.text.size() / written == before) return;
    bool turn = false;
    {
        const std::lock_guard lock(mutex_);
        turn = is_first(p);
    }
    if (turn || (p.text.size() >= kept_ && wait(p))) write(p);
    else if (!wanted(p)) p.text.clear();
}

bool turns::wait(part& p) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !wanted(p) || is_first(p); });
    return wanted(p);
}

void turns::write(part& p) {
    out_.write(p.text);
    p.text.clear();
    shown_.at(p.reached);
}

void turns::extend(part& p) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return stopped_ || !cutting_; });
    if (stopped_) return;
    if (parts_.size() == 1) cut(lock);
    parts_[1]->dropped = true;
    p.end = parts_[1]->end;
    parts_.erase(parts_.begin() + 1);
    changed_.notify_all();
}

void turns::finish(part& p) {
    std::unique_lock lock(mutex_);
    p.done = true;
    if (!is_first(p)) return;
    while (!parts_.empty() && parts_.front()->done) {
        part& first = *parts_.front();
        lock.unlock();
        first.reached = first.end.place;
        write(first);
        lock.lock();
        at_fault_ = at_fault_ || first.at_fault;
        parts_.pop_front();
        changed_.notify_all();
    }
}

void turns::stop(std::exception_ptr why) {
    const std::lock_guard lock(mutex_);
    if (!why_) why_ = std::move(why);
    stopped_ = true;
    changed_.notify_all();
}

bool turns::result() {
    out_.flush();
    if (why_) std::rethrow_exception(why_);
    return at_fault_;
}

}  // namespace trama::tool
