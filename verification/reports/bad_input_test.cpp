#include "verification/reports/program.h"

#include <catch2/catch.hpp>

namespace {
using namespace verification;

struct BadInput {
    std::vector<std::string> arguments;
    std::string message;  // on stderr
    int exit_code = 2;
};

const std::vector<BadInput> table{
    {{}, "no command given; expected one of: "},
    {{"fly"}, "no command \"fly\"; expected one of: "},
    {{"list", "everything"}, "everything not in {claims,studies,"},
    {{"list", "--colour"}, "The following argument was not expected: --colour"},
    {{"--threads", "0", "list"}, "Value 0 not in range 1 to 4096"},
    {{"--threads", "two", "list"}, "Value two not in range 1 to 4096"},

    {{"verify", "no_such_claim"}, "no claim matches", 3},
    {{"verify", "--tag", "no_such_tag"}, "no claim matches", 3},
    {{"verify", "--time-limit", "0"}, "expected a positive number, found \"0\""},
    {{"verify", "--time-limit", "nan"}, "expected a positive number, found \"nan\""},
    {{"verify", "--time-limit", "soon"}, "expected a positive number, found \"soon\""},
    {{"verify", "--json", "no/folder.json"}, "found \"no/folder.json\": its folder does not exist"},
    {{"verify", "--junit", "no/folder.xml"}, "found \"no/folder.xml\": its folder does not exist"},
    {{"verify", "--json", "."}, "found \".\": that is a folder"},

    {{"converge", "no_such_study"}, "no study matches", 3},
    {{"converge", "--tag", "no_such_tag"}, "no study matches", 3},
    {{"converge", "--time-limit", "-1"}, "expected a positive number, found \"-1\""},
    {{"converge", "--json", "no/folder.json"}, "its folder does not exist"},

    {{"kernel"}, "expected the name of a kernel"},
    {{"kernel", "top_hat"}, "no kernel \"top_hat\" in 2D; expected one of: cubic_spline"},
    {{"kernel", "poly6", "--dim", "4"}, "--dim: expected 1, 2 or 3, found 4"},
    {{"kernel", "poly6", "--dim", "two"}, "Could not convert: --dim = two"},
    {{"kernel", "poly6", "--support", "0"},
     "expected a support radius from 1e-50 to 1e+50, found 0"},
    {{"kernel", "poly6", "--support", "-1"},
     "expected a support radius from 1e-50 to 1e+50, found -1"},
    {{"kernel", "poly6", "--support", "nan"},
     "expected a support radius from 1e-50 to 1e+50, found nan"},
    {{"kernel", "poly6", "--support", "inf"},
     "expected a support radius from 1e-50 to 1e+50, found inf"},
    {{"kernel", "poly6", "--at", "0,one"}, "expected numbers r1,r2,..., found \"one\" as number 2"},
    {{"kernel", "poly6", "--at", "0,,1"}, "expected numbers r1,r2,..., found \"\" as number 2"},
    {{"kernel", "poly6", "--at", "1e400"},
     "expected numbers r1,r2,..., found \"1e400\" as number 1"},
    {{"kernel", "poly6", "--at", "-1"}, "expected radii r >= 0, found -1"},
    {{"kernel", "poly6", "--at", "nan"}, "expected radii r >= 0, found nan"},
};

std::string sentence(const std::vector<std::string>& arguments) {
    std::string text = "plumbline";
    for (const std::string& argument : arguments) text += " " + argument;
    return text;
}

TEST_CASE("bad input gets a message and an exit code, and never an answer") {
    const ScratchFolder folder;
    for (const BadInput& bad : table) {
        const ProgramRun run = run_plumbline(folder, bad.arguments);
        INFO(sentence(bad.arguments) << "\nstdout: " << run.out << "\nstderr: " << run.err);
        CHECK(run.exit_code == bad.exit_code);
        CHECK(run.err.find(bad.message) != std::string::npos);
        CHECK(run.out.empty());
    }
}
}  // namespace
