#pragma once
// Processes that a program starts, watches and outlives.

#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/wait.h>

#include "common/process.hpp"

namespace example {

/// What becomes of a child goes to `ended(i, status)`, status as a shell counts it: 128 and the signal if it was killed.
class family {
public:
    /// A process that does `life()`, whose value is its status. It comes to its end when this one dies.
    template <class F>
    void start(const std::string& name, F&& life) {
        std::fflush(stdout);
        const pid_t parent = getpid(), child = fork();
        if (child < 0) die("fork");
        if (child != 0) {
            children_.push_back({child, name});
            return;
        }
#ifdef __linux__
        prctl(PR_SET_PDEATHSIG, SIGTERM);
#endif
        if (getppid() != parent) stopped = 1;  // it died before that
        _exit(finish(life()));
    }
    bool alive(std::size_t i) const { return children_[i].process != 0; }

    /// SIGTERM, unless the child is gone: process 0 would be this one with all that the terminal started beside it.
    void stop(std::size_t i, int signal = SIGTERM) const {
        if (alive(i)) kill(children_[i].process, signal);
    }
    void stop_all(int signal = SIGTERM) const {
        for (std::size_t i = 0; i != children_.size(); ++i) stop(i, signal);
    }
    /// Looks who has ended.
    template <class F>
    void look(F&& ended) {
        int status = 0;
        for (pid_t gone; (gone = waitpid(-1, &status, WNOHANG)) > 0;)
            for (std::size_t i = 0; i != children_.size(); ++i) {
                if (children_[i].process != gone) continue;
                children_[i].process = 0;
                ended(i, WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status));
            }
    }
    /// Ends all that are left: by force those that do not listen.
    template <class F>
    void end(F&& ended) {
        stop_all();
        const std::uint64_t limit = now() + 5000;
        for (std::size_t i = 0; i != children_.size(); ++i)
            for (; alive(i); look(ended)) {
                if (now() >= limit) stop_all(SIGKILL);
                usleep(5000);
            }
    }
    /// Child `i` should not have ended; one that gave up, status 2, has said why itself.
    void complain(std::size_t i, int status) const {
        if (status != 2) std::fprintf(stderr, "%s has ended early, with status %d\n", children_[i].name.c_str(), status);
    }

private:
    struct member { pid_t process; std::string name; };
    std::vector<member> children_;
};

}  // namespace example
