#pragma once

#include <string>
#include <vector>

namespace lumi {

struct Candidate;

/// A sentence for each thing that was done to the colours of photographs that are kept, and which
/// their owner may want to know: from what they were converted, what was cut off or hidden, whose
/// profile could not be used (E-INGEST-PROFILE), and which are black and white among others that
/// are not.
[[nodiscard]] std::vector<std::string> color_notes(const std::vector<Candidate>& candidates);

}  // namespace lumi
