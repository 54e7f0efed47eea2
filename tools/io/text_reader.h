// Words and numbers of a text file, within a line or across lines, and errors that name the line.
#pragma once

#include <charconv>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

#include "ravel/result.h"

namespace ravel::io {

// Is the whole word one number? A leading '+', "nan", "inf", "infinity" and Fortran's 'D' exponents
// are taken too; too large or small a decimal becomes the nearest double (infinity, zero).
bool parse_real(std::string_view word, double& value);
bool parse_real(std::string_view word, float& value);  // rounded once, from the decimal

template <std::integral T>
bool parse_integer(std::string_view word, T& value) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    const char* end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    return error == std::errc{} && stop == end;
}

// ASCII only, whatever the locale: keywords of file formats.
std::string lower_case(std::string_view word);
bool same_word(std::string_view a, std::string_view b);  // upper and lower case are the same

struct TextRules {
    char comment = '#';            // starts a comment that ends with its line; '\0' for none
    bool within_words = false;     // it may start right behind a word: "0.9#red"
    bool continued_lines = false;  // a backslash at the end of a line joins the next one to it
};

// Keeps a view of `text`, which must outlive it. Lines are counted only when an error is made.
class TextReader {
  public:
    TextReader(std::string_view text, std::string file, TextRules rules = {});

    // Across lines. An empty word means that the text has ended.
    std::string_view word();
    std::string_view peek();  // the next word, which stays
    bool at_end() { return peek().empty(); }
    // The next word as a number; false (then `expected` tells) when there is none or it is no
    // number.
    template <class T>
    bool read(T& value) {
        return take_number(word(), value);
    }

    // Within the line. An empty word means that the line has ended (the line feed stays).
    std::string_view line_word();
    template <class T>
    bool read_in_line(T& value) {
        return take_number(line_word(), value);
    }
    bool line_ended();                // nothing but blanks or a comment is left of this line
    std::string_view rest_of_line();  // without blanks at its ends; comments are part of it
    bool next_line();                 // past the line feed; false when there is no further line
    // The next whole line that holds more than blanks and comments; false at the end of the text.
    bool next_filled_line();

    // Raw bytes for binary sections inside a text file; fewer than asked at the end of the file.
    std::string_view take(std::size_t bytes);
    std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }
    void seek(std::size_t offset) { at_ = last_ = begin_ + offset; }
    std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }

    // "FILE:LINE: sentence" at the line of the last word.
    Error error(const std::string& sentence) const;
    // "FILE:LINE: expected WHAT, found 'WORD'" or "... but the file (line) ends".
    Error expected(const std::string& what) const;
    std::uint64_t line() const;
    const std::string& file() const { return file_; }

  private:
    bool is_line_end(char c) const { return c == line_end_; }
    void skip_blanks_in_line();
    std::string_view word_here();
    template <class T>
    bool take_number(std::string_view found, T& value) {
        if constexpr (std::integral<T>) {
            return parse_integer(found, value);
        } else {
            return parse_real(found, value);
        }
    }

    const char* begin_;
    const char* end_;
    const char* at_;
    const char* last_;  // where the last word began
    char line_end_ = '\n';
    std::string file_;
    TextRules rules_;
};

}  // namespace ravel::io
