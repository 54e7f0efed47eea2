// spec/priors.txt says what codec/ has: blocks of contexts in order, their sizes, their letters.
// With RAVEL_SPEC_WRITE=1 the file is written anew; read the diff.
#include <catch2/catch.hpp>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include "predict/priors.h"
#include "spec/context_names.h"
#include "walk/priors.h"

using namespace ravel;

namespace {

const std::string kFile = std::string(RAVEL_SPEC_FOLDER) + "/priors.txt";

// Fails unless the blocks fill the contexts without a gap.
void add_stream(std::string& text, const char* name, unsigned seen,
                const std::vector<test::NamedBlock>& blocks, std::string_view letters,
                Context count) {
    text += "\nstream " + std::string(name) + " " + std::to_string(seen) + "\n";
    Context at = 0;
    for (const auto& [block_name, block] : blocks) {
        REQUIRE(block.base == at);
        at = block.end();
        std::ostringstream head;
        head << "block " << block_name << " " << block.base << " " << block.a << "," << block.b
             << "," << block.c << "," << block.d << "\n";
        text += head.str();
        for (Context from = block.base; from < at; from += 96) {
            for (Context c = from; c < std::min(from + 96, at); ++c)
                text += c < letters.size() ? letters[c] : 'P';
            text += "\n";
        }
    }
    REQUIRE(at == count);
    REQUIRE(letters.size() <= count);
}

std::string text_of_code() {
    std::string text =
        "# What models know before their first flag: chapter 4.6 of format.md.\n"
        "#   stream NAME SEEN           the stream's models with a letter other than P have seen "
        "so "
        "many flags\n"
        "#   block NAME BASE A,B,C,D    contexts BASE .. BASE + A*B*C*D - 1, the last coordinate "
        "fastest\n"
        "#   letters                    one per context, in lines of 96 at most\n";
    add_stream(text, "surface", surface::kPriorSeen, test::surface_blocks(), surface::kPriors,
               surface::kContexts);
    add_stream(text, "tet", tet::kPriorSeen, test::tet_blocks(), tet::kPriors, tet::kContexts);
    add_stream(text, "positions", kResidualPriorSeen, test::position_blocks(), kResidualPriors,
               ResidualContexts::count);
    return text;
}

}  // namespace

TEST_CASE("spec/priors.txt has the blocks and letters of the code") {
    const std::string text = text_of_code();
    if (std::getenv("RAVEL_SPEC_WRITE") != nullptr) std::ofstream(kFile) << text;
    std::ifstream in(kFile);
    std::ostringstream found;
    found << in.rdbuf();
    REQUIRE(in.good());
    CHECK(found.str() == text);
}
