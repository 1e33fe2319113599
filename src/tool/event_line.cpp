#include "tool/event_line.hpp"

namespace trama::tool {

namespace {

/// A JSON object under construction, or the same as `name=value` pairs.
class line {
public:
    line(text_sink& out, notation n) : out_(out), json_(n == notation::json), notation_(n) { if (json_) out_ << '{'; }
    text_sink& key(std::string_view name) {
        out_ << gap_;
        gap_ = json_ ? "," : " ";
        if (json_) out_.quoted(name) << ':';
        else out_ << name << '=';
        return out_;
    }
    void name(std::string_view key_name, std::string_view value) {
        if (json_) key(key_name).quoted(value);
        else key(key_name) << value;
    }
    void hex(std::string_view key_name, std::span<const std::uint8_t> bytes) {
        key(key_name);
        if (json_) out_ << '"';
        out_.hex(bytes);
        if (json_) out_ << '"';
    }
    void end() { if (json_) out_ << '}'; }
    text_sink& sink() { return out_; }
    notation style() const { return notation_; }

private:
    text_sink& out_;
    bool json_;
    notation notation_;
    std::string_view gap_;
};

/// A byte that people know in hex.
void print_byte(line& l, std::string_view name, std::uint8_t value) {
    const std::uint8_t octets[] = {value};
    if (l.style() == notation::json) l.key(name) << value;
    else (l.key(name) << "0x").hex(octets);
}

/// Where the event lies in the input.
template <wire_format F>
void print_place(line& l, const typename F::event& e) {
    l.name("protocol", F::name);
    if constexpr (std::is_same_v<F, can::format>) {
        l.key("line") << e.offset;
        l.key("frames") << e.length;
        l.key("id") << e.id;
    } else {
        l.key("offset") << e.offset;
        l.key("length") << e.length;
    }
}

template <wire_format F>
void print_error(line& l, const typename F::event& e, errc code) {
    l.name("error", name_of(code));
    if (code != errc::noise) l.hex("bytes", e.bytes.empty() ? e.packet.body() : e.bytes);
    if constexpr (std::is_same_v<F, daisy::format>) {
        if (code == errc::bad_checksum) {
            print_byte(l, "expected", e.expected);
            print_byte(l, "received", e.received);
        } else if (code == errc::unknown_message) {
            print_byte(l, "destination", e.packet.envelope().destination.octet);
            print_byte(l, "source", e.packet.envelope().source.octet);
            print_byte(l, "command", e.packet.command());
        }
    } else if constexpr (std::is_same_v<F, gateway::format>) {
        if (code == errc::unknown_message) l.key("type") << e.packet.type();
    }
}

template <wire_format F, has_layout M>
bool print_violations(line& l, const typename F::event& e, const M& m) {
    bool any = false;
    text_sink& out = l.sink();
    const bool json = l.style() == notation::json;
    const auto one = [&](const violation& v) {
        if (!any) l.key("violations") << '[';
        else out << ',';
        any = true;
        out << (json ? "{\"field\":\"" : "");
        print_path<M>(out, v.field);
        out << (json ? "\",\"value\":" : " is ") << v.value << (json ? ",\"allowed\":\"" : ", allowed ");
        out.allowed(*v.allowed);
        if (json) out << "\"}";
    };
    F::for_each_violation(e.packet.envelope(), m, one);
    for_each_violation(m, one);
    if (any) out << ']';
    return any;
}

template <wire_format F, has_layout M>
bool print_message(line& l, const typename F::event& e, const M& m) {
    if constexpr (std::is_same_v<F, daisy::format>) {
        print_byte(l, "destination", e.packet.envelope().destination.octet);
        print_byte(l, "source", e.packet.envelope().source.octet);
    }
    l.name("message", M::name);
    if constexpr (std::is_same_v<F, daisy::format>) l.name("kind", e.packet.response() ? "response" : "request");
    if (l.style() == notation::json) {
        print_fields(l.key("fields"), m, notation::json);
    } else if (M::layout.count != 0) {
        l.sink() << ' ';
        print_fields(l.sink(), m, notation::plain);
    }
    return print_violations<F>(l, e, m);
}

}  // namespace

template <wire_format F>
bool print_event(text_sink& out, const typename F::event& e, notation n) {
    line l(out, n);
    print_place<F>(l, e);
    bool at_fault = true;
    if (e.code == errc::ok) {
        bool shown = false;
        error bad{};
        F::messages::at(e.packet.index(), [&]<class M>() {
            M m{};
            bad = load_body(e.packet.body(), m);
            if (bad) return;
            at_fault = print_message<F>(l, e, m);
            shown = true;
        });
        if (!shown) {
            typename F::event raw = e;
            if constexpr (requires { e.packet.bytes(); }) raw.bytes = e.packet.bytes();
            print_error<F>(l, raw, bad.code);
            F::messages::at(e.packet.index(), [&]<class M>() {
                if (bad.code != errc::bad_number) return;
                l.key("field");
                if (n == notation::json) out << '"';
                print_path<M>(out, bad.field);
                if (n == notation::json) out << '"';
            });
        }
    } else {
        print_error<F>(l, e, e.code);
        if (e.code == errc::bad_number) l.name("field", "type");
    }
    l.end();
    return at_fault;
}

void print_bad_line(text_sink& out, std::uint64_t number, notation n) {
    line l(out, n);
    l.name("protocol", can::format::name);
    l.key("line") << number;
    l.name("error", "bad_line");
    l.end();
}

template bool print_event<daisy::format>(text_sink&, const daisy::event&, notation);
template bool print_event<can::format>(text_sink&, const can::event&, notation);
template bool print_event<gateway::format>(text_sink&, const gateway::event&, notation);

}  // namespace trama::tool
