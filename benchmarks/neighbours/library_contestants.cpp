#include "benchmarks/neighbours/cgal_kd_tree_search.h"
#include "benchmarks/neighbours/contestant_forms.h"
#include "benchmarks/neighbours/nanoflann_search.h"

namespace benchmarks {

template <int Dim> std::vector<ContestantMaker<Dim>> library_contestants() {
    using Default = NanoflannSearch<Dim, nanoflann_default_leaf>;
    using Tuned = NanoflannSearch<Dim, nanoflann_tuned_leaf>;
    return {maker<Dim, SortedForm<Dim, Default>>("nanoflann"),
            maker<Dim, SortedForm<Dim, Tuned>>("nanoflann_tuned"),
            maker<Dim, PackedForm<Dim, Tuned>>("nanoflann_packed"),
            maker<Dim, SortedForm<Dim, CgalKdTreeSearch<Dim>>>("cgal_kd_tree")};
}
template std::vector<ContestantMaker<2>> library_contestants<2>();
template std::vector<ContestantMaker<3>> library_contestants<3>();

}  // namespace benchmarks
