#include "verification/reports/program.h"
#include "verification/scene/scene_texts.h"

#include <catch2/catch.hpp>

namespace bad_input_test {
namespace {
using namespace verification;

struct BadInput {
    std::vector<std::string> arguments;
    std::string message;  // on stderr
    int exit_code = 2;
};

const std::vector<std::pair<std::string, std::string>> files{
    {"good.csv", "x,y,f\n0,0,1\n1,0,2\n0,1,3\n"},
    {"at.csv", "x,y\n0.2,0.2\n"},
    {"at_in_space.csv", "x,y,z\n0.2,0.2,0.2\n"},
    {"empty.csv", ""},
    {"header_only.csv", "x,y,f\n"},
    {"no_y.csv", "x,f\n0,1\n"},
    {"twice.csv", "x,y,x\n0,1,2\n"},
    {"no_header.csv", "# points\n0,0,1\n1,0,2\n"},
    {"word.csv", "x,y,f\n0,0,1\n1,zero,1\n"},
    {"nan.csv", "x,y,f\n0,nan,1\n"},
    {"infinite.csv", "x,y,f\n0,0,inf\n"},
    {"huge.csv", "x,y,f\n0,0,1e999\n"},
    {"cut.csv", "x,y,f\n0,0,1\n1,0"},
    {"long_row.csv", "x,y,f\n0,0,1,2\n"},
    {"no_field.csv", "x,y\n0,0\n"},
    {"negative_mass.csv", "x,y,f,m\n0,0,1,1\n1,0,1,-1\n"},
    {"far_away.csv", "x,y,f\n1e200,0,1\n"},
    {"picture.csv", "\x89PNG\r\n\x1a\n"},
    {"cut.ply",
     "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\n"
     "end_header\n0 0\n"},
    {"cut.vtp", "<VTKFile type=\"PolyData\"><PolyData>"},
    {"cut.xyz", "3\nthree points\n0 0 0\n1 0 0\n"},
    {"cut.json", "{\"schema\": \"plumbline.claims/1\", \"claims\": ["},
    {"other.json", "{\"name\": \"of another program\"}"},
    {"list.json", "[1, 2]"}};

/// `approximate` with one argument, or its value, wrong.
std::vector<std::string> approximate(const std::string& option, const std::string& value) {
    std::vector<std::string> arguments{"approximate"};
    for (const auto& [name, good] : {std::pair{"--samples", "good.csv"},
                                     {"--at", "at.csv"},
                                     {"--method", "sph"},
                                     {"--kernel", "poly6"},
                                     {"--support", "2"}}) {
        arguments.push_back(name);
        arguments.push_back(option == name ? value : good);
    }
    return arguments;
}
std::vector<std::string> extended(std::vector<std::string> arguments,
                                  const std::vector<std::string>& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}
std::vector<std::string> samples(const std::string& file) { return approximate("--samples", file); }
std::vector<std::string> neighbours_of(const std::string& file) {
    return {"neighbours", "--points", file, "--radius", "0.5"};
}

/// `run` with a scene in which `from` was replaced by `to`; the scene is the name of its file.
struct BadScene {
    std::string from, to, message;
};
const std::vector<BadScene> scenes{
    {"title = \"dam break\"\n", "", "s.toml:1:1: expected a key \"title\" in the file, a text"},
    {"dim = 2", "dim = 1", "s.toml:2:7: expected a whole number from 2 to 3, found 1"},
    {"dim = 2", "dim = \"two\"", "s.toml:2:7: expected a whole number from 2 to 3, found \"two\""},
    {"dim = 2", "dim = 2\ndim = 3", "s.toml:3:7: expected TOML, found something else"},
    {"dim = 2", "dim = ", "s.toml:2:7: expected TOML, found something else"},
    {"\"delta_sph\"", "\"pcisph\"",
     "s.toml:3:10: expected one of \"sph\", \"delta_sph\", \"dfsph\", found \"pcisph\""},
    {"[0, -9.81]", "-9.81", "s.toml:4:11: expected a list of 2 numbers, found -9.81"},
    {"[0, -9.81]", "[0, inf]", "s.toml:4:15: expected a finite number, found inf"},
    {"[particles]", "[particle]", "s.toml:1:1: expected a table [particles], found none"},
    {"[particles]", "particles = 3\n[grains]",
     "s.toml:5:13: expected a table [particles], found 3"},
    {"spacing = 0.02", "spacing = -0.02", "s.toml:6:11: expected a number > 0, found -0.02"},
    {"spacing = 0.02", "spacing = 0", "s.toml:6:11: expected a number > 0, found 0"},
    {"spacing = 0.02", "spacing = 1e-7", "expected 1 to 4294967294"},
    {"support = 2.6", "support = 0.5", "s.toml:7:11: expected a number from 1.6 to 6, found 0.5"},
    {"support = 2.6", "h = 2.6",
     "s.toml:7:1: expected one of the keys spacing, support in [particles], found \"h\""},
    {"density = 1000\n", "", "s.toml:8:1: expected a key \"density\" in [fluid], a number > 0"},
    {"density = 1000\n", "density = 1000\nexponent = 0.5\n",
     "s.toml:10:12: expected a number from 1 to 20, found 0.5"},
    {"tension = 0", "tension = 2", "s.toml:13:11: expected a number from 0 to 1, found 2"},
    {"alpha = 0.1", "alpha = 0.1\ncohesion = -1", "s.toml:13:12: expected a number >= 0, found -1"},
    {"alpha = 0.1", "mu = 0.1", "expected no key \"mu\" without viscosity = \"brookshaw\""},
    {"[[block]]", "[block]", "expected tables [[block]], found a table"},
    {"high = [0.6, 0.3]", "high = [0.6, -0.3]", "expected a corner above the one of \"low\""},
    {"high = [0.6, 0.3]", "high = [0.6, 0.001]", "s.toml:14:1: spacing: expected cells that fit"},
    {"high = [1, 0.6]", "high = [1.003, 0.6]", "expected a tank whose edges are multiples of"},
    {"low = [0, 0]", "low = [-0.1, 0]",
     "expected blocks that do not overlap, nor reach into walls"},
    {"[time]", "[time]\nstep = -1", "expected a number > 0, found -1"},
    {"[time]", "[time]\nstart = 0",
     "s.toml:24:1: expected one of the keys end, largest_step, step in [time], found \"start\""},
    {"interval = 0.02", "interval = 1e-9", "expected at most 100000 frames up to the end"},
    {"picture = \"none\"", "picture = \"red\"", "expected one of \"speed\", \"pressure\""},
    {"picture = \"none\"", "surface = 1", "expected a table [surface], found 1"},
    {"[time]", "[[probe]]\nname = \"p\"\nquantity = \"colour\"\nat = [0, 0]\n[time]",
     "expected one of \"pressure\", \"density\", \"speed\", \"height\", found \"colour\""}};

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
    {{"kernel", "poly6", "--json", "no/folder.json"}, "its folder does not exist"},
    {{"kernel", "poly6", "--at", "nan"}, "expected radii r >= 0, found nan"},

    {samples("nowhere.csv"), "nowhere.csv: expected a readable file, found none of that name"},
    {samples("."), ".: expected a readable file, found a directory"},
    {samples("empty.csv"), "empty.csv: expected a readable file, found an empty one"},
    {samples("header_only.csv"), "header_only.csv:1:1: expected at least one point"},
    {samples("no_y.csv"),
     "no_y.csv:1:1: expected a header x,y[,z][,further columns] with a column \"y\""},
    {samples("twice.csv"), "twice.csv:1:"},
    {samples("no_header.csv"),
     "no_header.csv:2:1: expected a header that names the columns before the first point: x,y or "
     "x,y,z"},
    {samples("word.csv"), "word.csv:3:3: expected a finite number, found \"zero\""},
    {samples("nan.csv"), "nan.csv:2:3: expected a finite number, found \"nan\""},
    {samples("infinite.csv"), "infinite.csv:2:5: expected a finite number, found \"inf\""},
    {samples("huge.csv"), "huge.csv:2:5: expected a number that fits into a double"},
    {samples("cut.csv"), "cut.csv:3:4: expected 3 fields as in the header, found 2"},
    {samples("long_row.csv"), "long_row.csv:2:"},
    {samples("no_field.csv"), "no_field.csv: expected a column \"f\", found coordinates only"},
    {samples("negative_mass.csv"), "expected a positive finite mass, found -1"},
    {samples("far_away.csv"), "expected a finite coordinate below 1e+150"},
    {samples("picture.csv"), "picture.csv:1:1: expected text, found a PNG image"},
    {samples("cut.ply"), "cut.ply: vertex 2 of 2: expected its values, found the end of the file"},
    {samples("cut.vtp"), "cut.vtp:1: expected well-formed XML"},
    {samples("cut.xyz"), "cut.xyz:1:1: expected the count of the points that follow, 2"},
    {approximate("--at", "at_in_space.csv"), "found 2D samples and 3D points"},
    {approximate("--method", "mls:4"), "found \"mls:4\""},
    {approximate("--method", "splines"), "expected sph, shepard, mls:N, mlsph:N"},
    {approximate("--kernel", "top_hat"), "no kernel \"top_hat\" in 2D; expected one of: "},
    {approximate("--kernel", "singular"),
     "sph: expected a kernel that is finite at 0, found \"singular\""},
    {extended(approximate("", ""), {"--json", "no/folder.json"}), "its folder does not exist"},
    {approximate("--support", "0"), "expected a positive, finite support, found 0"},
    {approximate("--support", "-1"), "expected a positive, finite support, found -1"},
    {approximate("--support", "nan"), "expected a positive, finite support, found nan"},
    {approximate("--support", "wide"), "Could not convert: --support = wide"},
    {{"approximate", "--samples", "good.csv"}, "is required"},

    {neighbours_of("nowhere.csv"), "nowhere.csv: expected a readable file, found none"},
    {neighbours_of("empty.csv"), "empty.csv: expected a readable file, found an empty one"},
    {neighbours_of("header_only.csv"), "header_only.csv:1:1: expected at least one point"},
    {neighbours_of("nan.csv"), "nan.csv:2:3: expected a finite number, found \"nan\""},

    {{"frontier", "--dim", "4"}, "--dim: 4 not in {2,3}"},
    {{"frontier", "everything"}, "everything"},
    {{"frontier", "--quick", "hydrostatic", "water"}, "dam_break, found \"water\""},
    {{"frontier", "gradient", "-o", "good.csv"}, "found \"good.csv\": that is a file"},

    {{"stability", "-o", "good.csv"}, "found \"good.csv\": that is a file"},
    {{"stability", "--json", "nowhere/a.json"}, "nowhere/a.json"},

    {{"compare"}, "is required"},
    {{"compare", "nowhere.json", "list.json"}, "nowhere.json: expected a file that can be read"},
    {{"compare", "cut.json", "cut.json"}, "cut.json:1:45: expected JSON, as --json writes it"},
    {{"compare", "other.json", "other.json"}, "expected a result of plumbline with a \"schema\""},
    {{"compare", "list.json", "other.json"}, "expected a result of plumbline with a \"schema\""},

    {{"report", "-o", "good.csv"}, "found \"good.csv\": that is a file"},
    {{"report", "--baseline", "nowhere.json"}, "nowhere.json: expected a file that can be read"},
    {{"report", "--baseline", "cut.json"}, "cut.json:1:45: expected JSON, as --json writes it"},
    {{"doctor", "--json", "no/folder.json"}, "its folder does not exist"},

    {{"run"}, "is required"},
    {{"run", "nowhere.toml"}, "nowhere.toml: expected a scene file, or the name of an example"},
    {{"run", "."}, ".: expected a scene file that can be read"},
    {{"run", "empty.csv"}, "empty.csv:1:1: expected a key \"title\" in the file"},
    {{"run", "picture.csv"}, "picture.csv:1:1: expected TOML, found something else"},
    {{"run", "hydrostatic", "-o", "good.csv"}, "found \"good.csv\": that is a file"},
    {{"run", "hydrostatic", "-o", "none", "--continue"},
     "none/checkpoint: expected a file that can"},
    {{"run", "hydrostatic", "--steps", "0"}, "Value 0 not in range 1 to"},
    {{"run", "hydrostatic", "--continue", "--overwrite"}, "excludes"},
};

std::string sentence(const std::vector<std::string>& arguments) {
    std::string text = "plumbline";
    for (const std::string& argument : arguments) text += " " + argument;
    return text;
}

TEST_CASE("bad input gets a message and an exit code, and never an answer") {
    REQUIRE(table.size() >= 40);
    const ScratchFolder folder;
    for (const auto& [name, bytes] : files) folder.write(name, bytes);
    for (const BadInput& bad : table) {
        const ProgramRun run = run_plumbline(folder, bad.arguments);
        INFO(sentence(bad.arguments) << "\nstdout: " << run.out << "\nstderr: " << run.err);
        CHECK(run.exit_code == bad.exit_code);
        CHECK(run.err.find(bad.message) != std::string::npos);
        CHECK(run.out.empty());
    }
}

TEST_CASE("a wrong scene gets a message with its place, and nothing is written") {
    REQUIRE(scenes.size() >= 20);
    const ScratchFolder folder;
    const std::string good = dam_break_scene(2, "delta_sph", 1.0);
    for (const BadScene& bad : scenes) {
        const std::string text = with(good, bad.from, bad.to);
        REQUIRE_FALSE(text.empty());
        folder.write("s.toml", text);
        const ProgramRun run = run_plumbline(folder, {"run", "s.toml", "-o", "out"});
        INFO(bad.from << " -> " << bad.to << "\nstderr: " << run.err);
        CHECK(run.exit_code == 2);
        CHECK(run.err.find(bad.message) != std::string::npos);
        CHECK(run.out.empty());
        CHECK_FALSE(std::filesystem::exists(folder.path() / "out"));
    }
}
}  // namespace
}  // namespace bad_input_test
