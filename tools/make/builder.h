// Grows a mesh point by point and cell by cell.
#pragma once

#include <cstring>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "ravel/mesh.h"

namespace ravel::make {

struct Builder {
    CellKind kind = CellKind::polygon;
    std::vector<double> coordinates;
    std::vector<Index> corner_begin;
    std::vector<Index> corners;

    explicit Builder(CellKind k) : kind(k) {
        if (kind == CellKind::polygon) corner_begin.push_back(0);
    }

    Index point_count() const { return coordinates.size() / 3; }
    Index add_point(double x, double y, double z) {
        coordinates.insert(coordinates.end(), {x, y, z});
        return point_count() - 1;
    }
    void add_cell(std::span<const Index> points) {
        corners.insert(corners.end(), points.begin(), points.end());
        if (kind == CellKind::polygon) corner_begin.push_back(corners.size());
    }
    void add_cell(std::initializer_list<Index> points) {
        add_cell(std::span<const Index>(points.begin(), points.size()));
    }
    // Positions become float64 or, each rounded once, float32.
    Mesh take(Scalar scalar) {
        Mesh mesh;
        mesh.kind = kind;
        mesh.positions = make_array(scalar, 3, point_count());
        for (std::size_t i = 0; i < coordinates.size(); ++i) {
            if (scalar == Scalar::f64)
                mesh.positions.as<double>()[i] = coordinates[i];
            else
                mesh.positions.as<float>()[i] = static_cast<float>(coordinates[i]);
        }
        mesh.corner_begin = std::move(corner_begin);
        mesh.corners = std::move(corners);
        return mesh;
    }
};

// One value of `scalar` per element, from a function of the element's number.
template <class T, class F>
Attribute make_attribute(std::string name, Place place, Scalar scalar, std::uint32_t arity,
                         std::size_t count, F value) {
    Attribute attribute{std::move(name), place, make_array(scalar, arity, count), {}, {}};
    std::span<T> values = attribute.values.as<T>();
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<T>(value(i));
    return attribute;
}

}  // namespace ravel::make
