#include <cmath>
#include <optional>
#include <utility>

#include "calib/ingest/ingest.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

struct Fault {
    std::string key;
    std::string expected;
};

std::optional<Fault> first_fault(const IngestOptions& options) {
    if (options.max_width_px < 0) return Fault{"max_width_px", "0 (as they are) or more"};
    if (options.min_width_px <= 0) return Fault{"min_width_px", "more than 0"};
    const int judged_width_px = options.judged_width_px.value_or(options.max_width_px);
    if (judged_width_px > 0 && judged_width_px < options.min_width_px) {
        return Fault{"max_width_px", "0 or at least min_width_px"};
    }
    if (options.min_photographs < 1) return Fault{"min_photographs", "1 or more"};
    if (!(options.video_fps > 0) || !std::isfinite(options.video_fps)) {
        return Fault{"video_fps", "more than 0"};
    }
    return std::nullopt;
}

}  // namespace

void validate(const IngestOptions& options) {
    if (const auto fault = first_fault(options)) {
        throw Error(ErrorKind::kUsage, "E-CONFIG-VALUE",
                    "`" + fault->key + "`: expected " + fault->expected,
                    "correct this option, or leave it out to use the default");
    }
}

IngestOptions read_ingest_options(const ConfigSection& section) {
    IngestOptions options;
    options.max_width_px = section.integer("max_width_px", options.max_width_px);
    options.min_width_px = section.integer("min_width_px", options.min_width_px);
    options.min_photographs = section.integer("min_photographs", options.min_photographs);
    options.video_fps = section.number("video_fps", options.video_fps);
    options.keep_overlays = section.boolean("keep_overlays", options.keep_overlays);
    if (const auto fault = first_fault(options)) section.refuse(fault->key, fault->expected);
    return options;
}

}  // namespace lumi
