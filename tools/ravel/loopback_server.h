// Serves a few documents to the browsers of this machine and to nobody else. GET and HEAD only; no
// file is opened by a request. Own code, for the library that Debian has brings TLS and brotli
// along.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>

#include "ravel/result.h"

namespace ravel::tool {

struct Document {
    std::string type;  // e.g. "text/html; charset=utf-8"
    std::span<const char> bytes;
};

// The key is the path, e.g. "/". Listens on 127.0.0.1, on any free port where `port` is 0, and
// calls `ready` with the port. Comes back only on failure; a signal ends it.
Error serve_on_loopback(const std::map<std::string, Document>& documents, std::uint16_t port,
                        const std::function<void(std::uint16_t)>& ready);

}  // namespace ravel::tool
