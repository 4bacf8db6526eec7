#include "solver/scene/scene_solids.h"

namespace plumbline {

void only_with(TomlSection& section, const std::string& key, bool allowed,
               const std::string& what) {
    if (!allowed && section.has(key))
        section.reject(key, "no key \"" + key + "\" without " + what, "one");
}

void read_box(TomlSection& s, int dim, Vec<3>& low, Vec<3>& high) {
    low = s.vector("low", dim);
    high = s.vector("high", dim);
    for (int d = 0; d < dim; ++d)
        if (!(low[d] < high[d]))
            s.reject("high", "a corner above the one of \"low\" along each axis",
                     std::to_string(high[d]) + " where low is " + std::to_string(low[d]));
}

Vec<3> read_direction(TomlSection& s, const std::string& key, int dim) {
    const Vec<3> direction = s.vector(key, dim);
    if (!(direction.norm() > 0.0)) s.reject(key, "a vector that is not zero", "zeros");
    return direction.normalized();
}

namespace {
SolidShape read_shape(TomlSection& s, int dim) {
    using enum SolidShape::Form;
    SolidShape shape;
    shape.form = s.choice<SolidShape::Form>(
        "shape", {{"box", box}, {"sphere", sphere}, {"plane", plane}, {"mesh", mesh}});
    switch (shape.form) {
        case plane:
            shape.point = s.vector("point", dim);
            shape.normal = read_direction(s, "normal", dim);
            break;
        case box:
            read_box(s, dim, shape.low, shape.high);
            break;
        case sphere:
            shape.centre = s.vector("centre", dim);
            shape.radius = s.number("radius", positive);
            break;
        case mesh:
            if (dim == 2) s.reject("shape", "no mesh in the plane", "one");
            shape.mesh_file = s.text("file");
            break;
    }
    return shape;
}
}  // namespace

SolidConstraint read_constraint(TomlSection& s, const SceneFile& scene) {
    SolidConstraint constraint;
    constraint.place = s.place();
    constraint.shape = read_shape(s, scene.dim);
    only_with(s, "stay", constraint.shape.form != SolidShape::Form::plane,
              "a shape that has an inside");
    constraint.hollow = s.choice<bool>("stay", {{"outside", false}, {"inside", true}}, true);
    constraint.restitution = s.number("restitution", fraction, 0.0);
    constraint.friction = s.number("friction", not_negative, 0.0);
    constraint.velocity = s.vector("velocity", scene.dim, Vec<3>::Zero());
    s.refuse_unknown_keys();
    return constraint;
}

}  // namespace plumbline
