#include "solver/io/source_text.h"

#include "solver/foundation/errors.h"

#include <catch2/catch.hpp>

#include <clocale>
#include <cmath>
#include <fstream>

namespace source_text_test {
namespace {
using namespace plumbline;
using Catch::Matchers::Message;

std::filesystem::path scratch() {
    const auto folder = std::filesystem::temp_directory_path() / "plumbline_source_text_test";
    std::filesystem::create_directories(folder);
    return folder;
}
}  // namespace

TEST_CASE("source text: a file that cannot be read says why", "[io]") {
    const std::string folder = scratch().string();
    CHECK_THROWS_MATCHES(
        SourceText::read(folder + "/none.csv"), InvalidInput,
        Message(folder + "/none.csv: expected a readable file, found none of that name"));
    CHECK_THROWS_MATCHES(SourceText::read(folder), InvalidInput,
                         Message(folder + ": expected a readable file, found a directory"));
    std::ofstream(folder + "/empty.csv").close();
    CHECK_THROWS_MATCHES(
        SourceText::read(folder + "/empty.csv"), InvalidInput,
        Message(folder + "/empty.csv: expected a readable file, found an empty one"));
    CHECK_THROWS_MATCHES(SourceText::read(""), InvalidInput,
                         Message(": expected a readable file, found none of that name"));
    std::filesystem::remove_all(folder);
}

TEST_CASE("source text: numbers are read exactly, whatever the locale", "[io]") {
    // Where a German locale is installed, strtod would stop at the point.
    const std::string before = std::setlocale(LC_ALL, nullptr);
    for (const char* name : {"de_DE.UTF-8", "C"}) {
        std::setlocale(LC_ALL, name);
        const SourceText text("t", "0.1 +2.5e-3 4.9406564584124654e-324 -0");
        const auto w = words(text.bytes());
        CHECK(text.finite_number(w[0]) == 0.1);
        CHECK(text.finite_number(w[1]) == 0.0025);
        CHECK(text.finite_number(w[2]) == 0x1p-1074);
        CHECK(std::signbit(text.finite_number(w[3])));
    }
    std::setlocale(LC_ALL, before.c_str());
}

TEST_CASE("source text: lines and columns count from 1, in characters", "[io]") {
    const SourceText text("t", "äö,x\nü y");
    CHECK_THROWS_MATCHES(text.reject(text.bytes().substr(5), "z"), InvalidInput,
                         Message("t:1:4: expected z, found \"x\\x0aü y\""));
    CHECK_THROWS_MATCHES(text.reject(text.bytes().substr(10), "z"), InvalidInput,
                         Message("t:2:3: expected z, found \"y\""));
    CHECK_THROWS_MATCHES(text.reject(text.bytes().substr(11), "z", "the end"), InvalidInput,
                         Message("t:2:4: expected z, found the end"));
}

TEST_CASE("source text: lines end with LF or CR LF, the last with either or none", "[io]") {
    for (const char* content : {"a\nb", "a\nb\n", "a\r\nb\r\n"}) {
        Lines lines(content);
        CHECK(lines.next() == "a");
        CHECK(lines.next() == "b");
        CHECK_FALSE(lines.next());
    }
}

TEST_CASE("source text: quotes are short and printable", "[io]") {
    CHECK(in_quotes("a\tb") == "\"a\\x09b\"");
    CHECK(in_quotes(std::string(41, 'x')) == "\"" + std::string(40, 'x') + "…\"");
}

}  // namespace source_text_test
