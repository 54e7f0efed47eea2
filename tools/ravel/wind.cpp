#include "ravel/wind.h"

#include <chrono>
#include <utility>

#include "strip/check.h"

namespace ravel::tool {

Result<Wound> wind(const Mesh& mesh, const WindOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    auto complex = build_complex(mesh);
    if (!complex) return complex.error();
    Wound wound;
    wound.complex = std::move(*complex);
    StripOptions strip = options.strip;
    std::vector<std::uint32_t> weights;
    if (options.weigh) weights = options.weigh(wound.complex);
    strip.weights = weights;
    wound.strip = build_strip(wound.complex, options.method, strip);
    wound.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (Status status = check_strip(wound.complex, wound.strip); !status)
        return Error{Code::corrupt, status.error().at, status.error().detail};
    auto made = materialise(mesh, wound.complex, wound.strip);
    if (!made) return Error{Code::corrupt, made.error().at, made.error().detail};
    if (Status status = check_materialised(mesh, *made); !status)
        return Error{Code::corrupt, status.error().at, status.error().detail};
    wound.made = std::move(*made);
    return wound;
}

}  // namespace ravel::tool
