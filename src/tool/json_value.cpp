#include "tool/json_value.hpp"

#include <cstdint>
#include <set>

#include "tool/hex.hpp"

namespace trama::tool {

namespace {

constexpr int deepest = 16;

class json_parser {
public:
    explicit json_parser(std::string_view text) : text_(text) {}

    json_result parse() {
        json_result r;
        value(r.value, 0);
        space();
        if (error_.empty() && at_ != text_.size()) fail("something follows the value");
        r.error = std::move(error_);
        r.column = at_ + 1;
        return r;
    }

private:
    bool fail(std::string_view what) {
        if (error_.empty()) error_ = what;
        return false;
    }
    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    void space() { while (peek() == ' ' || peek() == '\t' || peek() == '\r') ++at_; }
    bool take(char c) {
        space();
        if (peek() != c) return false;
        ++at_;
        return true;
    }
    bool word(std::string_view w, json_value& v, json_value::kind k) {
        if (text_.substr(at_, w.size()) != w) return fail("no JSON value");
        at_ += w.size();
        v.type = k;
        v.text = w;
        return true;
    }

    bool value(json_value& v, int depth) {
        space();
        if (depth > deepest) return fail("nested too deeply");
        switch (peek()) {
            case '{': return object(v, depth);
            case '[': return array(v, depth);
            case '"': v.type = json_value::kind::string; return string(v.text);
            case 't': return word("true", v, json_value::kind::boolean);
            case 'f': return word("false", v, json_value::kind::boolean);
            case 'n': return word("null", v, json_value::kind::null);
            default: return number(v);
        }
    }
    bool object(json_value& v, int depth) {
        v.type = json_value::kind::object;
        ++at_;
        if (take('}')) return true;
        std::set<std::string> names;  // ignored objects may have thousands
        do {
            space();
            json_value::member member;
            if (peek() != '"') return fail("a name in quotes is missing");
            if (!string(member.name)) return false;
            if (!names.insert(member.name).second) return fail(member.name + ": it stands twice");
            if (!take(':')) return fail("a colon is missing");
            if (!value(member.value, depth + 1)) return false;
            v.members.push_back(std::move(member));
        } while (take(','));
        return take('}') || fail("the object has no end");
    }
    bool array(json_value& v, int depth) {
        v.type = json_value::kind::array;
        ++at_;
        if (take(']')) return true;
        do {
            if (!value(v.items.emplace_back(), depth + 1)) return false;
        } while (take(','));
        return take(']') || fail("the array has no end");
    }
    bool digits(std::string& out) {
        const std::size_t begin = at_;
        while (peek() >= '0' && peek() <= '9') out += text_[at_++];
        return at_ != begin;
    }
    bool number(json_value& v) {
        v.type = json_value::kind::number;
        const std::size_t begin = at_;
        std::string seen;
        if (peek() == '-') ++at_;
        const bool zero = peek() == '0';
        if (!digits(seen)) return fail("no JSON value");
        if (zero && seen.size() > 1) return fail("a number begins with 0");
        if (peek() == '.' && (++at_, !digits(seen))) return fail("digits are missing behind the point");
        if (peek() == 'e' || peek() == 'E') {
            ++at_;
            if (peek() == '+' || peek() == '-') ++at_;
            if (!digits(seen)) return fail("digits are missing in the exponent");
        }
        v.text = text_.substr(begin, at_ - begin);
        return true;
    }

    static void put(std::uint32_t code, std::string& out) {
        const auto byte = [&](std::uint32_t value) { out += static_cast<char>(static_cast<unsigned char>(value)); };
        if (code < 0x80) return byte(code);
        const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
        byte((0xF0U << (3 - more) & 0xF0) | code >> (6 * more));
        for (int i = more - 1; i >= 0; --i) byte(0x80 | (code >> (6 * i) & 0x3F));
    }
    /// Four hex digits.
    bool unit(std::uint32_t& out) {
        if (text_.size() - at_ < 4) return false;
        out = 0;
        for (int i = 0; i != 4; ++i) {
            const int digit = hex_value(text_[at_++]);
            if (digit < 0) return false;
            out = out << 4 | static_cast<unsigned>(digit);
        }
        return true;
    }
    bool escape(std::string& out) {
        const char c = peek();
        ++at_;
        constexpr std::string_view names = "\"\\/bfnrt", values = "\"\\/\b\f\n\r\t";
        if (const std::size_t i = names.find(c); i != names.npos && at_ <= text_.size()) {
            out += values[i];
            return true;
        }
        if (c != 'u') return fail("no such escape");
        std::uint32_t code = 0, low = 0;
        if (!unit(code)) return fail("\\u needs four hex digits");
        if (const std::size_t behind = at_; code >> 10 == 0x36 && text_.substr(at_, 2) == "\\u") {
            at_ += 2;
            if (unit(low) && low >> 10 == 0x37) code = 0x10000 + ((code & 0x3FF) << 10) + (low & 0x3FF);
            else at_ = behind;
        }
        put(code, out);
        return true;
    }
    /// A character of more than one byte in UTF-8. [RFC 3629]
    bool multibyte(unsigned char lead, std::string& out) {
        const int more = lead >= 0xF0 && lead <= 0xF4 ? 3 : lead >= 0xE0 && lead < 0xF0 ? 2 : lead >= 0xC2 && lead < 0xE0 ? 1 : 0;
        if (more == 0) return fail("no UTF-8");
        std::uint32_t code = lead & (0x3FU >> more);
        for (int i = 0; i != more; ++i, ++at_) {
            const auto c = static_cast<unsigned char>(peek());
            if ((c & 0xC0) != 0x80) return fail("no UTF-8");
            code = code << 6 | (c & 0x3FU);
        }
        const bool overlong = (more == 2 && code < 0x800) || (more == 3 && code < 0x10000);
        if (overlong || code >> 11 == 0x1B || code > 0x10FFFF) return fail("no UTF-8");
        put(code, out);
        return true;
    }
    bool string(std::string& out) {
        ++at_;
        for (;;) {
            if (at_ == text_.size()) return fail("the string has no end");
            const auto c = static_cast<unsigned char>(text_[at_++]);
            if (c == '"') return true;
            if (c == '\\') {
                if (!escape(out)) return false;
            } else if (c < 0x20) {
                return fail("a control character in a string");
            } else if (c < 0x80) {
                out += static_cast<char>(c);
            } else if (!multibyte(c, out)) {
                return false;
            }
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::string error_;
};

}  // namespace

json_result parse_json(std::string_view text) { return json_parser(text).parse(); }

}  // namespace trama::tool
