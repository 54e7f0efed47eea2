// Damage as disks and networks do it: cut, flipped, exchanged.
#include "malformed/victims.h"

#include "make/random.h"

using namespace ravel;

TEST_CASE("every truncation is refused") {
    for (const auto& v : test::victims())
        for (std::size_t size = 0; size < v.file.size(); ++size) {
            const Bytes cut(v.file.begin(), v.file.begin() + static_cast<std::ptrdiff_t>(size));
            const auto decoded = decode(cut);
            INFO(v.name << " cut to " << size);
            REQUIRE_FALSE(decoded.ok());
            REQUIRE((decoded.error().code == Code::truncated || size < 5));
            REQUIRE_FALSE(inspect(cut).ok());
        }
}

TEST_CASE("every flipped bit gives an error or a mesh") {
    for (const auto& v : test::victims())
        for (std::size_t bit = 0; bit < 8 * v.file.size(); ++bit) {
            Bytes bad = v.file;
            bad[bit / 8] ^= static_cast<std::byte>(1u << bit % 8);
            INFO(v.name << ", bit " << bit);
            REQUIRE(test::unsafe(bad) == "");
        }
}

TEST_CASE("a flipped bit in a section's bytes is always seen") {
    const auto v = test::victim("polygons:mixed,size=4x4,attributes");
    const auto info = inspect(v.file);
    REQUIRE(info.ok());
    std::size_t bytes = 0;
    for (const SectionInfo& section : info->sections) bytes += section.bytes;
    std::size_t seen = 0;
    for (std::size_t at = 0; at < v.file.size(); ++at) {
        Bytes bad = v.file;
        bad[at] ^= std::byte{16};
        const auto decoded = decode(bad);
        CHECK_FALSE(decoded.ok());
        seen += !decoded.ok() && decoded.error().code == Code::checksum_mismatch;
    }
    CHECK(seen >= bytes);
}

TEST_CASE("every byte replaced by a random one gives an error or a mesh, checksums fixed") {
    make::Random random{9};
    for (const auto& v : test::victims()) {
        const auto parts = test::take_apart(v.file);
        REQUIRE(parts);
        for (std::size_t p = 0; p < parts->size(); ++p)
            for (std::size_t at = 0; at < (*parts)[p].raw.size(); ++at)
                for (int i = 0; i < 3; ++i) {
                    auto bad = *parts;
                    bad[p].raw[at] =
                        i == 0 ? ~bad[p].raw[at] : static_cast<std::byte>(random.next());
                    INFO(v.name << ", " << name_of(bad[p].id) << " byte " << at);
                    REQUIRE(test::unsafe(test::put_together(bad)) == "");
                }
    }
}

TEST_CASE("every truncated, padded or emptied section gives an error or a mesh") {
    for (const auto& v : test::victims()) {
        const auto parts = test::take_apart(v.file);
        for (std::size_t p = 0; p < parts->size(); ++p) {
            const std::size_t size = (*parts)[p].raw.size();
            for (std::size_t cut = 0; cut <= size + 3; ++cut) {
                auto bad = *parts;
                bad[p].raw.resize(cut, std::byte{0xFF});
                INFO(v.name << ", " << name_of(bad[p].id) << " of " << size << " bytes as " << cut);
                REQUIRE(test::unsafe(test::put_together(bad)) == "");
            }
        }
    }
}

TEST_CASE("sections removed or doubled are refused, those exchanged give an error or a mesh") {
    for (const auto& v : test::victims()) {
        const auto parts = test::take_apart(v.file);
        for (std::size_t p = 0; p < parts->size(); ++p) {
            INFO(v.name << ", " << name_of((*parts)[p].id));
            auto less = *parts;
            less.erase(less.begin() + static_cast<std::ptrdiff_t>(p));
            if ((*parts)[p].id != SectionId::names)
                CHECK_FALSE(decode(test::put_together(less)).ok());
            auto twice = *parts;
            twice.insert(twice.begin() + static_cast<std::ptrdiff_t>(p), (*parts)[p]);
            CHECK_FALSE(decode(test::put_together(twice)).ok());
            for (std::size_t q = 0; q < p; ++q) {
                auto other = *parts;
                std::swap(other[p].raw, other[q].raw);
                CHECK(test::unsafe(test::put_together(other)) == "");
            }
        }
    }
}

TEST_CASE("sections of another file give an error or a mesh") {
    const auto all = test::victims();
    for (const auto& a : all)
        for (const auto& b : all) {
            const auto x = *test::take_apart(a.file), y = *test::take_apart(b.file);
            for (std::size_t p = 0; p < x.size(); ++p)
                for (std::size_t q = 0; q < y.size(); ++q) {
                    if (x[p].id != y[q].id) continue;
                    auto mixed = x;
                    mixed[p].raw = y[q].raw;
                    INFO(a.name << " with " << name_of(x[p].id) << " of " << b.name);
                    REQUIRE(test::unsafe(test::put_together(mixed)) == "");
                }
        }
}

TEST_CASE("random bytes after the magic are refused") {
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        make::Random random{seed};
        Bytes bytes(kMagic.begin(), kMagic.end());
        bytes.push_back(std::byte{kVersion});
        for (std::uint64_t left = random.below(200); left > 0; --left)
            bytes.push_back(static_cast<std::byte>(random.next()));
        CHECK_FALSE(decode(bytes).ok());
    }
}
