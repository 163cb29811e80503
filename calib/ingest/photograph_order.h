#pragma once

#include <string_view>
#include <vector>

#include "calib/ingest/ingest.h"

namespace lumi {

/// True when the first name comes before the second as people count: letters byte by byte, digits
/// that follow each other as one number, so that "9.jpg" comes before "10.jpg". Of names that
/// differ in leading zeros alone the one with more comes first.
[[nodiscard]] bool comes_before(std::string_view first, std::string_view second);

/// The place of each photograph in the order in which they were probably taken: that of their
/// names, by comes_before().
[[nodiscard]] std::vector<int> places_in_order(const std::vector<Photograph>& photographs);

}  // namespace lumi
