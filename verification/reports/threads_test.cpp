#include "verification/reports/program.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace {
using namespace verification;
using nlohmann::json;

/// The measured claims without what may differ from run to run: how long they took.
json measured(const ScratchFolder& folder, const std::string& threads) {
    const ProgramRun run =
        run_plumbline(folder, {"--threads", threads, "verify", "--json", "-"}, 600);
    INFO(run.err);
    REQUIRE_FALSE(run.out.empty());
    json claims = json::parse(run.out).at("claims");
    for (json& claim : claims) claim.erase("seconds");
    return claims;
}

TEST_CASE("results do not depend on the number of threads") {
    const ScratchFolder folder;
    const json one = measured(folder, "1"), two = measured(folder, "2");
    REQUIRE(one.size() == two.size());
    REQUIRE_FALSE(one.empty());
    for (std::size_t i = 0; i < one.size(); ++i) CHECK(one[i].dump() == two[i].dump());
}
}  // namespace
