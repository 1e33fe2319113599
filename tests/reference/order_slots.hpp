#pragma once
// The order slots of a cart, once more from the document alone, as plain code on words; it shares nothing with the library.
#include <string>

namespace trama_reference {

struct plain_slot {
    std::string use = "unused", phase = "none";
    int order = 0;
};
struct plain_cart {
    plain_slot slot[2];

    int where(const std::string& use) const { return slot[0].use == use ? 0 : slot[1].use == use ? 1 : -1; }
    bool order(int number) {
        int at = where("unused");
        if (at < 0) at = where("previous");
        if (at < 0) return false;
        const int current = where("current");
        slot[at] = {"next", "none", number};
        if (current < 0) {
            slot[at] = {"current", "go_transit", number};
        } else if (slot[current].phase == "transit_done") {
            slot[current].use = "previous";
            slot[at] = {"current", "go_transit", number};
        }
        return true;
    }
    bool phase(const std::string& reached) {
        const int current = where("current");
        if (current < 0 || slot[current].phase == "transit_done") return false;
        slot[current].phase = reached;
        const int next = where("next");
        if (reached == "transit_done" && next >= 0) {
            slot[current].use = "previous";
            slot[next].use = "current";
            slot[next].phase = "go_transit";
        }
        return true;
    }
    int cancel() {
        int cancelled = 0;
        for (plain_slot& s : slot) {
            if (s.use == "next" || (s.use == "current" && s.phase != "transit_done")) {
                s = {};
                ++cancelled;
            }
        }
        return cancelled;
    }
};

}  // namespace trama_reference
