#include "ravel/viewer_page.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>

#include "ravel/input_file.h"

namespace ravel::tool {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPlace = "<script id=\"ravel-data\" type=\"application/json\">null<";

// Where the build leaves the page and where it is installed, both seen from the program.
Result<std::string> read_page() {
    std::error_code ignored;
    const fs::path folder = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    for (const char* place : {RAVEL_PAGE_BUILT, RAVEL_PAGE_INSTALLED}) {
        const fs::path path = folder / place;
        if (!fs::exists(path, ignored)) continue;
        auto bytes = read_bytes(path.string());
        if (!bytes) return bytes.error();
        return std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    }
    const fs::path built = folder / RAVEL_PAGE_BUILT;
    return Error{Code::unreadable, 0,
                 "the viewer's page was not built; in ravel's sources `tools/install-deps && "
                 "tools/viewer/build " +
                     built.parent_path().string() + "` builds it"};
}

}  // namespace

Result<std::string> viewer_page(const Json& data) {
    auto page = read_page();
    if (!page) return page.error();
    const std::size_t at = page->find(kPlace);
    if (at == std::string::npos)
        return Error{Code::unreadable, 0, "the viewer's page is of another version of ravel"};
    // Names come from files: none may end the script.
    std::string text;
    for (const char c : data.dump(-1, ' ', false, Json::error_handler_t::replace))
        c == '<' ? text += "\\u003c" : text += c;
    page->replace(at + kPlace.size() - 5, 4, text);
    return page;
}

std::string base64_of(std::span<const std::byte> bytes) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (k < count ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0);
        for (std::size_t k = 0; k < 4; ++k)
            text += k <= count ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

}  // namespace ravel::tool
