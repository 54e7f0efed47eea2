#include "decode/attributes.h"

#include <memory>

#include "decode/walk_driver.h"
#include "mesh/reorder.h"
#include "predict/array_planes.h"
#include "predict/attribute_coding.h"
#include "predict/cell_graph.h"
#include "predict/companion_graph.h"
#include "predict/corners_around.h"
#include "predict/points_around.h"
#include "predict/value_codes.h"

namespace ravel {
namespace {

class Reader {
  public:
    Reader(ByteReader& in, const Head& head, const Ground<Walked>& ground,
           const std::vector<Id>& marked, std::uint64_t& budget, Mesh& mesh)
        : in_(in), head_(head), ground_(ground), marked_(marked), budget_(budget), mesh_(mesh) {}

    Status run() {
        std::vector<AttributeCoding> codings(head_.attributes.size());
        for (std::size_t i = 0; i < codings.size(); ++i)
            if (Status status = read_head_of(head_.attributes[i], codings[i]); !status)
                return status;
        mesh_.attributes.resize(codings.size());
        for (std::size_t i = 0; i < codings.size(); ++i)
            if (Status status = read_planes_of(i, codings[i]); !status) return status;
        FlagDecoder bits(in_.raw(in_.left()));
        for (std::size_t i = 0; i < codings.size(); ++i)
            if (Status status = read_bits_of(bits, i, codings[i]); !status) return status;
        if (!bits.finished()) return corrupt("the attributes end too early or too late");
        return Done{};
    }

  private:
    using Tuples = AttributeCoding::Tuples;

    Status corrupt(const char* why) const { return Error{Code::corrupt, in_.at(), why}; }

    Status read_head_of(const AttributeHead& head, AttributeCoding& coding) {
        const bool indexed = head.indexed && head.place != Place::mesh;
        if (!read_coding(in_, coding, indexed, head.scalar))
            return corrupt("an attribute is coded in a way this version does not know");
        const Index elements = element_count(mesh_, head.place);
        const bool small = elements < kMostElements && head.tuples < kMostElements;
        const bool sane = indexed                     ? coding.tuples != Tuples::own
                          : head.place == Place::mesh ? coding.tuples == Tuples::own
                                                      : head.tuples == elements;
        if (!sane || (!small && (coding.tuples != Tuples::own || !coding.planes)) ||
            (coding.tuples == Tuples::flooded && head.place != Place::cell &&
             head.place != Place::companion) ||
            (!indexed && coding.pool > elements) ||
            ((coding.field.unit_length || coding.field.octahedral > 0) && head.arity != 3))
            return corrupt("an attribute has not one tuple per element, or what it can't have");
        return Done{};
    }

    // Tuples that are stored: of the pool, or of all elements.
    static Index stored(const AttributeHead& head, const AttributeCoding& coding) {
        return head.indexed || coding.tuples == Tuples::own ? head.tuples : coding.pool;
    }

    Status read_planes_of(std::size_t i, const AttributeCoding& coding) {
        const AttributeHead& head = head_.attributes[i];
        Attribute& attribute = mesh_.attributes[i];
        attribute.name = head.name;
        attribute.place = head.place;
        attribute.references = head.references;
        attribute.values = {head.scalar, head.arity, {}};
        if (!coding.planes) return Done{};
        const std::uint64_t stride = attribute.values.stride(), tuples = stored(head, coding);
        if (tuples > in_.left() / stride)
            return corrupt("an attribute has fewer bytes than tuples");
        attribute.values = array_of_planes(head.scalar, head.arity, in_.raw(tuples * stride));
        return Done{};
    }

    Status charge(Index count, std::uint64_t each) {
        if (count > budget_ / each)
            return Error{Code::limit_exceeded, in_.at(),
                         "the attributes need more memory than allowed"};
        budget_ -= count * each;
        return Done{};
    }

    // What is held about all elements of a place, once.
    Status charge_ground(Place place) {
        bool& charged = charged_[static_cast<std::size_t>(place)];
        if (charged) return Done{};
        charged = true;
        if (place == Place::companion) {
            if (Status status = charge(mesh_.companion_count(), 128); !status) return status;
            return charge(mesh_.point_count(), 9);
        }
        if (place == Place::point) return charge(mesh_.point_count(), 1);
        return charge(mesh_.corners.size(), place == Place::cell ? 1 : 4);
    }

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
    bool flood_place(Place place, ReadingCoder& coder, TupleCodes<ReadingCoder>& codes,
                     std::vector<Id>& tuple) {
        if (place == Place::companion) return flood(coder, codes, companion_graph(), tuple);
        if (!graph_) graph_ = std::make_unique<CellGraph<Walked>>(ground_, marked_);
        return flood(coder, codes, *graph_, tuple);
    }

    Status read_bits_of(FlagDecoder& bits, std::size_t i, const AttributeCoding& coding) {
        const AttributeHead& head = head_.attributes[i];
        Attribute& attribute = mesh_.attributes[i];
        Array& values = attribute.values;
        if (coding.tuples == Tuples::own && coding.planes) return Done{};
        const Index elements = element_count(mesh_, head.place);
        const bool indexed = head.indexed && head.place != Place::mesh;
        const Index count = stored(head, coding);
        const std::uint64_t stride = values.stride(), copies = head_.keeps_order ? 3 : 2;
        // Numbers and sizes of residuals are held beside the values while they are read.
        Status status = charge(count, coding.planes ? 1 : stride * copies + 13 * head.arity + 12);
        if (status && coding.tuples != Tuples::own) status = charge(elements, 24);
        if (status && !indexed && coding.tuples != Tuples::own)
            status = charge(elements, stride * copies);
        if (status) status = charge_ground(head.place);
        if (!status) return status;
        ReadingCoder coder{
            bits, with_size_kinds(
                      models_of(kResidualPriors, AttributeContexts::count, kResidualPriorSeen))};
        std::vector<Id> tuple;
        Around& beside = around(head.place);
        if (coding.tuples != Tuples::own) {
            tuple.assign(elements, 0);
            TupleCodes<ReadingCoder> codes(coder, static_cast<Id>(count), indexed);
            // One tuple that all have needs no words.
            const bool all_alike = !indexed && count == 1;
            const bool sane = all_alike || (coding.tuples == Tuples::flooded
                                                ? flood_place(head.place, coder, codes, tuple)
                                                : code_tuples(codes, beside, tuple));
            if (!sane || bits.exhausted() || (!indexed && !all_alike && codes.used() != count))
                return corrupt("an attribute refers to a tuple that does not exist");
        }
        if (!coding.planes) {
            values = make_array(head.scalar, head.arity, count);
            PoolAround pool(beside, tuple);
            if (!code_values(coder, coding.field, coding.tuples == Tuples::own ? beside : pool,
                             values, {}) ||
                bits.exhausted())
                return corrupt("the values of an attribute make no sense");
        }
        if (indexed) {
            attribute.index.resize(elements);
            for (Index e = 0; e < elements; ++e)
                attribute.index[e] = tuple[e] == kNone ? kNoIndex : tuple[e];
        } else if (coding.tuples != Tuples::own) {
            std::vector<Index> from(tuple.begin(), tuple.end());
            values = gather(values, from);
        }
        return Done{};
    }

    ByteReader& in_;
    const Head& head_;
    const Ground<Walked>& ground_;
    const std::vector<Id>& marked_;
    std::uint64_t& budget_;
    Mesh& mesh_;
    std::array<bool, 5> charged_{};  // by place
    InOrder in_order_;
    std::unique_ptr<PointsAround<Walked>> points_;
    std::unique_ptr<CellsAround<Walked>> cells_;
    std::unique_ptr<CornersAround<Walked>> corners_;
    std::unique_ptr<CellGraph<Walked>> graph_;
    std::unique_ptr<CompanionGraph<Walked>> companions_;
};

}  // namespace

Status read_attributes(ByteReader& in, const Head& head, const Ground<Walked>& ground,
                       const std::vector<Id>& marked, std::uint64_t& budget, Mesh& mesh) {
    return Reader(in, head, ground, marked, budget, mesh).run();
}

}  // namespace ravel
