// Files, meshes and errors as replies. src/reply.mjs reads the fields in the order in which they
// are written here; the first text is empty, or the code of an error.
#pragma once

#include "decoder/reply.h"
#include "ravel/ravel.h"

namespace ravel::web {

struct Wanted {
    bool strip = false;    // the strip's steps
    bool surface = false;  // the boundary of tets
};

void describe(const Error& error, Reply& reply);
void describe(const FileInfo& info, Reply& reply);

// Indices become 32-bit in place (a block has fewer than 2^32 of anything; kNoIndex becomes
// 0xFFFFFFFF), so no second copy of the mesh is made; `decoded` is no mesh any more afterwards. The
// reply's arrays live in `decoded` and `more`.
void describe(Decoded& decoded, const Wanted& wanted, std::vector<Bytes>& more, Reply& reply);

}  // namespace ravel::web
