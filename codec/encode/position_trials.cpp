#include "encode/position_trials.h"

#include <algorithm>
#include <future>
#include <utility>

#include "base/rice_code.h"
#include "encode/position_pass.h"
#include "encode/threads.h"
#include "entropy/priors.h"
#include "predict/priors.h"
#include "predict/residual_models.h"

namespace ravel {
namespace {

// Only counts what they would cost.
struct CountingCoder {
    static constexpr bool kWrites = true;
    double bits = 0;
    std::vector<FlagModel> models =
        with_size_kinds(models_of(kResidualPriors, ResidualContexts::count, kResidualPriorSeen));
    bool flag(Context context, bool truth) {
        FlagModel& model = models[context];
        bits += model.cost(truth);
        model.update(truth);
        return truth;
    }
    double cost(Context context, bool truth) const { return models[context].cost(truth); }
    std::uint64_t plain(std::uint64_t truth, int count) {
        bits += count;
        return truth;
    }
    std::uint64_t rice(std::uint64_t truth, int count) {
        bits += rice_bits(truth, count);
        return truth;
    }
};

// About how many bytes that would make. Of large meshes one in a few stretches of vertices is
// looked at, of very large ones only as far as kMost.
double try_out(const CodedPositions& all, const PositionFormat& format,
               const std::vector<std::uint8_t>& leads) {
    constexpr std::size_t kStretch = 256, kWhole = 8192, kEnough = 4096, kMost = 131072;
    const std::size_t size = std::min(all.size(), kMost);
    const std::size_t stride =
        all.size() <= kWhole ? 1 : std::clamp<std::size_t>(all.size() / kEnough, 3, 8);
    std::size_t count = 0;
    CountingCoder coder;
    code_positions(coder, all, format, leads, size, [&](std::size_t i) {
        const bool coded = i / kStretch % stride == 0;
        count += coded;
        return coded;
    });
    const double share =
        count == 0 ? 1 : static_cast<double>(all.size()) / static_cast<double>(count);
    return static_cast<double>(position_head_of(format).size()) + coder.bits / 8 * share;
}

class Trials {
  public:
    Trials(const CodedPositions& all, const std::vector<std::uint8_t>& leads, PositionFormat start,
           int threads)
        : all_(all),
          leads_(leads),
          kept_(std::move(start)),
          threads_(static_cast<std::size_t>(std::min(threads, kMostThreads))) {}

    PositionFormat run(const std::vector<Proposal>& proposals) {
        for (std::size_t i = 0; i < proposals.size(); ++i) {
            const Candidate candidate = proposals[i].format(kept_);
            if (!candidate) continue;
            if (bytes_of(*candidate) == nullptr) {
                std::vector<PositionFormat> formats{*candidate};
                if (tried_.empty()) formats.push_back(kept_);
                PositionFormat then = proposals[i].usual ? *candidate : kept_;
                for (std::size_t j = i + 1; j < proposals.size() && formats.size() < threads_;
                     ++j) {
                    const Candidate next = proposals[j].format(then);
                    if (!next) continue;
                    if (bytes_of(*next) == nullptr) formats.push_back(*next);
                    if (proposals[j].usual) then = *next;
                }
                try_all(formats);
            }
            const double ratio = *bytes_of(*candidate) / *bytes_of(kept_);
            if (proposals[i].ratio != nullptr) *proposals[i].ratio = ratio;
            const bool every_byte = all_.vertices() < kSmallPositions && !proposals[i].has_price;
            if (ratio < (every_byte ? 1 : 1 - proposals[i].worth)) kept_ = *candidate;
        }
        return kept_;
    }

  private:
    static constexpr int kMostThreads = 4;  // it seldom goes as usual for long

    struct Tried {
        PositionFormat format;
        double bytes;
    };

    const double* bytes_of(const PositionFormat& format) const {
        for (const Tried& tried : tried_)
            if (tried.format == format) return &tried.bytes;
        return nullptr;
    }
    void try_all(const std::vector<PositionFormat>& formats) {
        std::vector<std::future<double>> bytes;
        for (const PositionFormat& format : formats)
            bytes.push_back(start(threads_ > 1 && !bytes.empty(),
                                  [&, this] { return try_out(all_, format, leads_); }));
        for (std::size_t i = 0; i < formats.size(); ++i)
            tried_.push_back({formats[i], bytes[i].get()});
    }

    const CodedPositions& all_;
    const std::vector<std::uint8_t>& leads_;
    PositionFormat kept_;
    const std::size_t threads_;
    std::vector<Tried> tried_;
};

}  // namespace

PositionFormat try_in_turn(const CodedPositions& all, const std::vector<std::uint8_t>& leads,
                           PositionFormat start, const std::vector<Proposal>& proposals,
                           int threads) {
    return Trials(all, leads, std::move(start), threads).run(proposals);
}

}  // namespace ravel
