#pragma once

#include <list>
#include <optional>
#include <string>

#include "tool/hex.hpp"
#include "tool/json_value.hpp"
#include "trama/trama.hpp"

namespace trama::tool {

/// A whole number that JSON wrote as such.
std::optional<std::int64_t> whole_number(const json_value& v);
/// A number with at most one decimal, in tenths.
std::optional<std::int64_t> number_in_tenths(const json_value& v);

/// Fills a message from the object that `decode` prints as its fields. Missing fields keep their defaults.
class message_reader {
public:
    /// Unchecked, what is wrong is told by what the wire can carry, else by what the document allows.
    explicit message_reader(bool unchecked) : unchecked_(unchecked) {}

    /// Empty when all went well, else what is wrong where.
    const std::string& error() const { return error_; }

    template <has_layout M>
    bool read(const json_value& object, M& m) {
        if (object.type != json_value::kind::object) return fail("an object is needed");
        for (const json_value::member& one_member : object.members) {
            const std::string& name = one_member.name;
            const json_value& value = one_member.value;
            bool known = false, good = true;
            each_index<M>([&]<std::size_t I>() {
                using one = std::remove_cvref_t<decltype(field_of<M, I>)>;
                if (name != field_of<M, I>.name) return;
                known = true;
                const std::size_t before = enter(name);
                good = store<typename one::wire_type>(value, m.*one::member, field_of<M, I>.allowed);
                leave(before, good);
            });
            if (!known) {
                enter(name);
                return fail("there is no such field");
            }
            if (!good) return false;
        }
        return check_presence(object, m);
    }

private:
    /// Refuses a field that the message's other values rule out, which would be lost without a word.
    template <has_layout M>
    bool check_presence(const json_value& object, const M& m) {
        bool good = true;
        each_index<M>([&]<std::size_t I>() {
            constexpr auto& one = field_of<M, I>;
            if (!good || one.exists(m) || object.find(one.name) == nullptr) return;
            enter(one.name);
            good = fail("there is no such field in a message with these values");
        });
        return good;
    }
    bool fail(std::string_view what);
    bool fail_count(std::size_t needed, std::size_t given);
    bool fail_too_many(std::size_t most, std::size_t given);
    std::size_t enter(std::string_view name);
    std::size_t enter(std::size_t index);
    void leave(std::size_t before, bool good) { if (good) path_.resize(before); }

    /// Reads a value whose field has the rule `own`.
    template <class W, class V>
    bool store(const json_value& v, V& out, const rule& own) {
        if constexpr (requires { typename W::element; }) return store_array<W>(v, out, own);
        else if constexpr (has_layout<V>) return read(v, out);
        else if constexpr (flag_set<V>) return store_flags<W>(v, out);
        else if constexpr (enumerated<V>) return store_enum<W>(v, out, told_rule<W, V>(own));
        else if constexpr (std::integral<V>) return store_number<W>(v, out, told_rule<W, V>(own));
        else if constexpr (requires { out.columns; }) return store_text(v, out);
        else return store_bytes<W>(v, out);
    }
    /// What a number that the wire cannot carry is told to be instead.
    template <class W, class V>
    const rule& told_rule(const rule& own) const {
        const rule* documented = unchecked_ ? nullptr : documented_rule<W, V>(own);
        return documented != nullptr ? *documented : printed_range<W>();
    }
    /// A number in the range that the wire type can carry, else refused in the words of `told`.
    bool read_number(const json_value& v, wire::print printed, const rule& range, const rule& told, std::int64_t& out);
    /// The position of a name in `names`; a number is left for `read_number`.
    bool read_name(const json_value& v, std::span<const std::string_view> names, std::size_t& out);

    template <class W, class V>
    bool store_number(const json_value& v, V& out, const rule& told) {
        static_assert(std::in_range<V>(W::high) && std::in_range<V>(W::low));
        std::int64_t n = 0;
        if (!read_number(v, W::printed, wire_rule<W>, told, n)) return false;
        out = static_cast<V>(n);
        return true;
    }
    template <class W, class V>
    bool store_enum(const json_value& v, V& out, const rule& told) {
        if (v.type == json_value::kind::number) {
            std::underlying_type_t<V> n{};
            if (!store_number<W>(v, n, told)) return false;
            out = static_cast<V>(n);
            return true;
        }
        std::size_t position = 0;
        if (!read_name(v, name_list<V>, position)) return false;
        out = names(V{})[position].value;
        return true;
    }
    template <class W, class V>
    bool store_flags(const json_value& v, V& out) {
        if (v.type == json_value::kind::number) return store_enum<W>(v, out, printed_range<W>());
        if (v.type != json_value::kind::array) return fail("an array of names or a number is needed");
        std::uint64_t bits = 0;
        for (const json_value& item : v.items) {
            V one{};
            if (!store_enum<W>(item, one, printed_range<W>())) return false;
            bits |= static_cast<std::uint64_t>(one);
        }
        if (!W::carries(static_cast<std::int64_t>(bits))) return fail(std::to_string(bits) + " does not fit its columns");
        out = static_cast<V>(bits);
        return true;
    }
    template <class W, class V>
    bool store_array(const json_value& v, V& out, const rule& own) {
        if (v.type != json_value::kind::array) return fail("an array is needed");
        if constexpr (wire::variable<W>) {
            out = {};
            for (std::size_t i = 0; i != v.items.size(); ++i)
                if (!out.push_back({})) return fail_too_many(W::max_count, v.items.size());
        } else if (v.items.size() != out.size()) {
            return fail_count(out.size(), v.items.size());
        }
        for (std::size_t i = 0; i != v.items.size(); ++i) {
            const std::size_t before = enter(i);
            const bool good = store<typename W::element>(v.items[i], out[i], own);
            leave(before, good);
            if (!good) return false;
        }
        return true;
    }
    template <std::size_t Columns>
    bool store_text(const json_value& v, text<Columns>& out) {
        if (!check_text(v, Columns)) return false;
        out = text<Columns>(std::string_view{v.text});
        return true;
    }
    bool check_text(const json_value& v, std::size_t columns);
    template <class W>
    bool store_bytes(const json_value& v, byte_view& out) { return read_bytes(v, W::printed, out); }
    bool read_bytes(const json_value& v, wire::print printed, byte_view& out);
    static bool from_hex(std::vector<std::uint8_t>& text);

    bool unchecked_;
    std::string path_, error_;
    std::list<std::vector<std::uint8_t>> bytes_;  ///< What the message's views point to.
};

}  // namespace trama::tool
