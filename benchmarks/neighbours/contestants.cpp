#include "benchmarks/neighbours/contestants.h"

namespace benchmarks {

using plumbline::InvalidInput;

namespace {
template <int Dim> std::vector<ContestantMaker<Dim>> all_contestants() {
    auto all = our_contestants<Dim>();
    for (auto& maker : library_contestants<Dim>()) all.push_back(std::move(maker));
    return all;
}
}  // namespace

std::vector<std::string> contestant_names() {
    std::vector<std::string> names;
    for (const auto& maker : all_contestants<3>()) names.push_back(maker.name);
    return names;
}

template <int Dim> std::unique_ptr<Contestant<Dim>> make_contestant(const std::string& name) {
    for (const auto& maker : all_contestants<Dim>())
        if (maker.name == name) return maker.make();
    std::string expected;
    for (const std::string& known : contestant_names()) expected.append(" ").append(known);
    throw InvalidInput("no search \"" + name + "\"; expected one of:" + expected);
}
template std::unique_ptr<Contestant<2>> make_contestant<2>(const std::string&);
template std::unique_ptr<Contestant<3>> make_contestant<3>(const std::string&);

}  // namespace benchmarks
