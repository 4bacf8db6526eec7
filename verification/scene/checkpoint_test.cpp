#include "solver/scene/checkpoint.h"

#include "solver/scene/simulation.h"
#include "verification/scene/scene_texts.h"

#include <catch2/catch.hpp>

namespace checkpoint_test {
namespace {
using namespace plumbline;
using namespace verification;

TEST_CASE("a state that is cut short, too long or of another size is refused") {
    const SceneFile scene = SceneFile::parse("scene", dam_break_scene(2, "sph", 1.0));
    const auto simulation = make_simulation(scene);
    std::string bytes;
    simulation->save(bytes);
    CHECK_NOTHROW(simulation->load(bytes));
    CHECK_THROWS_WITH(simulation->load(bytes.substr(0, bytes.size() / 2)),
                      Catch::Contains("found the end of the data"));
    CHECK_THROWS_WITH(simulation->load(bytes + "x"), Catch::Contains("found 1 more bytes"));
    std::string huge = bytes;
    huge[7] = '\x7f';
    CHECK_THROWS_WITH(simulation->load(huge), Catch::Contains("expected the number of positions"));
}
}  // namespace
}  // namespace checkpoint_test
