#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trama::tool {

/// A JSON value as it was read.
struct json_value {
    enum class kind { null, boolean, number, string, array, object };

    kind type = kind::null;
    std::string text;  ///< Of a number its literal; of a string its characters in UTF-8 (half a surrogate pair in three bytes).
    std::vector<json_value> items;
    struct member;
    std::vector<member> members;

    /// The member called `name`, or null.
    const json_value* find(std::string_view name) const;
};
struct json_value::member {
    std::string name;  ///< In UTF-8.
    json_value value;
};

inline const json_value* json_value::find(std::string_view name) const {
    for (const member& one : members)
        if (one.name == name) return &one.value;
    return nullptr;
}

/// What came of reading a text: a value, or what is wrong at which column, from 1.
struct json_result {
    json_value value;
    std::string error;
    std::size_t column = 0;
};
json_result parse_json(std::string_view text);

}  // namespace trama::tool
