// Which context a code is read under. A context is a number; encoder and decoder keep one adaptive
// model for each. Blocks of contexts stand one after the other.
#pragma once

#include <algorithm>
#include <cstdint>

namespace ravel {

using Context = std::uint32_t;

// A block of contexts with up to four small coordinates; each is clamped into its range.
struct ContextBlock {
    Context base = 0;
    std::uint32_t a = 1, b = 1, c = 1, d = 1;

    constexpr Context end() const { return base + a * b * c * d; }
    constexpr Context at(std::uint32_t i, std::uint32_t j = 0, std::uint32_t k = 0,
                         std::uint32_t l = 0) const {
        i = std::min(i, a - 1), j = std::min(j, b - 1), k = std::min(k, c - 1), l = std::min(l, d - 1);
        return base + ((i * b + j) * c + k) * d + l;
    }
};

// Numbers are coded as the unary count of their bits, each step under its own context, and the bits
// below the highest as they are.
inline constexpr std::uint32_t kNumberSteps = 64;

namespace surface {
inline constexpr ContextBlock kDegree{0, 4, 4, 6};                  // last cell's, gate cell's, step
inline constexpr ContextBlock kDegreeRest{kDegree.end(), kNumberSteps};
inline constexpr ContextBlock kZipRight{kDegreeRest.end(), 3, 8, 5, 2};  // degree, corners, other end's, first
inline constexpr ContextBlock kZipLeft{kZipRight.end(), 3, 8, 5, 2};
inline constexpr ContextBlock kZipMiddle{kZipLeft.end(), 3, 8};
inline constexpr ContextBlock kNew{kZipMiddle.end(), 3, 3, 3, 3};   // degree, zips right, left, border near
inline constexpr ContextBlock kOldNear{kNew.end(), 2};
inline constexpr ContextBlock kOldSide{kOldNear.end(), 2};
inline constexpr ContextBlock kOldSteps{kOldSide.end(), kNumberSteps};
inline constexpr ContextBlock kOldFar{kOldSteps.end(), kNumberSteps};
inline constexpr ContextBlock kBorder{kOldFar.end(), 2, 2, 3, 3};   // front border at start, end; kind of vertices
inline constexpr ContextBlock kLink{kBorder.end(), 2, 3};           // returned, exits
inline constexpr ContextBlock kExit{kLink.end(), 3, 3, 5, 5};       // which, exits left, corners at its ends
inline constexpr ContextBlock kFlip{kExit.end(), 3};                // gate cell's
inline constexpr ContextBlock kCopy{kFlip.end(), 2};                // last vertex's
inline constexpr ContextBlock kCopyOf{kCopy.end(), kNumberSteps};
inline constexpr Context kContexts = kCopyOf.end();
}  // namespace surface

namespace tet {
inline constexpr ContextBlock kFold{0, 3, 9, 2, 3};                 // asked before, fan, border, same apex
inline constexpr ContextBlock kNew{kFold.end(), 4, 4, 3};           // border mates, distinct apexes, fan
inline constexpr ContextBlock kOldNear{kNew.end(), 32};             // place in the list
inline constexpr ContextBlock kOldIsNear{kOldNear.end(), 4};
inline constexpr ContextBlock kOldFar{kOldIsNear.end(), kNumberSteps};
inline constexpr ContextBlock kGlue{kOldFar.end(), 2};
inline constexpr ContextBlock kBorder{kGlue.end(), 2, 4, 3};        // border mate, border vertices, apex
inline constexpr ContextBlock kLink{kBorder.end(), 2, 3};
inline constexpr ContextBlock kExit{kLink.end(), 3, 3, 4, 4};       // which, exits left, ...
inline constexpr ContextBlock kFlip{kExit.end(), 3};
inline constexpr ContextBlock kCopy{kFlip.end(), 2};
inline constexpr ContextBlock kCopyOf{kCopy.end(), kNumberSteps};
inline constexpr Context kContexts = kCopyOf.end();
}  // namespace tet

}  // namespace ravel
