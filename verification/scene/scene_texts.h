#pragma once

#include <string>

namespace verification {

/// A small dam break, as a scene file; `method` and `end` [s] as given, 450 particles in the plane, 432 in space.
inline std::string dam_break_scene(int dim, const std::string& method, double end) {
    const bool plane = dim == 2;
    return "title = \"dam break\"\ndim = " + std::to_string(dim) + "\nmethod = \"" + method +
           "\"\ngravity = " + (plane ? "[0, -9.81]" : "[0, 0, -9.81]") +
           "\n[particles]\nspacing = " + (plane ? "0.02" : "0.05") +
           "\nsupport = " + (method == "dfsph" ? "2.0" : "2.6") +
           "\n[fluid]\ndensity = 1000\nspeed_of_sound = 30\n"
           "viscosity = \"artificial\"\nalpha = 0.1\n" +
           (method == "dfsph" ? "" : "tension = 0\n") +
           (method == "sph" ? "xsph = 0.05\nxsph_step = 0.001\n" : "") +
           "[[block]]\nshape = \"box\"\nlow = " + (plane ? "[0, 0]" : "[0, 0, 0]") +
           "\nhigh = " + (plane ? "[0.6, 0.3]" : "[0.6, 0.3, 0.3]") +
           "\n[[wall]]\nshape = \"tank\"\nlow = " + (plane ? "[0, 0]" : "[0, 0, 0]") +
           "\nhigh = " + (plane ? "[1, 0.6]" : "[1, 0.3, 0.6]") + "\nopen = [\"" +
           (plane ? "+y" : "+z") + "\"]\n[time]\nend = " + std::to_string(end) +
           "\n[output]\ninterval = 0.02\npicture = \"none\"\n";
}

/// The text with `from` replaced by `to`, once.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    return at == std::string::npos ? "" : text.replace(at, from.size(), to);
}

}  // namespace verification
