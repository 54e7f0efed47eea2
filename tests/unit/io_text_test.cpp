#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "io/attributes.h"
#include "io/decimals.h"
#include "io/file_bytes.h"
#include "io/text_reader.h"
#include "support/temp_files.h"

using namespace ravel;
using namespace ravel::io;

TEST_CASE("an empty text has no words and no lines", "[io]") {
    TextReader in("", "t");
    CHECK(in.at_end());
    CHECK(in.word().empty());
    CHECK_FALSE(in.next_line());
    CHECK(in.expected("a number").detail == "t:1: expected a number, but the file ends");
}

TEST_CASE("words cross lines and skip comments, line words do not", "[io]") {
    TextReader in("a # no\r\n\n b c", "t");
    CHECK(in.word() == "a");
    CHECK(in.line_word().empty());
    CHECK(in.word() == "b");
    CHECK(in.line() == 3);
    CHECK(in.line_word() == "c");
    CHECK(in.line_word().empty());
}

TEST_CASE("a word ends where a comment begins if the format says so", "[io]") {
    TextReader in("1#one\n2.5# two\n#\n3 4", "t", {.comment = '#', .within_words = true});
    CHECK(in.word() == "1");
    CHECK(in.line_ended());
    CHECK(in.peek() == "2.5");
    CHECK(in.word() == "2.5");
    CHECK(in.line_word().empty());
    CHECK(in.word() == "3");
    CHECK(in.line_word() == "4");
    CHECK(TextReader("a#b", "t").word() == "a#b");
}

TEST_CASE("a backslash at the end of a line joins lines where the format says so", "[io]") {
    TextReader in("f 1 \\\n2\\\r\n 3\ng", "t", {.comment = '#', .continued_lines = true});
    for (const char* word : {"f", "1", "2", "3"}) CHECK(in.line_word() == word);
    CHECK(in.line_word().empty());
    CHECK(in.word() == "g");
    CHECK(in.line() == 4);
}

TEST_CASE("carriage returns alone end lines in a file that has no line feeds", "[io]") {
    TextReader in("a\rb", "t");
    CHECK(in.line_word() == "a");
    CHECK(in.line_word().empty());
    CHECK(in.word() == "b");
    CHECK(in.line() == 2);
}

TEST_CASE("numbers are read whole or not at all", "[io]") {
    double x = 0;
    std::int32_t i = 0;
    for (const char* word : {"", "+", "-", "1x", "0x10", "1e", "--1", "+-1", "1.0.0"})
        CHECK_FALSE(parse_real(word, x));
    for (const char* word : {"", "1.0", "2147483648", "+", "a"})
        CHECK_FALSE(parse_integer(word, i));
    CHECK((parse_real("+1.5D+02", x) && x == 150));
    CHECK((parse_real("1e999", x) && std::isinf(x)));
    CHECK((parse_real("1e-999", x) && x == 0));
    CHECK((parse_real("nan", x) && std::isnan(x)));
    CHECK((parse_real("-inf", x) && x < 0));
    CHECK((parse_integer("+7", i) && i == 7));
    CHECK((parse_real("-0", x) && std::signbit(x)));
}

TEST_CASE("float32 is chosen only where every number survives it", "[io]") {
    const double few[] = {0.1, -0.0, 1e30, std::numeric_limits<double>::infinity(),
                          std::numeric_limits<double>::quiet_NaN()};
    CHECK(floats_from_text(few, 1).scalar == Scalar::f32);
    CHECK(std::signbit(floats_from_text(few, 1).as<float>()[1]));
    const double many[] = {0.1, 0.123456789012};
    CHECK(floats_from_text(many, 1).scalar == Scalar::f64);
    for (const double x : {1e300, 1e-60, 16777217.0, double(0.1f)})
        CHECK_FALSE(survives_float32(x));
    CHECK(floats_from_text({}, 3).scalar == Scalar::f32);
}

TEST_CASE("every float32 written as text survives reading as float32", "[io]") {
    std::uint32_t bits = 12345;
    for (int i = 0; i < 20000; ++i) {
        bits = bits * 1664525u + 1013904223u;
        const float value = std::bit_cast<float>(bits);
        if (std::isnan(value)) continue;
        std::string text;
        append_number(text, value);
        double wide = 0;
        REQUIRE(parse_real(text, wide));
        REQUIRE(survives_float32(wide));
        REQUIRE(std::bit_cast<std::uint32_t>(static_cast<float>(wide)) == bits);
    }
}

TEST_CASE("whole numbers of text are integers, however they are written", "[io]") {
    TextNumbers whole, broken;
    for (const char* word : {"1", "2.0", "-3e2"}) CHECK(whole.add(word));
    CHECK(whole.take(1).scalar == Scalar::i32);
    for (const char* word : {"1", "0.5"}) CHECK(broken.add(word));
    CHECK(broken.take(1).scalar == Scalar::f32);
    CHECK_FALSE(broken.add("x"));
    TextNumbers wide;
    CHECK(wide.add("9007199254740993"));
    CHECK(wide.take(1).as<std::int64_t>()[0] == 9007199254740993);
}

TEST_CASE("missing files, directories and unwritable paths are told apart", "[io]") {
    const test::TempFolder folder;
    CHECK(read_file(folder / "none").error().detail.find("No such file") != std::string::npos);
    CHECK(read_file(folder / "").error().detail.find("directory") != std::string::npos);
    CHECK(write_file(folder / "none/x", "").error().code == Code::unwritable);
    if (std::filesystem::exists("/dev/full"))
        CHECK(write_file("/dev/full", "x").error().code == Code::unwritable);
    CHECK(write_file(folder / "x", "abc").ok());
    CHECK(*read_file(folder / "x") == "abc");
}

TEST_CASE("an unknown ending is refused for reading and writing", "[io]") {
    CHECK(read_mesh("a.xyz").error().code == Code::unreadable);
    CHECK(read_mesh("dir.obj/a").error().detail.find("known format") != std::string::npos);
    CHECK(write_mesh(Mesh{}, "a", {}).error().code == Code::unwritable);
    CHECK(known_endings().size() == 10);
}
