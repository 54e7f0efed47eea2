#include "ravel/encode_options.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

namespace ravel::tool {
namespace {

constexpr int kFastLevel = 3;

// CLI11's own ranges let NaN pass and print hundreds of digits.
CLI::Validator between(double least, double most, const char* words) {
    return {[=](std::string& text) {
                double value = 0;
                const char* const end = text.data() + text.size();
                const auto [stop, problem] = std::from_chars(text.data(), end, value);
                const bool good =
                    problem == std::errc() && stop == end && value >= least && value <= most;
                return good ? std::string() : fmt::format("'{}' is not {}", text, words);
            },
            ""};
}
CLI::Validator positive_number() {
    return between(1e-300, 1e299, "a number above 0");
}
CLI::Validator percentage() {
    return between(0, 1000, "a percentage from 0 to 1000");
}

// A number, or a power of two written 2^-10.
double step_of(const std::string& text) {
    const bool power = text.starts_with("2^");
    const char* const end = text.data() + text.size();
    double value = 0;
    const auto [stop, problem] = std::from_chars(text.data() + (power ? 2 : 0), end, value);
    const bool read = problem == std::errc() && stop == end;
    const double step = power ? std::exp2(value) : value;
    int exponent = 0;
    if (!read || !(step > 0) || !std::isfinite(step) || std::frexp(step, &exponent) != 0.5)
        throw CLI::ValidationError(
            "--lattice", fmt::format("'{}' is not a power of two, such as 2^-10 or 0.5", text));
    return step;
}

// NAME:bits=12, NAME:max-error=1e-3, NAME:max-error-relative=1e-4, NAME:octahedral=10. The name
// ends at the last colon.
AttributeOptions attribute_of(const std::string& text) {
    AttributeOptions options;
    const std::size_t colon = text.rfind(':'), equals = text.find('=', colon + 1);
    const auto fail = [&] {
        return CLI::ValidationError("--attribute",
                                    fmt::format("'{}' is not NAME:bits=N, NAME:max-error=E, "
                                                "NAME:max-error-relative=E or NAME:octahedral=N",
                                                text));
    };
    if (colon == std::string::npos || colon == 0 || equals == std::string::npos) throw fail();
    options.name = text.substr(0, colon);
    const std::string what = text.substr(colon + 1, equals - colon - 1);
    const char *const begin = text.data() + equals + 1, *const end = text.data() + text.size();
    const auto read = [&](auto& into) {
        const auto [stop, problem] = std::from_chars(begin, end, into.emplace());
        if (problem != std::errc() || stop != end) throw fail();
    };
    if (what == "bits")
        read(options.bits);
    else if (what == "max-error")
        read(options.max_error);
    else if (what == "max-error-relative")
        read(options.max_error_relative);
    else if (what == "octahedral")
        read(options.octahedral);
    else
        throw fail();
    return options;
}

}  // namespace

void add_encode_flags(CLI::App& verb, EncodeFlags& flags) {
    auto* bits = verb.add_option("--position-bits", flags.position_bits,
                                 "Positions on a grid of 2^N steps along the longest side, or on a "
                                 "coarser one that they lie on already")
                     ->check(CLI::Range(1, 30))
                     ->type_name("N")
                     ->group("Positions");
    auto* error = verb.add_option("--max-error", flags.max_error,
                                  "Positions on a grid; no coordinate moves by more than E")
                      ->check(positive_number())
                      ->type_name("E")
                      ->group("Positions");
    auto* relative = verb.add_option("--max-error-relative", flags.max_error_relative,
                                     "The same, E in diagonals of the bounding box")
                         ->check(positive_number())
                         ->type_name("E")
                         ->group("Positions");
    auto* lattice =
        verb.add_option_function<std::string>(
                "--lattice", [&flags](const std::string& text) { flags.lattice = step_of(text); },
                "Positions on multiples of STEP, a power of two such as 2^-10; meshes packed one "
                "by "
                "one agree where they meet")
            ->type_name("STEP")
            ->group("Positions");
    auto* lossless =
        verb.add_flag("--lossless", flags.lossless, "Positions to the last bit (the default)")
            ->group("Positions");
    verb.add_flag("--float32", flags.float32, "Round float64 positions to float32 first")
        ->excludes(bits)
        ->excludes(error)
        ->group("Positions");
    const std::array<CLI::Option*, 5> grids{bits, error, relative, lattice, lossless};
    for (std::size_t i = 0; i < grids.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) grids[i]->excludes(grids[j]);
    verb.add_option_function<std::vector<std::string>>(
            "--attribute",
            [&flags](const std::vector<std::string>& all) {
                for (const std::string& one : all) flags.attributes.push_back(attribute_of(one));
            },
            "An attribute of floats within a bound: NAME:bits=N along its range, NAME:max-error=E, "
            "NAME:max-error-relative=E (in ranges) or NAME:octahedral=N (unit vectors); others are "
            "kept to the last bit")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->type_name("NAME:WHAT=N")
        ->group("Attributes");
    verb.add_flag("--keep-order", flags.keep_order,
                  "Restore the order of points and cells and where each polygon starts")
        ->group("Connectivity");
    verb.add_option(
            "--strip-budget", flags.strip_budget,
            "Cells that the strip may add when it is read as the walk runs, in percent (2.5 "
            "for polygons, 12 for tets if not given); beyond that it is mended when made")
        ->check(percentage())
        ->type_name("PERCENT")
        ->group("Connectivity");
    auto* level = verb.add_option("--level", flags.level, "zstd's level, 1 to 22 (19 if not given)")
                      ->check(CLI::Range(1, 22))
                      ->type_name("L")
                      ->group("Effort");
    verb.add_flag("--fast", flags.fast,
                  "Mostly made and decoded at twice the speed or more, and larger: parts, mirrors "
                  "and planes are not looked for; zstd's level 3")
        ->excludes(level)
        ->group("Effort");
}

void add_threads_flag(CLI::App& verb, EncodeFlags& flags) {
    flags.threads = 0;
    verb.add_option("--threads", flags.threads,
                    "Threads that may work at a time (all there are if not given); the file is the "
                    "same")
        ->check(CLI::Range(1, 1024))
        ->type_name("N")
        ->group("Effort");
}

EncodeOptions options_of(const EncodeFlags& flags) {
    EncodeOptions options;
    if (flags.position_bits > 0) options.position_bits = flags.position_bits;
    if (flags.max_error > 0) options.max_error = flags.max_error;
    if (flags.max_error_relative > 0) options.max_error_relative = flags.max_error_relative;
    if (flags.lattice > 0) options.lattice = flags.lattice;
    options.float32 = flags.float32;
    options.keep_order = flags.keep_order;
    options.attributes = flags.attributes;
    if (flags.strip_budget >= 0) options.strip_budget = flags.strip_budget;
    if (flags.level > 0) options.level = flags.level;
    options.fast = flags.fast;
    options.threads = flags.threads;
    if (flags.fast) options.level = kFastLevel;
    return options;
}

std::string words_for(const EncodeOptions& options) {
    std::string words = "lossless";
    if (options.position_bits) words = fmt::format("{} bits", *options.position_bits);
    if (options.max_error) words = fmt::format("error <= {:g}", *options.max_error);
    if (options.max_error_relative)
        words = fmt::format("error <= {:g} diagonals", *options.max_error_relative);
    if (options.lattice) words = fmt::format("lattice {:g}", *options.lattice);
    if (options.float32) words += ", float32";
    if (options.keep_order) words += ", order kept";
    for (const AttributeOptions& a : options.attributes)
        words += fmt::format(", {} rounded", a.name);
    if (options.level != EncodeOptions{}.level) words += fmt::format(", level {}", options.level);
    return words;
}

}  // namespace ravel::tool
