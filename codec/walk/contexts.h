// Which context a code of the walk is read under.
#pragma once

#include "base/context.h"

namespace ravel {

namespace surface {
inline constexpr ContextBlock kDegree{0, 4, 4, 6};  // last cell's, gate cell's, step
inline constexpr ContextBlock kDegreeRest{kDegree.end(), kNumberSteps};
inline constexpr ContextBlock kZipRight{kDegreeRest.end(), 3, 8, 5,
                                        2};  // degree, corners, other end's, first
inline constexpr ContextBlock kZipLeft{kZipRight.end(), 3, 8, 5, 2};
inline constexpr ContextBlock kZipMiddle{kZipLeft.end(), 3, 8};
inline constexpr ContextBlock kNew{kZipMiddle.end(), 3, 3, 3,
                                   3};  // degree, zips right, left, border near
inline constexpr ContextBlock kOldNear{kNew.end(), 2};
inline constexpr ContextBlock kOldSide{kOldNear.end(), 2};
inline constexpr ContextBlock kOldSteps{kOldSide.end(), kNumberSteps};
inline constexpr ContextBlock kOldFar{kOldSteps.end(), kNumberSteps};
inline constexpr ContextBlock kBorder{kOldFar.end(), 2, 2, 3,
                                      3};  // front border at start, end; kind of vertices
inline constexpr ContextBlock kLink{kBorder.end(), 2, 3};  // returned, exits
inline constexpr ContextBlock kExit{kLink.end(), 27, 3, 4,
                                    4};  // which and last turns, exits left, corners at its ends
inline constexpr ContextBlock kFlip{kExit.end(), 3};  // gate cell's
inline constexpr ContextBlock kCopy{kFlip.end(), 2};  // last vertex's
inline constexpr ContextBlock kCopyOf{kCopy.end(), kNumberSteps};
inline constexpr Context kContexts = kCopyOf.end();
}  // namespace surface

namespace tet {
inline constexpr ContextBlock kLowest{0, 14, 4, 4, 2};        // height, folds, fan, border across
inline constexpr ContextBlock kNew{kLowest.end(), 14, 4, 3};  // height, folds, borders across
inline constexpr ContextBlock kNext{kNew.end(), 12, 3, 2};    // place in the list, folds, above
inline constexpr ContextBlock kOldFar{kNext.end(), kNumberSteps};
inline constexpr ContextBlock kGlue{kOldFar.end(), 2};
inline constexpr ContextBlock kBorder{kGlue.end(), 7, 4, 3,
                                      3};  // flatness, border vertices, apex, facet
inline constexpr ContextBlock kLink{kBorder.end(), 2, 3};
inline constexpr ContextBlock kExit{kLink.end(), 3, 3, 4, 4};  // which, exits left, ...
inline constexpr ContextBlock kFlip{kExit.end(), 3};
inline constexpr ContextBlock kCopy{kFlip.end(), 2};
inline constexpr ContextBlock kCopyOf{kCopy.end(), kNumberSteps};
inline constexpr Context kContexts = kCopyOf.end();
}  // namespace tet

}  // namespace ravel
