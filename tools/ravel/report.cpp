#include "ravel/report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace ravel::tool {
namespace {

std::string readable(const Json& value) {
    if (value.is_null()) return "-";
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    if (value.is_string()) return value.get<std::string>();
    if (!value.is_number_float()) return value.dump();
    const double number = value.get<double>();
    const double size = std::fabs(number);
    if (number == 0) return "0";
    if (size >= 0.01 && size < 1e6) return fmt::format("{:.3f}", number);
    return fmt::format("{:.3g}", number);
}

std::string label_of(std::string key) {
    std::replace(key.begin(), key.end(), '_', ' ');
    return key;
}

std::vector<std::string> columns_of(const Json& rows, const std::vector<std::string>& wanted) {
    if (!wanted.empty() || rows.empty()) return wanted;
    std::vector<std::string> keys;
    for (const auto& item : rows.front().items()) keys.push_back(item.key());
    return keys;
}

std::string quoted_csv(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

std::string escaped_html(const std::string& text) {
    std::string escaped;
    for (char c : text) {
        if (c == '<')
            escaped += "&lt;";
        else if (c == '>')
            escaped += "&gt;";
        else if (c == '&')
            escaped += "&amp;";
        else
            escaped += c;
    }
    return escaped;
}

std::string escaped_markdown(const std::string& text) {
    std::string escaped;
    for (char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
    return escaped;
}

void append_lines(std::string& text, const Json& object, std::size_t indent) {
    std::size_t width = 0;
    for (const auto& item : object.items()) width = std::max(width, item.key().size());
    for (const auto& item : object.items()) {
        const std::string margin(indent, ' ');
        if (item.value().is_object()) {
            text += fmt::format("{}{}\n", margin, label_of(item.key()));
            append_lines(text, item.value(), indent + 2);
        } else {
            text += fmt::format("{}{:<{}}  {}\n", margin, label_of(item.key()), width,
                                readable(item.value()));
        }
    }
}

}  // namespace

std::string text_of(const Json& object) {
    std::string text;
    append_lines(text, object, 0);
    return text;
}

std::string json_of(const Json& value) {
    return value.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string table_of(const Json& rows, const std::vector<std::string>& wanted) {
    const std::vector<std::string> columns = columns_of(rows, wanted);
    std::vector<std::vector<std::string>> lines;
    std::vector<bool> numeric(columns.size(), true);
    lines.emplace_back();
    for (const std::string& column : columns) lines.back().push_back(label_of(column));
    for (const Json& row : rows) {
        lines.emplace_back();
        for (std::size_t k = 0; k < columns.size(); ++k) {
            const Json& value = row.at(columns[k]);
            numeric[k] = numeric[k] && (value.is_number() || value.is_null());
            lines.back().push_back(readable(value));
        }
    }
    std::vector<std::size_t> width(columns.size(), 0);
    for (const auto& line : lines)
        for (std::size_t k = 0; k < line.size(); ++k) width[k] = std::max(width[k], line[k].size());
    std::string text;
    for (const auto& line : lines) {
        std::string row;
        for (std::size_t k = 0; k < line.size(); ++k)
            row += numeric[k] ? fmt::format("{:>{}}  ", line[k], width[k])
                              : fmt::format("{:<{}}  ", line[k], width[k]);
        row.erase(row.find_last_not_of(' ') + 1);
        text += row + "\n";
    }
    return text;
}

std::string csv_of(const Json& rows) {
    const std::vector<std::string> columns = columns_of(rows, {});
    std::string text;
    for (std::size_t k = 0; k < columns.size(); ++k) text += (k ? "," : "") + columns[k];
    text += "\n";
    for (const Json& row : rows) {
        for (std::size_t k = 0; k < columns.size(); ++k) {
            const Json& value = row.at(columns[k]);
            if (k) text += ",";
            if (value.is_null()) continue;
            text += quoted_csv(value.is_string() ? value.get<std::string>() : value.dump());
        }
        text += "\n";
    }
    return text;
}

std::string markdown_of(const Json& rows, const std::vector<std::string>& wanted) {
    const std::vector<std::string> columns = columns_of(rows, wanted);
    std::string text = "|", rule = "|";
    for (const std::string& column : columns) {
        text += " " + label_of(column) + " |";
        rule += "---|";
    }
    text += "\n" + rule + "\n";
    for (const Json& row : rows) {
        text += "|";
        for (const std::string& column : columns)
            text += " " + escaped_markdown(readable(row.at(column))) + " |";
        text += "\n";
    }
    return text;
}

std::string html_of(const Json& rows, const std::string& title, const std::string& remarks) {
    const std::vector<std::string> columns = columns_of(rows, {});
    std::string page = fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta "
        "charset=\"utf-8\"><title>{0}</title>\n<style>\n"
        "body {{ font: 14px/1.4 system-ui, sans-serif; margin: 2em; color: #222; }}\n"
        "table {{ border-collapse: collapse; }}\n"
        "th, td {{ padding: 2px 8px; border-bottom: 1px solid #ddd; text-align: right; }}\n"
        "th {{ position: sticky; top: 0; background: #fff; }}\n"
        "th.word, td.word {{ text-align: left; }}\n"
        "tr.ours {{ background: #eef6ee; }}\n"
        "</style></head><body>\n<h1>{0}</h1>\n<table>\n<thead><tr>",
        escaped_html(title));
    for (const std::string& column : columns)
        page += fmt::format("<th>{}</th>", escaped_html(label_of(column)));
    page += "</tr></thead>\n<tbody>\n";
    for (const Json& row : rows) {
        page += row.value("codec", "") == "ravel" ? "<tr class=\"ours\">" : "<tr>";
        for (const std::string& column : columns) {
            const Json& value = row.at(column);
            page += fmt::format("<td{}>{}</td>", value.is_string() ? " class=\"word\"" : "",
                                escaped_html(readable(value)));
        }
        page += "</tr>\n";
    }
    page += fmt::format("</tbody></table>\n<pre>{}</pre>\n</body></html>\n", escaped_html(remarks));
    return page;
}

}  // namespace ravel::tool
