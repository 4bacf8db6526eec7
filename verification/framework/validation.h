#pragma once

#include "verification/framework/claim.h"
#include "verification/framework/study.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace verification {

struct Curve {
    std::vector<double> x, y;  // x rises
};

/// A case against an experiment, or a computation in the place of one, as ASME V&V 20 (2009) has it: the
/// error E = S − D beside u_val = √(u_num² + u_input² + u_D²), all uncertainties of 95 % coverage. The error
/// of the model is within E ± u_val; that it is wrong is told only by |E| > u_val.
struct Validation {
    std::string id;
    Source source;
    std::string says;         // the experiment, and which numbers are compared
    std::string what_is_run;  // for people: model, particles, steps

    std::vector<double> spacing;  // of the particles [m], coarse to fine; at least 3
    int quick_levels = 3;       // how many of them, from the coarse end, a quick run takes; 0: none
    double formal_order = 1.0;  // of the error in the spacing; 1 with a free surface

    /// A number that was measured.
    struct Quantity {
        std::string name, unit;
        double measured;         // D
        double u_data, u_input;  // of D, and of what was not known about the experiment
        std::string why;         // where both come from
        Bound goal = between(-HUGE_VAL, HUGE_VAL, "");  // of E/D, where more is asked than u_val
    };
    std::vector<Quantity> quantities;

    /// A signal that was measured.
    struct Panel {
        std::string name, x_label, x_unit, y_label, y_unit;
        Curve measured;
        std::vector<double> low, high;  // the band that holds 95 % of the repeats; may be empty
        Bound goal = between(0.0, 1.0, "");  // of the share of samples inside the band
    };
    std::vector<Panel> panels;

    struct Observation {
        std::vector<double> quantities;  // S, in their order; NaN where there was no answer
        std::vector<Curve> curves;       // one per panel
    };
    /// A function of its argument alone.
    std::function<Observation(double spacing)> observe;
    std::vector<std::string> tags = {};
};

/// Where the comparison stands:
/// - agrees: |E| ≤ u_val;
/// - differs: |E| > u_val, the model is wrong by E ± u_val;
/// - inconclusive: u_val > |D|, or an answer is missing, so nothing is said about the model.
enum class Agreement { agrees, differs, inconclusive };
std::string_view name_of(Agreement agreement);

struct QuantityResult {
    Validation::Quantity quantity;
    std::vector<double> simulated;  // by level
    double error;                   // E of the finest level
    double u_num, u_val;
    Agreement agreement;
    bool reaches_goal;
};

struct PanelResult {
    Validation::Panel panel;
    std::vector<Curve> curves;  // by level
    double deviation;  // rms of S − D at the samples of D, over the range of D; finest level
    std::optional<double> inside_band;  // share of these samples
    bool reaches_goal;
};

struct ValidationResult {
    Validation validation;
    std::vector<double> spacing;  // the levels that were run
    std::vector<QuantityResult> quantities;
    std::vector<PanelResult> panels;
};

/// How far the last of `values` may be from the limit of fine spacing: Roache's Fs |S₁ − S₂| / (rᵖ − 1) of the
/// three finest levels, S₁ the finest. p solves (S₃ − S₂)/(S₂ − S₁) = r₂₁ᵖ (r₃₂ᵖ − 1)/(r₂₁ᵖ − 1), r₂₁ = h₂/h₁
/// (Celik et al. 2008), and is taken within [1/2, formal order]; Fs = 1.25, or 3 where p is outside [1/2, 2 formal order] (Oberkampf & Roy
/// 2010). If the three are not monotone, 3 times half the spread of all levels (Logan & Nitta 2005).
/// NaN below three levels, or if a value is missing.
double numerical_uncertainty(const std::vector<double>& spacing, const std::vector<double>& values,
                             double formal_order);

/// The levels of a run.
std::vector<double> levels_of(const Validation& validation, Effort effort);

/// The verdicts on what was observed, one observation per level.
/// Throws InvalidInput if an observation has not one number per quantity and one curve per panel.
ValidationResult judge(const Validation& validation, const std::vector<double>& spacing,
                       const std::vector<Validation::Observation>& observed);

/// All registered validations, by id.
const std::vector<Validation>& validations();
/// `const RegisterValidation r{Validation{…}};` in a verification file.
struct RegisterValidation {
    explicit RegisterValidation(Validation validation);
};

}  // namespace verification
