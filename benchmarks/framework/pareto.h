#pragma once

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace benchmarks {

/// Of those that did not fail: neither cost(c) nor the error can be had lower without raising the
/// other. By ascending cost.
template <class Candidate, class Cost>
std::vector<std::size_t> pareto_front_of(const std::vector<Candidate>& candidates, Cost cost) {
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < candidates.size(); ++k)
        if (!candidates[k].failed()) order.push_back(k);
    std::ranges::sort(order, {}, [&](std::size_t k) {
        return std::pair(std::invoke(cost, candidates[k]), candidates[k].error);
    });
    std::vector<std::size_t> front;
    for (const std::size_t k : order)
        if (front.empty() || candidates[k].error < candidates[front.back()].error)
            front.push_back(k);
    return front;
}

}  // namespace benchmarks
