// The names that spec/format.md gives to blocks of contexts, in the order of each stream.
#pragma once

#include <string>
#include <vector>

#include "predict/residual_context.h"
#include "walk/contexts.h"

namespace ravel::test {

struct NamedBlock {
    const char* name;
    ContextBlock block;
};

inline const std::vector<NamedBlock>& surface_blocks() {
    static const std::vector<NamedBlock> blocks{
        {"kDegree", surface::kDegree},       {"kDegreeRest", surface::kDegreeRest},
        {"kZipRight", surface::kZipRight},   {"kZipLeft", surface::kZipLeft},
        {"kZipMiddle", surface::kZipMiddle}, {"kNew", surface::kNew},
        {"kOldNear", surface::kOldNear},     {"kOldSide", surface::kOldSide},
        {"kOldSteps", surface::kOldSteps},   {"kOldFar", surface::kOldFar},
        {"kBorder", surface::kBorder},       {"kFlip", surface::kFlip},
        {"kCopy", surface::kCopy},           {"kCopyNear", surface::kCopyNear},
        {"kCopyOf", surface::kCopyOf},       {"kPrecedent", surface::kPrecedent}};
    return blocks;
}

inline const std::vector<NamedBlock>& tet_blocks() {
    static const std::vector<NamedBlock> blocks{{"kLowest", tet::kLowest},
                                                {"kNew", tet::kNew},
                                                {"kNext", tet::kNext},
                                                {"kNear", tet::kNear},
                                                {"kNearRank", tet::kNearRank},
                                                {"kOldFar", tet::kOldFar},
                                                {"kGlue", tet::kGlue},
                                                {"kBorder", tet::kBorder},
                                                {"kFlip", tet::kFlip},
                                                {"kCopy", tet::kCopy},
                                                {"kCopyNear", tet::kCopyNear},
                                                {"kCopyOf", tet::kCopyOf},
                                                {"kLed", tet::kLed},
                                                {"kLedBorder", tet::kLedBorder},
                                                {"kFold", tet::kFold},
                                                {"kFoldNew", tet::kFoldNew},
                                                {"kFoldNear", tet::kFoldNear},
                                                {"kFoldRank", tet::kFoldRank},
                                                {"kFoldAge", tet::kFoldAge},
                                                {"kFoldBorders", tet::kFoldBorders},
                                                {"kFoldBorder", tet::kFoldBorder}};
    return blocks;
}

inline const std::vector<NamedBlock>& position_blocks() {
    using R = ResidualContexts;
    static const std::vector<NamedBlock> blocks{{"size", R::size},
                                                {"second", R::second},
                                                {"escape", R::escape},
                                                {"escape_same", R::escape_same},
                                                {"echo", R::echo},
                                                {"same", R::same},
                                                {"minus_zero", R::minus_zero},
                                                {"whole_zero", R::whole_zero},
                                                {"leading", R::leading},
                                                {"rest_zero", R::rest_zero},
                                                {"level", R::level},
                                                {"follow", R::follow},
                                                {"follow_same", R::follow_same},
                                                {"along", R::along},
                                                {"known", R::known},
                                                {"pair", R::pair},
                                                {"all_same", R::all_same},
                                                {"sign", R::sign},
                                                {"sign_of_large", R::sign_of_large},
                                                {"lead", R::lead},
                                                {"lead_place", R::lead_place},
                                                {"along_round", R::along_round},
                                                {"size_by", R::size_by}};
    return blocks;
}

// "kBorder(0, 1, 2, 0)": with as many coordinates as have more than one value.
inline std::string name_of_context(const std::vector<NamedBlock>& blocks, Context context) {
    for (const auto& [name, block] : blocks) {
        if (context >= block.end()) continue;
        Context at = context - block.base;
        const std::uint32_t l = at % block.d, k = (at /= block.d) % block.c,
                            j = (at /= block.c) % block.b, i = at / block.b;
        const std::uint32_t all[] = {i, j, k, l};
        const int count = block.d > 1 ? 4 : block.c > 1 ? 3 : block.b > 1 ? 2 : 1;
        std::string text = name;
        for (int n = 0; n < count; ++n) text += (n == 0 ? "(" : ", ") + std::to_string(all[n]);
        return text + ")";
    }
    return "?";
}

}  // namespace ravel::test
