#pragma once

#include "reports/charts/chart_json.h"

namespace verification {

/// A report with one chart, a claim that holds, one that does not, and text that HTML must escape.
inline reports::Json small_report() {
    using reports::Chart;
    using reports::Json;
    const auto claim = [](const char* id, const char* verdict) -> Json {
        return {{"id", id},
                {"source", {{"paper", "adams2009"}, {"place", "Eq. 13"}}},
                {"says", "<script>alert(1)</script> & more"},
                {"measured", 1e-9},
                {"bound", {{"low", "-inf"}, {"high", 1e-6}, {"why", "because"}}},
                {"verdict", verdict},
                {"sabotaged", {{"measured", nullptr}, {"caught", true}}},
                {"seconds", 0.1}};
    };
    const Chart chart{.finding = "falls",
                      .x = {"spacing", "m", true},
                      .y = {"error", "1", true},
                      .series = {{.name = "mls", .x = {0.1, 0.05}, .y = {0.01, 0.0025}}},
                      .slopes = {2},
                      .caption = "",
                      .alt = "a falling line",
                      .command = "plumbline converge s"};
    const Json series = {{"name", "mls"},
                         {"verdict", "saturated"},
                         {"order", 2.0},
                         {"confidence", {1.9, 2.1}},
                         {"expected", {{"low", 1.5}, {"high", 2.5}, {"why", "theory"}}},
                         {"expected_saturation", false},
                         {"sabotaged", false},
                         {"floor", 0.0},
                         {"grid_convergence_index", nullptr},
                         {"failures", 0}};
    return {{"schema", "plumbline.report/1"},
            {"provenance",
             {{"version", "v1"},
              {"started", "2026-01-01T00:00:00Z"},
              {"processor", "cpu"},
              {"libraries", {{"Eigen", "3.4"}}},
              {"seeds", Json::object()}}},
            {"claims", {claim("a.one", "verified"), claim("a.two", "failed")}},
            {"studies",
             {{{"id", "s"},
               {"source", {{"paper", "adams2009"}, {"place", "Sec. 4"}}},
               {"says", "it converges"},
               {"quantity", "error [1]"},
               {"spacing", {0.1, 0.05}},
               {"seeds", 5},
               {"series", {series}},
               {"chart", json_of(chart, "s")}}}}};
}

}  // namespace verification
