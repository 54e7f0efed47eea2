#include "io/file_bytes.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

namespace ravel::io {

namespace {

struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

std::string reason(int error_number) {
    return std::generic_category().message(error_number);
}

Error unreadable(const std::string& path, const std::string& why) {
    return {Code::unreadable, 0, path + ": cannot be read: " + why};
}

Error unwritable(const std::string& path, const std::string& why) {
    return {Code::unwritable, 0, path + ": cannot be written: " + why};
}

}  // namespace

Result<std::string> read_file(const std::string& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        return unreadable(path, "it is a directory, not a file");
    errno = 0;
    const std::unique_ptr<std::FILE, Closer> file(std::fopen(path.c_str(), "rb"));
    if (!file) return unreadable(path, reason(errno));

    std::string bytes;
    std::error_code no_size;
    const auto size = std::filesystem::file_size(path, no_size);  // pipes have none
    // One byte more than the file has, so that the end is seen without growing.
    bytes.resize(no_size ? std::size_t{1} << 16 : static_cast<std::size_t>(size) + 1);
    std::size_t filled = 0;
    while (true) {
        const std::size_t got =
            std::fread(bytes.data() + filled, 1, bytes.size() - filled, file.get());
        filled += got;
        if (got == 0) break;
        if (filled == bytes.size()) bytes.resize(bytes.size() * 2);
    }
    if (std::ferror(file.get())) return unreadable(path, reason(errno));
    bytes.resize(filled);
    return bytes;
}

Status write_file(const std::string& path, std::string_view bytes) {
    errno = 0;
    std::unique_ptr<std::FILE, Closer> file(std::fopen(path.c_str(), "wb"));
    if (!file) return unwritable(path, reason(errno));
    if (std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size())
        return unwritable(path, reason(errno));
    // A full disk may only show when the last buffer goes out.
    if (std::fflush(file.get()) != 0) return unwritable(path, reason(errno));
    if (std::fclose(file.release()) != 0) return unwritable(path, reason(errno));
    return Done{};
}

bool file_exists(const std::string& path) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(path, ignored);
}

Error byte_error(const std::string& path, std::uint64_t byte, const std::string& sentence) {
    return {Code::unreadable, byte, path + ": byte " + std::to_string(byte) + ": " + sentence};
}

}  // namespace ravel::io
