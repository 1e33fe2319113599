#include "tool/encode_line.hpp"

#include <array>

#include "tool/event_line.hpp"
#include "tool/from_json.hpp"

namespace trama::tool {

namespace {

/// Reads the line of one packet step by step; the first thing that is wrong ends it.
template <wire_format F>
class line_encoder {
public:
    line_encoder(const json_value& line, bool unchecked) : line_(line), unchecked_(unchecked) {}

    encoded<F> run() {
        (void)(check_keys() && read_envelope() && read_message());
        return std::move(result_);
    }

private:
    static constexpr bool is_daisy = std::is_same_v<F, daisy::format>, is_can = std::is_same_v<F, can::format>;

    bool fail(std::string what) {
        result_.error = std::move(what);
        return false;
    }
    bool check_keys() {
        if (line_.type != json_value::kind::object) return fail("a JSON object is needed");
        if (!check_protocol()) return false;
        if (const json_value* e = line_.find("error")) return fail("skipped, it reports an error: " + e->text);
        for (const auto& [name, value] : line_.members) {
            const bool place = name == "offset" || name == "length" || name == "line" || name == "frames";
            const bool address = is_can ? name == "id" : is_daisy && (name == "destination" || name == "source" || name == "kind");
            if (!place && !address && name != "protocol" && name != "message" && name != "fields" && name != "violations") return fail(name + ": there is no such field");
        }
        return true;
    }
    /// First, since the other formats have other keys.
    bool check_protocol() {
        const json_value* protocol = line_.find("protocol");
        if (protocol == nullptr) return true;
        if (protocol->type != json_value::kind::string) return fail("protocol: a string is needed");
        return protocol->text == F::name || fail("protocol: it is " + protocol->text + ", not " + std::string{F::name});
    }
    template <class T>
    bool read_number(std::string_view name, std::int64_t most, T& out) {
        const json_value* v = line_.find(name);
        if (v == nullptr) return fail(std::string{name} + ": it is missing");
        const auto n = whole_number(*v);
        if (!n || *n < 0 || *n > most) return fail(std::string{name} + ": a whole number in 0.." + std::to_string(most) + " is needed");
        out = static_cast<T>(*n);
        return true;
    }
    bool read_envelope() {
        if constexpr (is_daisy) return read_number("destination", 255, envelope_.destination.octet) && read_number("source", 255, envelope_.source.octet) && read_kind();
        else if constexpr (is_can) return read_number("id", can::last_id, envelope_.id);
        else return true;
    }
    bool read_kind() {
        const json_value* kind = line_.find("kind");
        if (kind == nullptr) return true;
        response_ = kind->text == "response";
        return (kind->type == json_value::kind::string && (response_ || kind->text == "request")) || fail("kind: request or response is needed");
    }
    template <class M>
    bool is_called(std::string_view name) const {
        if constexpr (is_daisy) return M::name == name && response_ == ((daisy::command_of(M::key) & daisy::response_bit) != 0);
        else return M::name == name;
    }
    bool read_message() {
        const json_value* name = line_.find("message");
        if (name == nullptr) return fail("message: it is missing");
        if (name->type != json_value::kind::string) return fail("message: a string is needed");
        bool found = false, good = false;
        F::messages::each([&]<class M>() {
            if (found || !is_called<M>(name->text)) return;
            found = true;
            good = encode_as<M>();
        });
        return found ? good : fail("message: there is no " + name->text + (is_daisy ? response_ ? " with kind response" : " with kind request" : ""));
    }
    template <class M>
    [[gnu::noinline]] bool encode_as() {
        M m{};
        message_reader reader(unchecked_);
        const json_value* values = line_.find("fields");
        if (values != nullptr && !reader.read(*values, m)) return fail(reader.error());
        if constexpr (requires { m.expected_count(); m.readings.count; })  // the default for a list is zeros
            if (values == nullptr || values->find("readings") == nullptr) m.readings.count = static_cast<std::uint8_t>(m.expected_count());
        std::array<typename F::unit, F::max_units> units;
        const auto size = unchecked_ ? F::encode_unchecked(envelope_, m, std::span{units}) : F::encode(envelope_, m, std::span{units});
        if (!size) return fail(explain(m, size.error()));
        result_.units.assign(units.begin(), units.begin() + static_cast<std::ptrdiff_t>(*size));
        return true;
    }
    /// The violation that an encoder refused, in words.
    template <class M>
    std::string explain(const M& m, error refused) const {
        violation told{};
        const auto find = [&](const violation& v) { if (told.allowed == nullptr && v.field == refused.field) told = v; };
        F::for_each_violation(envelope_, m, find);
        for_each_violation(m, find);
        std::array<char, 1024> memory;
        text_sink out(memory);
        print_path<M>(out, refused.field);
        return explain(out, told, counted<M>(refused.field));
    }
    static std::string explain(text_sink& out, const violation& told, std::string_view unit) {
        if (told.allowed != nullptr) {
            out << ": " << told.value << unit << (unit.empty() || told.value == 1 ? " is" : "s are") << " not allowed (";
            out.allowed(*told.allowed) << ')';
        }
        return std::string{out.view()};
    }
    /// What the value of a violation counts: the values of a list, or the bytes of what fills the rest of a body.
    template <class M>
    static std::string_view counted(field_ref refused) {
        std::string_view what;
        each_index<M>([&]<std::size_t I>() {
            using wire_type = typename std::remove_cvref_t<decltype(field_of<M, I>)>::wire_type;
            if constexpr (wire::variable<wire_type>)
                if (refused == field_ref{I}) what = requires { typename wire_type::element; } ? " value" : " byte";
        });
        return what;
    }

    const json_value& line_;
    bool unchecked_;
    bool response_ = false;
    typename F::envelope envelope_{};
    encoded<F> result_;
};

}  // namespace

template <wire_format F>
encoded<F> encode_line(std::string_view line, bool unchecked) {
    const json_result parsed = parse_json(line);
    if (!parsed.error.empty()) return {{}, "column " + std::to_string(parsed.column) + ": " + parsed.error};
    return line_encoder<F>(parsed.value, unchecked).run();
}

template encoded<daisy::format> encode_line(std::string_view, bool);
template encoded<can::format> encode_line(std::string_view, bool);
template encoded<gateway::format> encode_line(std::string_view, bool);

}  // namespace trama::tool
