#include "pipeline/commands/number_checks.h"

#include <cmath>
#include <sstream>

namespace lumi {
namespace {

/// Empty where `text` is a number that is `right`, else what is wrong, as CLI11 asks its checks.
template <typename Right>
std::string complaint_about(const std::string& text, const std::string& expected, Right right) {
    double value = 0.0;
    if (CLI::detail::lexical_cast(text, value) && right(value)) return {};
    return "expected " + expected + ", found " + text;
}

/// Such as 0.25 and 10000, without zeros at the end.
std::string short_text(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
}

}  // namespace

CLI::Validator positive_number() {
    return {[](std::string& text) {
                return complaint_about(text, "a number above 0", [](double value) {
                    return std::isfinite(value) && value > 0.0;
                });
            },
            "POSITIVE"};
}

CLI::Validator number_from_to(double least, double most) {
    const std::string bounds = short_text(least) + " to " + short_text(most);
    return {[=](std::string& text) {
                return complaint_about(text, bounds, [=](double value) {
                    return value >= least && value <= most;  // NaN is neither.
                });
            },
            bounds};
}

}  // namespace lumi
