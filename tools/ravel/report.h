// The same facts as aligned text, JSON, CSV, Markdown or a page of HTML.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace ravel::tool {

using Json = nlohmann::ordered_json;  // keys stay in the order they were given

// One object: a line per key; nested objects are indented.
std::string text_of(const Json& object);
std::string json_of(const Json& value);

// Rows: objects with the same keys. `columns` chooses and orders them; empty means all.
std::string table_of(const Json& rows, const std::vector<std::string>& columns);
std::string csv_of(const Json& rows);
std::string markdown_of(const Json& rows, const std::vector<std::string>& columns);
std::string html_of(const Json& rows, const std::string& title, const std::string& remarks);

}  // namespace ravel::tool
