#include "verification/reference_data/reference.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <set>

namespace origins_test {
namespace {
namespace fs = std::filesystem;

std::set<std::string> names_with(const std::string& ending) {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(verification::reference_folder())) {
        const std::string file = entry.path().string();
        if (entry.is_regular_file() && file.ends_with(ending))
            names.insert(file.substr(0, file.size() - ending.size()));
    }
    return names;
}
}  // namespace

TEST_CASE("reference data: each table has its origin, and each origin its table",
          "[reference_data]") {
    const auto tables = names_with(".csv");
    CHECK(tables == names_with(".origin.json"));
    CHECK(tables.size() >= 48);
    std::size_t files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(verification::reference_folder()))
        files += entry.is_regular_file();
    CHECK(files == 2 * tables.size());
}

TEST_CASE("reference data: an origin says all that a reader needs", "[reference_data]") {
    for (const std::string& name : names_with(".csv")) {
        INFO(name);
        std::ifstream file(name + ".origin.json");
        const auto origin = nlohmann::json::parse(file, nullptr, false);
        REQUIRE_FALSE(origin.is_discarded());
        for (const char* key : {"source", "provenance", "licence", "units", "regenerate"}) {
            INFO(key);
            REQUIRE(origin.contains(key));
            CHECK_FALSE(origin[key].get<std::string>().empty());
        }
        CHECK(origin.at("notes").is_array());
        const auto table = plumbline::CsvTable::read(name + ".csv");
        CHECK(origin.at("columns").get<std::vector<std::string>>() == table.header());
        CHECK(table.rows() > 0);
    }
}

TEST_CASE("reference data: folders tell how far a table can be trusted", "[reference_data]") {
    for (const auto& entry : fs::directory_iterator(verification::reference_folder()))
        CHECK(std::set<std::string>{"analytic", "published", "independent"}.contains(
            entry.path().filename().string()));
}

}  // namespace origins_test
