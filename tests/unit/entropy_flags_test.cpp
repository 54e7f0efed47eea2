#include <catch2/catch.hpp>

#include <cmath>

#include "entropy/flag_decoder.h"
#include "entropy/flag_encoder.h"
#include "make/random.h"

using namespace ravel;

namespace {

// A sequence of flags over contexts and plain bits, with how often each context says yes.
struct Script {
    struct Event {
        std::uint32_t context;  // kPlain: `value` has `width` bits
        std::uint64_t value;
        int width;
    };
    static constexpr std::uint32_t kPlain = ~0u;
    std::uint32_t contexts = 1;
    std::vector<Event> events;
};

Script random_script(std::uint32_t seed) {
    make::Random random{seed};
    Script script;
    script.contexts = 1 + static_cast<std::uint32_t>(random.below(40));
    std::vector<std::uint32_t> chance(script.contexts);  // in 1/1000000
    for (std::uint32_t& c : chance) {
        static constexpr std::uint32_t kChances[] = {0,      30,     1000,   20000,  200000,
                                                     500000, 900000, 999900, 1000000};
        c = kChances[random.below(9)];
    }
    const std::uint64_t count = random.below(4000);
    for (std::uint64_t i = 0; i < count; ++i) {
        if (random.one_in(20)) {
            const int width = static_cast<int>(random.below(65));
            std::uint64_t value = random.next();
            if (width < 64) value &= (std::uint64_t{1} << width) - 1;
            script.events.push_back({Script::kPlain, value, width});
        } else {
            const auto context = static_cast<std::uint32_t>(random.below(script.contexts));
            script.events.push_back({context, random.below(1000000) < chance[context], 1});
        }
    }
    return script;
}

Bytes write(const Script& script) {
    FlagEncoder out;
    std::vector<FlagModel> models(script.contexts);
    for (const auto& e : script.events) {
        if (e.context == Script::kPlain)
            out.plain(e.value, e.width);
        else
            out.flag(models[e.context], e.value != 0);
    }
    return out.finish();
}

// Flags of one context that say yes with chance p each, and the bits they take.
double bits_per_flag(double p, std::size_t count, std::uint32_t seed) {
    make::Random random{seed};
    std::vector<bool> flags(count);
    for (std::size_t i = 0; i < count; ++i)
        flags[i] = static_cast<double>(random.next() >> 11) < p * 0x1p53;
    FlagEncoder out;
    FlagModel model;
    for (const bool f : flags) out.flag(model, f);
    return 8.0 * static_cast<double>(out.finish().size()) / static_cast<double>(count);
}

double entropy(double p) {
    return -p * std::log2(p) - (1 - p) * std::log2(1 - p);
}

}  // namespace

TEST_CASE("no flags take no bytes") {
    CHECK(FlagEncoder().finish().empty());
    FlagDecoder in({});
    CHECK_FALSE(in.exhausted());
    CHECK(in.finished());
}

TEST_CASE("a single flag comes back, either way") {
    for (const bool yes : {false, true}) {
        FlagEncoder out;
        FlagModel model, again;
        out.flag(model, yes);
        const Bytes bytes = out.finish();
        CHECK(bytes.size() == 1);
        FlagDecoder in(bytes);
        CHECK(in.flag(again) == yes);
        CHECK_FALSE(in.exhausted());
        CHECK(in.finished());
    }
}

TEST_CASE("flags over random contexts and plain bits come back") {
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        const Script script = random_script(seed);
        const Bytes bytes = write(script);
        FlagDecoder in(bytes);
        std::vector<FlagModel> models(script.contexts);
        bool same = true;
        for (const auto& e : script.events) {
            if (e.context == Script::kPlain)
                same = same && in.plain(e.width) == e.value;
            else
                same = same && in.flag(models[e.context]) == (e.value != 0);
        }
        INFO("seed " << seed);
        REQUIRE(same);
        REQUIRE_FALSE(in.exhausted());
        REQUIRE(in.finished());
    }
}

TEST_CASE("flags cost what their entropy says, within a few percent") {
    for (const double p :
         {0.5, 0.4, 0.3, 0.2, 0.15, 0.1, 0.07, 0.05, 0.03, 0.02, 0.01, 0.005, 0.002, 0.001}) {
        INFO("p " << p);
        const std::size_t count = 400000;
        const double constant = 64.0 / static_cast<double>(count);  // the adaptation, once
        // A model that follows the recent past is a few percent off where nothing ever changes.
        CHECK(bits_per_flag(p, count, 1) < 1.1 * entropy(p) + constant + 0.0006);
        CHECK(bits_per_flag(1 - p, count, 2) < 1.1 * entropy(p) + constant + 0.0006);
    }
}

TEST_CASE("flags that never miss cost next to nothing") {
    CHECK(bits_per_flag(0, 400000, 3) < 1.0 / 400);
}

TEST_CASE("reading past the end is safe and reported") {
    for (std::uint32_t seed = 0; seed < 50; ++seed) {
        const Script script = random_script(seed);
        Bytes bytes = write(script);
        bytes.resize(bytes.size() / 2);
        FlagDecoder in(bytes);
        std::vector<FlagModel> models(script.contexts);
        for (std::size_t i = 0; i < 100000; ++i) {
            in.flag(models[i % script.contexts]);
            if (i % 5 == 0) in.plain(64);
        }
        CHECK(in.exhausted());
    }
}

TEST_CASE("bits of any value are some flags") {
    make::Random random{5};
    Bytes bytes(3000);
    for (std::byte& b : bytes) b = static_cast<std::byte>(random.next());
    FlagDecoder in(bytes);
    std::vector<FlagModel> models(50);
    std::size_t read = 0;
    for (; !in.exhausted(); ++read) in.flag(models[random.below(50)]);
    CHECK(read > 8 * 3000 / 2);
}
