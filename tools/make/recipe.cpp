#include "make/recipe.h"

#include <charconv>

namespace ravel::make {
namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

Recipe::Word* find(Recipe& recipe, std::string_view key) {
    for (Recipe::Word& word : recipe.words)
        if (word.key == key) {
            word.used = true;
            return &word;
        }
    return nullptr;
}

template <class T>
bool parse(std::string_view text, T& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size() && !text.empty();
}

template <class T>
T bounded(Recipe& recipe, std::string_view key, T otherwise, T low, T high) {
    const Recipe::Word* word = find(recipe, key);
    if (!word) return otherwise;
    T value{};
    if (!parse(word->value, value) || !(value >= low) || !(value <= high)) {
        if (recipe.complaint.empty())
            recipe.complaint = std::string(key) + " must be a number from " + std::to_string(low) +
                               " to " + std::to_string(high);
        return otherwise;
    }
    return value;
}

}  // namespace

bool Recipe::has(std::string_view key) {
    return find(*this, key) != nullptr;
}

std::uint64_t Recipe::integer(std::string_view key, std::uint64_t otherwise, std::uint64_t low,
                              std::uint64_t high) {
    return bounded(*this, key, otherwise, low, high);
}

double Recipe::number(std::string_view key, double otherwise, double low, double high) {
    return bounded(*this, key, otherwise, low, high);
}

void Recipe::sizes(std::string_view key, std::uint64_t* values, int count, std::uint64_t high) {
    const Word* word = find(*this, key);
    if (!word || word->value.empty()) return;
    const auto parts = split(word->value, 'x');
    bool good = parts.size() <= static_cast<std::size_t>(count);
    for (int i = 0; good && i < count; ++i) {
        const std::size_t part = static_cast<std::size_t>(i) < parts.size()
                                     ? static_cast<std::size_t>(i)
                                     : parts.size() - 1;
        good = parse(parts[part], values[i]) && values[i] >= 1 && values[i] <= high;
        if (!good) values[i] = 1;
    }
    if (!good && complaint.empty())
        complaint =
            std::string(key) + " must be like 20x20x20, each from 1 to " + std::to_string(high);
}

std::string Recipe::verdict() const {
    if (!complaint.empty()) return complaint;
    for (const Word& word : words)
        if (!word.used) return "\"" + word.key + "\" is not known here";
    return {};
}

Recipe parse_recipe(std::string_view text) {
    Recipe recipe;
    recipe.text = text;
    const std::size_t colon = text.find(':');
    recipe.family = text.substr(0, colon);
    if (colon == std::string_view::npos) return recipe;
    for (std::string_view word : split(text.substr(colon + 1), ',')) {
        if (word.empty()) continue;
        const std::size_t equals = word.find('=');
        Recipe::Word parsed;
        parsed.key = word.substr(0, equals);
        if (equals != std::string_view::npos) parsed.value = word.substr(equals + 1);
        recipe.words.push_back(std::move(parsed));
    }
    return recipe;
}

}  // namespace ravel::make
