// What the strip should look for, as weights of facets, and how well it does.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mesh/complex.h"
#include "strip/strip.h"

namespace ravel::tool {

enum class Objective : std::uint8_t {
    turns,    // exits as the decoder expects them: no weights, the walker's rule alone
    normals,  // neighbours on the strip face the same way (polygons)
    axis_x,   // steps along an axis
    axis_y,
    axis_z,
};

// "turns", "normals", "axis=x"...
std::optional<Objective> objective_of(const std::string& name);
const std::vector<std::string>& objective_names();

// Per facet, equal on twins, light where the step across it serves the objective; empty for turns.
// Linear.
std::vector<std::uint32_t> facet_weights(const Mesh& mesh, const Complex& complex,
                                         Objective objective);

// Over all steps of the strips from cell to cell, links left out. Steps with cells that have no
// normal or place (flat or not finite) don't count.
struct StepFacts {
    std::uint64_t steps = 0;
    double normal_change_degrees = 0;      // mean angle between the normals; 0 for tets
    double turn_percent = 0;               // polygons: cells left by a side next to the entry
    std::array<double, 3> axis_percent{};  // steps whose longest component is x, y or z
};
StepFacts measure_steps(const Mesh& mesh, const Complex& complex, const Strip& strip);

}  // namespace ravel::tool
