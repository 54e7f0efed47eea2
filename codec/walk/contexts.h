// Which context a code of the walk is read under.
#pragma once

#include "base/context.h"

namespace ravel {

namespace surface {
inline constexpr ContextBlock kDegree{0, 4, 26, 6};  // gate cell's, angles at the gate's ends, step
inline constexpr ContextBlock kDegreeRest{kDegree.end(), kNumberSteps};
inline constexpr ContextBlock kZipRight{kDegreeRest.end(), 3, 8, 9,
                                        2};  // degree, corners, angle, first
inline constexpr ContextBlock kZipLeft{kZipRight.end(), 3, 8, 9, 2};
inline constexpr ContextBlock kZipMiddle{kZipLeft.end(), 3, 8};
inline constexpr ContextBlock kNew{kZipMiddle.end(), 3, 3, 3,
                                   3};  // degree, zips right, left, border near
inline constexpr ContextBlock kOldNear{kNew.end(), 1};
inline constexpr ContextBlock kOldSide{kOldNear.end(), 1};
inline constexpr ContextBlock kOldSteps{kOldSide.end(), kNumberSteps};
inline constexpr ContextBlock kOldFar{kOldSteps.end(), kNumberSteps};
inline constexpr ContextBlock kBorder{kOldFar.end(), 2, 2, 3,
                                      3};  // front border at start, end; kind of vertices
inline constexpr ContextBlock kFlip{kBorder.end(), 2};          // last cell's
inline constexpr ContextBlock kCopy{kFlip.end(), 2, 6};         // last vertex's, neighbours
inline constexpr ContextBlock kCopyNear{kCopy.end(), 5, 3, 2};  // rank, distance, is it the last?
inline constexpr ContextBlock kCopyOf{kCopyNear.end(), kNumberSteps};
inline constexpr ContextBlock kPrecedent{kCopyOf.end(), 4, 2, 3};  // agreed, likely, how sure
inline constexpr Context kContexts = kPrecedent.end();
}  // namespace surface

namespace tet {
inline constexpr ContextBlock kLowest{0, 8, 5, 4,
                                      20};  // height, folds, gap to the next, see ApexSigns
inline constexpr ContextBlock kNew{kLowest.end(), 14, 4, 3,
                                   6};                      // height, folds, borders, next height
inline constexpr ContextBlock kNext{kNew.end(), 12, 3, 2};  // place in the list, folds, above
inline constexpr ContextBlock kNear{kNext.end(), 1};
inline constexpr ContextBlock kNearRank{kNear.end(), kNumberSteps};
inline constexpr ContextBlock kOldFar{kNearRank.end(), kNumberSteps};
inline constexpr ContextBlock kGlue{kOldFar.end(), 2};
inline constexpr ContextBlock kBorder{kGlue.end(), 28, 3, 2, 9};  // see BorderSigns
inline constexpr ContextBlock kFlip{kBorder.end(), 2};
inline constexpr ContextBlock kCopy{kFlip.end(), 2, 6};
inline constexpr ContextBlock kCopyNear{kCopy.end(), 5, 3, 2};
inline constexpr ContextBlock kCopyOf{kCopyNear.end(), kNumberSteps};
inline constexpr ContextBlock kLed{kCopyOf.end(), 16, 4, 2,
                                   4};  // the leader's misses, those of all; new? mismatch
inline constexpr ContextBlock kLedBorder{kLed.end(), 2, 28, 3, 2};  // the leader's; the same
// Of the walk by folds:
inline constexpr ContextBlock kFold{kLedBorder.end(), 8, 5, 3, 4};  // tets round the edge, the next
                                                                    // one; times; borders
inline constexpr ContextBlock kFoldNew{kFold.end(), 6, 4, 4, 4};  // the same tets; borders, corners
                                                                  // on borders
inline constexpr ContextBlock kFoldNear{kFoldNew.end(), 4, 8};    // borders across; near? which?
inline constexpr ContextBlock kFoldRank{kFoldNear.end(), kNumberSteps};
inline constexpr ContextBlock kFoldAge{kFoldRank.end(), kNumberSteps};
inline constexpr ContextBlock kFoldBorders{kFoldAge.end(), 5, 2};  // how many; new?
inline constexpr ContextBlock kFoldBorder{kFoldBorders.end(), 22};
inline constexpr Context kContexts = kFoldBorder.end();
}  // namespace tet

}  // namespace ravel
