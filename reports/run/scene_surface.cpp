#include "reports/run/scene_surface.h"

#include "solver/io/write_surface.h"
#include "solver/kernels/wendland_c2.h"
#include "solver/surface/blobby_field.h"
#include "solver/surface/density_field.h"
#include "solver/surface/weighted_average_field.h"

#include <sstream>

namespace reports {

namespace {
using namespace plumbline;

template <int Dim>
ScalarGrid<Dim> field_of(const SceneFile& scene, const SurfaceOutput& asked, const Snapshot& s) {
    Points<Dim> x(s.size());
    for (std::size_t i = 0; i < x.size(); ++i)
        for (int d = 0; d < Dim; ++d) x[i][d] = s.coordinate(i, d);
    const std::span<const Vec<Dim>> points(x);
    const double d = scene.spacing, cell = asked.cell * d, radius = asked.radius * d;
    if (asked.field == SurfaceOutput::Field::blobby)
        return on_grid<Dim>(BlobbyField<Dim>{radius, asked.level}, points, cell);
    if (asked.field == SurfaceOutput::Field::weighted_average)
        return on_grid<Dim>(WeightedAverageField<Dim>{radius, asked.distance * d}, points, cell);
    using W = WendlandC2<Dim>;
    return on_grid<Dim>(DensityField<W>{W(scene.support), s.m, asked.level * scene.density}, points,
                        cell);
}

template <int Dim> std::string text_of(const SceneFile& scene, const Snapshot& s) {
    const SurfaceOutput& asked = *scene.surface;
    const Isosurface<Dim> surface = isosurface(field_of<Dim>(scene, asked, s), 0.0);
    std::ostringstream out;
    if (asked.format == "obj")
        write_surface_obj(out, surface);
    else if (asked.format == "ply")
        write_surface_ply(out, surface);
    else
        write_vtp(out, poly_data_of(surface));
    return std::move(out).str();
}
}  // namespace

std::string surface_text(const SceneFile& scene, const Snapshot& particles) {
    return scene.dim == 2 ? text_of<2>(scene, particles) : text_of<3>(scene, particles);
}

}  // namespace reports
