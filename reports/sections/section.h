#pragma once

#include "reports/json.h"
#include "reports/pieces.h"

#include <functional>
#include <string>
#include <vector>

namespace reports {

/// What the sections measure into, one after the other. `report` becomes report.json.
struct ReportRun {
    Json report;
    Pieces& pieces;
    bool quick;

    /// The piece `key`; says on stderr that `what` begins if it has to be made.
    Json piece(const std::string& key, const std::string& what, const std::function<Json()>& make);
};

/// One part of the page: what it measures, and how that is shown.
struct Section {
    int place;  // sections stand, and are measured, in this order
    std::string id, title;
    /// Adds its results to `run.report`; long work goes through `run.pieces`.
    std::function<void(ReportRun& run)> measure;
    /// What the template reads, from the finished report; null if there is nothing to show, then the
    /// section is left out. A function of its arguments alone, so a stored report gives its page.
    /// The page draws every chart in it: where an object has a "chart", as json_of(Chart) gives it,
    /// the template finds the picture and its table as "drawn". A "file" with a "name" and a "text", a CSV, is
    /// written beside the charts; the template finds a "link" that saves it.
    std::function<Json(const Json& report)> view;
    std::string body;  // mustache
};

/// All registered sections, in order.
std::vector<Section> sections();

/// `const RegisterSection r{{30, "convergence", …}};` in reports/sections/<id>.cpp.
struct RegisterSection {
    explicit RegisterSection(Section section);
};

}  // namespace reports
