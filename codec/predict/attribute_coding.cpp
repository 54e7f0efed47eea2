#include "predict/attribute_coding.h"

namespace ravel {

void write_coding(ByteWriter& out, const AttributeCoding& coding, bool indexed) {
    const FieldFormat& f = coding.field;
    out.u8(static_cast<std::uint8_t>(static_cast<unsigned>(coding.tuples) |
                                     (coding.planes ? 4u : 0u) |
                                     (coding.planes ? 0u
                                                    : static_cast<unsigned>(f.guess) << 4 |
                                                          static_cast<unsigned>(f.numbers) << 6)));
    if (coding.tuples != AttributeCoding::Tuples::own && !indexed) out.varint(coding.pool);
    if (coding.planes || f.numbers == FieldNumbers::integer) return;
    out.u8(static_cast<std::uint8_t>((f.has_outliers ? 1 : 0) | (f.unit_length ? 2 : 0) |
                                     (f.unit.has_minus_zero ? 4 : 0) |
                                     (f.unit.base == NumberBase::decimal ? 8 : 0) |
                                     (f.by_angle ? 16 : 0) | (f.octahedral > 0 ? 32 : 0)));
    if (f.numbers == FieldNumbers::unit) out.varint(zigzag(f.unit.places));
    if (f.octahedral > 0)
        out.u8(static_cast<std::uint8_t>(f.octahedral));
    else if (f.numbers == FieldNumbers::grid)
        out.f64(f.step);
}

bool read_coding(ByteReader& in, AttributeCoding& coding, bool indexed, Scalar scalar) {
    const unsigned kind = in.u8();
    FieldFormat& f = coding.field;
    if ((kind & 3) > static_cast<unsigned>(AttributeCoding::Tuples::flooded) || (kind & 8) != 0)
        return false;
    coding.tuples = static_cast<AttributeCoding::Tuples>(kind & 3);
    coding.planes = (kind & 4) != 0;
    f.guess = static_cast<Guess>(kind >> 4 & 3);
    f.numbers = static_cast<FieldNumbers>(kind >> 6);
    if (coding.planes && kind >> 4 != 0) return false;
    if (coding.tuples != AttributeCoding::Tuples::own && !indexed) {
        const std::uint64_t pool = in.varint();
        if (pool >= kMostElements) return false;
        coding.pool = static_cast<Id>(pool);
    }
    if (coding.planes) return in.ok();
    if (is_float(scalar) == (f.numbers == FieldNumbers::integer)) return false;
    if (f.numbers == FieldNumbers::integer) return in.ok();
    const unsigned flags = in.u8();
    f.has_outliers = (flags & 1) != 0;
    f.unit_length = (flags & 2) != 0;
    f.unit.has_minus_zero = (flags & 4) != 0;
    f.unit.base = (flags & 8) != 0 ? NumberBase::decimal : NumberBase::binary;
    f.by_angle = (flags & 16) != 0;
    const bool octahedral = (flags & 32) != 0;
    bool sane = flags < 64 && (f.numbers == FieldNumbers::unit || (flags & 12) == 0) &&
                (f.guess == Guess::normal || !f.by_angle) &&
                (f.numbers != FieldNumbers::image || !f.has_outliers) &&
                (!octahedral || (f.numbers == FieldNumbers::grid && !f.unit_length));
    if (f.numbers == FieldNumbers::unit) {
        const std::int64_t places = unzigzag(in.varint());
        const bool decimal = f.unit.base == NumberBase::decimal;
        sane = sane && places >= (decimal ? 0 : -kMostBinaryPlaces) &&
               places <= (decimal ? kMostPlaces : kMostBinaryPlaces);
        f.unit.places = sane ? static_cast<int>(places) : 0;
    }
    if (octahedral) {
        f.octahedral = in.u8();
        sane = sane && f.octahedral >= 3 && f.octahedral <= kMostOctahedralBits;
    } else if (f.numbers == FieldNumbers::grid) {
        f.step = in.f64();
        sane = sane && std::isfinite(f.step) && f.step > 0;
    }
    return sane && in.ok();
}

}  // namespace ravel
