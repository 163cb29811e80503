#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "pipeline/report/standing_package.h"

namespace lumi {

/// How a run went, in words.
struct Verdict {
    enum class Level { kGood, kFair, kBad };
    Level level = Level::kGood;
    std::string headline;
    std::vector<std::string> remarks;  ///< What to know or to do about it.
};

/// Bad: the line ended early. Fair: something was left out or is missing. Good: all there. `stages`
/// is what stages.json says; `evaluation` what evaluation.json says of the package that stands
/// there, null when there is none.
[[nodiscard]] Verdict verdict_of(const nlohmann::ordered_json& stages,
                                 const StandingPackage& package,
                                 const nlohmann::ordered_json& evaluation);

}  // namespace lumi
