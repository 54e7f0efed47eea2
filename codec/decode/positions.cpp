#include "decode/positions.h"

#include "predict/follows.h"

namespace ravel {
namespace {

bool read_round_faces(ByteReader& in, RoundFaceList& faces) {
    faces.count = in.u8();
    faces.slack = in.u8();
    bool sane =
        faces.count >= 1 && faces.count <= kMostRoundFaces && faces.slack <= kMostRoundSlack;
    for (std::size_t f = 0; f < faces.count && sane; ++f) {
        RoundFace& face = faces.face[f];
        const std::uint8_t kind = in.u8();
        face.kind = static_cast<RoundKind>(kind);
        sane = kind < static_cast<std::uint8_t>(RoundKind::count);
        for (std::int64_t& x : face.centre) {
            x = unzigzag(in.varint());
            sane = sane && x <= kMostRoundLength && x >= -kMostRoundLength;
        }
        for (std::size_t k = 0; k < 3 && face.kind != RoundKind::sphere; ++k) {
            face.axis[k] = unzigzag(in.varint());
            sane = sane && face.axis[k] <= kMostRoundAxis && face.axis[k] >= -kMostRoundAxis;
        }
        const std::uint64_t radius = in.varint();
        const std::uint64_t ring = face.kind == RoundKind::torus ? in.varint() : 0;
        sane = sane && radius <= std::uint64_t{kMostRoundLength} &&
               ring <= std::uint64_t{kMostRoundLength};
        face.radius = static_cast<std::int64_t>(radius);
        face.ring = static_cast<std::int64_t>(ring);
    }
    return sane;
}

}  // namespace

Result<PositionFormat> read_position_format(ByteReader& in, const Head& head) {
    PositionFormat format;
    NumberFormat& numbers = format.numbers;
    format.narrow = head.position_scalar == Scalar::f32;
    const std::uint8_t flags = in.u8();
    const std::uint64_t fitted = in.varint();
    format.has_escapes = (flags & 4) != 0;
    numbers.has_minus_zero = (flags & 8) != 0;
    format.has_levels = (flags & 128) != 0;
    format.has_follows = (flags & 1) != 0;
    format.has_along = (flags & 2) != 0;
    const unsigned base = flags >> 4 & 3;
    numbers.base = static_cast<NumberBase>(base);
    bool sane = fitted < 2 * kHasRice && ((fitted & kHasRounds) == 0 || format.has_along) &&
                (!format.has_along || head.kind == CellKind::tet) && base <= 2 &&
                (base == 0) == !head.lossless && (head.lossless || !numbers.has_minus_zero);
    if (head.lossless) {
        const std::int64_t places = unzigzag(in.varint());
        const bool decimal = numbers.base == NumberBase::decimal;
        numbers.digits = in.u8();
        sane = sane && places >= (decimal ? 0 : -kMostBinaryPlaces) &&
               places <= (decimal ? kMostPlaces : kMostBinaryPlaces) &&
               numbers.digits <= (decimal ? 17 : 53);
        numbers.places = sane ? static_cast<int>(places) : 0;
    }
    if (flags & 64) {
        const std::uint8_t count = in.u8();
        format.cube_bits = in.u8();
        sane = sane && count >= 1 && count <= kMostEchoes && format.cube_bits <= kMostCubeBits;
        for (std::size_t e = 0; e < count && sane; ++e) {
            Echo echo;
            const std::uint8_t mirrored = in.u8();
            sane = mirrored < 8;
            for (std::size_t k = 0; k < 3; ++k) {
                echo.mirrored[k] = (mirrored >> k & 1) != 0;
                echo.offset[k] = unzigzag(in.varint());
                sane = sane && echo.offset[k] <= kMostWhole && echo.offset[k] >= -kMostWhole &&
                       (echo.offset[k] == 0 || numbers.digits == 0);
            }
            format.echoes.push_back(echo);
        }
    }
    if (format.has_levels) {
        const std::uint8_t look = in.u8();
        format.level_bits = look & 127;
        format.has_pairs = (look & 128) != 0;
        sane = sane && format.level_bits <= kMostLevelBits &&
               (format.level_bits > 0 || !format.has_pairs);
    }
    if ((fitted & kNoTriangleDefaults) != 0) format.weights = without_triangles(format.weights);
    for (std::size_t c = 0; c < kWeightSets && sane; ++c) {
        if ((fitted >> c & 1) == 0) continue;
        const std::uint8_t grain = in.u8();
        sane = grain <= kMostGrain;
        for (std::size_t i = 0; i < kFeatureCount[c] && sane; ++i) {
            const std::int64_t steps = unzigzag(in.varint()),
                               most = std::int64_t{1} << (15 - grain);
            sane = steps >= -most && steps < most;
            format.weights[c][i] = static_cast<std::int16_t>(sane ? steps * (1 << grain) : 0);
        }
    }
    format.has_rice = (fitted & kHasRice) != 0;
    if ((fitted & kHasRounds) != 0 && sane) sane = read_round_faces(in, format.rounds);
    if (!sane || !in.ok())
        return Error{Code::corrupt, in.at(), "the head of the positions makes no sense"};
    format.has_stand_ins = head.lossless && head.kind == CellKind::tet;
    if (format.has_stand_ins) {
        for (double& x : format.place_origin) x = in.f64();
        format.place_scale = in.f64();
        // Any numbers will do: places are clamped.
        if (!in.ok()) return Error{Code::truncated, in.at(), "the positions end in their head"};
    }
    return format;
}

Array positions_of(const Head& head, const PositionCodes<ReadingCoder>& codes,
                   const std::vector<Id>& copy_of, std::size_t points) {
    Array out = make_array(head.position_scalar, 3, points);
    const Grid grid{{head.origin[0], head.origin[1], head.origin[2]}, head.step};
    std::size_t p = 0, next_escape = 0;
    const auto store = [&](std::size_t axis, std::uint64_t bits) {
        if (head.position_scalar == Scalar::f32)
            out.as<std::uint32_t>()[3 * p + axis] = static_cast<std::uint32_t>(bits);
        else
            out.as<std::uint64_t>()[3 * p + axis] = bits;
    };
    for (std::size_t v = 0; v < codes.values().size(); ++v) {
        if (v < copy_of.size() && copy_of[v] != kNone) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double x =
                head.lossless
                    ? codes.exact(v, axis)
                    : coordinate_of(grid, axis, static_cast<std::int64_t>(codes.values()[v][axis]),
                                    head.position_scalar);
            if (head.position_scalar == Scalar::f32)
                out.as<float>()[3 * p + axis] = static_cast<float>(x);
            else
                out.as<double>()[3 * p + axis] = x;
        }
        const std::vector<Escape>& escapes = codes.escapes();
        for (; next_escape < escapes.size() && escapes[next_escape].vertex == v; ++next_escape)
            store(escapes[next_escape].axis, escapes[next_escape].bits);
        ++p;
    }
    return out;
}

}  // namespace ravel
