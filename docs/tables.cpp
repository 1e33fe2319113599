// Prints the layout tables of one format as Markdown, straight from the schema. docs/update puts them into the pages.
#include <array>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "trama/trama.hpp"

namespace {

using namespace trama;

std::string allowed_in_words(const rule* r) {
    if (r == nullptr) return {};
    std::array<char, 1024> memory;
    text_sink s(memory);
    s.allowed(*r);
    std::string text{s.view()};
    for (std::size_t at = 0; (at = text.find('|', at)) != text.npos; at += 2) text.insert(at, "\\");
    return text;
}

/// A value as the wire has it: a number, or two letters.
template <class W>
std::string on_the_wire(std::int64_t v) {
    if constexpr (std::is_same_v<W, wire::letter_pair>) return {static_cast<char>(v >> 8), static_cast<char>(v)};
    else return std::to_string(v);
}

/// What a named value may be, name and value: `clockwise 0, counter_clockwise 1`. Empty for all other fields.
template <class M, std::size_t I>
std::string names_and_values() {
    using one = std::remove_cvref_t<decltype(field_of<M, I>)>;
    using value = typename one::value;
    std::string text;
    if constexpr (enumerated<value> && !flag_set<value>) {
        for (const std::string_view name : documented_rule<typename one::wire_type, value>(field_of<M, I>.allowed)->names)
            for (const auto& e : names(value{}))
                if (e.name == name) text.append(text.empty() ? "" : ", ").append(name).append(" ").append(on_the_wire<typename one::wire_type>(static_cast<std::int64_t>(e.value)));
    }
    return text;
}

/// The same for every row of `M`, in the order of `for_each_row`.
template <class M>
std::vector<std::string> named_values() {
    std::vector<std::string> all;
    each_index<M>([&]<std::size_t I>() {
        all.push_back(names_and_values<M, I>());
        using inner = typename detail::structure<typename std::remove_cvref_t<decltype(field_of<M, I>)>::wire_type>::type;
        if constexpr (has_layout<inner>) each_index<inner>([&]<std::size_t J>() { all.push_back(names_and_values<inner, J>()); });
    });
    return all;
}

/// The bits of each flag set, name and value.
template <class M>
void print_bits() {
    each_index<M>([]<std::size_t I>() {
        constexpr auto& one = field_of<M, I>;
        using value = typename std::remove_cvref_t<decltype(one)>::value;
        if constexpr (flag_set<value>) {
            std::printf("\nValues of the bits of `%.*s`, whose sum is sent:", static_cast<int>(one.name.size()), one.name.data());
            const char* gap = " ";
            for (const auto& e : names(value{})) {
                std::printf("%s`%.*s` %llu", gap, static_cast<int>(e.name.size()), e.name.data(), static_cast<unsigned long long>(e.value));
                gap = ", ";
            }
            std::printf("\n");
        }
    });
}

template <class F, class M>
std::string heading() {
    if constexpr (std::is_same_v<F, daisy::format>) {
        const unsigned command = daisy::command_of(M::key);
        std::array<char, 64> code{};
        std::snprintf(code.data(), code.size(), "%s, command 0x%02X", (command & daisy::response_bit) != 0 ? "response" : "request", command);
        return code.data();
    } else if constexpr (std::is_same_v<F, can::format>) {
        std::string text = std::string{"letter "} + static_cast<char>(static_cast<unsigned>(M::key) >> 8) + ", DLC";
        for (const unsigned n : M::frame_lengths) text.append(" ").append(std::to_string(n));
        return text;
    } else {
        return "type " + std::to_string(static_cast<unsigned>(M::key)) + ", payload " + std::to_string(M::layout.size + gateway::type_size) + " characters";
    }
}

template <class F, class M>
void table() {
    std::printf("\n#### `%.*s` (%s)\n\nSource: %s.", static_cast<int>(M::name.size()), M::name.data(), heading<F, M>().c_str(), (std::string{"section \""} + std::string{M::section} + '"').c_str());
    if (M::layout.count == 0) {
        std::printf(" No fields.\n");
        return;
    }
    std::printf("\n\n| offset | size | field | type | allowed | meaning |\n|---|---|---|---|---|---|\n");
    const std::vector<std::string> named = named_values<M>();
    auto values = named.begin();
    for_each_row<M>([&](const layout_row& row) {
        const std::string name = row.parent.empty() ? std::string{row.name} : std::string{row.parent} + (row.count > 1 ? "[i]." : ".") + std::string{row.name};
        const std::string count = row.parent.empty() && row.count > 1 ? std::string{"["}.append(std::to_string(row.count)).append("]") : "";
        const std::string offset = row.from_end ? "last" : std::to_string(row.offset) + (row.parent.empty() || row.count == 1 ? "" : " + " + std::to_string(row.stride) + "i");
        const std::string size = row.size == 0 ? "rest" : row.split != 0 ? std::to_string(row.split) + " + " + std::to_string(row.size - row.split) : std::to_string(row.size);
        std::printf("| %s | %s | `%s%s` | %.*s | %s | %.*s |\n", offset.c_str(), size.c_str(), name.c_str(), count.c_str(), static_cast<int>(row.type.size()), row.type.data(),
                    values->empty() ? allowed_in_words(row.allowed).c_str() : values->c_str(), static_cast<int>(row.meaning.size()), row.meaning.data());
        if (row.constant != '\0') std::printf("| %zu | 1 | | constant | `%c` | the message's letter |\n", row.offset + row.size, row.constant);
        ++values;
    });
    print_bits<M>();
}

template <class F>
int tables() {
    F::messages::each([]<class M>() { table<F, M>(); });
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view format = argc == 2 ? argv[1] : "";
    if (format == daisy::format::name) return tables<daisy::format>();
    if (format == can::format::name) return tables<can::format>();
    if (format == gateway::format::name) return tables<gateway::format>();
    std::fputs("usage: docs_tables daisy|can|gateway\n", stderr);
    return 2;
}
