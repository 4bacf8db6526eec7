#include "solver/io/csv.h"

#include "solver/foundation/errors.h"
#include "solver/foundation/random.h"

#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

namespace csv_test {
namespace {
using namespace plumbline;
using Catch::Matchers::Message;

CsvTable table(const std::string& content) {
    const auto path = std::filesystem::temp_directory_path() / "plumbline_csv_test.csv";
    std::ofstream(path, std::ios::binary) << content;
    const CsvTable result = CsvTable::read(path);
    std::filesystem::remove(path);
    return result;
}
}  // namespace

TEST_CASE("csv: 17 digits give back the same bits", "[io]") {
    Random random(1);
    for (int k = 0; k < 10000; ++k) {
        const double value = std::bit_cast<double>(random.bits());
        if (!std::isfinite(value)) continue;
        const SourceText text("t", digits17(value));
        REQUIRE(std::bit_cast<std::uint64_t>(text.finite_number(text.bytes())) ==
                std::bit_cast<std::uint64_t>(value));
    }
    CHECK(digits17(0.1) == "0.10000000000000001");
    CHECK(digits17(-2) == "-2");
}

TEST_CASE("csv: what the writer writes, the table reads", "[io]") {
    std::ostringstream out;
    const std::vector<std::string> header = {"name", "a, \"b\""};
    CsvWriter csv(out, header);
    csv.add("one").add(0.1).end_row();
    csv.add("two, \"three\"").add(2.0).end_row();
    const CsvTable read = table(out.str());
    CHECK(read.header() == header);
    CHECK(read.text("name") == std::vector<std::string>{"one", "two, \"three\""});
    CHECK(read.numbers("a, \"b\"") == std::vector<double>{0.1, 2.0});
}

TEST_CASE("csv: a row of another length is an error of the program", "[io]") {
    std::ostringstream out;
    CsvWriter csv(out, {"a", "b"});
    csv.add(1.0);
    CHECK_THROWS_MATCHES(csv.end_row(), std::logic_error,
                         Message("CsvWriter: expected 2 fields in a row, found 1"));
}

TEST_CASE("csv: missing numbers are NaN, other text is refused", "[io]") {
    const CsvTable read = table("# comment\n\na, b ,c\n1,,nan\n 2 ,x,3\r\n");
    CHECK(read.rows() == 2);
    CHECK(read.numbers("a") == std::vector<double>{1, 2});
    CHECK(std::isnan(read.numbers("c")[0]));
    CHECK_THROWS_WITH(read.numbers("b"), Catch::Contains("column b, row 2:1:1: expected a finite "
                                                         "number, found \"x\""));
    CHECK_THROWS_WITH(read.text("d"), Catch::Contains("expected a column \"d\""));
}

}  // namespace csv_test
