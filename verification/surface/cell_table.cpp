#include "solver/surface/cell_table.h"

#include "solver/foundation/random.h"
#include "verification/framework/in_dimensions.h"
#include "verification/framework/registry.h"
#include "verification/surface/topology.h"

#include <bit>

namespace cell_table_claims {
namespace {
using namespace plumbline;
using namespace verification;

template <int Dim> constexpr std::size_t corners = 1 << Dim;

/// A grid of n nodes per axis, of value 1: outside.
template <int Dim> ScalarGrid<Dim> outside(std::size_t n) {
    ScalarGrid<Dim> grid{Vec<Dim>::Zero(), 1.0, {}};
    grid.size.fill(n);
    grid.values.assign(grid.nodes(), 1.0);
    return grid;
}
/// One cell with the corners of `inside`, in the middle of cells that are outside.
template <int Dim> ScalarGrid<Dim> single_cell(std::size_t inside) {
    ScalarGrid<Dim> grid = outside<Dim>(4);
    for (std::size_t corner = 0; corner < corners<Dim>; ++corner) {
        std::size_t node = 0;
        for (int d = 0; d < Dim; ++d) node += grid.stride(d) * (1 + (corner >> d & 1));
        if ((inside >> corner & 1) != 0) grid.values[node] = -1.0;
    }
    return grid;
}
/// Random values but for the rim, where it is outside.
template <int Dim> ScalarGrid<Dim> random_field(std::uint64_t seed) {
    Random random(seed);
    ScalarGrid<Dim> grid = outside<Dim>(9);
    for (std::size_t node = 0; node < grid.nodes(); ++node) {
        bool rim = false;
        for (const std::size_t k : grid.place(node)) rim = rim || k == 0 || k == 8;
        if (!rim) grid.values[node] = random.uniform(-1.0, 1.0);
    }
    return grid;
}

template <int Dim> double faults(const Isosurface<Dim>& s) {
    return open_edges(s) + split_vertices(s);
}
template <int Dim> CellCase<Dim> turned(CellCase<Dim> cell) {
    for (int k = 0; k < cell.count; ++k) std::swap(cell.facets[k][0], cell.facets[k][1]);
    return cell;
}
/// As printed in 1987: a case with more than half of its corners inside is the complementary one, turned
/// inside out. That joins corners which the cell behind the face separates.
template <int Dim> CellTable<Dim> by_complement() {
    CellTable<Dim> table = cell_table<Dim>();
    for (std::size_t c = 0; c < table.size(); ++c)
        if (std::popcount(c) > static_cast<int>(corners<Dim> / 2))
            table[c] = turned(cell_table<Dim>()[table.size() - 1 - c]);
    return table;
}
/// One facet ends on the next edge of the cell.
template <int Dim> CellTable<Dim> with_slip_of_the_pen() {
    CellTable<Dim> table = cell_table<Dim>();
    table[9].facets[0][0] = table[9].facets[1][0];  // of two corners at the ends of a diagonal
    return table;
}
template <int Dim> CellTable<Dim> turned_inside_out() {
    CellTable<Dim> table = cell_table<Dim>();
    for (CellCase<Dim>& cell : table) cell = turned(cell);
    return table;
}

template <int Dim> double faults_of_all_cases(const CellTable<Dim>& table) {
    double sum = 0.0;
    for (std::size_t c = 0; c < table.size(); ++c)
        sum += faults(isosurface(single_cell<Dim>(c), 0.0, table));
    return sum;
}
template <int Dim> double faults_of_random_fields(const CellTable<Dim>& table) {
    double sum = 0.0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
        sum += faults(isosurface(random_field<Dim>(seed), 0.0, table));
    return sum;
}
/// How many cases do not hold a positive volume, but for the one without a corner inside.
template <int Dim> double cases_facing_inwards(const CellTable<Dim>& table) {
    double sum = 0.0;
    for (std::size_t c = 1; c < table.size(); ++c)
        sum += !(volume(isosurface(single_cell<Dim>(c), 0.0, table)) > 0.0);
    return sum;
}
constexpr const char* a_count = "a count";

const Register closed{in_dimensions<2, 3>([]<int Dim>() {
    return Claim{
        .id = "cell_table.closed_for_all_cases",
        .source = {Paper::plumbline, "docstring of cell_table"},
        .says =
            "a cell with any of its corners inside, amid cells that are outside, has a closed "
            "surface with one fan of facets at each vertex: faults, over all cases; not "
            "if one facet ends on a wrong edge",
        .bound = at_most(0.0, a_count),
        .measure = [] { return faults_of_all_cases(cell_table<Dim>()); },
        .sabotaged = [] { return faults_of_all_cases(with_slip_of_the_pen<Dim>()); }};
})};
const Register closed_for_fields{in_dimensions<2, 3>([]<int Dim>() {
    return Claim{
        .id = "cell_table.closed_for_random_fields",
        .source = {Paper::literature, "Lorensen and Cline 1987"},
        .says =
            "20 fields of random values on 9^dim nodes have closed surfaces: faults; in space "
            "not with complementary cases turned inside out, by which there are only 15 in 1987 "
            "and holes between them; in the plane not if one facet ends on a wrong edge",
        .bound = at_most(0.0, a_count),
        .measure = [] { return faults_of_random_fields(cell_table<Dim>()); },
        .sabotaged =
            [] {
                return faults_of_random_fields(Dim == 3 ? by_complement<Dim>()
                                                        : with_slip_of_the_pen<Dim>());
            }};
})};
const Register outwards{in_dimensions<2, 3>([]<int Dim>() {
    return Claim{.id = "cell_table.facets_face_outwards",
                 .source = {Paper::plumbline, "docstring of cell_table"},
                 .says = "each case encloses a positive volume: cases that do not",
                 .bound = at_most(0.0, a_count),
                 .measure = [] { return cases_facing_inwards(cell_table<Dim>()); },
                 .sabotaged = [] { return cases_facing_inwards(turned_inside_out<Dim>()); }};
})};
}  // namespace
}  // namespace cell_table_claims
