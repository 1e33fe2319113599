#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace trama::tool {

/// A JSON value as it was read.
struct json_value {
    enum class kind { null, boolean, number, string, array, object };

    kind type = kind::null;
    std::string text;   ///< Of a number its literal; of a string its characters, each as one byte.
    bool wide = false;  ///< The string holds a character beyond U+00FF, which no byte can be.
    std::vector<json_value> items;
    std::vector<std::pair<std::string, json_value>> members;

    /// The member called `name`, or null.
    const json_value* find(std::string_view name) const {
        for (const auto& [key, value] : members)
            if (key == name) return &value;
        return nullptr;
    }
};

/// What came of reading a text: a value, or what is wrong at which column, from 1.
struct json_result {
    json_value value;
    std::string_view error;
    std::size_t column = 0;
};
json_result parse_json(std::string_view text);

}  // namespace trama::tool
