#include "io/text_reader.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace ravel::io {

namespace {

constexpr bool is_blank(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

constexpr char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
}

float string_to(const char* text, char** stop, float) {
    return std::strtof(text, stop);
}
double string_to(const char* text, char** stop, double) {
    return std::strtod(text, stop);
}

// What std::from_chars does not take: numbers out of range and 'D' exponents.
template <class T>
bool parse_unusual(std::string_view word, T& value) {
    constexpr std::size_t kLongest = 400;
    if (word.empty() || word.size() > kLongest) return false;
    std::string copy(word);
    for (char& c : copy)
        if (c == 'd' || c == 'D') c = 'e';
    const bool plain = copy.find_first_not_of("+-.0123456789eE") == std::string::npos;
    if (!plain) return false;
    char* stop = nullptr;
    const T parsed = string_to(copy.c_str(), &stop, T{});
    if (stop != copy.c_str() + copy.size()) return false;
    value = parsed;
    return true;
}

template <class T>
bool parse_any_real(std::string_view word, T& value) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    const char* end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (error == std::errc{} && stop == end) return true;
    return parse_unusual(word, value);
}

}  // namespace

bool parse_real(std::string_view word, double& value) {
    return parse_any_real(word, value);
}
bool parse_real(std::string_view word, float& value) {
    return parse_any_real(word, value);
}

std::string lower_case(std::string_view word) {
    std::string lowered(word);
    std::transform(lowered.begin(), lowered.end(), lowered.begin(), lower);
    return lowered;
}

bool same_word(std::string_view a, std::string_view b) {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(),
                                              [](char x, char y) { return lower(x) == lower(y); });
}

TextReader::TextReader(std::string_view text, std::string file, TextRules rules)
    : begin_(text.data()),
      end_(text.data() + text.size()),
      at_(begin_),
      last_(begin_),
      file_(std::move(file)),
      rules_(rules) {
    if (text.starts_with("\xEF\xBB\xBF")) at_ = last_ = begin_ + 3;  // a byte order mark
    // Some programs of old end lines with a carriage return alone.
    if (text.find('\n') == std::string_view::npos && text.find('\r') != std::string_view::npos)
        line_end_ = '\r';
}

void TextReader::skip_blanks_in_line() {
    while (at_ != end_) {
        const char c = *at_;
        if (is_line_end(c)) return;
        if (is_blank(c)) {
            ++at_;
        } else if (c == rules_.comment && c != '\0') {
            const void* stop = std::memchr(at_, line_end_, static_cast<std::size_t>(end_ - at_));
            at_ = stop ? static_cast<const char*>(stop) : end_;
            return;
        } else if (c == '\\' && rules_.continued_lines) {
            const char* next = at_ + 1;
            if (next != end_ && *next == '\r' && line_end_ != '\r') ++next;
            if (next == end_ || !is_line_end(*next)) return;
            at_ = next + 1;
        } else {
            return;
        }
    }
}

std::string_view TextReader::word_here() {
    last_ = at_;
    const char stop = rules_.within_words ? rules_.comment : ' ';
    while (at_ != end_ && !is_blank(*at_) && *at_ != stop) ++at_;
    // "1/2\" at the end of a line is the word "1/2" and a continuation.
    if (rules_.continued_lines && at_ - last_ > 1 && at_[-1] == '\\' && at_ != end_ &&
        (*at_ == '\r' || *at_ == '\n'))
        --at_;
    return {last_, static_cast<std::size_t>(at_ - last_)};
}

std::string_view TextReader::word() {
    skip_blanks_in_line();
    while (at_ != end_ && is_line_end(*at_)) {
        ++at_;
        skip_blanks_in_line();
    }
    return word_here();
}

std::string_view TextReader::peek() {
    const std::string_view next = word();
    at_ = last_;
    return next;
}

std::string_view TextReader::line_word() {
    skip_blanks_in_line();
    return word_here();
}

bool TextReader::line_ended() {
    skip_blanks_in_line();
    return at_ == end_ || is_line_end(*at_);
}

std::string_view TextReader::rest_of_line() {
    last_ = at_;
    const void* stop = std::memchr(at_, line_end_, static_cast<std::size_t>(end_ - at_));
    const char* line_stop = stop ? static_cast<const char*>(stop) : end_;
    const char* first = at_;
    const char* last = line_stop;
    while (first != last && is_blank(*first)) ++first;
    while (first != last && is_blank(last[-1])) --last;
    at_ = line_stop;
    return {first, static_cast<std::size_t>(last - first)};
}

bool TextReader::next_line() {
    const void* stop = std::memchr(at_, line_end_, static_cast<std::size_t>(end_ - at_));
    at_ = stop ? static_cast<const char*>(stop) + 1 : end_;
    last_ = at_;
    return at_ != end_;
}

bool TextReader::next_filled_line() {
    while (line_ended()) {
        if (at_ == end_) return false;
        ++at_;
        last_ = at_;
    }
    return true;
}

std::string_view TextReader::take(std::size_t bytes) {
    last_ = at_;
    at_ += std::min(bytes, bytes_left());
    return {last_, static_cast<std::size_t>(at_ - last_)};
}

std::uint64_t TextReader::line() const {
    return 1 + static_cast<std::uint64_t>(std::count(begin_, last_, line_end_));
}

Error TextReader::error(const std::string& sentence) const {
    const std::uint64_t number = line();
    return {Code::unreadable, number, file_ + ":" + std::to_string(number) + ": " + sentence};
}

Error TextReader::expected(const std::string& what) const {
    constexpr std::size_t kShown = 40;
    std::string sentence = "expected " + what;
    if (last_ == end_) return error(sentence + ", but the file ends");
    if (is_blank(*last_) || at_ == last_) return error(sentence + ", but the line ends");
    std::string found(last_, std::min(static_cast<std::size_t>(at_ - last_), kShown));
    for (char& c : found)
        if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~') c = '?';
    return error(sentence + ", found '" + found + "'");
}

}  // namespace ravel::io
