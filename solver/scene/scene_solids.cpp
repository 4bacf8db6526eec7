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

namespace {
void read_name(TomlSection& s, const SceneFile& scene, SceneBody& body) {
    body.name = "body_" + std::to_string(scene.bodies.size() + 1);
    if (s.has("name")) body.name = s.text("name");
    if (body.name.find_first_of(",\"\n\r") != std::string::npos)
        s.reject("name", "a name without commas, quotes and line breaks", "\"" + body.name + "\"");
    for (const SceneBody& other : scene.bodies)
        if (other.name == body.name)
            s.reject("name", "a name of its own for each body", "\"" + body.name + "\" twice");
}
void read_mass(TomlSection& s, SceneBody& body) {
    body.fixed = s.flag("fixed", false);
    only_with(s, "mass", !body.fixed, "a body that is free");
    only_with(s, "density", !body.fixed, "a body that is free");
    only_with(s, "mass", !s.has("density"), "leaving out \"density\"");
    if (body.fixed) return;
    if (s.has("mass"))
        body.mass = s.number("mass", positive);
    else
        body.density = s.number("density", positive);
}
}  // namespace

SceneBody read_body(TomlSection& s, const SceneFile& scene) {
    SceneBody body;
    body.place = s.place();
    read_name(s, scene, body);
    body.shape = read_shape(s, scene.dim);
    if (body.shape.form == SolidShape::Form::plane)
        s.reject("shape", "a shape that ends somewhere", "a plane");
    read_mass(s, body);
    body.velocity = s.vector("velocity", scene.dim, Vec<3>::Zero());
    body.spin = Vec<3>::Zero();
    if (scene.dim == 2)
        body.spin[2] = s.number("spin", any_number, 0.0);
    else
        body.spin = s.vector("spin", 3, Vec<3>::Zero());
    s.refuse_unknown_keys();
    return body;
}

SceneEmitter read_emitter(TomlSection& s, const SceneFile& scene) {
    SceneEmitter emitter;
    emitter.place = s.place();
    emitter.centre = s.vector("centre", scene.dim);
    emitter.direction = read_direction(s, "direction", scene.dim);
    emitter.radius = s.number("radius", positive);
    if (emitter.radius < 0.5 * scene.spacing || (scene.dim == 3 && emitter.radius < scene.spacing))
        s.reject("radius", "room for a particle: at least half of the spacing, in space all of it",
                 std::to_string(emitter.radius));
    emitter.speed = s.number("speed", positive);
    emitter.until = s.optional_number("until", positive);
    s.refuse_unknown_keys();
    return emitter;
}

SolidShape read_outflow(TomlSection& s, const SceneFile& scene) {
    SolidShape shape = read_shape(s, scene.dim);
    s.refuse_unknown_keys();
    return shape;
}

}  // namespace plumbline
