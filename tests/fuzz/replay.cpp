// Stands in for libFuzzer: runs the fuzz target over every file of the folders it is given, and
// over cheap mutations of each, so that any compiler and machine can replay what was found.
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int count, char** words) {
    std::size_t runs = 0;
    for (int i = 1; i < count; ++i) {
        if (!std::filesystem::is_directory(words[i])) {
            std::fprintf(stderr, "no folder: %s\n", words[i]);
            return 2;
        }
        for (const auto& entry : std::filesystem::directory_iterator(words[i])) {
            std::ifstream in(entry.path(), std::ios::binary);
            const std::string text{std::istreambuf_iterator<char>(in), {}};
            std::vector<std::uint8_t> bytes(text.begin(), text.end());
            LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
            ++runs;
            for (std::size_t at = 0; at < bytes.size(); at += 1 + bytes.size() / 16) {
                const std::uint8_t old = bytes[at];
                bytes[at] = static_cast<std::uint8_t>(old ^ (1u << at % 8));
                LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
                bytes[at] = old;
                LLVMFuzzerTestOneInput(bytes.data(), at);
                runs += 2;
            }
        }
    }
    std::printf("%zu inputs\n", runs);
    return runs > 0 ? 0 : 1;
}
