#include "solver/scene/scene_file.h"

#include "solver/scene/scene_solids.h"
#include "solver/scene/toml_section.h"

#include <cmath>
#include <fstream>
#include <sstream>

namespace plumbline {

namespace {
using Section = TomlSection;

/// A table that must be there.
Section required(Section& file, const std::string& key) {
    auto section = file.section(key);
    if (!section) file.reject(key, "a table [" + key + "]", "none");
    return *std::move(section);
}

void read_particles(Section s, SceneFile& scene) {
    scene.spacing = s.number("spacing", positive);
    // Fewer than 1.6 spacings leave a particle without enough neighbours; more than 6 only smooth.
    constexpr Range of_support{[](double h) { return h >= 1.6 && h <= 6.0; },
                               "a number from 1.6 to 6"};
    scene.support =
        s.number("support", of_support, scene.method == Method::dfsph ? 2.0 : 3.0) * scene.spacing;
    s.refuse_unknown_keys();
}

void read_viscosity(Section& s, SceneFile& scene) {
    using enum ViscosityForm;
    scene.viscosity = s.choice<ViscosityForm>("viscosity",
                                              {{"none", none},
                                               {"artificial", artificial},
                                               {"brookshaw", brookshaw},
                                               {"monaghan", monaghan}},
                                              true);
    const bool physical = scene.viscosity == brookshaw || scene.viscosity == monaghan;
    only_with(s, "alpha", scene.viscosity == artificial, "viscosity = \"artificial\"");
    only_with(s, "mu", physical, "viscosity = \"brookshaw\" or \"monaghan\"");
    if (scene.viscosity == artificial) scene.alpha = s.number("alpha", positive);
    if (physical) scene.mu = s.number("mu", positive);
}

void read_xsph(Section& s, SceneFile& scene) {
    const bool possible = scene.method == Method::sph;
    for (const char* key : {"xsph", "xsph_form", "xsph_step"})
        only_with(s, key, possible, "method = \"sph\"");
    scene.xsph = s.number("xsph", fraction, 0.0);
    scene.xsph_form = s.choice<XsphForm>(
        "xsph_form", {{"velocities", XsphForm::velocities}, {"motion", XsphForm::motion}}, true);
    const bool per_step = scene.xsph > 0.0 && scene.xsph_form == XsphForm::velocities;
    only_with(s, "xsph_step", per_step, "xsph > 0 of the form \"velocities\"");
    if (per_step) scene.xsph_step = s.number("xsph_step", positive);
}

void read_fluid(Section s, SceneFile& scene) {
    constexpr Range of_exponent{[](double g) { return g >= 1.0 && g <= 20.0; },
                                "a number from 1 to 20"};
    scene.density = s.number("density", positive);
    // An incompressible fluid has no sound; the artificial viscosity alone is written with one.
    const bool sound = scene.method != Method::dfsph;
    for (const char* key : {"exponent", "tension", "pressure_force"})
        only_with(s, key, sound, "a method with sound, \"sph\" or \"delta_sph\"");
    scene.speed_of_sound = s.number("speed_of_sound", positive);
    scene.exponent = s.number("exponent", of_exponent, 7.0);
    scene.tension = s.number("tension", fraction, scene.method == Method::sph ? 0.0 : 1.0);
    only_with(s, "diffusion", scene.method == Method::delta_sph, "method = \"delta_sph\"");
    scene.diffusion = s.number("diffusion", fraction, 0.1);
    using enum PressureForm;
    scene.pressure_force = s.choice<PressureForm>(
        "pressure_force", {{"symmetric", symmetric}, {"averaged", averaged}, {"plain", plain}},
        true);
    read_viscosity(s, scene);
    scene.cohesion = s.number("cohesion", not_negative, 0.0);
    read_xsph(s, scene);
    s.refuse_unknown_keys();
}

FluidBlock read_block(Section& s, const SceneFile& scene) {
    FluidBlock block;
    block.place = s.place();
    block.sphere = s.choice<bool>("shape", {{"box", false}, {"sphere", true}});
    if (block.sphere) {
        block.centre = s.vector("centre", scene.dim);
        block.radius = s.number("radius", positive);
        Vec<3> reach = Vec<3>::Zero();
        for (int d = 0; d < scene.dim; ++d) reach[d] = block.radius;
        block.low = block.centre - reach, block.high = block.centre + reach;
    } else {
        read_box(s, scene.dim, block.low, block.high);
        block.centre = 0.5 * (block.low + block.high);
    }
    block.velocity = s.vector("velocity", scene.dim, Vec<3>::Zero());
    block.stretching = Vec<3>(s.vector("stretching", scene.dim, Vec<3>::Zero())).asDiagonal();
    block.sampling = scene.dim == 2
                         ? s.choice<FluidSampling>("sampling",
                                                   {{"lattice", FluidSampling::lattice},
                                                    {"jittered", FluidSampling::jittered},
                                                    {"hexagonal", FluidSampling::hexagonal}},
                                                   true)
                         : s.choice<FluidSampling>("sampling",
                                                   {{"lattice", FluidSampling::lattice},
                                                    {"jittered", FluidSampling::jittered}},
                                                   true);
    constexpr Range of_jitter{[](double j) { return j >= 0.0 && j <= 0.4; },
                              "a number from 0 to 0.4"};
    only_with(s, "jitter", block.sampling == FluidSampling::jittered, "sampling = \"jittered\"");
    if (block.sampling == FluidSampling::jittered) block.jitter = s.number("jitter", of_jitter);
    block.hydrostatic = s.flag("hydrostatic", false);
    if (block.hydrostatic && (block.sphere || scene.method != Method::delta_sph))
        s.reject("hydrostatic", "a box, and method = \"delta_sph\", which starts from densities",
                 "another one");
    s.refuse_unknown_keys();
    return block;
}

Wall read_wall(Section& s, const SceneFile& scene) {
    Wall wall;
    wall.place = s.place();
    wall.plane = s.choice<bool>("shape", {{"tank", false}, {"plane", true}});
    if (wall.plane) {
        wall.point = s.vector("point", scene.dim);
        wall.normal = read_direction(s, "normal", scene.dim);
    } else {
        read_box(s, scene.dim, wall.low, wall.high);
        std::vector<std::string> sides{"-x", "+x", "-y", "+y"};
        if (scene.dim == 3) sides.insert(sides.end(), {"-z", "+z"});
        for (const std::string& side : s.words("open", sides))
            wall.open[static_cast<std::size_t>(side[1] - 'x')][side[0] == '+' ? 1 : 0] = true;
    }
    wall.velocity = s.vector("velocity", scene.dim, Vec<3>::Zero());
    if (wall.plane && std::abs(wall.velocity.dot(wall.normal)) > 1e-12 * wall.velocity.norm())
        s.reject("velocity", "a velocity along the plane", "one across it");
    s.refuse_unknown_keys();
    return wall;
}

void read_time(Section s, SceneFile& scene) {
    scene.end = s.number("end", positive);
    scene.step = s.optional_number("step", positive);
    only_with(s, "largest_step", !scene.step, "steps that adapt (no key \"step\")");
    scene.largest_step = s.optional_number("largest_step", positive);
    s.refuse_unknown_keys();
}

SurfaceOutput read_surface(Section s) {
    SurfaceOutput surface;
    using enum SurfaceOutput::Field;
    surface.field = s.choice<SurfaceOutput::Field>(
        "field",
        {{"density", density}, {"blobby", blobby}, {"weighted_average", weighted_average}});
    constexpr Range of_level{[](double x) { return x > 0.0 && x < 1.0; },
                             "a number between 0 and 1"};
    constexpr Range of_cell{[](double x) { return x >= 0.1 && x <= 4.0; },
                            "a number from 0.1 to 4"};
    surface.cell = s.number("cell", of_cell, 0.5);
    const bool averaged = surface.field == weighted_average;
    only_with(s, "level", !averaged, "field = \"density\" or \"blobby\"");
    only_with(s, "radius", surface.field != density, "field = \"blobby\" or \"weighted_average\"");
    only_with(s, "distance", averaged, "field = \"weighted_average\"");
    surface.level = s.number("level", of_level, 0.5);
    surface.radius = s.number("radius", positive, 3.0);
    surface.distance = s.number("distance", positive, 0.5);
    surface.format =
        s.choice<std::string>("format", {{"vtp", "vtp"}, {"ply", "ply"}, {"obj", "obj"}}, true);
    s.refuse_unknown_keys();
    return surface;
}

void read_output(Section s, SceneFile& scene) {
    scene.interval = s.number("interval", positive);
    scene.scalar_interval = s.number("scalars", positive, scene.interval / 10.0);
    scene.picture = s.choice<const char*>(
        "picture",
        {{"speed", "speed"}, {"pressure", "pressure"}, {"density", "density"}, {"none", "none"}},
        true);
    if (scene.end / scene.interval > 1e5)
        s.reject("interval", "at most 100000 frames up to the end",
                 std::to_string(scene.end / scene.interval));
    if (auto surface = s.section("surface")) scene.surface = read_surface(*std::move(surface));
    s.refuse_unknown_keys();
}

Probe read_probe(Section& s, const SceneFile& scene) {
    Probe probe;
    probe.name = s.text("name");
    if (probe.name.find_first_of(",\"\n\r") != std::string::npos)
        s.reject("name", "a name without commas, quotes and line breaks", "\"" + probe.name + "\"");
    for (const Probe& other : scene.probes)
        if (other.name == probe.name)
            s.reject("name", "a name of its own for each probe", "\"" + probe.name + "\" twice");
    using enum Probe::Quantity;
    probe.quantity = s.choice<Probe::Quantity>(
        "quantity",
        {{"pressure", pressure}, {"density", density}, {"speed", speed}, {"height", height}});
    if (probe.quantity == height && scene.gravity.norm() == 0.0)
        s.reject("quantity", "gravity where a height is asked for", "none");
    probe.at = s.vector("at", scene.dim);
    s.refuse_unknown_keys();
    return probe;
}

SceneFile read_scene(Section file) {
    SceneFile scene;
    scene.title = file.text("title");
    scene.dim = file.whole_number("dim", 2, 3);
    scene.method = file.choice<Method>(
        "method",
        {{"sph", Method::sph}, {"delta_sph", Method::delta_sph}, {"dfsph", Method::dfsph}});
    scene.gravity = file.vector("gravity", scene.dim, Vec<3>::Zero());
    read_particles(required(file, "particles"), scene);
    read_fluid(required(file, "fluid"), scene);
    for (Section& s : file.sections("block")) scene.blocks.push_back(read_block(s, scene));
    for (Section& s : file.sections("emitter")) scene.emitters.push_back(read_emitter(s, scene));
    for (Section& s : file.sections("outflow")) scene.outflows.push_back(read_outflow(s, scene));
    if (scene.blocks.empty() && scene.emitters.empty())
        file.reject("block", "at least one table [[block]] or [[emitter]]", "none");
    for (Section& s : file.sections("wall")) scene.walls.push_back(read_wall(s, scene));
    for (Section& s : file.sections("constraint"))
        scene.constraints.push_back(read_constraint(s, scene));
    for (Section& s : file.sections("body")) scene.bodies.push_back(read_body(s, scene));
    if (auto contact = file.section("contact")) {
        scene.body_restitution = contact->number("restitution", fraction, 0.0);
        scene.body_friction = contact->number("friction", not_negative, 0.0);
        contact->refuse_unknown_keys();
    }
    scene.wall_layers = file.whole_number("wall_layers", 1, 6, 3);
    scene.no_slip = file.flag("no_slip", false);
    if (scene.no_slip && scene.mu == 0.0)
        file.reject("no_slip", "walls that slip, where the fluid has no mu", "true");
    if (scene.no_slip && scene.xsph > 0.0 && !scene.bodies.empty())
        file.reject("no_slip", "bodies that slip, or no xsph, which would drag at them unseen",
                    "true");
    if (auto domain = file.section("domain")) {
        Vec<3> low, high;
        read_box(*domain, scene.dim, low, high);
        domain->refuse_unknown_keys();
        scene.domain = {low, high};
    }
    if (!scene.emitters.empty() && !scene.domain)
        file.reject("domain", "a table [domain], where there are emitters", "none");
    read_time(required(file, "time"), scene);
    read_output(required(file, "output"), scene);
    for (Section& s : file.sections("probe")) scene.probes.push_back(read_probe(s, scene));
    file.refuse_unknown_keys();
    return scene;
}
}  // namespace

SceneFile SceneFile::parse(const std::string& name, const std::string& text) {
    try {
        const toml::table table = toml::parse(text, name);
        SceneFile scene = read_scene(TomlSection(table, name, ""));
        scene.name = name, scene.text = text;
        return scene;
    } catch (const toml::parse_error& e) {
        const toml::source_position& at = e.source().begin;
        throw InvalidInput(
            name + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) +
            ": expected TOML, found something else: " + std::string(e.description()));
    }
}

SceneFile SceneFile::read(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    if (std::filesystem::is_directory(path) || !in)
        throw InvalidInput(path.string() + ": expected a scene file that can be read");
    return parse(path.string(), {std::istreambuf_iterator<char>(in), {}});
}

}  // namespace plumbline
