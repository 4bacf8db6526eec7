#pragma once

#include "benchmarks/neighbours/contestants.h"
#include "solver/neighbours/packed_lists.h"

namespace benchmarks {

/// Builds and queries a search in double precision.
template <int Dim, plumbline::NeighbourSearch<Dim> Search>
class Searching : public Contestant<Dim> {
public:
    void build(double radius) override { search_.build(this->points(), radius); }
    void update() override {
        if constexpr (updates)
            search_.update(this->points());
        else
            search_.build(this->points(), search_.radius());
    }
    bool has_update() const override { return updates; }

protected:
    template <class Lists> void find(std::span<const double> radii, Lists& lists) const {
        if (radii.empty())
            search_.query(this->points(), lists);
        else
            search_.query(this->points(), radii, lists);
    }
    const Search& search() const { return search_; }

private:
    static constexpr bool updates =
        requires(Search search, typename Contestant<Dim>::Points points) {
        search.update(points);
    };

    Search search_;
};

/// Answers with sorted lists.
template <int Dim, class Search> class SortedForm : public Searching<Dim, Search> {
public:
    void query(std::span<const double> radii, plumbline::NeighbourLists& lists) override {
        this->find(radii, lists);
    }
};

/// Answers with lists as found.
template <int Dim, class Search> class PackedForm : public Searching<Dim, Search> {
public:
    using Lists = plumbline::NeighbourLists;
    void query(std::span<const double> radii, Lists&) override { this->find(radii, packed_); }
    Lists answer(const Lists&) const override { return ascending(packed_); }
    std::size_t answer_bytes(const Lists&) const override { return packed_.memory(); }
    std::string form() const override { return "lists as found"; }

protected:
    plumbline::PackedLists packed_;
};

/// A maker of contestants of that type and name.
template <int Dim, class Type> ContestantMaker<Dim> maker(std::string name) {
    return {std::move(name), [] { return std::make_unique<Type>(); }};
}

}  // namespace benchmarks
