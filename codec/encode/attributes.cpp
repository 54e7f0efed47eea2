#include "encode/attributes.h"

#include <map>
#include <memory>
#include <string_view>

#include "encode/bits_writer.h"
#include "encode/field_plan.h"
#include "mesh/reorder.h"
#include "predict/array_planes.h"
#include "predict/cell_graph.h"
#include "predict/companion_graph.h"
#include "predict/corners_around.h"
#include "predict/points_around.h"

namespace ravel {
namespace {

using Tuples = AttributeCoding::Tuples;

// Elements that have a tuple in common with others.
struct Sharing {
    std::vector<Id> tuple;       // per element; numbers of the given pool, or by first use
    std::vector<Index> sources;  // number -> tuple of the given values that has it
};

Sharing sharing_of(const Attribute& attribute, bool pool) {
    Sharing s;
    if (pool) {
        for (const Index i : attribute.index)
            s.tuple.push_back(i == kNoIndex ? kNone : static_cast<Id>(i));
        for (Index t = 0; t < attribute.values.count(); ++t) s.sources.push_back(t);
        return s;
    }
    const Array& values = attribute.values;
    const std::size_t stride = values.stride();
    std::map<std::string_view, Id> known;
    for (std::size_t e = 0; e < values.count(); ++e) {
        const std::string_view bytes(
            reinterpret_cast<const char*>(values.bytes.data()) + e * stride, stride);
        const auto [at, fresh] = known.emplace(bytes, static_cast<Id>(known.size()));
        if (fresh) s.sources.push_back(e);
        s.tuple.push_back(at->second);
    }
    return s;
}

// Everything that one attribute puts into the section.
struct Plan {
    AttributeCoding coding;
    std::vector<Id> tuple;       // as in Sharing
    Array values;                // that are stored, in their order
    std::vector<Index> sources;  // of a pool: where they were in it
    FieldTruth truth;
};

class Writer {
  public:
    Writer(const Ground<Walked>& ground, const std::vector<Id>& marked,
           const std::vector<AttributeGrid>& grids)
        : ground_(ground), mesh_(ground.mesh), marked_(marked), grids_(grids) {}

    Bytes run(std::vector<std::vector<Index>>& old_tuple) {
        ByteWriter out, planes;
        FlagEncoder bits;
        for (std::size_t i = 0; i < mesh_.attributes.size(); ++i) {
            const Attribute& attribute = mesh_.attributes[i];
            Plan p = plan(attribute, grids_[i].bound > 0 ? &grids_[i].format : nullptr);
            if (p.coding.planes)
                planes.raw(planes_of(p.values));
            else
                p.truth = truth_of(p.values, p.coding.field);
            if (attribute.index.empty()) p.sources.clear();
            old_tuple.push_back(std::move(p.sources));
            write_coding(out, p.coding, is_pool(mesh_, attribute));
            write_bits(bits, attribute, p);
        }
        out.raw(planes.bytes());
        out.raw(bits.finish());
        return out.take();
    }

  private:
    Around& around(Place place) {
        if (place == Place::point && !points_)
            points_ = std::make_unique<PointsAround<Walked>>(ground_);
        if (place == Place::cell && !cells_)
            cells_ = std::make_unique<CellsAround<Walked>>(ground_);
        if (place == Place::companion) return companion_graph();
        if (place == Place::corner && !corners_)
            corners_ = std::make_unique<CornersAround<Walked>>(ground_);
        return place == Place::point    ? static_cast<Around&>(*points_)
               : place == Place::cell   ? static_cast<Around&>(*cells_)
               : place == Place::corner ? static_cast<Around&>(*corners_)
                                        : in_order_;
    }
    CompanionGraph<Walked>& companion_graph() {
        if (!companions_) companions_ = std::make_unique<CompanionGraph<Walked>>(ground_);
        return *companions_;
    }
    FloodGraph& graph(Place place) {
        if (place == Place::companion) return companion_graph();
        if (!graph_) graph_ = std::make_unique<CellGraph<Walked>>(ground_, marked_);
        return *graph_;
    }

    // One that knows the walls of the floods that are written.
    std::unique_ptr<FloodGraph> trial_graph(Place place) {
        std::unique_ptr<FloodGraph> trial;
        if (place == Place::companion)
            trial = std::make_unique<CompanionGraph<Walked>>(ground_);
        else
            trial = std::make_unique<CellGraph<Walked>>(ground_, marked_);
        trial->remember(graph(place));
        return trial;
    }

    // Codes which tuple each element has; `tuple` then has numbers by use. Returns how many.
    Id code_sharing(BitsWriter& coder, const Attribute& attribute, Tuples how, Id most, bool pool,
                    FloodGraph* graph, std::vector<Id>& tuple) {
        TupleCodes<BitsWriter> codes(coder, most, pool);
        if (how == Tuples::flooded)
            flood(coder, codes, *graph, tuple);
        else
            code_tuples(codes, around(attribute.place), tuple);
        return codes.used();
    }

    // The tuples in the order of their use, then those that are not used.
    static std::vector<Index> in_order_of_use(const Sharing& sharing,
                                              const std::vector<Id>& by_use) {
        std::vector<Index> from(sharing.sources.size(), kNoIndex), rest;
        std::vector<bool> used(sharing.sources.size(), false);
        for (std::size_t e = 0; e < by_use.size(); ++e) {
            if (by_use[e] == kNone) continue;
            from[by_use[e]] = sharing.sources[sharing.tuple[e]];
            used[sharing.tuple[e]] = true;
        }
        std::size_t next = 0;
        for (const bool u : used) next += u;
        for (std::size_t t = 0; t < used.size(); ++t)
            if (!used[t]) from[next++] = sharing.sources[t];
        return from;
    }

    Plan plan(const Attribute& attribute, const FieldFormat* grid) {
        const bool pool = is_pool(mesh_, attribute);
        const Array& values = attribute.values;
        Plan best;
        best.values = values;
        const bool small =
            element_count(mesh_, attribute.place) < kMostElements && values.count() < kMostElements;
        if (!small && !pool) return best;
        std::size_t least = 0;
        if (!pool) {
            const FieldPlan own = plan_field(values, around(attribute.place), grid);
            best.coding.planes = own.planes;
            best.coding.field = own.format;
            least = own.bytes;
            if (attribute.place == Place::mesh) return best;
        }
        const Sharing sharing = sharing_of(attribute, pool);
        const auto tuples = static_cast<Id>(sharing.sources.size());
        if (!pool && 2 * std::size_t{tuples} > sharing.tuple.size()) return best;
        bool first = pool;
        for (const Tuples how : {Tuples::in_order, Tuples::flooded}) {
            if (how == Tuples::flooded && attribute.place != Place::cell &&
                attribute.place != Place::companion)
                continue;
            const std::unique_ptr<FloodGraph> trial =
                how == Tuples::flooded ? trial_graph(attribute.place) : nullptr;
            std::vector<Id> by_use = sharing.tuple;
            FlagEncoder bits;
            BitsWriter coder{bits};
            if (pool || tuples > 1)
                code_sharing(coder, attribute, how, tuples, pool, trial.get(), by_use);
            std::vector<Index> sources = in_order_of_use(sharing, by_use);
            Array stored = gather(values, sources);
            PoolAround tuples_around(around(attribute.place), by_use);
            const FieldPlan field = plan_field(stored, tuples_around, grid);
            const std::size_t bytes = bits.finish().size() + field.bytes;
            if (!first && bytes >= least) continue;
            first = false;
            least = bytes;
            best = {{how, field.planes, tuples, field.format},
                    sharing.tuple,
                    std::move(stored),
                    pool ? std::move(sources) : std::vector<Index>(),
                    {}};
        }
        return best;
    }

    void write_bits(FlagEncoder& bits, const Attribute& attribute, Plan& plan) {
        const AttributeCoding& coding = plan.coding;
        BitsWriter coder{bits};
        const bool pool = is_pool(mesh_, attribute);
        if (coding.tuples != Tuples::own && (pool || coding.pool != 1))
            code_sharing(coder, attribute, coding.tuples, coding.pool, pool,
                         coding.tuples == Tuples::flooded ? &graph(attribute.place) : nullptr,
                         plan.tuple);
        if (coding.planes) return;
        Around& elements = around(attribute.place);
        PoolAround tuples(elements, plan.tuple);
        code_values(coder, coding.field, coding.tuples == Tuples::own ? elements : tuples,
                    plan.values, plan.truth);
    }

    const Ground<Walked>& ground_;
    const Mesh& mesh_;
    const std::vector<Id>& marked_;
    const std::vector<AttributeGrid>& grids_;
    InOrder in_order_;
    std::unique_ptr<PointsAround<Walked>> points_;
    std::unique_ptr<CellsAround<Walked>> cells_;
    std::unique_ptr<CornersAround<Walked>> corners_;
    std::unique_ptr<CellGraph<Walked>> graph_;
    std::unique_ptr<CompanionGraph<Walked>> companions_;
};

}  // namespace

bool is_pool(const Mesh& mesh, const Attribute& attribute) {
    return !attribute.index.empty() ||
           (attribute.place != Place::mesh && element_count(mesh, attribute.place) == 0);
}

Bytes write_attributes(const Ground<Walked>& ground, const std::vector<Id>& marked,
                       const std::vector<AttributeGrid>& grids,
                       std::vector<std::vector<Index>>& old_tuple) {
    return Writer(ground, marked, grids).run(old_tuple);
}

}  // namespace ravel
