#include "reports/pieces.h"

#include "reports/files.h"

#include <catch2/catch.hpp>

#include <filesystem>

namespace pieces_test {
namespace {
using reports::Json;
using reports::Pieces;

struct Counter {
    int made = 0;
    Json operator()(const std::string& key, Pieces& pieces) {
        return pieces.get(key, [this] { return Json{{"made", ++made}}; });
    }
};

/// Of its own for each test: they may run at the same time.
std::filesystem::path fresh_directory(const std::string& test) {
    const auto directory =
        std::filesystem::temp_directory_path() / ("plumbline_pieces_test_" + test);
    std::filesystem::remove_all(directory);
    return directory;
}
}  // namespace

TEST_CASE("a finished piece is reused under the same fingerprint, and only then") {
    const auto directory = fresh_directory("kept");
    Counter counter;
    Pieces first(directory, "v1");
    CHECK(counter("claims/a", first)["made"] == 1);
    CHECK(counter("claims/b", first)["made"] == 2);
    CHECK(first.reused() == 0);

    Pieces again(directory, "v1");
    CHECK(counter("claims/a", again)["made"] == 1);
    CHECK(again.reused() == 1);

    Pieces other(directory, "v2");
    CHECK(counter("claims/a", other)["made"] == 3);
    CHECK(counter("claims/b", other)["made"] == 4);
    CHECK(other.reused() == 0);
}

TEST_CASE("a piece that is broken, or of another key with the same file, is made again") {
    const auto directory = fresh_directory("fingerprint");
    Counter counter;
    Pieces pieces(directory, "v1");
    counter("a b", pieces);
    CHECK(counter("a:b", pieces)["made"] == 2);
    reports::write_file(directory / "c.json", "{\"key\": \"c\", \"fing");
    CHECK(counter("c", pieces)["made"] == 3);
}

TEST_CASE("a piece whose making is interrupted leaves nothing behind") {
    const auto directory = fresh_directory("broken");
    Pieces pieces(directory, "v1");
    CHECK_THROWS_AS(pieces.get("a", []() -> Json { throw std::runtime_error("interrupted"); }),
                    std::runtime_error);
    CHECK_FALSE(std::filesystem::exists(directory / "a.json"));
}

TEST_CASE("the fingerprint tells runs with other options apart") {
    CHECK(reports::fingerprint("quick") == reports::fingerprint("quick"));
    CHECK(reports::fingerprint("quick") != reports::fingerprint("full"));
}

}  // namespace pieces_test
