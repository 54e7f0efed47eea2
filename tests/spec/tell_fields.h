// Fields of heads, told one by one: where each starts, its bytes, its name, its value.
#pragma once

#include <bit>
#include <span>
#include <string>

#include "container/head.h"
#include "predict/position_codes.h"

namespace ravel::test {

std::string hex(std::span<const std::byte> bytes);
// The same, but of many bytes only how many.
std::string data_hex(std::span<const std::byte> bytes);
// As many digits as tell it from all others.
std::string number_text(double x, bool narrow = false);

class Fields {
  public:
    Fields(std::span<const std::byte> bytes, std::string& out)
        : bytes_(bytes), in_(bytes), out_(out) {}

    unsigned u8(const char* name) {
        const unsigned v = in_.u8();
        tell(name, std::to_string(v));
        return v;
    }
    std::uint64_t varint(const char* name) {
        const std::uint64_t v = in_.varint();
        tell(name, std::to_string(v));
        return v;
    }
    std::int64_t signed_varint(const char* name) {
        const std::int64_t v = unzigzag(in_.varint());
        tell(name, std::to_string(v));
        return v;
    }
    double real(const char* name, bool narrow) {
        const double v = narrow ? static_cast<double>(std::bit_cast<float>(in_.u32())) : in_.f64();
        tell(name, number_text(v, narrow));
        return v;
    }
    void text(const char* name) {
        const std::string v = in_.text();
        tell(name, "\"" + v + "\"");
    }
    std::span<const std::byte> rest() {
        const std::size_t from = at_;
        at_ = bytes_.size();
        return bytes_.subspan(from);
    }

  private:
    void tell(const char* name, const std::string& value) {
        const std::size_t end = bytes_.size() - in_.left();
        out_ += "  +" + std::to_string(at_) + "  " + hex(bytes_.subspan(at_, end - at_)) + "  " +
                name + " = " + value + "\n";
        at_ = end;
    }

    std::span<const std::byte> bytes_;
    ByteReader in_;
    std::string& out_;
    std::size_t at_ = 0;
};

void tell_head(Fields f);
void tell_block(Fields f, bool tets);
PositionFormat tell_position_head(Fields& f, const Head& head, const BlockHead& block);

// The head of the section `positions`, and where its bits begin.
PositionFormat position_format_of(const Bytes& positions, const Head& head, const BlockHead& block,
                                  std::size_t& bits_at);

}  // namespace ravel::test
